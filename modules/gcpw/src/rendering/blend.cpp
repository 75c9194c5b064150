// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "rendering/blend.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/stitching/detail/blenders.hpp>
#include "rendering/extension.hpp"
#include "rendering/seam_cut.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double GHOST_MEGAPIX = 0.2; ///< shows signs and lamp posts, which are a few pixels wide there
const int BANDS = 5;
/// The blender adds up weighted values of two pictures in 15 bits and a sign, and rounds downwards in every band: it gets 13 bits, of
/// which nothing of that is seen in 8.
const double BYTES_TO_13 = 32;
const double DEEP_TO_13 = 1 / 8.0;

/// Both pictures, reduced to a number of pixels.
std::array<PlacedPicture, 2> reduced(const TwoImages& images, const TwoMasks& masks, double megapix)
{
    const Size full = images[0].size();
    const double scale = std::min(1.0, std::sqrt(megapix * 1e6 / static_cast<double>(images[0].total())));
    const Size size(std::max(cvRound(full.width * scale), 1), std::max(cvRound(full.height * scale), 1));
    std::array<PlacedPicture, 2> small;
    for (int i = 0; i < 2; ++i)
    {
        Mat image;
        resize(images[i], image, size, 0, 0, INTER_AREA);
        image.convertTo(small[i].image, CV_32F, image.depth() == CV_16U ? 1 / 257.0 : 1.0);
        resize(masks[i], small[i].mask, size, 0, 0, INTER_NEAREST);
    }
    return small;
}

/// Splits the overlap between the images where they differ least; returns what each of them keeps.
std::array<Mat, 2> cutSeam(const TwoImages& images, const TwoMasks& masks)
{
    std::array<PlacedPicture, 2> small = reduced(images, masks, SEAM_MEGAPIX);
    const std::array<PlacedPicture, 2> larger = reduced(images, masks, GHOST_MEGAPIX);
    const Size full = images[0].size();
    const double x_scale = static_cast<double>(small[0].image.cols) / larger[0].image.cols;
    const double y_scale = static_cast<double>(small[0].image.rows) / larger[0].image.rows;
    std::vector<Ghost> ghosts = findGhosts(larger[0], larger[1]);
    for (Ghost& ghost : ghosts)
        for (Point* place : {&ghost.in_first, &ghost.in_second})
            *place = Point(cvFloor((place->x + 0.5) * x_scale), cvFloor((place->y + 0.5) * y_scale));
    cutBetween(small[0], small[1], ghosts);
    // As cv::Stitcher does: a little wider than the seam, so that every pixel belongs to one of them.
    std::array<Mat, 2> kept;
    for (int i = 0; i < 2; ++i)
    {
        Mat mask;
        dilate(small[i].mask, mask, Mat());
        resize(mask, mask, full, 0, 0, INTER_LINEAR);
        kept[i] = masks[i] & (mask > 0);
    }
    return kept;
}

} // namespace

Mat blendAverage(const TwoImages& images, const TwoMasks& masks)
{
    Mat panorama;
    addWeighted(images[0], 0.5, images[1], 0.5, 0, panorama);
    images[0].copyTo(panorama, masks[1] == 0);
    images[1].copyTo(panorama, masks[0] == 0);
    return panorama;
}

Mat blendMultiband(const TwoImages& images, const TwoMasks& masks)
{
    const std::array<Mat, 2> kept = cutSeam(images, masks);
    const double scale = images[0].depth() == CV_16U ? DEEP_TO_13 : BYTES_TO_13;
    cv::detail::MultiBandBlender blender(false, BANDS);
    blender.prepare(Rect(Point(), images[0].size()));
    for (int i = 0; i < 2; ++i)
    {
        Mat wide;
        images[i].convertTo(wide, CV_16S, scale);
        extendOutside(wide, masks[i]);
        blender.feed(wide, kept[i], Point());
    }
    Mat blended;
    Mat covered;
    blender.blend(blended, covered);
    Mat panorama;
    blended.convertTo(panorama, images[0].depth(), 1 / scale);
    panorama.setTo(Scalar::all(0), (masks[0] | masks[1]) == 0);
    return panorama;
}

} // namespace gcpw
} // namespace cv
