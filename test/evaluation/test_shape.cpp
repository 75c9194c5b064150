// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <gtest/gtest.h>
#include "evaluation/shape.hpp"
#include "moved_mesh.hpp"

namespace
{

using cv::gcpw::AlignedImage;
using cv::gcpw::Alignment;
using evaluation::Shape;
using evaluation::shapeOf;

const cv::Size SIZE(400, 300);

Alignment alignmentOf(const std::vector<AlignedImage>& images)
{
    return Alignment(images, cv::Size2d(1, 1), cv::gcpw::Report());
}

TEST(Evaluation_Shape, what_did_not_move_or_is_only_similar_keeps_its_shape)
{
    const AlignedImage still = movedMesh(SIZE, [](const cv::Vec2d& p) { return p; }, 8);
    const AlignedImage similar =
        movedMesh(SIZE, [](const cv::Vec2d& p) { return cv::Vec2d(1.2 * p[0] - 0.5 * p[1] + 7, 0.5 * p[0] + 1.2 * p[1]); }, 8);
    for (const Shape& shape : {shapeOf(Alignment()), shapeOf(alignmentOf({still})), shapeOf(alignmentOf({still, similar}))})
    {
        EXPECT_NEAR(shape.stretch, 0, 1e-6);
        EXPECT_NEAR(shape.area, 0, 1e-6);
        EXPECT_NEAR(shape.largest, 1, 1e-6);
    }
}

TEST(Evaluation_Shape, a_stretch_is_the_logarithm_of_its_ratio)
{
    const AlignedImage still = movedMesh(SIZE, [](const cv::Vec2d& p) { return p; }, 8);
    const AlignedImage wide = movedMesh(SIZE, [](const cv::Vec2d& p) { return cv::Vec2d(1.5 * p[0], p[1]); }, 8);
    const Shape shape = shapeOf(alignmentOf({wide, still}));
    EXPECT_NEAR(shape.stretch, std::log(1.5), 1e-9) << "images that do not move do not thin it out";
    EXPECT_NEAR(shape.largest, 1.5, 1e-9);
    EXPECT_NEAR(shape.area, 0, 1e-6) << "all quads grow alike";
    const Shape both = shapeOf(alignmentOf({wide, movedMesh(SIZE, [](const cv::Vec2d& p) { return p + cv::Vec2d(1, 1); }, 8)}));
    EXPECT_NEAR(both.stretch, std::log(1.5) / std::sqrt(2.0), 1e-9);
}

TEST(Evaluation_Shape, a_shear_stretches_by_its_singular_values)
{
    const double k = 0.4; // of [1 k; 0 1]: s1 / s2 = s1^2, s1 = (k + sqrt(k^2 + 4)) / 2
    const Shape shape = shapeOf(alignmentOf({movedMesh(SIZE, [&](const cv::Vec2d& p) { return cv::Vec2d(p[0] + k * p[1], p[1]); }, 8)}));
    EXPECT_NEAR(shape.stretch, 2 * std::log(0.5 * (k + std::sqrt(k * k + 4))), 1e-9);
}

TEST(Evaluation_Shape, quads_of_unequal_size_show_in_the_area)
{
    // The left half is half as wide, the right half 1.5 times: logarithms of area apart by ln 3.
    const AlignedImage uneven = movedMesh(SIZE, [](const cv::Vec2d& p)
    { return cv::Vec2d(p[0] < 199.6 ? 0.5 * p[0] : 99.75 + 1.5 * (p[0] - 199.5), p[1]); }, 8);
    EXPECT_NEAR(shapeOf(alignmentOf({uneven})).area, 0.5 * std::log(3.0), 1e-6);
}

} // namespace
