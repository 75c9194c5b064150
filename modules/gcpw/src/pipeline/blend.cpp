// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/stitching/detail/blenders.hpp>
#include <opencv2/stitching/detail/seam_finders.hpp>
#include "imaging/extension.hpp"
#include "opencv2/gcpw/pair.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double SEAM_MEGAPIX = 0.1; ///< graph cut takes seconds at more, and a seam needs no more
const int BANDS = 5;

Mat blendAverage(const PairCanvas& canvas)
{
    Mat panorama;
    addWeighted(canvas.source, 0.5, canvas.target, 0.5, 0, panorama);
    canvas.source.copyTo(panorama, canvas.target_mask == 0);
    canvas.target.copyTo(panorama, canvas.source_mask == 0);
    return panorama;
}

/// Splits the overlap between the images where they differ least; returns what each of them keeps.
std::vector<Mat> cutSeam(const Mat (&images)[2], const Mat (&masks)[2])
{
    const Size full = images[0].size();
    const double scale = std::min(1.0, std::sqrt(SEAM_MEGAPIX * 1e6 / static_cast<double>(images[0].total())));
    const Size size(std::max(cvRound(full.width * scale), 1), std::max(cvRound(full.height * scale), 1));
    std::vector<UMat> small(2);
    std::vector<UMat> cut(2);
    for (int i = 0; i < 2; ++i)
    {
        Mat image;
        Mat mask;
        resize(images[i], image, size, 0, 0, INTER_AREA);
        resize(masks[i], mask, size, 0, 0, INTER_NEAREST);
        image.convertTo(small[i], CV_32F);
        mask.copyTo(cut[i]);
    }
    cv::detail::GraphCutSeamFinder finder(cv::detail::GraphCutSeamFinderBase::COST_COLOR_GRAD);
    finder.find(small, {Point(), Point()}, cut);
    // As cv::Stitcher does: a little wider than the seam, so that no pixel is left to neither.
    std::vector<Mat> kept(2);
    for (int i = 0; i < 2; ++i)
    {
        Mat mask;
        dilate(cut[i], mask, Mat());
        resize(mask, mask, full, 0, 0, INTER_LINEAR);
        kept[i] = masks[i] & (mask > 0);
    }
    return kept;
}

Mat blendMultiband(const PairCanvas& canvas)
{
    const Mat images[2] = {canvas.source_corrected, canvas.target};
    const Mat masks[2] = {canvas.source_mask, canvas.target_mask};
    const std::vector<Mat> kept = cutSeam(images, masks);
    cv::detail::MultiBandBlender blender(false, BANDS);
    blender.prepare(Rect(Point(), images[0].size()));
    for (int i = 0; i < 2; ++i)
    {
        Mat wide;
        images[i].convertTo(wide, CV_16S);
        extendOutside(wide, masks[i]);
        blender.feed(wide, kept[i], Point());
    }
    Mat blended;
    Mat covered;
    blender.blend(blended, covered);
    Mat panorama;
    blended.convertTo(panorama, CV_8U);
    panorama.setTo(Scalar::all(0), (masks[0] | masks[1]) == 0);
    return panorama;
}

} // namespace

Mat blendPair(const PairCanvas& canvas, Blend blend)
{
    CV_Assert(!canvas.source.empty() && canvas.source.size() == canvas.target.size());
    return blend == Blend::AVERAGE ? blendAverage(canvas) : blendMultiband(canvas);
}

} // namespace gcpw
} // namespace cv
