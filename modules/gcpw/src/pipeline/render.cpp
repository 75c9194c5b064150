// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include <opencv2/imgproc.hpp>
#include <opencv2/stitching/detail/blenders.hpp>
#include <opencv2/stitching/detail/seam_finders.hpp>
#include "imaging/photograph.hpp"
#include "imaging/score.hpp"
#include "model/color_grid.hpp"
#include "model/inverse_map.hpp"
#include "opencv2/gcpw/pair.hpp"
#include "pipeline/result.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

/// Gain and bias per pixel, read at the source position each canvas pixel shows.
Mat applyColor(const Mat& warped, const Mat& map, const Mat& mask, const Mat& color, Size full)
{
    Mat ycrcb;
    cvtColor(warped, ycrcb, COLOR_BGR2YCrCb);
    const double sx = static_cast<double>(color.cols) / full.width;
    const double sy = static_cast<double>(color.rows) / full.height;
    Mat grid_map(map.size(), CV_32FC2);
    for (int y = 0; y < map.rows; ++y)
        for (int x = 0; x < map.cols; ++x)
        {
            const Vec2f p = map.at<Vec2f>(y, x);
            grid_map.at<Vec2f>(y, x) = Vec2f(static_cast<float>((p[0] + 0.5) * sx - 0.5), static_cast<float>((p[1] + 0.5) * sy - 0.5));
        }
    std::vector<Mat> planes;
    split(color, planes);
    Mat result = warped.clone();
    Mat corrected(warped.size(), CV_8UC3);
    Mat gains;
    Mat biases;
    Mat gain_grid;
    Mat bias_grid;
    merge(std::vector<Mat>(planes.begin(), planes.begin() + 3), gain_grid);
    merge(std::vector<Mat>(planes.begin() + 3, planes.end()), bias_grid);
    remap(gain_grid, gains, grid_map, noArray(), INTER_LINEAR, BORDER_REPLICATE);
    remap(bias_grid, biases, grid_map, noArray(), INTER_LINEAR, BORDER_REPLICATE);
    for (int y = 0; y < warped.rows; ++y)
        for (int x = 0; x < warped.cols; ++x)
        {
            const Vec3b in = ycrcb.at<Vec3b>(y, x);
            const Vec3f g = gains.at<Vec3f>(y, x);
            const Vec3f b = biases.at<Vec3f>(y, x);
            Vec3b& out = corrected.at<Vec3b>(y, x);
            for (int c = 0; c < 3; ++c)
                out[c] = saturate_cast<uchar>(g[c] * in[c] + 255 * b[c]);
        }
    cvtColor(corrected, corrected, COLOR_YCrCb2BGR);
    corrected.copyTo(result, mask);
    return result;
}

} // namespace

PairCanvas renderPair(const Alignment& alignment, InputArray source_input, InputArray target_input)
{
    const Photograph source = toPhotograph(source_input, "source");
    const Photograph target = toPhotograph(target_input, "target");
    const Alignment::Image& image = alignment.image(0);
    CV_Assert(source.image.size() == image.full_size && target.image.size() == alignment.image(1).full_size);
    const MeshGrid mesh = meshOf(image);
    FrameScale canvas_scale;
    canvas_scale.x = alignment.canvasScale().width;
    canvas_scale.y = alignment.canvasScale().height;
    const FrameScale source_scale(image.work_size, image.full_size);
    const Rect target_rect(Point(), target.image.size());
    const Rect roi = coveredRect(mesh, canvas_scale) | target_rect;
    CV_Assert(roi.width < 32767 && roi.height < 32767 && static_cast<double>(roi.width) * roi.height < 4e8);
    PairCanvas canvas;
    Mat map;
    buildInverseMap(mesh, canvas_scale, source_scale, roi, map, canvas.source_mask);
    remap(source.image, canvas.source, map, noArray(), INTER_CUBIC, BORDER_REPLICATE);
    canvas.source.setTo(Scalar::all(0), canvas.source_mask == 0);
    if (!source.mask.empty())
    {
        Mat valid;
        remap(source.mask, valid, map, noArray(), INTER_NEAREST, BORDER_CONSTANT);
        canvas.source_mask &= valid;
    }
    canvas.source_corrected = applyColor(canvas.source, map, canvas.source_mask, image.color, image.full_size);
    canvas.target_origin = -roi.tl();
    canvas.target = Mat::zeros(roi.size(), CV_8UC3);
    canvas.target_mask = Mat::zeros(roi.size(), CV_8UC1);
    const Rect place = target_rect - roi.tl();
    target.image.copyTo(canvas.target(place));
    if (target.mask.empty())
        canvas.target_mask(place).setTo(255);
    else
        target.mask.copyTo(canvas.target_mask(place));
    return canvas;
}

Mat blendPair(const PairCanvas& canvas, Blend blend)
{
    Mat panorama;
    if (blend == Blend::AVERAGE)
    {
        addWeighted(canvas.source, 0.5, canvas.target, 0.5, 0, panorama);
        canvas.source.copyTo(panorama, canvas.target_mask == 0);
        canvas.target.copyTo(panorama, canvas.source_mask == 0);
        return panorama;
    }
    std::vector<UMat> images(2);
    std::vector<UMat> masks(2);
    canvas.source_corrected.convertTo(images[0], CV_32F);
    canvas.target.convertTo(images[1], CV_32F);
    canvas.source_mask.copyTo(masks[0]);
    canvas.target_mask.copyTo(masks[1]);
    cv::detail::GraphCutSeamFinder(cv::detail::GraphCutSeamFinderBase::COST_COLOR_GRAD).find(images, {Point(), Point()}, masks);
    cv::detail::MultiBandBlender blender(false, 5);
    blender.prepare(Rect(Point(), canvas.target.size()));
    for (int i = 0; i < 2; ++i)
    {
        Mat image;
        images[i].getMat(ACCESS_READ).convertTo(image, CV_16S);
        blender.feed(image, masks[i], Point());
    }
    Mat result;
    Mat mask;
    blender.blend(result, mask);
    result.convertTo(panorama, CV_8U);
    return panorama;
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
