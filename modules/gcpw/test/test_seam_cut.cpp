// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <opencv2/imgproc.hpp>
#include "refusal.hpp"
#include "rendering/seam_cut.hpp"
#include "scene.hpp"

namespace opencv_test
{
namespace
{

using namespace cv::gcpw;

const Size SIZE(240, 160);
const Point SECOND(120, 0); ///< where the second picture lies

/// Two pictures of one texture that share their middle, each with a bright thing at a place of its own there.
struct Two
{
    PlacedPicture first;
    PlacedPicture second;

    explicit Two(Rect thing_of_first = Rect(), Rect thing_of_second = Rect())
    {
        for (PlacedPicture* picture : {&first, &second})
        {
            picture->corner = picture == &first ? Point() : SECOND;
            picture->image.create(SIZE, CV_32FC3);
            picture->mask = Mat(SIZE, CV_8UC1, Scalar(255));
            const Texture texture(8);
            for (int y = 0; y < SIZE.height; ++y)
                for (int x = 0; x < SIZE.width; ++x)
                    picture->image.at<Vec3f>(y, x) = Vec3f(90 * texture.at(Point2d(Point(x, y) + picture->corner)));
            const Rect thing = picture == &first ? thing_of_first : thing_of_second;
            if (!thing.empty())
                picture->image(thing - picture->corner).setTo(Scalar(40, 40, 230));
        }
    }
};

/// How many pixels of a part of the canvas a picture shows.
int shown(const PlacedPicture& picture, Rect part)
{
    return countNonZero(picture.mask((part & picture.rect()) - picture.corner));
}

TEST(Gcpw_SeamCut, afterwards_every_pixel_belongs_to_one_picture)
{
    Two two;
    cutBetween(two.first, two.second, findGhosts(two.first, two.second));
    const Rect shared = two.first.rect() & two.second.rect();
    const Mat a = two.first.mask(shared);
    const Mat b = two.second.mask(shared - SECOND);
    EXPECT_EQ(countNonZero(a & b), 0);
    EXPECT_EQ(countNonZero(a | b), shared.area());
    EXPECT_EQ(shown(two.first, Rect(0, 0, SECOND.x, SIZE.height)), SECOND.x * SIZE.height) << "what only one has";
    EXPECT_GT(countNonZero(a), 0);
    EXPECT_GT(countNonZero(b), 0);
}

TEST(Gcpw_SeamCut, a_thing_in_two_places_is_left_to_one_picture_as_a_whole)
{
    const Rect of_first(150, 40, 40, 60);
    for (const int shift : {12, 25, 38})
    {
        const Rect of_second = of_first + Point(shift, 3);
        Two two(of_first, of_second);
        cutBetween(two.first, two.second, findGhosts(two.first, two.second));
        const Rect both = of_first | of_second;
        const int pixels = shown(two.first, both);
        EXPECT_TRUE(pixels == 0 || pixels == both.area()) << shift << ": " << pixels << " of " << both.area();
    }
}

TEST(Gcpw_SeamCut, the_cost_is_the_difference_around_a_pixel)
{
    const Rect shared(SECOND, Size(SIZE.width - SECOND.x, SIZE.height));
    const Two equal;
    EXPECT_EQ(cv::norm(seamCost(equal.first, equal.second, shared), NORM_INF), 0);
    const Rect thing(160, 60, 20, 20);
    Two two(thing);
    const Mat cost = seamCost(two.first, two.second, shared);
    EXPECT_EQ(cost.type(), CV_32FC1);
    EXPECT_EQ(cost.size(), shared.size());
    EXPECT_GT(cost.at<float>(Point(170, 70) - SECOND), 50) << "in its middle";
    EXPECT_GT(cost.at<float>(Point(157, 70) - SECOND), 5) << "3 px beside it";
    EXPECT_LT(cost.at<float>(Point(145, 70) - SECOND), 1) << "15 px beside it";
    // Hidden pixels say nothing, neither where they are nor to their neighbours.
    two.first.mask(thing).setTo(0);
    EXPECT_LT(cv::norm(seamCost(two.first, two.second, shared), NORM_INF), 1);
    EXPECT_EQ(seamCost(two.first, two.second, shared).at<float>(Point(170, 70) - SECOND), 0);
}

TEST(Gcpw_SeamCut, pictures_apart_stay_as_they_are)
{
    Two two;
    two.second.corner = Point(SIZE.width, 0);
    cutBetween(two.first, two.second, findGhosts(two.first, two.second));
    EXPECT_EQ(countNonZero(two.first.mask), SIZE.area());
    EXPECT_EQ(countNonZero(two.second.mask), SIZE.area());
}

TEST(Gcpw_SeamFinder, cuts_every_pair_and_is_refused_what_no_stitcher_gives)
{
    const Rect of_first(150, 40, 40, 60);
    const Two two(of_first, of_first + Point(25, 3));
    const auto find = [&](const Mat& image, const Mat& mask)
    {
        std::vector<UMat> images = {two.first.image.getUMat(ACCESS_READ), image.getUMat(ACCESS_READ)};
        std::vector<UMat> masks = {two.first.mask.clone().getUMat(ACCESS_RW), mask.clone().getUMat(ACCESS_RW)};
        GcpwSeamFinder().find(images, {Point(), SECOND}, masks);
        return masks[0].getMat(ACCESS_READ).clone();
    };
    Two same = two;
    same.first.mask = two.first.mask.clone();
    same.second.mask = two.second.mask.clone();
    cutBetween(same.first, same.second, findGhosts(same.first, same.second));
    EXPECT_EQ(cv::norm(find(two.second.image, two.second.mask), same.first.mask, NORM_INF), 0);
    Mat other;
    two.second.image.convertTo(other, CV_8U);
    Mat rounded;
    other.convertTo(rounded, CV_32F);
    EXPECT_EQ(cv::norm(find(other, two.second.mask), find(rounded, two.second.mask), NORM_INF), 0);
    two.second.image.convertTo(other, CV_16S);
    expectRefused([&] { find(other, two.second.mask); }, "CV_32FC3");
    expectRefused([&] { find(two.second.image, Mat(Size(3, 3), CV_8UC1, Scalar(255))); }, "3 x 3 px");
}

TEST(Gcpw_SeamFinder, takes_the_place_of_the_default_and_of_nothing_else)
{
    const Ptr<Stitcher> stitcher = Stitcher::create(Stitcher::PANORAMA);
    const Ptr<cv::detail::SeamFinder> own = stitcher->seamFinder();
    attach(stitcher);
    Ptr<GcpwSeamFinder> ours = stitcher->seamFinder().dynamicCast<GcpwSeamFinder>();
    ASSERT_TRUE(ours);
    EXPECT_EQ(ours->fallback(), own);
    attach(stitcher);
    ours = stitcher->seamFinder().dynamicCast<GcpwSeamFinder>();
    ASSERT_TRUE(ours);
    EXPECT_EQ(ours->fallback(), own) << "attached twice it still contains the stitcher's own";
    const Ptr<cv::detail::SeamFinder> chosen = makePtr<cv::detail::VoronoiSeamFinder>();
    stitcher->setSeamFinder(chosen);
    attach(stitcher);
    EXPECT_EQ(stitcher->seamFinder(), chosen);
}

} // namespace
} // namespace opencv_test
