// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/pair.hpp"

#include <opencv2/imgproc.hpp>
#include "api/pair_view.hpp"
#include "api/result.hpp"
#include "api/shared_light.hpp"
#include "geometry/homography.hpp"
#include "imaging/photograph.hpp"
#include "imaging/score.hpp"
#include "model/color_grid.hpp"
#include "rendering/blend.hpp"
#include "rendering/color_field.hpp"
#include "rendering/inverse_map.hpp"
#include "rendering/mesh_overlay.hpp"
#include "rendering/remap_tiled.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double MAX_AREA = 4e8; ///< px: a larger canvas comes from a wrong alignment, and would exhaust the memory

/// Both images together, or an exception that names the size.
Rect canvasRect(const Rect2d& source, const Rect2d& target)
{
    const Rect2d roi = source | target;
    // In double: a mesh that ran away is wider than an int can say.
    if (!(roi.width <= MAX_REMAP_SIDE && roi.height <= MAX_REMAP_SIDE && roi.width * roi.height <= MAX_AREA))
        CV_Error(Error::StsOutOfRange,
                 format("gcpw: the canvas would be %.10g x %.10g px, more than %d px a side or %.0f Mpx; scale the photographs down",
                        roi.width, roi.height, MAX_REMAP_SIDE, MAX_AREA / 1e6));
    return roi;
}

/// A photograph on the full-resolution canvas of the target.
struct Placed
{
    Photograph photograph;
    MeshGrid mesh; ///< in work pixels of canvas and photograph
    FrameScale canvas;
    FrameScale scale; ///< work pixels per pixel of the photograph
};

/// The target's mesh says only that it is its own frame.
Placed placedTarget(const Photograph& target, const Lattice& quads)
{
    return {target, MeshGrid(Lattice(target.image.size(), quads.cols(), quads.rows())), FrameScale(), FrameScale()};
}

void checkView(View view)
{
    if (view != View::TARGET && view != View::NATURAL)
        CV_Error(Error::StsOutOfRange, format("gcpw: the view is %d; it must be one of gcpw::View", static_cast<int>(view)));
}

/// @param map receives where each pixel of the mask lies in the photograph
void warp(const Placed& placed, const CanvasView& view, Rect roi, Mat& image, Mat& mask, Mat& map)
{
    buildInverseMap(placed.mesh, placed.canvas, placed.scale, roi, map, mask, view);
    remapTiled(placed.photograph.image, image, map, Mat(), INTER_CUBIC, BORDER_REPLICATE);
    if (!placed.photograph.mask.empty())
    {
        Mat valid;
        remapTiled(placed.photograph.mask, valid, map, Mat(), INTER_NEAREST, BORDER_REPLICATE);
        mask &= valid;
    }
    image.setTo(Scalar::all(0), mask == 0);
}

/// The target where it is: without resampling.
void place(const Photograph& target, Rect place, Size canvas, Mat& image, Mat& mask)
{
    mask = Mat::zeros(canvas, CV_8UC1);
    mask(place).setTo(255);
    if (!target.mask.empty())
        target.mask.copyTo(mask(place));
    image = Mat::zeros(canvas, target.image.type());
    target.image.copyTo(image(place), mask(place));
}

/// Colours of the warped source; `map` says where each pixel of the mask lies in the photograph of `full_size`.
Mat corrected(const Mat& image, const Mat& mask, const Mat& map, const Mat& color, Size full_size)
{
    const float x_scale = static_cast<float>(color.cols) / static_cast<float>(full_size.width);
    const float y_scale = static_cast<float>(color.rows) / static_cast<float>(full_size.height);
    Mat result = image.clone();
    ColorField(color).apply(result, mask, [&](Point pixel)
    {
        const Vec2f& at = map.at<Vec2f>(pixel);
        return Point2f((at[0] + 0.5F) * x_scale, (at[1] + 0.5F) * y_scale);
    });
    return result;
}

/// Whether the method of the alignment corrects colours.
bool hasColors(const Alignment::Image& image)
{
    const Mat unchanged = ColorGrid(Lattice(image.work_size, image.color.cols, image.color.rows)).toMat();
    return norm(image.color, unchanged, NORM_INF) > 0;
}

