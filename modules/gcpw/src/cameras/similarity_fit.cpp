// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "cameras/similarity_fit.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

const double LOSS_PX = 4; ///< of the robust loss, pixels of a photograph
const int ROUNDS = 30;    ///< of reweighting; weights stand still before
const int UNKNOWNS = 4;   ///< of an image: s, t, u, v

/// A match's position in the unknowns of one image: two rows.
Matx<double, 2, UNKNOWNS> rowsOf(Point2f p)
{
    return {p.x, -p.y, 1, 0, p.y, p.x, 0, 1};
}

Vec4d partOf(const Mat& solution, int image)
{
    return {solution.at<double>(UNKNOWNS * image), solution.at<double>(UNKNOWNS * image + 1),
            solution.at<double>(UNKNOWNS * image + 2), solution.at<double>(UNKNOWNS * image + 3)};
}

double scaleOf(const Vec4d& similarity)
{
    return std::hypot(similarity[0], similarity[1]);
}

/// The image with the most matches.
int anchorOf(size_t count, const std::vector<Link>& links)
{
    std::vector<size_t> matches(count, 0);
    for (const Link& link : links)
    {
        matches[link.a] += link.points_a.size();
        matches[link.b] += link.points_a.size();
    }
    return static_cast<int>(std::max_element(matches.begin(), matches.end()) - matches.begin());
}

void add(Mat& normal, int a, int b, const Matx44d& block)
{
    for (int r = 0; r < UNKNOWNS; ++r)
        for (int c = 0; c < UNKNOWNS; ++c)
            normal.at<double>(UNKNOWNS * a + r, UNKNOWNS * b + c) += block(r, c);
}

/// Solves at the weights that the last solution gives; all are 1 without one. False if not all images are held.
bool solveOnce(size_t count, const std::vector<Link>& links, int anchor, Mat& solution)
{
    const int unknowns = UNKNOWNS * static_cast<int>(count);
    Mat normal = Mat::zeros(unknowns, unknowns, CV_64F);
    for (const Link& link : links)
        for (size_t k = 0; k < link.points_a.size(); ++k)
        {
            const Matx<double, 2, UNKNOWNS> in_a = rowsOf(link.points_a[k]);
            const Matx<double, 2, UNKNOWNS> in_b = rowsOf(link.points_b[k]);
            double weight = 1;
            if (!solution.empty())
            {
                const Vec4d a = partOf(solution, link.a);
                const Vec4d b = partOf(solution, link.b);
                const Vec2d miss = in_a * a - in_b * b;
                const double scale2 = std::max(scaleOf(a) * scaleOf(b), 1e-12);
                weight = 1 / scale2 / (1 + miss.dot(miss) / (scale2 * LOSS_PX * LOSS_PX));
            }
            add(normal, link.a, link.a, weight * (in_a.t() * in_a));
            add(normal, link.b, link.b, weight * (in_b.t() * in_b));
            const Matx44d mixed = -weight * (in_a.t() * in_b);
            add(normal, link.a, link.b, mixed);
            add(normal, link.b, link.a, mixed.t());
        }
    // The anchor is the identity: its unknowns become right-hand sides.
    Mat right = -normal.col(UNKNOWNS * anchor);
    for (int r = UNKNOWNS * anchor; r < UNKNOWNS * (anchor + 1); ++r)
    {
        normal.row(r).setTo(0);
        normal.col(r).setTo(0);
        normal.at<double>(r, r) = 1;
        right.at<double>(r) = r == UNKNOWNS * anchor ? 1 : 0;
    }
    return solve(normal, right, solution, DECOMP_CHOLESKY);
}

} // namespace

bool fitSimilarities(const std::vector<Size>& sizes, const std::vector<Link>& links,
                     std::vector<Matx33d>& canvas_from_image)
{
    const size_t count = sizes.size();
    const int anchor = anchorOf(count, links);
    Mat solution;
    for (int round = 0; round < ROUNDS; ++round)
        if (!solveOnce(count, links, anchor, solution) || !checkRange(solution))
            return false;
    double log_scale = 0;
    for (size_t i = 0; i < count; ++i)
        log_scale += std::log(std::max(scaleOf(partOf(solution, static_cast<int>(i))), 1e-12));
    const double unit = std::exp(-log_scale / static_cast<double>(count));
    canvas_from_image.clear();
    for (size_t i = 0; i < count; ++i)
    {
        const Vec4d s = partOf(solution, static_cast<int>(i)) * unit;
        canvas_from_image.emplace_back(s[0], -s[1], s[2], s[1], s[0], s[3], 0, 0, 1);
    }
    return true;
}

} // namespace gcpw
} // namespace cv
