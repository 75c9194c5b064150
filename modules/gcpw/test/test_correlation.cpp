// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "bent_mesh.hpp"
#include "imaging/pyramid.hpp"
#include "energy/photometric_term.hpp"
#include "overlap/color_comparison.hpp"
#include "overlap/correlation.hpp"
#include "recording_equations.hpp"
#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const Size SIZE(160, 120);
const Lattice LATTICE(SIZE, 8, 6); // cells of 20 x 20 px

/// The same picture twice, the source's colours changed where asked; at the truth all meshes are undeformed.
OverlapSamples samplesOf(double gain, double bias)
{
    Mat target(SIZE, CV_8UC3);
    Mat source(SIZE, CV_8UC3);
    const Texture texture(5);
    for (int y = 0; y < SIZE.height; ++y)
        for (int x = 0; x < SIZE.width; ++x)
        {
            const Vec3d color = 255.0 * texture.at(Point2d(x, y));
            target.at<Vec3b>(y, x) = Vec3b(color);
            source.at<Vec3b>(y, x) = Vec3b(gain * color + Vec3d::all(bias));
        }
    return OverlapSamples(0, 1, buildPyramid(source, Mat(), 1)[0], buildPyramid(target, Mat(), 1)[0], LATTICE, 3);
}

std::vector<ImageState> atRest()
{
    std::vector<ImageState> states(2);
    for (ImageState& state : states)
    {
        state.mesh = MeshGrid(LATTICE);
        state.color = ColorGrid(LATTICE);
    }
    return states;
}

/// One vertex inside moved far away from the truth.
std::vector<ImageState> spoiled(int col, int row)
{
    std::vector<ImageState> states = atRest();
    states[0].mesh.vertices()[row * 9 + col] += Point2d(7, -6);
    return states;
}

TEST(Gcpw_Correlation, the_truth_is_nowhere_worse)
{
    const OverlapSamples samples = samplesOf(1, 0);
    EXPECT_TRUE(worseQuads(samples, atRest(), atRest(), 1.05).empty());
    EXPECT_TRUE(worseQuads(samples, atRest(), spoiled(4, 3), 1.05).empty());
}

TEST(Gcpw_Correlation, a_spoiled_region_is_worse_and_no_other)
{
    const OverlapSamples samples = samplesOf(1, 0);
    const std::vector<int> worse = worseQuads(samples, spoiled(4, 3), atRest(), 1.05);
    // The four quads around the vertex, measured with their neighbours.
    EXPECT_GE(worse.size(), 4u);
    for (const int cell : worse)
    {
        EXPECT_GE(cell % 8, 2);
        EXPECT_LE(cell % 8, 5);
        EXPECT_GE(cell / 8, 1);
        EXPECT_LE(cell / 8, 4);
    }
    for (const int cell : {2 * 8 + 3, 2 * 8 + 4, 3 * 8 + 3, 3 * 8 + 4})
        EXPECT_EQ(std::count(worse.begin(), worse.end(), cell), 1) << cell;
}

TEST(Gcpw_Correlation, a_change_of_color_is_not_taken_for_a_wrong_place)
{
    const OverlapSamples samples = samplesOf(0.7, 40);
    EXPECT_TRUE(worseQuads(samples, atRest(), spoiled(4, 3), 1.05).empty());
    EXPECT_GE(worseQuads(samples, spoiled(4, 3), atRest(), 1.05).size(), 4u);
}

TEST(Gcpw_Correlation, without_an_overlap_nothing_is_worse)
{
    const OverlapSamples samples = samplesOf(1, 0);
    std::vector<ImageState> away = atRest();
    away[0].mesh = MeshGrid(LATTICE, Point2d(1000, 0));
    EXPECT_TRUE(worseQuads(samples, away, atRest(), 1.05).empty());
    EXPECT_TRUE(worseQuads(samples, atRest(), away, 1.05).empty());
}

TEST(Gcpw_PhotometricTerm, frozen_quads_no_longer_move_the_mesh_but_still_say_their_color)
{
    const OverlapSamples samples = samplesOf(0.8, 10);
    const std::vector<ImageState> states = spoiled(4, 3);
    RecordingEquations before({LATTICE, LATTICE});
    RecordingEquations after({LATTICE, LATTICE});
    const double energy = PhotometricTerm(samples, PhotometricTerm::Options()).linearize(states, before);
    EXPECT_EQ(PhotometricTerm(samples, PhotometricTerm::Options(), {11, 12}).linearize(states, after), energy);
    ASSERT_EQ(before.blocks.size(), after.blocks.size());
    for (size_t i = 0; i < before.blocks.size(); ++i)
    {
        const PhotometricBlock& b = before.blocks[i].block;
        const PhotometricBlock& a = after.blocks[i].block;
        const bool frozen = after.blocks[i].quad.cell == 11 || after.blocks[i].quad.cell == 12;
        EXPECT_EQ(a.mesh_gradient, frozen ? QuadRow{} : b.mesh_gradient);
        EXPECT_EQ(a.mesh_mesh, frozen ? QuadBlock{} : b.mesh_mesh);
        EXPECT_EQ(a.color_gradient, b.color_gradient);
        EXPECT_EQ(a.color_color, b.color_color);
    }
}

TEST(Gcpw_ColorComparison, colours_are_compared_where_quads_lie_on_each_other)
{
    const OverlapSamples samples = samplesOf(1, 0);
    std::vector<ImageState> states = atRest();
    states[0].mesh = MeshGrid(LATTICE, Point2d(80, 0));
    std::vector<bool> source(LATTICE.cellCount(), false);
    std::vector<bool> target(LATTICE.cellCount(), false);
    for (const QuadColors& quads : compareColors(samples, states).quads)
    {
        EXPECT_GT(quads.moments.samples(), 0);
        source[quads.source_cell] = target[quads.target_cell] = true;
    }
    for (int cell = 0; cell < LATTICE.cellCount(); ++cell)
    {
        EXPECT_EQ(source[cell], cell % 8 < 4) << cell;
        EXPECT_EQ(target[cell], cell % 8 >= 4) << cell;
    }
}

}} // namespace
