// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitching/affine_warper.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const double FARTHEST = 1e9; ///< px: rectangles of twice this size still fit an int

Matx33d matrixOf(InputArray input)
{
    Mat doubles;
    input.getMat().convertTo(doubles, CV_64F);
    CV_CheckEQ(doubles.total(), size_t(9), "gcpw: a camera matrix is 3 x 3");
    return Matx33d(doubles.ptr<double>());
}

Point2d through(const Matx33d& map, Point2d p)
{
    return {map(0, 0) * p.x + map(0, 1) * p.y + map(0, 2), map(1, 0) * p.x + map(1, 1) * p.y + map(1, 2)};
}

Matx23d upperRows(const Matx33d& map)
{
    return {map(0, 0), map(0, 1), map(0, 2), map(1, 0), map(1, 1), map(1, 2)};
}

} // namespace

Matx33d AffineWarper::imageFromCanvas(InputArray K, InputArray R) const
{
    return matrixOf(K) * matrixOf(R) * Matx33d::diag(Vec3d(1.0 / scale_, 1.0 / scale_, 1));
}

Point2f AffineWarper::warpPoint(const Point2f& pt, InputArray K, InputArray R)
{
    return through(imageFromCanvas(K, R).inv(), pt);
}

Point2f AffineWarper::warpPointBackward(const Point2f& pt, InputArray K, InputArray R)
{
    return through(imageFromCanvas(K, R), pt);
}

Rect AffineWarper::warpRoi(Size src_size, InputArray K, InputArray R)
{
    const Matx33d canvas_from_image = imageFromCanvas(K, R).inv();
    Point2d low = through(canvas_from_image, Point2d());
    Point2d high = low;
    for (int k = 1; k < 4; ++k)
    {
        const Point2d p = through(canvas_from_image, Point2d(k & 1 ? src_size.width - 1 : 0, k & 2 ? src_size.height - 1 : 0));
        low = Point2d(std::min(low.x, p.x), std::min(low.y, p.y));
        high = Point2d(std::max(high.x, p.x), std::max(high.y, p.y));
    }
    for (const double value : {low.x, low.y, high.x, high.y})
        if (!(std::abs(value) <= FARTHEST))
            CV_Error(Error::StsOutOfRange, format("gcpw: the affine map puts an image of %d x %d px at (%g, %g) to (%g, %g), beyond any canvas",
                                                  src_size.width, src_size.height, low.x, low.y, high.x, high.y));
    return {Point(cvFloor(low.x), cvFloor(low.y)), Point(cvCeil(high.x) + 1, cvCeil(high.y) + 1)};
}

Rect AffineWarper::buildMaps(Size src_size, InputArray K, InputArray R, OutputArray xmap, OutputArray ymap)
{
    const Rect roi = warpRoi(src_size, K, R);
    const auto image_at = imageAt(K, R);
    xmap.create(roi.size(), CV_32FC1);
    ymap.create(roi.size(), CV_32FC1);
    Mat x_map = xmap.getMat();
    Mat y_map = ymap.getMat();
    for (int y = 0; y < roi.height; ++y)
        for (int x = 0; x < roi.width; ++x)
        {
            const Point2f p = image_at(x + roi.x, y + roi.y);
            x_map.at<float>(y, x) = p.x;
            y_map.at<float>(y, x) = p.y;
        }
    return {roi.tl(), roi.br() - Point(1, 1)};
}

std::function<Point2f(int, int)> AffineWarper::imageAt(InputArray K, InputArray R) const
{
    const Matx33d image_from_canvas = imageFromCanvas(K, R);
    return [image_from_canvas](int x, int y) { return Point2f(through(image_from_canvas, Point2d(x, y))); };
}

Point AffineWarper::warp(InputArray src, InputArray K, InputArray R, int interp_mode, int border_mode, OutputArray dst)
{
    Mat x_map;
    Mat y_map;
    const Rect roi = buildMaps(src.size(), K, R, x_map, y_map);
    remap(src, dst, x_map, y_map, interp_mode, border_mode);
    return roi.tl();
}

void AffineWarper::warpBackward(InputArray src, InputArray K, InputArray R, int interp_mode, int border_mode,
                                Size dst_size, OutputArray dst)
{
    const Rect roi = warpRoi(dst_size, K, R);
    checkPicture(src.size(), roi.size());
    Matx33d from_image = imageFromCanvas(K, R).inv();
    from_image(0, 2) -= roi.x;
    from_image(1, 2) -= roi.y;
    warpAffine(src, dst, upperRows(from_image), dst_size, interp_mode | WARP_INVERSE_MAP, border_mode);
}

void checkPicture(Size picture, Size expected)
{
    if (picture != expected)
        CV_Error(Error::StsUnmatchedSizes, format("gcpw: warpBackward() takes a picture of warpRoi()'s size, %d x %d px, not %d x %d px",
                                                  expected.width, expected.height, picture.width, picture.height));
}

Ptr<cv::detail::RotationWarper> trueWarper(const Ptr<cv::detail::RotationWarper>& base)
{
    if (base.dynamicCast<cv::detail::AffineWarper>())
        return makePtr<AffineWarper>(base->getScale());
    return base;
}

} // namespace gcpw
} // namespace cv
