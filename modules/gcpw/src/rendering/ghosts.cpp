// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "rendering/ghosts.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const int HALF = 4;             ///< px, of a patch: at 0.1 million pixels the smallest thing that one notices
const int PATCH = 2 * HALF + 1; ///< px
const int STEP = 5;             ///< px between patches: they overlap by half
const double REACH = 0.15;      ///< of the longer side of a picture: nearer things than that fill it
const double CONTRAST = 8;      ///< gray levels, deviation of a patch: more than noise
/// Squared gray levels per px, mean of a patch: eigenvalues of the structure tensor of a line, and of a point.
const double EDGE = 12;
const double POINT = 6;
const double PER_PX = 0.25; ///< makes that mean of OpenCV's tensor, whose Sobel sums are divided by 4 PATCH
const double AGREES = 0.6;  ///< correlation from which on a patch may be what lies there, in other light or turned
const double FOUND = 0.85;  ///< correlation of the same thing
const double RIVAL = 0.05;  ///< less than what is found: it could as well be there
const int LEEWAY = 3;       ///< px around what is found, in which rivals are the same peak; ghosts are further away
const int BACK = 1;         ///< px, of the way back
const double NEAR = 22;     ///< px, of neighbours: four steps
const int ALLIES = 3;       ///< neighbours that move alike; false finds have none
const double ALIKE = 0.15;  ///< of the distance, and LEEWAY at least

/// What the search needs of a picture, over a part of the canvas; 0 outside the picture.
struct Side
{
    Mat gray;      ///< CV_32FC1
    Mat whole;     ///< CV_8UC1: the patch around a pixel lies inside
    Mat deviation; ///< CV_32FC1: norm of the patch less its mean
    Mat tensor;    ///< CV_32FC6, cv::cornerEigenValsAndVecs()

    Side(const PlacedPicture& picture, Rect canvas)
    {
        const Rect inside = canvas & picture.rect();
        gray = Mat::zeros(canvas.size(), CV_32FC1);
        whole = Mat::zeros(canvas.size(), CV_8UC1);
        cvtColor(picture.image(inside - picture.corner), gray(inside - canvas.tl()), COLOR_BGR2GRAY);
        Mat(picture.mask(inside - picture.corner) != 0).copyTo(whole(inside - canvas.tl()));
        gray.setTo(0, whole == 0);
        erode(whole, whole, Mat::ones(PATCH, PATCH, CV_8UC1), Point(-1, -1), 1, BORDER_CONSTANT, Scalar(0));
        Mat mean;
        Mat square;
        boxFilter(gray, mean, CV_64F, Size(PATCH, PATCH));
        sqrBoxFilter(gray, square, CV_64F, Size(PATCH, PATCH), Point(-1, -1), false);
        square -= PATCH * PATCH * mean.mul(mean);
        sqrt(cv::max(square, 0.0), square);
        square.convertTo(deviation, CV_32F);
        cornerEigenValsAndVecs(gray, tensor, PATCH, 3);
    }
};

/// Where a patch is to be searched, and how.
struct Patch
{
    Point place;
    Vec2d across;  ///< unit vector, the edge's normal
    bool is_point; ///< has texture in both directions

    /// How far apart two places are for this patch, px: along an edge nothing tells.
    double distance(Point d) const
    {
        return is_point ? std::max(std::abs(d.x), std::abs(d.y)) : std::abs(across.dot(Vec2d(d.x, d.y)));
    }
};

/// @return false if there is too little texture
bool patchAt(const Side& side, Point place, Patch& patch)
{
    const auto& t = side.tensor.at<Vec6f>(place);
    const double larger = std::max(t[0], t[1]) * PER_PX;
    const double smaller = std::min(t[0], t[1]) * PER_PX;
    const int k = t[0] >= t[1] ? 2 : 4;
    patch = {place, Vec2d(t[k], t[k + 1]), smaller >= POINT};
    return larger >= EDGE && side.deviation.at<float>(place) >= CONTRAST * PATCH;
}

/// All within a distance of a place, px.
Rect square(Point place, int distance)
{
    return {place.x - distance, place.y - distance, 2 * distance + 1, 2 * distance + 1};
}

/// Correlation of a patch with another picture's, at every place of a window; -1 where that has none.
Mat correlate(const Side& from, Point place, const Side& to, Rect window)
{
    const Mat patch = from.gray(square(place, HALF));
    const Mat kernel = (patch - mean(patch)) / from.deviation.at<float>(place);
    Mat correlation;
    filter2D(to.gray(window), correlation, CV_32F, kernel);
    correlation /= to.deviation(window) + 1e-3;
    correlation.setTo(-1, to.whole(window) == 0);
    return correlation;
}

