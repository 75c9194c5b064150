// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/rotation_warper.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <opencv2/imgproc.hpp>
#include "rendering/extension.hpp"
#include "rendering/remap_tiled.hpp"
#include "stitching/affine_warper.hpp"
#include "stitching/rig_model.hpp"
#include "stitching/seam_rotation.hpp"
#include "stitching/warp_maps.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int STRIP = 256;            ///< rows that warpWithMask() makes maps of at a time
const int PIECE = 16384;          ///< columns of such a strip that cv::remap gets at once: less than it takes
const int LARGEST_SIDE = 1000000; ///< px: more than photographs make together, less than what a bad camera asks for

Mat floats(InputArray matrix, const char* name)
{
    Mat result;
    matrix.getMat().convertTo(result, CV_32F);
    CV_CheckEQ(result.total(), size_t(9), "gcpw: a camera matrix is 3 x 3");
    if (!checkRange(result))
        CV_Error(Error::StsBadArg, format("gcpw: the camera's %s holds values that are not finite", name));
    return result;
}

/// A bad camera must not exhaust the memory.
void checkRoi(Rect roi, int most = MAX_REMAP_SIDE)
{
    if (roi.width <= 0 || roi.height <= 0 || roi.width > most || roi.height > most)
        CV_Error(Error::StsOutOfRange,
                 format("gcpw: the camera would make a picture of %d x %d px, more than %d px a side", roi.width,
                        roi.height, most));
}

/// Makes the maps of a rectangle of the canvas.
typedef std::function<void(Rect, Mat&, Mat&)> MakeMaps;

/// Warps an image and its mask strip by strip. @param inside receives where the maps lead to the image
void warpStrips(const Mat& image, const Mat& mask, const MakeMaps& make_maps, Rect roi, Mat& picture, Mat& shown,
                Mat& inside)
{
    Mat x_map;
    Mat y_map;
    for (int y = 0; y < roi.height; y += STRIP)
        for (int x = 0; x < roi.width; x += PIECE)
        {
            const Rect part(x, y, std::min(PIECE, roi.width - x), std::min(STRIP, roi.height - y));
            make_maps(part + roi.tl(), x_map, y_map);
            Mat pixels = picture(part);
            Mat pixels_shown = shown(part);
            remap(image, pixels, x_map, y_map, INTER_LINEAR, BORDER_REFLECT);
            remap(mask, pixels_shown, x_map, y_map, INTER_NEAREST, BORDER_CONSTANT);
            Mat((x_map != -1) | (y_map != -1)).copyTo(inside(part));
        }
}

/// What a call does: calls of one kind come in the order of the images.
enum class Call
{
    Point,
    Roi,
    Image,
    Mask
};

} // namespace

class GcpwRotationWarper::Impl
{
public:
    Ptr<cv::detail::RotationWarper> base;
    std::shared_ptr<const RigModel> model;

    /// The camera of one call and the image it belongs to; -1 for none, or one with an undeformed mesh: the base warper answers.
    struct CameraCall
    {
        Mat K;
        Matx33f R;
        int index = -1;
    };

    CameraCall camera_call(InputArray K, InputArray R, Call call)
    {
        CameraCall result;
        result.K = floats(K, "K");
        result.R = Matx33f(floats(R, "R").ptr<float>());
        if (!model)
            return result;
        const std::vector<int> found = model->find(result.R);
        if (found.empty())
            return result;
        // Equal rotations: OpenCV asks for images in their order, and again from the first.
        const size_t nth = found.size() == 1 || call == Call::Point ? 0 : calls_[{found[0], call}]++ % found.size();
        const int index = found[nth];
        result.index = model->items()[index].isIdentity ? -1 : index;
        return result;
    }

    WarpMaps maps(const CameraCall& camera_call)
    {
        return {*base, model->place(camera_call.index, base->getScale()), camera_call.K, camera_call.R, model->items()[camera_call.index].seam_rotation_rad};
    }

    /// Where an image lies on the canvas. @param most px a side that are not refused
    Rect roiOf(const CameraCall& camera_call, Size size, int most)
    {
        const Rect rect = camera_call.index < 0 ? base->warpRoi(size, camera_call.K, Mat(camera_call.R))
                                                : maps(camera_call).roi(size);
        checkRoi(rect, most);
        return rect;
    }

