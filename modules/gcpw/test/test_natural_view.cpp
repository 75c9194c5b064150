// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <cmath>
#include "camera_turn.hpp"
#include "geometry/homography.hpp"
#include "rendering/natural_view.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Size PHOTO(400, 300);

PlacedPhotograph placed(const Matx33d& canvas_from_photo, Size size = PHOTO)
{
    return {warpedLattice(Lattice(size, 16, 12), canvas_from_photo), size};
}

/// A photograph and the target that gives the canvas its frame.
std::vector<PlacedPhotograph> pairOf(const Matx33d& target_from_source)
{
    return {placed(target_from_source), placed(Matx33d::eye())};
}

Matx33d similarity(double scale, double degrees, Point2d shift)
{
    const double c = scale * std::cos(degrees * CV_PI / 180);
    const double s = scale * std::sin(degrees * CV_PI / 180);
    return {c, -s, shift.x, s, c, shift.y, 0, 0, 1};
}

MeshGrid shown(const Matx33d& view, const PlacedPhotograph& photograph)
{
    MeshGrid mesh = photograph.mesh;
    for (Point2d& vertex : mesh.vertices())
        vertex = applyHomography(view, vertex);
    return mesh;
}

/// Area of a picture that holds all photographs, px.
double canvasArea(const Matx33d& view, const std::vector<PlacedPhotograph>& photographs)
{
    Rect2d bounds = shown(view, photographs[0]).bounds();
    for (const PlacedPhotograph& photograph : photographs)
        bounds |= shown(view, photograph).bounds();
    return bounds.area();
}

double shownArea(const Matx33d& view, const std::vector<PlacedPhotograph>& photographs)
{
    double area = 0;
    for (const PlacedPhotograph& photograph : photographs)
    {
        const MeshGrid mesh = shown(view, photograph);
        for (int cell = 0; cell < mesh.lattice().cellCount(); ++cell)
            area += 0.5 * (mesh.cornerArea(cell, 0) + mesh.cornerArea(cell, 3));
    }
    return area;
}

/// E of the view, from singular values of each quad's map.
double strainOf(const Matx33d& view, const std::vector<PlacedPhotograph>& photographs)
{
    double energy = 0;
    for (const PlacedPhotograph& photograph : photographs)
    {
        const MeshGrid mesh = shown(view, photograph);
        const int count = mesh.lattice().cellCount();
        std::vector<double> areas;
        for (int cell = 0; cell < count; ++cell)
        {
            CellPoint middle;
            middle.cell = cell;
            middle.weight = bilinearWeights(0.5, 0.5);
            Mat values;
            SVD::compute(Mat(mesh.jacobian(middle)), values, SVD::NO_UV);
            const double large = std::log(values.at<double>(0));
            const double small = std::log(values.at<double>(1));
            energy += 0.5 * (large - small) * (large - small) / count;
            areas.push_back(large + small);
        }
        double mean = 0;
        for (const double area : areas)
            mean += area / count;
        for (const double area : areas)
            energy += 0.5 * (area - mean) * (area - mean) / count;
    }
    return energy;
}

/// How much a view turns a photograph at its centre, degrees.
double turnAt(const Matx33d& view, const PlacedPhotograph& photograph)
{
    const MeshGrid mesh = shown(view, photograph);
    const Matx22d j = mesh.jacobian(mesh.lattice().locate(Point2d(PHOTO) * 0.5));
    return std::atan2(j(1, 0) - j(0, 1), j(0, 0) + j(1, 1)) * 180 / CV_PI;
}

TEST(Gcpw_NaturalView, of_photographs_related_by_a_similarity_it_is_one_that_keeps_their_area)
{
    const std::vector<PlacedPhotograph> pair = pairOf(similarity(1.5, 20, Point2d(230, -40)));
    const Matx33d view = naturalView(pair);
    EXPECT_LT(strainOf(view, pair), 1e-12);
    EXPECT_NEAR(shownArea(view, pair), 2 * PHOTO.area(), 1e-3 * PHOTO.area());
}

TEST(Gcpw_NaturalView, one_photograph_twice_stays_as_it_is)
{
    const Matx33d view = naturalView(pairOf(Matx33d::eye()));
    for (const Point2d p : {Point2d(0, 0), Point2d(399, 0), Point2d(0, 299), Point2d(399, 299)})
        EXPECT_LT(cv::norm(applyHomography(view, p) - applyHomography(view, Point2d()) - p), 1e-6);
}

TEST(Gcpw_NaturalView, each_photograph_takes_half_of_the_turn_between_them)
{
    const std::vector<PlacedPhotograph> pair = pairOf(similarity(1, 8, Point2d(200, 10)));
    const Matx33d view = naturalView(pair);
    EXPECT_NEAR(turnAt(view, pair[0]), 4, 1e-6);
    EXPECT_NEAR(turnAt(view, pair[1]), -4, 1e-6);
}

