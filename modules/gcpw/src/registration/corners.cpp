// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "registration/corners.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const int BLOCK = 5;  ///< px: neighbourhood of the gradient products; smaller ones find noise
const int BORDER = 3; ///< px next to the image's border where gradients are extrapolated
/// Least eigenvalue of a corner as cornerMinEigenVal() has it, gray levels in [0, 1]: about twice what noise of two gray levels makes.
const float LEAST_RESPONSE = 1e-5F;

/// Whether no neighbour is stronger; of equals the first.
bool isPeak(const Mat& response, Point p)
{
    const float mine = response.at<float>(p);
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
        {
            const float other = response.at<float>(p + Point(dx, dy));
            if (other > mine || (other == mine && (dy < 0 || (dy == 0 && dx < 0))))
                return false;
        }
    return true;
}

} // namespace

std::vector<Point> findCorners(const Mat& gray, const Mat& mask, int spacing)
{
    CV_CheckGT(spacing, 0, "Squares of corners need a side");
    std::vector<Point> corners;
    const Rect inside(BORDER, BORDER, gray.cols - 2 * BORDER, gray.rows - 2 * BORDER);
    if (inside.width < 1 || inside.height < 1)
        return corners;
    Mat response;
    cornerMinEigenVal(gray, response, BLOCK);
    Mat valid = mask;
    if (!mask.empty()) // gradients and block see this far
        erode(mask, valid, getStructuringElement(MORPH_RECT, Size(2 * BORDER + 1, 2 * BORDER + 1)));
    for (int top = inside.y; top < inside.br().y; top += spacing)
        for (int left = inside.x; left < inside.br().x; left += spacing)
        {
            const Rect square = Rect(left, top, spacing, spacing) & inside;
            Point best;
            float strongest = LEAST_RESPONSE;
            for (int y = square.y; y < square.br().y; ++y)
            {
                const float* row = response.ptr<float>(y);
                for (int x = square.x; x < square.br().x; ++x)
                    if (row[x] > strongest && (valid.empty() || valid.at<uchar>(y, x) != 0) &&
                        isPeak(response, Point(x, y)))
                    {
                        strongest = row[x];
                        best = Point(x, y);
                    }
            }
            if (strongest > LEAST_RESPONSE)
                corners.push_back(best);
        }
    return corners;
}

} // namespace gcpw
} // namespace cv
