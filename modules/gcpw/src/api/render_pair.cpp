// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/pair.hpp"

#include <opencv2/imgproc.hpp>
#include "api/result.hpp"
#include "imaging/photograph.hpp"
#include "imaging/score.hpp"
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
Rect canvasRect(const MeshGrid& mesh, const FrameScale& scale, Size target)
{
    const Rect2d roi = coveredBounds(mesh, scale) | Rect2d(Point2d(), target);
    // In double: a mesh that ran away is wider than an int can say.
    if (!(roi.width <= MAX_REMAP_SIDE && roi.height <= MAX_REMAP_SIDE && roi.width * roi.height <= MAX_AREA))
        CV_Error(Error::StsOutOfRange,
                 format("gcpw: the canvas would be %.10g x %.10g px, more than %d px a side or %.0f Mpx; scale the photographs down",
                        roi.width, roi.height, MAX_REMAP_SIDE, MAX_AREA / 1e6));
    return roi;
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

void checkSize(const Mat& image, Size expected, const char* name)
{
    if (image.size() != expected)
        CV_Error(Error::StsUnmatchedSizes, format("gcpw: the %s image is %d x %d px but was aligned at %d x %d px", name,
                                                  image.cols, image.rows, expected.width, expected.height));
}

} // namespace

PairCanvas renderPair(const Alignment& alignment, InputArray source_input, InputArray target_input)
{
    CV_CheckEQ(alignment.imageCount(), 2, "gcpw: renderPair() takes the result of a successful alignPair()");
    const Photograph source = toPhotograph(source_input, "source");
    const Photograph target = toPhotograph(target_input, "target");
    const Alignment::Image& image = alignment.image(0);
    checkSize(source.image, image.full_size, "source");
    checkSize(target.image, alignment.image(1).full_size, "target");
    FrameScale canvas_scale;
    canvas_scale.x = alignment.canvasScale().width;
    canvas_scale.y = alignment.canvasScale().height;
    const MeshGrid mesh = meshOf(image);
    const Rect roi = canvasRect(mesh, canvas_scale, target.image.size());

    PairCanvas canvas;
    Mat map;
    buildInverseMap(mesh, canvas_scale, FrameScale(image.work_size, image.full_size), roi, map, canvas.source_mask);
    remapTiled(source.image, canvas.source, map, Mat(), INTER_CUBIC, BORDER_REPLICATE);
    if (!source.mask.empty())
    {
        Mat valid;
        remapTiled(source.mask, valid, map, Mat(), INTER_NEAREST, BORDER_REPLICATE);
        canvas.source_mask &= valid;
    }
    canvas.source.setTo(Scalar::all(0), canvas.source_mask == 0);
    canvas.source_corrected = corrected(canvas.source, canvas.source_mask, map, image.color, image.full_size);

    canvas.target_origin = -roi.tl();
    const Rect place(canvas.target_origin, target.image.size());
    canvas.target_mask = Mat::zeros(roi.size(), CV_8UC1);
    canvas.target_mask(place).setTo(255);
    if (!target.mask.empty())
        target.mask.copyTo(canvas.target_mask(place));
    canvas.target = Mat::zeros(roi.size(), CV_8UC3);
    target.image.copyTo(canvas.target(place), canvas.target_mask(place));

    canvas.mesh = blendPair(canvas, Blend::AVERAGE);
    drawMesh(mesh, canvas_scale, roi.tl(), canvas.mesh);
    return canvas;
}

Mat blendPair(const PairCanvas& canvas, Blend blend)
{
    CV_Assert(!canvas.source.empty() && canvas.source.size() == canvas.target.size());
    const TwoMasks masks{{canvas.source_mask, canvas.target_mask}};
    return blend == Blend::AVERAGE ? blendAverage({{canvas.source, canvas.target}}, masks)
                                   : blendMultiband({{canvas.source_corrected, canvas.target}}, masks);
}

void blendPair(const PairCanvas& canvas, Blend blend, OutputArray picture)
{
    blendPair(canvas, blend).copyTo(picture);
}

Score scorePair(const PairCanvas& canvas)
{
    return scoreOverlap(canvas.source, canvas.target, canvas.source_mask & canvas.target_mask);
}

bool stitchPair(InputArray source, InputArray target, OutputArray panorama, const Params& params, Blend blend)
{
    const Alignment alignment = alignPair(source, target, params);
    if (alignment.report().status == Status::NO_ALIGNMENT)
        return false;
    blendPair(renderPair(alignment, source, target), blend, panorama);
    return true;
}

} // namespace gcpw
} // namespace cv
