// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/frame_composer.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/stitching/detail/util.hpp>
#include "opencv2/gcpw/compensator.hpp"
#include "opencv2/gcpw/seam_finder.hpp"
#include "opencv2/gcpw/warper.hpp"
#include "rendering/color_field.hpp"
#include "rendering/feather.hpp"
#include "rendering/remap_tiled.hpp"
#include "rendering/seam_cut.hpp"
#include "stitching/rig_colors.hpp"
#include "stitching/warper_names.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double FEATHER = 0.01;     ///< of the longer side of a frame: hides a step of colour, and doubles little
const int BAND = 32;             ///< rows that are made at once: they stay in the cache

/// One camera's frames on the canvas.
struct View
{
    Size frame;
    Rect shown;  ///< what it shows, on the canvas
    Mat xy;      ///< CV_16SC2, and
    Mat between; ///< CV_16UC1: as of cv::convertMaps()
    Mat weight;  ///< CV_8UC1
    ColorField colors;
    Point offset;          ///< of `shown` in the picture that `position` is of
    GridPosition position; ///< on the colours
};

/// Cameras of the rig, for frames.
class FrameCameras
{
public:
    FrameCameras(const Rig& rig, const std::vector<Mat>& frames)
    {
        for (size_t k = 0; k < frames.size(); ++k)
        {
            const double width = rig.image_sizes.empty() ? frames[k].cols * rig.work_scale : rig.image_sizes[k].width;
            const double height = rig.image_sizes.empty() ? frames[k].rows * rig.work_scale : rig.image_sizes[k].height;
            const double ratio = frames[k].cols / width;
            if (std::abs(frames[k].rows - ratio * height) > std::max(2.0, ratio))
                CV_Error(Error::StsUnmatchedSizes,
                         format("gcpw: frame %zu is %d x %d px, which is not the shape of the rig's %g x %g px", k,
                                frames[k].cols, frames[k].rows, width, height));
            ratios_.push_back(ratio);
        }
        cameras_ = rig.cameras;
        scale_ = rig.scale;
    }

    /// @param part of a frame's resolution
    Mat intrinsics(size_t k, double part) const
    {
        Mat K;
        cameras_[k].K().convertTo(K, CV_32F);
        K.rowRange(0, 2) *= static_cast<float>(ratios_[k] * part);
        return K;
    }

    const Mat& rotation(size_t k) const { return cameras_[k].R; }
    float scale(double part) const { return static_cast<float>(scale_ * ratios_[0] * part); }

private:
    std::vector<cv::detail::CameraParams> cameras_;
    std::vector<double> ratios_; ///< pixels of a frame per pixel of the estimation
    double scale_ = 1;
};

std::vector<Mat> framesOf(InputArrayOfArrays input, size_t expected)
{
    std::vector<Mat> frames;
    input.getMatVector(frames);
    CV_CheckEQ(frames.size(), expected, "gcpw: FrameComposer takes one frame for each image of the rig");
    for (const Mat& frame : frames)
        CV_CheckTypeEQ(frame.type(), CV_8UC3, "gcpw: FrameComposer takes frames of type CV_8UC3");
    return frames;
}

/// What each camera is to show, at the resolution of seams.
std::vector<UMat> cuts(const GcpwWarper& creator, const FrameCameras& cameras, const std::vector<Mat>& frames)
{
    const double part = std::min(1.0, std::sqrt(SEAM_MEGAPIX * 1e6 / static_cast<double>(frames[0].total())));
    const Ptr<cv::detail::RotationWarper> warper = creator.create(cameras.scale(part));
    std::vector<Point> corners;
    std::vector<UMat> pictures(frames.size());
    std::vector<UMat> masks(frames.size());
    for (size_t k = 0; k < frames.size(); ++k)
    {
        Mat small;
        resize(frames[k], small, Size(), part, part, INTER_AREA);
        const Mat K = cameras.intrinsics(k, part);
        const Mat inside(small.size(), CV_8UC1, Scalar(255));
        corners.push_back(warper->warp(small, K, cameras.rotation(k), INTER_LINEAR, BORDER_REFLECT, pictures[k]));
        warper->warp(inside, K, cameras.rotation(k), INTER_NEAREST, BORDER_CONSTANT, masks[k]);
    }
    const Ptr<GcpwCompensator> compensator = creator.compensator();
    for (size_t k = 0; k < frames.size(); ++k)
        compensator->apply(static_cast<int>(k), corners[k], pictures[k], masks[k]);
    GcpwSeamFinder().find(pictures, corners, masks);
    return masks;
}

/// Lays a row over another by its weights, which sum to 255 over all rows that are laid.
void addRow(const Vec3b* from, const uchar* weight, int cols, Vec3b* to)
{
    for (int x = 0; x < cols; ++x)
    {
        if (weight[x] == 255)
            to[x] = from[x];
        else if (weight[x] > 0)
            for (int c = 0; c < 3; ++c)
                to[x][c] = static_cast<uchar>(std::min(255, to[x][c] + (from[x][c] * weight[x] + 127) / 255));
    }
}

} // namespace