    /// What warp() is called with. Masks have one channel; where the photographs have one too, the flags with which
    /// cv::Stitcher and similar loops warp masks tell them apart.
    Call kindOf(int channels, int interp_mode, int border_mode)
    {
        photometric_ = photometric_ || channels != 1;
        const bool nearest = interp_mode == INTER_NEAREST || interp_mode == INTER_NEAREST_EXACT;
        return channels == 1 && (photometric_ || (nearest && border_mode == BORDER_CONSTANT)) ? Call::Mask : Call::Image;
    }

    /// The maps of an image: its mask is warped right after it, with the same ones.
    void build(const CameraCall& camera_call, Size size)
    {
        const Key key{camera_call.index, size, Matx33f(camera_call.K.ptr<float>()), base->getScale()};
        if (!x_map.empty() && key == key_)
            return;
        const WarpMaps warp = maps(camera_call);
        const Rect rect = warp.roi(size);
        checkRoi(rect);
        warp.build(size, rect, x_map, y_map);
        roi = rect;
        key_ = key;
    }

    /// Nobody asks for an image again once its mask was warped, and the blender needs the memory.
    void forgetMaps()
    {
        x_map.release();
        y_map.release();
    }

    Mat x_map;
    Mat y_map;
    Rect roi;

private:
    struct Key
    {
        int index = -1;
        Size size;
        Matx33f K;
        float scale = 0;
        bool operator==(const Key& other) const
        {
            return index == other.index && size == other.size && K == other.K && scale == other.scale;
        }
    };

    std::map<std::pair<int, Call>, size_t> calls_;
    bool photometric_ = false; ///< an image of several channels was warped
    Key key_;
};

GcpwRotationWarper::GcpwRotationWarper(const Ptr<cv::detail::RotationWarper>& base, const Rig& rig)
    : GcpwRotationWarper(trueWarper(base), RigModel::create(rig))
{
}

GcpwRotationWarper::GcpwRotationWarper(const Ptr<cv::detail::RotationWarper>& base, const std::shared_ptr<const RigModel>& model)
    : impl_(new Impl)
{
    if (!base)
        CV_Error(Error::StsNullPtr, "gcpw: GcpwRotationWarper needs a base warper");
    impl_->base = base;
    impl_->model = model;
}

GcpwRotationWarper::~GcpwRotationWarper() = default;

Point2f GcpwRotationWarper::warpPoint(const Point2f& pt, InputArray K, InputArray R)
{
    const Impl::CameraCall camera_call = impl_->camera_call(K, R, Call::Point);
    if (camera_call.index < 0)
        return impl_->base->warpPoint(pt, camera_call.K, Mat(camera_call.R));
    return impl_->maps(camera_call).canvasAt(pt);
}

Point2f GcpwRotationWarper::warpPointBackward(const Point2f& pt, InputArray K, InputArray R)
{
    const Impl::CameraCall camera_call = impl_->camera_call(K, R, Call::Point);
    if (camera_call.index < 0)
        return impl_->base->warpPointBackward(pt, camera_call.K, Mat(camera_call.R));
    return impl_->maps(camera_call).imageAt(pt);
}

Rect GcpwRotationWarper::warpRoi(Size src_size, InputArray K, InputArray R)
{
    const Impl::CameraCall camera_call = impl_->camera_call(K, R, Call::Roi);
    return impl_->roiOf(camera_call, src_size, MAX_REMAP_SIDE);
}

Rect GcpwRotationWarper::buildMaps(Size src_size, InputArray K, InputArray R, OutputArray xmap, OutputArray ymap)
{
    const Impl::CameraCall camera_call = impl_->camera_call(K, R, Call::Image);
    if (camera_call.index < 0)
    {
        checkRoi(impl_->base->warpRoi(src_size, camera_call.K, Mat(camera_call.R)));
        return impl_->base->buildMaps(src_size, camera_call.K, Mat(camera_call.R), xmap, ymap);
    }
    impl_->build(camera_call, src_size);
    impl_->x_map.copyTo(xmap);
    impl_->y_map.copyTo(ymap);
    return {impl_->roi.tl(), impl_->roi.br() - Point(1, 1)};
}