void checkSize(const Mat& image, Size expected, const char* name)
{
    if (image.size() != expected)
        CV_Error(Error::StsUnmatchedSizes, format("gcpw: the %s image is %d x %d px but was aligned at %d x %d px", name,
                                                  image.cols, image.rows, expected.width, expected.height));
}

} // namespace

PairCanvas renderPair(const Alignment& alignment, InputArray source_input, InputArray target_input, View view)
{
    checkView(view);
    CV_CheckEQ(alignment.imageCount(), 2, "gcpw: renderPair() takes the result of a successful alignPair()");
    const Alignment::Image& image = alignment.image(0);
    const bool is_deep = source_input.depth() == CV_16U || target_input.depth() == CV_16U;
    const int depth = is_deep ? CV_16U : CV_8U;
    Placed source{toPhotograph(source_input, "source", depth), meshOf(image), FrameScale(),
                  FrameScale(image.work_size, image.full_size)};
    source.canvas.x = alignment.canvasScale().width;
    source.canvas.y = alignment.canvasScale().height;
    const Placed target = placedTarget(toPhotograph(target_input, "target", depth), source.mesh.lattice());
    checkSize(source.photograph.image, image.full_size, "source");
    checkSize(target.photograph.image, alignment.image(1).full_size, "target");
    const Size target_size = target.photograph.image.size();
    CanvasView shown;
    if (view == View::NATURAL)
        shown = pairView(viewed(meshOf(alignment.rough().image(0)), source.canvas, CanvasView()), source.photograph.image.size(), target_size);
    const Rect roi = canvasRect(viewedBounds(source.mesh, source.canvas, shown), viewedBounds(target.mesh, target.canvas, shown));

    PairCanvas canvas;
    Mat map;
    warp(source, shown, roi, canvas.source, canvas.source_mask, map);
    const bool shared_light = view == View::NATURAL && hasColors(image);
    if (!shared_light)
        canvas.source_corrected = corrected(canvas.source, canvas.source_mask, map, image.color, image.full_size);
    if (view == View::TARGET)
        place(target.photograph, {-roi.tl(), target_size}, roi.size(), canvas.target, canvas.target_mask);
    else
        warp(target, shown, roi, canvas.target, canvas.target_mask, map);
    canvas.target_corrected = canvas.target;
    if (shared_light)
        shareLight(canvas);
    const Point2d middle(0.5 * target_size.width, 0.5 * target_size.height);
    const Matx33d to_canvas = Matx33d(1, 0, -roi.x, 0, 1, -roi.y, 0, 0, 1) * shown.homographyAt(middle);
    canvas.canvas_from_target = Mat(to_canvas * (1 / to_canvas(2, 2)));
    canvas.target_origin = shown.show(Point2d()) - Point2d(roi.tl());

    canvas.mesh = toDepth(blendPair(canvas, Blend::AVERAGE), CV_8U);
    drawMesh(viewed(source.mesh, source.canvas, shown), FrameScale(), roi.tl(), canvas.mesh);
    return canvas;
}

Mat blendPair(const PairCanvas& canvas, Blend blend)
{
    CV_Assert(!canvas.source.empty() && canvas.source.size() == canvas.target.size());
    const TwoMasks masks{{canvas.source_mask, canvas.target_mask}};
    if (blend == Blend::AVERAGE)
        return blendAverage({{canvas.source, canvas.target}}, masks);
    const Mat& target = canvas.target_corrected.empty() ? canvas.target : canvas.target_corrected;
    return blendMultiband({{canvas.source_corrected, target}}, masks);
}

void blendPair(const PairCanvas& canvas, Blend blend, OutputArray picture)
{
    blendPair(canvas, blend).copyTo(picture);
}

Score scorePair(const PairCanvas& canvas)
{
    return scoreOverlap(toDepth(canvas.source, CV_8U), toDepth(canvas.target, CV_8U),
                        canvas.source_mask & canvas.target_mask);
}

bool stitchPair(InputArray source, InputArray target, OutputArray panorama, const Params& params, Blend blend, View view)
{
    checkView(view);
    const Alignment alignment = alignPair(source, target, params);
    if (alignment.report().status == Status::NO_ALIGNMENT)
        return false;
    blendPair(renderPair(alignment, source, target, view), blend, panorama);
    return true;
}

} // namespace gcpw
} // namespace cv