/// Whether a patch has texture and what the other picture has in its place is something else.
bool disagrees(const Side& from, Point place, const Side& to, Patch& patch)
{
    // Only what both have can be there twice, or nowhere.
    if (!from.whole.at<uchar>(place) || !to.whole.at<uchar>(place) || !patchAt(from, place, patch))
        return false;
    double here = -1;
    const Mat around = correlate(from, place, to, square(place, 1) & Rect(Point(), to.gray.size()));
    minMaxLoc(around, nullptr, &here);
    return here <= AGREES;
}

/// Where a patch is found; false if nowhere, or at several places.
bool search(const Side& from, const Patch& patch, const Side& to, int reach, Point& found)
{
    if (!from.whole.at<uchar>(patch.place))
        return false;
    const Rect window = square(patch.place, reach) & Rect(Point(), to.gray.size());
    const Mat correlation = correlate(from, patch.place, to, window);
    double best = -1;
    Point peak;
    minMaxLoc(correlation, nullptr, &best, nullptr, &peak);
    if (best < FOUND)
        return false;
    for (int y = 0; y < correlation.rows; ++y)
    {
        const float* row = correlation.ptr<float>(y);
        for (int x = 0; x < correlation.cols; ++x)
            if (row[x] > best - RIVAL && patch.distance(Point(x, y) - peak) > LEEWAY)
                return false;
    }
    found = peak + window.tl();
    return true;
}

/// Ghosts of one row of patches of a picture, as (in from, in to), by search without a hint.
void searchRow(const Side& from, const Side& to, int y, int reach, std::vector<Ghost>& ghosts)
{
    for (int x = reach + HALF; x < from.gray.cols - reach - HALF; x += STEP)
    {
        Patch patch;
        Point there;
        Point back;
        if (!disagrees(from, Point(x, y), to, patch) || !search(from, patch, to, reach, there))
            continue;
        Patch other = patch;
        other.place = there;
        if (!search(to, other, from, reach, back) || patch.distance(back - patch.place) > BACK)
            continue;
        Point move = there - patch.place;
        if (!patch.is_point)
        {
            const Vec2d shift = patch.across * patch.across.dot(Vec2d(move.x, move.y));
            move = Point(cvRound(shift[0]), cvRound(shift[1]));
        }
        if (move.dot(move) > LEEWAY * LEEWAY)
            ghosts.push_back({patch.place, patch.place + move});
    }
}

/// Drops those whose neighbours say otherwise.
std::vector<Ghost> agreeing(const std::vector<Ghost>& ghosts)
{
    std::vector<Ghost> kept;
    for (const Ghost& ghost : ghosts)
    {
        const Point move = ghost.in_second - ghost.in_first;
        const double leeway = std::max<double>(LEEWAY, ALIKE * norm(move));
        const auto ally = [&](const Ghost& other) {
            return norm(other.in_first - ghost.in_first) < NEAR &&
                   norm(other.in_second - other.in_first - move) < leeway;
        };
        if (std::count_if(ghosts.begin(), ghosts.end(), ally) > ALLIES) // it is its own, too
            kept.push_back(ghost);
    }
    return kept;
}

} // namespace

std::vector<Ghost> findGhosts(const PlacedPicture& first, const PlacedPicture& second)
{
    const Rect shared = first.rect() & second.rect();
    if (shared.empty())
        return {};
    const Size a = first.image.size();
    const Size b = second.image.size();
    const int reach = cvRound(REACH * std::max({a.width, a.height, b.width, b.height}));
    const int margin = reach + HALF;
    const Rect canvas(shared.x - margin, shared.y - margin, shared.width + 2 * margin, shared.height + 2 * margin);
    const Side sides[] = {Side(first, canvas), Side(second, canvas)};
    const int rows = std::max(shared.height / STEP, 1);
    std::vector<std::vector<Ghost>> found(static_cast<size_t>(2) * rows);
    parallel_for_(Range(0, 2 * rows),
                  [&](const Range& range)
                  {
        for (int i = range.start; i < range.end; ++i)
            searchRow(sides[i / rows], sides[1 - i / rows], margin + i % rows * STEP, reach, found[i]);
    });
    const auto swapped = [](Ghost ghost)
    {
        std::swap(ghost.in_first, ghost.in_second);
        return ghost;
    };
    std::vector<Ghost> ghosts;
    for (int i = 0; i < 2 * rows; ++i)
        for (const Ghost& ghost : found[i])
            ghosts.push_back(i < rows ? ghost : swapped(ghost));
    ghosts = agreeing(ghosts);
    for (Ghost& ghost : ghosts)
        ghost = {ghost.in_first + canvas.tl(), ghost.in_second + canvas.tl()};
    return ghosts;
}

} // namespace gcpw
} // namespace cv