TEST(Gcpw_NaturalView, a_camera_held_on_its_side_does_not_lay_the_target_down)
{
    for (const double quarters : {-90.0, 90.0, 180.0})
    {
        const std::vector<PlacedPhotograph> pair = pairOf(similarity(1, quarters + 8, Point2d(200, 10)));
        EXPECT_NEAR(turnAt(naturalView(pair), pair[1]), -4, 1e-6) << quarters;
    }
}

TEST(Gcpw_NaturalView, a_camera_that_turned_asks_for_a_smaller_canvas_than_in_the_target_s_frame)
{
    double last = 1;
    for (const double degrees : {10.0, 20.0, 30.0, 40.0})
    {
        const std::vector<PlacedPhotograph> pair = pairOf(targetFromSource(PHOTO, degrees));
        const double ratio = canvasArea(naturalView(pair), pair) / canvasArea(Matx33d::eye(), pair);
        EXPECT_LT(ratio, 0.98 * last) << degrees;
        last = ratio;
    }
    EXPECT_LT(last, 0.4);
}

TEST(Gcpw_NaturalView, the_canvas_needs_little_more_than_the_photographs)
{
    for (const double degrees : {10.0, 20.0, 30.0, 40.0})
    {
        const std::vector<PlacedPhotograph> pair = pairOf(targetFromSource(PHOTO, degrees));
        const Matx33d view = naturalView(pair);
        EXPECT_LT(canvasArea(view, pair), 1.15 * 2 * PHOTO.area()) << degrees;
        EXPECT_NEAR(shownArea(view, pair), 2 * PHOTO.area(), 0.1 * 2 * PHOTO.area()) << degrees;
    }
}

TEST(Gcpw_NaturalView, it_does_not_matter_which_photograph_is_the_target)
{
    const Matx33d h = targetFromSource(PHOTO, 35);
    const std::vector<PlacedPhotograph> there = pairOf(h);
    const std::vector<PlacedPhotograph> back = pairOf(h.inv());
    const MeshGrid source = shown(naturalView(there), there[0]);
    const MeshGrid target = shown(naturalView(back), back[1]);
    const Point2d shift = source.vertices()[0] - target.vertices()[0];
    // Not exactly: a quad counts as what its centre says, and there the two photographs differ a little.
    for (size_t i = 0; i < source.vertices().size(); ++i)
        ASSERT_LT(cv::norm(source.vertices()[i] - target.vertices()[i] - shift), 0.1) << i;
}

TEST(Gcpw_NaturalView, no_homography_near_it_strains_less)
{
    const std::vector<PlacedPhotograph> pair = pairOf(similarity(1.1, 5, Point2d(20, 30)) * targetFromSource(PHOTO, 30));
    const Matx33d view = naturalView(pair);
    const double energy = strainOf(view, pair);
    EXPECT_LT(energy, 0.5 * strainOf(Matx33d::eye(), pair));
    const double l = 1.0 / PHOTO.width; // of a homography that acts on the picture
    for (const double amount : {-0.003, 0.003})
        for (const Matx33d& change : {Matx33d(amount, 0, 0, 0, -amount, 0, 0, 0, 0), Matx33d(0, amount, 0, amount, 0, 0, 0, 0, 0),
                                      Matx33d(0, 0, 0, 0, 0, 0, amount * l, 0, 0), Matx33d(0, 0, 0, 0, 0, 0, 0, amount * l, 0)})
            EXPECT_GT(strainOf((Matx33d::eye() + change) * view, pair), energy);
}

TEST(Gcpw_NaturalView, no_quad_folds_however_far_the_camera_turned)
{
    for (const double degrees : {45.0, 55.0})
    {
        const std::vector<PlacedPhotograph> pair = pairOf(targetFromSource(PHOTO, degrees));
        const Matx33d view = naturalView(pair);
        for (const PlacedPhotograph& photograph : pair)
            EXPECT_EQ(shown(view, photograph).countFolds(), 0) << degrees;
        EXPECT_LT(canvasArea(view, pair), 1.5 * 2 * PHOTO.area());
    }
}

TEST(Gcpw_NaturalView, folded_quads_say_nothing_and_without_others_nothing_is_changed)
{
    std::vector<PlacedPhotograph> pair = pairOf(targetFromSource(PHOTO, 20));
    const Matx33d view = naturalView(pair);
    // One vertex drawn over its neighbours.
    pair[0].mesh.vertices()[5 * 17 + 8] += Point2d(120, 0);
    const Matx33d nearly = naturalView(pair);
    EXPECT_LT(std::abs(canvasArea(nearly, pair) / canvasArea(view, pair) - 1), 0.05);
    pair[0] = placed(Matx33d(-1, 0, 0, 0, 1, 0, 0, 0, 1));
    EXPECT_EQ(naturalView(pair), Matx33d::eye());
}

}} // namespace
