// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "opencv2/gcpw/aligner.hpp"
#include "opencv2/gcpw/pair.hpp"
#include "api/result.hpp"
#include "energy/straightness_term.hpp"
#include "overlap/outside_curves.hpp"
#include "registration/straight_lines.hpp"
#include "scene.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

/// @param vertices mesh or rough of the image
MeshGrid meshOf(const Alignment::Image& image, const Mat& vertices)
{
    MeshGrid mesh(Lattice(image.work_size, vertices.cols - 1, vertices.rows - 1));
    for (int v = 0; v < mesh.lattice().vertexCount(); ++v)
        mesh.vertices()[v] = vertices.at<Point2d>(v / vertices.cols, v % vertices.cols);
    return mesh;
}

/// Root mean square of what curves of an image bend, canvas px.
double bendOf(const Alignment::Image& image, const std::vector<Curve>& curves)
{
    double count = 0;
    for (const Curve& curve : curves)
        count += lengthOf(curve) / 4;
    const MeshGrid rough = meshOf(image, image.rough);
    const StraightnessTerm term(0, rough, curves, 4, 1);
    return std::sqrt(term.evaluate({{meshOf(image, image.mesh), ColorGrid(rough.lattice())}}) / count);
}

/// What the first image's borders bend where the second does not show them.
double borderBend(const Alignment& alignment)
{
    const Alignment::Image& image = alignment.image(0);
    const MeshGrid rough = meshOf(image, image.rough);
    const MeshGrid other = meshOf(alignment.image(1), alignment.image(1).rough);
    std::vector<Curve> borders;
    for (const Segment& border : bordersOf(image.work_size))
        for (const Curve& part : partsOutside({border.start, border.end}, rough, {{&other, Point2d()}}, 4, 20, 0))
            borders.push_back(part);
    return bendOf(image, borders);
}

Params straightness(double weight)
{
    Params params;
    params.straightnessWeight = weight;
    return params;
}

Scene scene()
{
    SceneOptions options;
    options.displacement_px = 20;
    return Scene(options);
}

TEST(Gcpw_StraightResult, lines_of_the_source_stay_straighter_than_without_the_term)
{
    const Scene s = scene();
    std::vector<Curve> lines;
    for (const Segment& line : findStraightLines(s.source(), Mat()))
        lines.push_back({line.start, line.end});
    ASSERT_GT(lines.size(), 3u);
    const double without = bendOf(alignPair(s.source(), s.target(), straightness(0)).image(0), lines);
    const double with = bendOf(alignPair(s.source(), s.target(), straightness(4)).image(0), lines);
    EXPECT_GT(without, 0.15) << "nothing bends";
    EXPECT_LT(with, 0.5 * without);
}

TEST(Gcpw_StraightResult, an_aligner_holds_the_curves_it_is_given)
{
    const Scene s = scene();
    const std::vector<Mat> images = {s.source(), s.target()};
    const std::vector<Point> corners = {Point(96, 0), Point(0, 0)};
    Params params = straightness(50);
    params.referenceImage = 1;
    const Curve arc = {Point2d(150, 60), Point2d(220, 110), Point2d(300, 170), Point2d(360, 240)};
    std::vector<KnownLines> lines(2);
    lines[0].curves.emplace_back(arc.begin(), arc.end());
    const auto bend = [&](const std::vector<KnownLines>& known)
    {
        const Alignment alignment = Aligner::create(params)->align(corners, images, noArray(), std::vector<Correspondences>(),
                                                                   Progress(), std::vector<KnownKeypoints>(), known);
        return bendOf(alignment.image(0), {arc});
    };
    const double free = bend(std::vector<KnownLines>(2));
    EXPECT_GT(free, 0.3) << "nothing bends";
    EXPECT_LT(bend(lines), 0.2 * free);
}

TEST(Gcpw_StraightResult, borders_of_the_source_stay_straight_where_they_are_those_of_the_picture)
{
    const Scene s = scene();
    const double without = borderBend(alignPair(s.source(), s.target(), straightness(0)));
    EXPECT_GT(without, 0.5) << "nothing bends";
    EXPECT_LT(borderBend(alignPair(s.source(), s.target(), straightness(4))), 0.1 * without);
}

TEST(Gcpw_StraightResult, an_aligner_holds_the_borders_of_images_and_of_photographs_it_is_told)
{
    const Scene s = scene();
    const std::vector<Mat> images = {s.source(), s.target()};
    Params params = straightness(4);
    params.referenceImage = 1;
    const auto bend = [&](InputArrayOfArrays masks, const std::vector<KnownLines>& known)
    {
        return borderBend(Aligner::create(params)->align({Point(96, 0), Point(0, 0)}, images, masks, std::vector<Correspondences>(),
                                                         Progress(), std::vector<KnownKeypoints>(), known));
    };
    Mat mask(s.source().size(), CV_8UC1, Scalar(255));
    mask.row(0).setTo(0);
    const std::vector<Mat> masks(2, mask);
    std::vector<KnownLines> lines(2);
    const double free = bend(noArray(), lines);
    EXPECT_GT(free, 0.5) << "nothing bends";
    EXPECT_LT(bend(noArray(), std::vector<KnownLines>()), 0.1 * free);
    EXPECT_GT(bend(masks, std::vector<KnownLines>()), 0.3 * free) << "what a mask hides has no border";
    for (const Segment& border : bordersOf(s.source().size()))
        lines[0].borders.push_back({border.start, border.end});
    EXPECT_LT(bend(masks, lines), 0.1 * free);
}

TEST(Gcpw_StraightResult, lines_that_do_not_fit_are_refused)
{
    const Scene s = scene();
    const std::vector<Mat> images = {s.source(), s.target()};
    const auto align = [&](const std::vector<KnownLines>& lines)
    {
        Aligner::create()->align({Point(96, 0), Point(0, 0)}, images, noArray(), std::vector<Correspondences>(), Progress(),
                                 std::vector<KnownKeypoints>(), lines);
    };
    EXPECT_THROW(align(std::vector<KnownLines>(3)), cv::Exception);
    std::vector<KnownLines> lines(2);
    lines[1].curves = {{Point2f(1, 2)}};
    EXPECT_THROW(align(lines), cv::Exception);
    lines[1].curves = {{Point2f(1, 2), Point2f(std::nanf(""), 4)}};
    EXPECT_THROW(align(lines), cv::Exception);
    lines[1].curves.clear();
    lines[1].borders = {{Point2f(1, 2)}};
    EXPECT_THROW(align(lines), cv::Exception);
}

}} // namespace
