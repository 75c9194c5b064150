// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "rendering/seam_cut.hpp"

#include <opencv2/imgproc.hpp>
#include <opencv2/stitching/detail/seam_finders.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const double RADIUS = 2;   ///< px, sigma: at 0.1 million pixels half a per cent of the diagonal
const double HUE = 0.5;    ///< of a squared difference of Cr and Cb, which is seen less than one of Y
const double SOBEL = 0.25; ///< turns Sobel's sum into gray levels over 2 px
/// px around what both share: OpenCV's graph cut looks there for what only one of them has.
const int GAP = 12;
const double GHOST = 12;  ///< gray levels, of a cut through a thing that the pictures show at different places
const int GHOST_SIZE = 5; ///< px: as far as patches of ghosts are apart, so that those of a thing leave no gap

/// The part of a picture in a rectangle of the canvas; shares its pixels.
PlacedPicture part(const PlacedPicture& picture, Rect where)
{
    const Rect inside = where & picture.rect();
    const Rect own = inside - picture.corner;
    return {picture.image(own), picture.mask(own), inside.tl()};
}

/// Where a cut would show a thing twice, or not at all: GHOST, else 0. As large as roi.
Mat ghostCost(const std::vector<Ghost>& ghosts, Rect roi)
{
    Mat cost = Mat::zeros(roi.size(), CV_32FC1);
    for (const Ghost& ghost : ghosts)
        line(cost, ghost.in_first - roi.tl(), ghost.in_second - roi.tl(), Scalar(GHOST), GHOST_SIZE);
    return cost;
}

} // namespace

Mat seamCost(const PlacedPicture& first, const PlacedPicture& second, Rect roi)
{
    const PlacedPicture a = part(first, roi);
    const PlacedPicture b = part(second, roi);
    Mat both;
    Mat(((a.mask != 0) & (b.mask != 0)) / 255).convertTo(both, CV_32F);
    Mat ycrcb[2];
    cvtColor(Mat(a.image * (1.0 / 255)), ycrcb[0], COLOR_BGR2YCrCb);
    cvtColor(Mat(b.image * (1.0 / 255)), ycrcb[1], COLOR_BGR2YCrCb);
    std::vector<Mat> difference;
    split(Mat((ycrcb[0] - ycrcb[1]) * 255), difference);
    for (Mat& channel : difference)
        channel = channel.mul(both); // hidden pixels have none, and no edge
    Mat cost =
        difference[0].mul(difference[0]) + HUE * (difference[1].mul(difference[1]) + difference[2].mul(difference[2]));
    for (const Point axis : {Point(1, 0), Point(0, 1)})
    {
        Mat slope;
        Sobel(difference[0], slope, CV_32F, axis.x, axis.y, 3, SOBEL);
        cost += slope.mul(slope);
    }
    Mat weight;
    GaussianBlur(cost, cost, Size(), RADIUS);
    GaussianBlur(both, weight, Size(), RADIUS);
    cost /= weight + 1e-6;
    sqrt(cost, cost);
    return cost.mul(both);
}

void cutBetween(PlacedPicture& first, PlacedPicture& second, const std::vector<Ghost>& ghosts)
{
    const Rect roi = first.rect() & second.rect();
    if (roi.empty())
        return;
    const Rect wide(roi.x - GAP, roi.y - GAP, roi.width + 2 * GAP, roi.height + 2 * GAP);
    const PlacedPicture parts[] = {part(first, wide), part(second, wide)};
    // The finder takes squared differences of pictures: of the cost and nothing.
    std::vector<UMat> pictures(2);
    std::vector<UMat> masks(2);
    std::vector<Point> corners(2);
    const Mat cost = seamCost(first, second, roi) + ghostCost(ghosts, roi);
    for (int i = 0; i < 2; ++i)
    {
        Mat picture = Mat::zeros(parts[i].image.size(), CV_32FC3);
        if (i == 0)
            cvtColor(cost, picture(roi - parts[i].corner), COLOR_GRAY2BGR);
        picture *= 1 / std::sqrt(3.0); // in each of three channels
        picture.copyTo(pictures[i]);
        parts[i].mask.copyTo(masks[i]);
        corners[i] = parts[i].corner;
    }
    cv::detail::GraphCutSeamFinder(cv::detail::GraphCutSeamFinderBase::COST_COLOR).find(pictures, corners, masks);
    masks[0].copyTo(parts[0].mask);
    masks[1].copyTo(parts[1].mask);
}

} // namespace gcpw
} // namespace cv