struct FrameComposer::Impl
{
    Impl(const Rig& rig, const Ptr<WarperCreator>& base, InputArrayOfArrays input, double scale)
    {
        if (!rig.usable())
            CV_Error(Error::StsBadArg,
                     "gcpw: FrameComposer takes a usable() rig; its alignment's report says why this one is not");
        if (!(scale > 0 && scale <= MAX_REMAP_SIDE))
            CV_Error(Error::StsOutOfRange, format("gcpw: the scale is %g; it must be above 0", scale));
        const std::vector<Mat> frames = framesOf(input, rig.cameras.size());
        const FrameCameras cameras(rig, frames);
        const GcpwWarper creator(base, rig);
        const std::vector<UMat> kept = cuts(creator, cameras, frames);
        const Ptr<cv::detail::RotationWarper> warper = creator.create(cameras.scale(scale));
        std::vector<Mat> x_maps(frames.size());
        std::vector<Mat> y_maps(frames.size());
        std::vector<CutPicture> pictures(frames.size());
        std::vector<Point> corners;
        std::vector<Size> sizes;
        int longer = 1;
        for (size_t k = 0; k < frames.size(); ++k)
        {
            const Size frame = frames[k].size();
            const Rect roi =
                warper->buildMaps(frame, cameras.intrinsics(k, 1), cameras.rotation(k), x_maps[k], y_maps[k]);
            kept[k].copyTo(pictures[k].kept);
            pictures[k].corner = roi.tl();
            remapTiled(Mat(frame, CV_8UC1, Scalar(255)), pictures[k].valid, x_maps[k], y_maps[k], INTER_NEAREST,
                       BORDER_CONSTANT);
            corners.push_back(roi.tl());
            sizes.push_back(x_maps[k].size());
            longer = std::max({longer, frame.width, frame.height});
        }
        canvas = cv::detail::resultRoi(corners, sizes);
        if (canvas.width > MAX_REMAP_SIDE || canvas.height > MAX_REMAP_SIDE)
            CV_Error(Error::StsOutOfRange,
                     format("gcpw: the canvas would be %d x %d px, more than %d px a side; lower the scale",
                            canvas.width, canvas.height, MAX_REMAP_SIDE));
        const std::vector<Mat> weights =
            featherWeights(pictures, canvas, std::max(1, cvRound(FEATHER * longer * scale)));
        const std::shared_ptr<const RigModel> model = RigModel::create(rig);
        for (size_t k = 0; k < frames.size(); ++k)
        {
            const Rect inside = boundingRect(weights[k]);
            const Rect picture(corners[k], sizes[k]);
            const RigModel::Item& item = model->items()[k];
            views.push_back({frames[k].size(), inside + corners[k] - canvas.tl(), Mat(), Mat(),
                             weights[k](inside).clone(), ColorField(item.image.color), inside.tl(),
                             positionOnColors(*model, static_cast<int>(k), cameras.scale(scale), picture,
                                              item.image.color.size())});
            if (!inside.empty())
                convertMaps(x_maps[k](inside), y_maps[k](inside), views.back().xy, views.back().between, CV_16SC2);
        }
    }

    /// Some rows of the canvas.
    void composeRows(const std::vector<Mat>& frames, const Range& rows, Mat panorama) const
    {
        panorama.rowRange(rows).setTo(Scalar::all(0));
        for (size_t k = 0; k < views.size(); ++k)
        {
            const View& view = views[k];
            const Range own(std::max(rows.start - view.shown.y, 0),
                            std::min(rows.end - view.shown.y, view.shown.height));
            if (own.start >= own.end)
                continue;
            const Mat weight = view.weight.rowRange(own);
            Mat part;
            remap(frames[k], part, view.xy.rowRange(own), view.between.rowRange(own), INTER_LINEAR, BORDER_REFLECT);
            const Point offset = view.offset + Point(0, own.start);
            view.colors.apply(part, weight, [&](Point p) { return view.position(p + offset); });
            for (int y = 0; y < part.rows; ++y)
                addRow(part.ptr<Vec3b>(y), weight.ptr<uchar>(y), part.cols,
                       panorama.ptr<Vec3b>(view.shown.y + own.start + y) + view.shown.x);
        }
    }

    std::vector<View> views;
    Rect canvas;
};

FrameComposer::FrameComposer(const Rig& rig, const Ptr<WarperCreator>& base, InputArrayOfArrays frames, double scale)
    : impl_(std::make_shared<Impl>(rig, base, frames, scale))
{
}

FrameComposer::FrameComposer(const Rig& rig, InputArrayOfArrays frames, double scale)
    : FrameComposer(rig, warperOfName(rig.projection), frames, scale)
{
}

void FrameComposer::compose(InputArrayOfArrays input, OutputArray panorama) const
{
    const std::vector<Mat> frames = framesOf(input, impl_->views.size());
    for (size_t k = 0; k < frames.size(); ++k)
    {
        const Size expected = impl_->views[k].frame;
        if (frames[k].size() != expected)
            CV_Error(Error::StsUnmatchedSizes,
                     format("gcpw: frame %zu is %d x %d px; this FrameComposer was made for %d x %d px", k,
                            frames[k].cols, frames[k].rows, expected.width, expected.height));
    }
    panorama.create(size(), CV_8UC3);
    Mat picture = panorama.getMat();
    const int bands = (picture.rows + BAND - 1) / BAND;
    parallel_for_(Range(0, bands),
                  [&](const Range& range)
                  {
        for (int i = range.start; i < range.end; ++i)
            impl_->composeRows(frames, Range(i * BAND, std::min((i + 1) * BAND, picture.rows)), picture);
    });
}

Size FrameComposer::size() const
{
    return impl_->canvas.size();
}

} // namespace gcpw
} // namespace cv
