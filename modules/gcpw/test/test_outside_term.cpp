// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "bent_mesh.hpp"
#include "term_laws.hpp"
#include "energy/outside_term.hpp"
#include "opencv2/gcpw/aligner.hpp"
#include "overlap/outside_distance.hpp"
#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Lattice LATTICE(Size(80, 60), 4, 3);
const int COLUMNS = 2 * LATTICE.vertexCount();

std::vector<double> weights()
{
    std::vector<double> all;
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        all.push_back(cell % LATTICE.cols());
    return all;
}

MeshGrid rough()
{
    return bentMesh(LATTICE, 3, 1, Point2d(200, 100));
}

TermState deformed()
{
    return TermState({bentMesh(LATTICE, 4, 2, Point2d(190, 120))});
}

double energyOf(const MeshGrid& mesh)
{
    return OutsideTerm(0, rough(), weights(), 0.5).evaluate({{mesh, ColorGrid(LATTICE)}});
}

TEST(Gcpw_OutsideTerm, an_image_may_shift_but_neither_turn_nor_grow)
{
    EXPECT_NEAR(energyOf(affineMesh(rough(), Matx22d::eye(), Point2d(30, -8))), 0, 1e-9);
    EXPECT_GT(energyOf(affineMesh(rough(), Matx22d(1, -0.05, 0.05, 1), Point2d())), 1);
    EXPECT_GT(energyOf(affineMesh(rough(), Matx22d(1.05, 0, 0, 1.05), Point2d())), 1);
}

TEST(Gcpw_OutsideTerm, quads_of_weight_zero_are_free)
{
    // The vertices of the left column of quads, less those that it shares with the next one.
    MeshGrid mesh = rough();
    for (int row = 0; row <= LATTICE.rows(); ++row)
        mesh.vertices()[row * (LATTICE.cols() + 1)] += Point2d(5, 3);
    EXPECT_NEAR(energyOf(mesh), 0, 1e-9);
}

TEST(Gcpw_OutsideTerm, energy_equals_the_sum_of_the_accumulated_blocks)
{
    expectEnergyIsSumOfRows(linearizing(std::make_shared<OutsideTerm>(0, rough(), weights(), 0.5)), deformed());
}

TEST(Gcpw_OutsideTerm, jacobian_equals_finite_differences)
{
    const LinearizeTerm accumulate = linearizing(std::make_shared<OutsideTerm>(0, rough(), weights(), 0.5));
    expectExactlyQuadratic(accumulate, deformed(), 0, COLUMNS, 2.0, 1e-9);
    expectGradientIsSlope(accumulate, deformed(), 0, COLUMNS, 1e-3, 1e-7);
}

TEST(Gcpw_OutsideDistance, it_is_zero_in_the_overlap_and_grows_from_there)
{
    const MeshGrid left(LATTICE);
    const MeshGrid right(LATTICE, Point2d(40, 0)); // shows the two right columns of quads
    const std::vector<double> distances = distanceOutside(left, {{&right, Point2d()}});
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
        EXPECT_NEAR(distances[cell], std::max(0, 2 - cell % LATTICE.cols()) * 20, 1e-9) << cell;
}

TEST(Gcpw_OutsideDistance, a_neighbour_is_looked_for_where_it_is_seen)
{
    const MeshGrid left(LATTICE);
    const MeshGrid far(LATTICE, Point2d(1040, 0));
    const std::vector<double> distances = distanceOutside(left, {{&far, Point2d(-1000, 0)}});
    EXPECT_EQ(distances[3], 0);
    EXPECT_NEAR(distances[0], 40, 1e-9);
}

TEST(Gcpw_OutsideDistance, without_an_overlap_nothing_is_outside)
{
    const MeshGrid left(LATTICE);
    const MeshGrid far(LATTICE, Point2d(500, 0));
    for (const double distance : distanceOutside(left, {{&far, Point2d()}}))
        EXPECT_EQ(distance, 0);
}

TEST(Gcpw_OutsideResult, what_one_image_shows_alone_turns_less_with_the_term)
{
    SceneOptions options = smallScene();
    options.displacement_px = 16;
    options.rough = slightHomography(160);
    const Scene scene(options);
    const auto change = [&](double weight)
    {
        Params params;
        params.outsideWeight = weight;
        params.referenceImage = 1;
        const std::vector<Mat> images = {scene.source(), scene.target()};
        const Alignment::Image image = Aligner::create(params)->align({Point(160, 0), Point(0, 0)}, images, noArray()).image(0);
        // The far column of vertices: its length and direction from top to bottom, against the rough alignment.
        const auto edge = [](const Mat& mesh)
        { return mesh.at<Point2d>(mesh.rows - 1, mesh.cols - 1) - mesh.at<Point2d>(0, mesh.cols - 1); };
        return cv::norm(edge(image.mesh) - edge(image.rough));
    };
    const double without = change(0);
    EXPECT_GT(without, 1) << "nothing turns";
    EXPECT_LT(change(3), 0.5 * without);
}

}} // namespace
