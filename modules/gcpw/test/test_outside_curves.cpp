// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "overlap/outside_curves.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice LATTICE(Size(200, 100), 8, 4);
const Curve TOP = {Point2d(0, 0), Point2d(199, 0)};

std::vector<Curve> parts(const Curve& curve, const std::vector<Neighbour>& neighbours, double margin_px = 0, double min_length = 10)
{
    const MeshGrid mesh(LATTICE);
    return partsOutside(curve, mesh, neighbours, 1, min_length, margin_px);
}

TEST(Gcpw_OutsideCurves, only_what_no_neighbour_shows_is_left)
{
    const MeshGrid right(LATTICE, Point2d(120, -20));
    const std::vector<Curve> left = parts(TOP, {{&right, Point2d()}});
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].front(), Point2d(0, 0));
    EXPECT_NEAR(left[0].back().x, 119, 1.01);
}

TEST(Gcpw_OutsideCurves, a_neighbour_in_the_middle_leaves_two_parts)
{
    const MeshGrid middle(Lattice(Size(40, 60), 4, 4), Point2d(80, -30));
    const std::vector<Curve> both = parts(TOP, {{&middle, Point2d()}});
    ASSERT_EQ(both.size(), 2u);
    EXPECT_NEAR(both[0].back().x, 79, 1.01);
    EXPECT_NEAR(both[1].front().x, 120, 1.01);
}

TEST(Gcpw_OutsideCurves, all_is_left_where_no_neighbour_is)
{
    const MeshGrid far(LATTICE, Point2d(1000, 0));
    const std::vector<Curve> all = parts(TOP, {{&far, Point2d()}});
    ASSERT_EQ(all.size(), 1u);
    EXPECT_NEAR(lengthOf(all[0]), 199, 1e-9);
    EXPECT_EQ(parts(TOP, {}).size(), 1u);
}

TEST(Gcpw_OutsideCurves, a_neighbour_is_looked_for_where_it_is_seen)
{
    const MeshGrid far(LATTICE, Point2d(1120, -20));
    const std::vector<Curve> left = parts(TOP, {{&far, Point2d(-1000, 0)}});
    ASSERT_EQ(left.size(), 1u);
    EXPECT_NEAR(left[0].back().x, 119, 1.01);
}

TEST(Gcpw_OutsideCurves, the_margin_of_a_neighbour_does_not_count)
{
    // The top border lies 20 px below that of the neighbour, the left end of which is at 120.
    const MeshGrid right(LATTICE, Point2d(120, -20));
    EXPECT_NEAR(parts(TOP, {{&right, Point2d()}}, 15)[0].back().x, 134, 1.01);
    EXPECT_NEAR(lengthOf(parts(TOP, {{&right, Point2d()}}, 25)[0]), 199, 1e-9);
}

TEST(Gcpw_OutsideCurves, short_parts_are_dropped)
{
    const MeshGrid right(LATTICE, Point2d(120, -20));
    EXPECT_TRUE(parts(TOP, {{&right, Point2d()}}, 0, 150).empty());
}

}} // namespace
