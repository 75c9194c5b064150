// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include "evaluation/external.hpp"
#include "noise_image.hpp"
#include "scratch_folder.hpp"

namespace
{

using evaluation::alignmentOf;
using evaluation::ExternalResult;
using evaluation::PairMethod;

const cv::Size SIZE(160, 120);

/// x, y, u, v on a grid of so many points a side, by a law.
template <typename Law>
std::vector<cv::Vec4d> gridOf(int points, Law law)
{
    std::vector<cv::Vec4d> rows;
    for (int row = 0; row < points; ++row)
        for (int col = 0; col < points; ++col)
        {
            const cv::Vec2d p(static_cast<double>(col) * (SIZE.width - 1) / (points - 1),
                              static_cast<double>(row) * (SIZE.height - 1) / (points - 1));
            const cv::Vec2d q = law(p);
            rows.emplace_back(p[0], p[1], q[0], q[1]);
        }
    return rows;
}

cv::Vec2d affine(const cv::Vec2d& p)
{
    return {1.1 * p[0] - 0.2 * p[1] + 7, 0.1 * p[0] + 0.9 * p[1] - 3};
}

std::string textOf(const std::vector<cv::Vec4d>& rows)
{
    std::string text = "x,y,u,v\n";
    for (const cv::Vec4d& row : rows)
        text += cv::format("%.6f,%.6f,%.6f,%.6f\n", row[0], row[1], row[2], row[3]);
    return text;
}

cv::Mat noise(int seed)
{
    return noiseImage(SIZE, seed);
}

TEST(Evaluation_External, an_affine_grid_of_any_density_is_that_map_beyond_its_border_too)
{
    for (const int points : {2, 5, 41})
    {
        const cv::gcpw::Alignment alignment = alignmentOf(gridOf(points, affine), SIZE, SIZE, cv::Matx33d::eye());
        const cv::gcpw::AlignedImage& image = alignment.image(0);
        for (int row = 0; row < image.mesh.rows; ++row)
            for (int col = 0; col < image.mesh.cols; ++col)
            {
                const cv::Vec2d rest = image.rough.at<cv::Vec2d>(row, col); // by the identity
                EXPECT_LT(cv::norm(image.mesh.at<cv::Vec2d>(row, col) - affine(rest)), 1e-9) << points;
            }
        EXPECT_EQ(image.rough.at<cv::Vec2d>(0, 0), cv::Vec2d(-0.5, -0.5));
        EXPECT_EQ(cv::norm(alignment.image(1).mesh, alignment.image(1).rough, cv::NORM_INF), 0);
        EXPECT_EQ(alignment.report().folds, 0);
    }
}

TEST(Evaluation_External, folds_are_counted)
{
    const auto flipped = [](const cv::Vec2d& p) { return cv::Vec2d(-p[0], p[1]); };
    EXPECT_GT(alignmentOf(gridOf(9, flipped), SIZE, SIZE, cv::Matx33d::eye()).report().folds, 0);
}

TEST(Evaluation_External, what_is_no_grid_is_refused)
{
    std::vector<cv::Vec4d> rows = gridOf(4, affine);
    rows.pop_back();
    EXPECT_THROW(alignmentOf(rows, SIZE, SIZE, cv::Matx33d::eye()), cv::Exception) << "a point is missing";
    rows.push_back(rows[0]);
    EXPECT_THROW(alignmentOf(rows, SIZE, SIZE, cv::Matx33d::eye()), cv::Exception) << "a point is there twice";
    rows = gridOf(4, affine);
    rows[5][2] = std::nan("");
    EXPECT_THROW(alignmentOf(rows, SIZE, SIZE, cv::Matx33d::eye()), cv::Exception);
    EXPECT_THROW(alignmentOf({{0, 0, 0, 0}, {1, 0, 1, 0}}, SIZE, SIZE, cv::Matx33d::eye()), cv::Exception) << "a line";
    EXPECT_THROW(alignmentOf({}, SIZE, SIZE, cv::Matx33d::eye()), cv::Exception);
}

TEST(Evaluation_External, the_true_warp_scores_as_perfect_and_others_do_not)
{
    const ScratchFolder folder;
    const cv::Mat source = noise(1);
    cv::Mat target;
    cv::warpAffine(source, target, cv::Matx23d(1, 0, 12, 0, 1, 5), SIZE);
    const auto shifted = [](double x, double y)
    { return gridOf(5, [=](const cv::Vec2d& p) { return p + cv::Vec2d(x, y); }); };
    folder.write("pair/1/warp.csv", textOf(shifted(12, 5)));
    folder.write("pair/2/warp.csv", textOf(shifted(12, 8)));
    const PairMethod method = evaluation::externalMethod("rival:" + folder.path());
    EXPECT_EQ(method.name, "rival");
    const auto zncc = [&](int input)
    {
        return cv::gcpw::scorePair(
                   evaluation::readExternal(method, "pair", input, source, target, cv::Matx33d::eye()).canvas)
            .zncc;
    };
    EXPECT_LT(zncc(1), 2);
    EXPECT_GT(zncc(2), 30);
}

TEST(Evaluation_External, warped_images_and_pictures_are_read_too)
{
    const ScratchFolder folder;
    folder.write("pair/1/source.png", "");
    const std::string place = folder.path("pair/1/");
    const PairMethod method = evaluation::externalMethod("rival:" + folder.path());
    const auto read = [&]
    { return evaluation::readExternal(method, "pair", 1, noise(1), noise(2), cv::Matx33d::eye()); };
    cv::Mat with_alpha;
    cv::cvtColor(noise(3), with_alpha, cv::COLOR_BGR2BGRA);
    with_alpha.colRange(0, 50).setTo(cv::Scalar::all(0));
    cv::imwrite(place + "source.png", with_alpha);
    cv::imwrite(place + "target.png", noise(3));
    EXPECT_THROW(read(), cv::Exception) << "no mask";
    cv::imwrite(place + "target_mask.png", cv::Mat(SIZE, CV_8UC1, cv::Scalar(255)));
    const ExternalResult warped = read();
    EXPECT_EQ(cv::countNonZero(warped.canvas.source_mask), (SIZE.width - 50) * SIZE.height);
    EXPECT_LT(cv::gcpw::scorePair(warped.canvas).zncc, 1e-3);
    EXPECT_EQ(warped.alignment.imageCount(), 0);

    std::filesystem::remove(place + "source.png");
    EXPECT_THROW(read(), cv::Exception) << "nothing that can be read";
    cv::imwrite(place + "panorama.png", noise(4));
    EXPECT_EQ(read().panorama.size(), SIZE);
    EXPECT_TRUE(read().canvas.source.empty());
}

TEST(Evaluation_External, the_first_input_may_lie_in_the_folder_of_its_pair)
{
    const ScratchFolder folder;
    folder.write("pair/warp.csv", textOf(gridOf(3, affine)));
    const PairMethod method = evaluation::externalMethod("rival:" + folder.path());
    EXPECT_EQ(
        evaluation::readExternal(method, "pair", 1, noise(1), noise(2), cv::Matx33d::eye()).alignment.imageCount(), 2);
    EXPECT_THROW(evaluation::readExternal(method, "pair", 2, noise(1), noise(2), cv::Matx33d::eye()), cv::Exception);
}

TEST(Evaluation_External, an_option_that_names_nothing_is_refused)
{
    const ScratchFolder folder;
    for (const std::string& option : {std::string("rival"), "rival:" + folder.path("none"), ":" + folder.path(),
                                      std::string("rival:"), "gcpw:" + folder.path(), "a|b:" + folder.path()})
        EXPECT_THROW(evaluation::externalMethod(option), cv::Exception) << option;
}

} // namespace
