// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <limits>
#include "refusal.hpp"
#include "scene.hpp"

namespace opencv_test
{
namespace
{

using namespace cv::gcpw;

const double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
const double ENDLESS = std::numeric_limits<double>::infinity();

/// Matches of two equal images, a caller's own, with nothing wrong.
PairMatches goodMatches(Size size)
{
    PairMatches matches;
    matches.source_size = matches.target_size = size;
    for (int y = 8; y < size.height; y += 16)
        for (int x = 8; x < size.width; x += 16)
        {
            matches.source_points.emplace_back(x, y);
            matches.target_points.emplace_back(x, y);
        }
    for (int y = 10; y < size.height; y += 30)
    {
        matches.source_lines.emplace_back(5, y, size.width - 5, y);
        matches.target_lines.emplace_back(5, y, size.width - 5, y);
        matches.line_weights.push_back(1);
    }
    return matches;
}

class Gcpw_MatchCheck : public ::testing::Test
{
protected:
    void expectRefused(const PairMatches& bad, const std::string& part) const
    {
        opencv_test::expectRefused([&] { alignPair(image, image, bad); }, part);
    }

    Mat image = Scene(smallScene()).source();
    PairMatches matches = goodMatches(image.size());
};

TEST_F(Gcpw_MatchCheck, good_matches_pass)
{
    expectTaken([&] { alignPair(image, image, matches); });
    matches.target_from_source = Matx33d::eye() * -3; // the same map
    expectTaken([&] { alignPair(image, image, matches); });
}

TEST_F(Gcpw_MatchCheck, a_point_that_is_not_finite_or_far_beyond_is_named)
{
    for (const double bad : {NOT_A_NUMBER, ENDLESS, -1e300})
    {
        PairMatches broken = matches;
        broken.source_points[7].x = bad;
        expectRefused(broken, "source_points[7]");
        broken = matches;
        broken.target_points[3].y = bad;
        expectRefused(broken, "target_points[3]");
    }
}

TEST_F(Gcpw_MatchCheck, a_line_that_is_not_finite_or_far_beyond_is_named)
{
    for (const double bad : {NOT_A_NUMBER, ENDLESS, 1e300})
        for (int k = 0; k < 4; ++k)
        {
            PairMatches broken = matches;
            broken.source_lines[2][k] = bad;
            expectRefused(broken, "source_lines[2]");
            broken = matches;
            broken.target_lines[1][k] = bad;
            expectRefused(broken, "target_lines[1]");
        }
}

TEST_F(Gcpw_MatchCheck, a_weight_that_is_not_finite_or_not_positive_is_named)
{
    for (const double bad : {NOT_A_NUMBER, ENDLESS, 0.0, -1.0, 1e300})
    {
        matches.line_weights[1] = bad;
        expectRefused(matches, "line_weights[1]");
    }
}

TEST_F(Gcpw_MatchCheck, a_homography_that_keeps_no_image_upright_is_refused)
{
    const double width = image.cols;
    matches.target_from_source = Matx33d::zeros();
    expectRefused(matches, "target_from_source");
    matches.target_from_source = Matx33d(1, 0, 0, 0, NOT_A_NUMBER, 0, 0, 0, 1);
    expectRefused(matches, "not finite");
    matches.target_from_source = Matx33d(1, 2, 3, 2, 4, 6, 0, 0, 1);
    expectRefused(matches, "singular");
    matches.target_from_source = Matx33d(-1, 0, width, 0, 1, 0, 0, 0, 1);
    expectRefused(matches, "mirrored");
    matches.target_from_source = Matx33d(1, 0, 0, 0, 1, 0, -2 / width, 0, 1);
    expectRefused(matches, "horizon");
    matches.target_from_source = Matx33d(1e-5, 0, 0, 0, 1e-5, 0, 0, 0, 1);
    expectRefused(matches, "target_from_source");
}

TEST_F(Gcpw_MatchCheck, a_status_of_no_matches_is_refused)
{
    for (const int bad : {-2, 1, 5, 77})
    {
        matches.status = static_cast<Status>(bad);
        expectRefused(matches, "PairMatches::status is " + std::to_string(bad));
    }
}

TEST_F(Gcpw_MatchCheck, counts_that_differ_are_refused)
{
    PairMatches broken = matches;
    broken.target_points.pop_back();
    expectRefused(broken, "pairs of points");
    broken = matches;
    broken.line_weights.clear();
    expectRefused(broken, "weight");
}

} // namespace
} // namespace opencv_test
