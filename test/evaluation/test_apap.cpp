// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <gtest/gtest.h>
#include "evaluation/apap.hpp"
#include "evaluation/mesh_folds.hpp"

namespace
{

using cv::gcpw::Alignment;
using cv::gcpw::PairMatches;

const cv::Size SIZE(320, 240);

cv::Point2d apply(const cv::Matx33d& h, cv::Point2d p)
{
    const cv::Vec3d q = h * cv::Vec3d(p.x, p.y, 1);
    return {q[0] / q[2], q[1] / q[2]};
}

/// Matches on a grid over the right part of the source, moved by `target_of`.
template <typename TargetOf>
PairMatches gridMatches(TargetOf target_of)
{
    PairMatches matches;
    matches.source_size = matches.target_size = SIZE;
    for (int y = 10; y < SIZE.height; y += 20)
        for (int x = 100; x < SIZE.width; x += 20)
        {
            matches.source_points.emplace_back(x, y);
            matches.target_points.push_back(target_of(cv::Point2d(x, y)));
        }
    return matches;
}

Alignment alignApap(const PairMatches& matches, const evaluation::ApapOptions& options = evaluation::ApapOptions())
{
    const cv::Mat picture(SIZE, CV_8UC3, cv::Scalar::all(100));
    return evaluation::alignApap(picture, picture, matches, cv::gcpw::Params(), options);
}

double distanceFrom(const Alignment& alignment, const cv::Matx33d& truth)
{
    const cv::Mat& mesh = alignment.image(0).mesh;
    double largest = 0;
    for (int row = 0; row < mesh.rows; ++row)
        for (int col = 0; col < mesh.cols; ++col)
        {
            const cv::Point2d vertex(col * SIZE.width / 32.0 - 0.5, row * SIZE.height / 32.0 - 0.5);
            const cv::Vec2d found = mesh.at<cv::Vec2d>(row, col);
            largest = std::max(largest, cv::norm(apply(truth, vertex) - cv::Point2d(found[0], found[1])));
        }
    return largest;
}

TEST(Evaluation_Apap, matches_of_a_homography_give_that_homography_at_every_vertex)
{
    const cv::Matx33d truth(1.05, 0.03, -90, -0.02, 0.98, 7, 1e-4, -5e-5, 1);
    PairMatches matches = gridMatches([&](cv::Point2d p) { return apply(truth, p); });
    matches.target_from_source = cv::Matx33d(1, 0, -80, 0, 1, 0, 0, 0, 1); // a poor start does not matter
    const Alignment alignment = alignApap(matches);
    ASSERT_TRUE(alignment.ok());
    EXPECT_LT(distanceFrom(alignment, truth), 1e-5);
    EXPECT_EQ(alignment.report().folds, 0);
}

TEST(Evaluation_Apap, two_planes_are_each_followed_where_they_are)
{
    const auto target_of = [](cv::Point2d p) { return p + (p.y < 120 ? cv::Point2d(-80, 0) : cv::Point2d(-86, 0)); };
    const Alignment alignment = alignApap(gridMatches(target_of));
    ASSERT_TRUE(alignment.ok());
    const cv::Mat& mesh = alignment.image(0).mesh;
    for (const int row : {4, 28})
    {
        const cv::Point2d vertex(24 * SIZE.width / 32.0 - 0.5, row * SIZE.height / 32.0 - 0.5);
        EXPECT_NEAR(mesh.at<cv::Vec2d>(row, 24)[0], target_of(vertex).x, 0.5);
    }
}

TEST(Evaluation_Apap, a_flat_kernel_is_one_homography)
{
    const auto target_of = [](cv::Point2d p) { return p + (p.y < 120 ? cv::Point2d(-80, 0) : cv::Point2d(-90, 0)); };
    evaluation::ApapOptions flat;
    flat.gamma = 1;
    const Alignment alignment = alignApap(gridMatches(target_of), flat);
    ASSERT_TRUE(alignment.ok());
    const cv::Mat& mesh = alignment.image(0).mesh;
    // The vertices of a straight line stay on one.
    const cv::Vec2d a = mesh.at<cv::Vec2d>(0, 20);
    const cv::Vec2d b = mesh.at<cv::Vec2d>(32, 20);
    const cv::Vec2d p = mesh.at<cv::Vec2d>(13, 20);
    EXPECT_NEAR((p[0] - a[0]) * (b[1] - a[1]) - (p[1] - a[1]) * (b[0] - a[0]), 0, 1e-3);
}

TEST(Evaluation_Apap, folds_are_counted)
{
    // Neighbouring columns of matches change sides.
    const auto target_of = [](cv::Point2d p) { return p - cv::Point2d(80, 0) + cv::Point2d(p.x < 200 ? 60 : -60, 0); };
    const Alignment alignment = alignApap(gridMatches(target_of));
    ASSERT_TRUE(alignment.ok());
    EXPECT_GT(alignment.report().folds, 0);
}

TEST(Evaluation_Apap, three_points_keep_the_rough_alignment)
{
    PairMatches matches = gridMatches([](cv::Point2d p) { return p; });
    matches.source_points.resize(3);
    matches.target_points.resize(3);
    const Alignment alignment = alignApap(matches);
    EXPECT_EQ(alignment.report().status, cv::gcpw::Status::ROUGH);
    EXPECT_EQ(cv::norm(alignment.image(0).mesh, alignment.image(0).rough, cv::NORM_INF), 0);
}

TEST(Evaluation_Apap, options_out_of_range_are_refused)
{
    const PairMatches matches = gridMatches([](cv::Point2d p) { return p; });
    evaluation::ApapOptions options;
    options.sigma = 0;
    EXPECT_THROW(alignApap(matches, options), cv::Exception);
    options.sigma = 0.1;
    options.gamma = 2;
    EXPECT_THROW(alignApap(matches, options), cv::Exception);
}

TEST(Evaluation_MeshFolds, a_turned_corner_and_a_lost_vertex_fold_their_quads)
{
    cv::Mat mesh(4, 4, CV_64FC2);
    for (int row = 0; row < 4; ++row)
        for (int col = 0; col < 4; ++col)
            mesh.at<cv::Vec2d>(row, col) = cv::Vec2d(10 * col, 10 * row);
    EXPECT_EQ(evaluation::countFoldedQuads(mesh), 0);
    cv::Mat turned = mesh.clone();
    turned.at<cv::Vec2d>(0, 0) = cv::Vec2d(8, 8); // beyond the diagonal of its quad
    EXPECT_EQ(evaluation::countFoldedQuads(turned), 1);
    cv::Mat lost = mesh.clone();
    lost.at<cv::Vec2d>(1, 1)[0] = std::nan("");
    EXPECT_EQ(evaluation::countFoldedQuads(lost), 4);
    cv::Mat mirrored;
    cv::flip(mesh, mirrored, 1);
    EXPECT_EQ(evaluation::countFoldedQuads(mirrored), 9);
}

} // namespace
