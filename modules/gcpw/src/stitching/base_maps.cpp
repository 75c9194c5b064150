// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitching/base_maps.hpp"

#include "stitching/affine_warper.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

typedef std::function<Point2f(int, int)> ImageAt;

/// OpenCV keeps the projection for the heirs of its warpers.
template <typename Projector>
struct Heir : cv::detail::RotationWarperBase<Projector>
{
    static Projector projectorOf(cv::detail::RotationWarperBase<Projector>& warper)
    {
        return warper.*(&Heir::projector_);
    }
};

template <typename Projector>
ImageAt ofProjector(cv::detail::RotationWarper& base, const Mat& K, const Mat& R)
{
    auto* const warper = dynamic_cast<cv::detail::RotationWarperBase<Projector>*>(&base);
    if (!warper)
        return {};
    Projector projector = Heir<Projector>::projectorOf(*warper);
    projector.setCameraParams(K, R);
    return [projector](int x, int y) mutable
    {
        Point2f image_px;
        projector.mapBackward(static_cast<float>(x), static_cast<float>(y), image_px.x, image_px.y);
        return image_px;
        };
}

ImageAt imageAtOf(cv::detail::RotationWarper& base, const Mat& K, const Mat& R)
{
    using namespace cv::detail;
    if (auto* const affine = dynamic_cast<gcpw::AffineWarper*>(&base))
        return affine->imageAt(K, R);
    if (dynamic_cast<cv::detail::AffineWarper*>(&base)) // a PlaneWarper that takes its camera in another way
        return {};
    for (const auto& of :
         {ofProjector<SphericalProjector>, ofProjector<PlaneProjector>, ofProjector<CylindricalProjector>,
          ofProjector<StereographicProjector>, ofProjector<FisheyeProjector>,
          ofProjector<CompressedRectilinearProjector>, ofProjector<CompressedRectilinearPortraitProjector>,
          ofProjector<PaniniProjector>, ofProjector<PaniniPortraitProjector>, ofProjector<MercatorProjector>,
          ofProjector<TransverseMercatorProjector>})
        if (const ImageAt image_at = of(base, K, R))
            return image_at;
    return {};
}

} // namespace

BaseMaps::BaseMaps(cv::detail::RotationWarper& base, Size image, const Mat& K, const Mat& R)
    : whole_(base.warpRoi(image, K, R)), image_at_(imageAtOf(base, K, R))
{
    if (image_at_)
        return;
    const Point corner = base.buildMaps(image, K, R, x_map_, y_map_).tl();
    whole_ = Rect(corner, x_map_.size());
}

void BaseMaps::build(Rect window, Mat& x_map, Mat& y_map) const
{
    CV_Assert((window & whole_) == window);
    if (!image_at_)
    {
        x_map = x_map_(window - whole_.tl());
        y_map = y_map_(window - whole_.tl());
        return;
    }
    x_map.create(window.size(), CV_32FC1);
    y_map.create(window.size(), CV_32FC1);
    parallel_for_(Range(0, window.height),
                  [&](const Range& rows)
                  {
        const ImageAt image_at = image_at_; // its own copy: projections are not const
        for (int y = rows.start; y < rows.end; ++y)
            for (int x = 0; x < window.width; ++x)
            {
                const Point2f p = image_at(window.x + x, window.y + y);
                x_map.at<float>(y, x) = p.x;
                y_map.at<float>(y, x) = p.y;
            }
    });
}

} // namespace gcpw
} // namespace cv
