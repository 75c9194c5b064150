// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include <opencv2/imgproc.hpp>
#include "color/color_correction.hpp"
#include "imaging/photograph.hpp"
#include "imaging/score.hpp"
#include "model/inverse_map.hpp"
#include "opencv2/gcpw/pair.hpp"
#include "pipeline/mesh_overlay.hpp"
#include "pipeline/result.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int MAX_SIDE = 32766;   ///< px: cv::remap takes no more
const double MAX_AREA = 4e8;  ///< px: a larger canvas comes from a wrong alignment, and would eat the memory
const int TILE = 1024;        ///< rows a remap call: bounds its temporaries

/// Both images together, or an exception that names the size.
Rect canvasRect(const MeshGrid& mesh, const FrameScale& scale, Size target)
{
    const Rect2d roi = coveredBounds(mesh, scale) | Rect2d(Point2d(), target);
    // In double: a mesh that ran away is wider than an int can say.
    if (!(roi.width <= MAX_SIDE && roi.height <= MAX_SIDE && roi.width * roi.height <= MAX_AREA))
        CV_Error(Error::StsOutOfRange,
                 format("gcpw: the canvas would be %.10g x %.10g px, more than %d px a side or %.0f Mpx; scale the photographs down",
                        roi.width, roi.height, MAX_SIDE, MAX_AREA / 1e6));
    return roi;
}

Mat remapped(const Mat& image, const Mat& map, int interpolation, int border)
{
    Mat result(map.size(), image.type());
    for (int top = 0; top < map.rows; top += TILE)
    {
        const Range rows(top, std::min(top + TILE, map.rows));
        Mat part = result.rowRange(rows);
        remap(image, part, map.rowRange(rows), noArray(), interpolation, border);
    }
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
    canvas.source = remapped(source.image, map, INTER_CUBIC, BORDER_REPLICATE);
    if (!source.mask.empty())
        canvas.source_mask &= remapped(source.mask, map, INTER_NEAREST, BORDER_REPLICATE);
    canvas.source.setTo(Scalar::all(0), canvas.source_mask == 0);
    canvas.source_corrected = correctColors(canvas.source, map, canvas.source_mask, image.color, image.full_size);

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

Score scorePair(const PairCanvas& canvas)
{
    return scoreOverlap(canvas.source, canvas.target, canvas.source_mask & canvas.target_mask);
}

bool stitchPair(InputArray source, InputArray target, OutputArray panorama, const Params& params, Blend blend)
{
    const Alignment alignment = alignPair(source, target, params);
    if (alignment.report().status == Status::NO_ALIGNMENT)
        return false;
    blendPair(renderPair(alignment, source, target), blend).copyTo(panorama);
    return true;
}

} // namespace gcpw
} // namespace cv