Point GcpwRotationWarper::warp(InputArray src, InputArray K, InputArray R, int interp_mode, int border_mode, OutputArray dst)
{
    const Call kind = impl_->kindOf(src.channels(), interp_mode, border_mode);
    const Impl::CameraCall camera_call = impl_->camera_call(K, R, kind);
    if (camera_call.index < 0)
    {
        checkRoi(impl_->base->warpRoi(src.size(), camera_call.K, Mat(camera_call.R)));
        return impl_->base->warp(src, camera_call.K, Mat(camera_call.R), interp_mode, border_mode, dst);
    }
    const Mat image = src.getMat();
    impl_->build(camera_call, image.size());
    dst.create(impl_->roi.size(), image.type());
    Mat picture = dst.getMat();
    remapTiled(image, picture, impl_->x_map, impl_->y_map, interp_mode, border_mode);
    // With these border modes the base warper fills all of its picture too: blenders mix what lies beyond the border.
    if (border_mode == BORDER_REFLECT || border_mode == BORDER_REFLECT_101 || border_mode == BORDER_REPLICATE)
        extendOutside(picture, (impl_->x_map != -1) | (impl_->y_map != -1));
    if (kind == Call::Mask)
        impl_->forgetMaps();
    return impl_->roi.tl();
}

Point GcpwRotationWarper::warpWithMask(InputArray src, InputArray mask, InputArray K, InputArray R, OutputArray dst,
                                       OutputArray dst_mask)
{
    const Mat image = src.getMat();
    if (mask.size() != image.size() || mask.type() != CV_8UC1)
        CV_Error(Error::StsUnmatchedSizes,
                 format("gcpw: warpWithMask() takes a mask of type CV_8UC1 and of the image's size, %d x %d px",
                        image.cols, image.rows));
    const Impl::CameraCall camera_call = impl_->camera_call(K, R, Call::Image);
    impl_->camera_call(K, R, Call::Mask);
    const Rect roi = impl_->roiOf(camera_call, image.size(), LARGEST_SIDE);
    dst.create(roi.size(), image.type());
    dst_mask.create(roi.size(), CV_8UC1);
    Mat picture = dst.getMat();
    Mat shown = dst_mask.getMat();
    Mat inside(roi.size(), CV_8UC1);
    if (camera_call.index < 0)
    {
        const BaseMaps base(*impl_->base, image.size(), camera_call.K, Mat(camera_call.R));
        warpStrips(
            image, mask.getMat(), [&](Rect part, Mat& x_map, Mat& y_map) { base.build(part, x_map, y_map); }, roi,
            picture, shown, inside);
        return roi.tl();
    }
    const WarpMaps warp = impl_->maps(camera_call);
    const BaseMaps base = warp.baseMaps(image.size());
    warpStrips(
        image, mask.getMat(), [&](Rect part, Mat& x_map, Mat& y_map) { warp.build(base, part, x_map, y_map); }, roi,
        picture, shown, inside);
    extendOutside(picture, inside);
    return roi.tl();
}

Rect GcpwRotationWarper::largeRoi(Size src_size, InputArray K, InputArray R)
{
    const Impl::CameraCall camera_call = impl_->camera_call(K, R, Call::Roi);
    return impl_->roiOf(camera_call, src_size, LARGEST_SIDE);
}

void GcpwRotationWarper::warpBackward(InputArray src, InputArray K, InputArray R, int interp_mode, int border_mode,
                              Size dst_size, OutputArray dst)
{
    const Impl::CameraCall camera_call = impl_->camera_call(K, R, Call::Image);
    if (camera_call.index < 0)
    {
        impl_->base->warpBackward(src, camera_call.K, Mat(camera_call.R), interp_mode, border_mode, dst_size, dst);
        return;
    }
    const WarpMaps warp = impl_->maps(camera_call);
    const Rect roi = warp.roi(dst_size);
    checkPicture(src.size(), roi.size());
    Mat x_map;
    Mat y_map;
    warp.buildForward(dst_size, roi.tl(), x_map, y_map);
    remap(src, dst, x_map, y_map, interp_mode, border_mode);
}

float GcpwRotationWarper::getScale() const
{
    return impl_->base->getScale();
}

void GcpwRotationWarper::setScale(float scale)
{
    impl_->base->setScale(scale);
}

} // namespace gcpw
} // namespace cv
