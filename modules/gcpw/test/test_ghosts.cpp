// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <cmath>
#include <set>
#include <opencv2/imgproc.hpp>
#include "rendering/seam_cut.hpp"

namespace opencv_test
{
namespace
{

using namespace cv::gcpw;

const Size SIZE(240, 160);
const Point SECOND(120, 0); ///< where the second picture lies
const Rect SHARED(120, 0, 120, 160);

/// Gray pattern without repetition, of a mean and a deviation.
Mat pattern(uint64_t seed, double mean, double deviation)
{
    Mat noise(SIZE.height, SECOND.x + SIZE.width, CV_32FC1);
    cv::RNG(seed).fill(noise, cv::RNG::NORMAL, 0, 1);
    cv::GaussianBlur(noise, noise, Size(), 1.5);
    Mat bgr;
    cv::cvtColor(Mat(noise * (deviation / cv::norm(noise, NORM_L2) * std::sqrt(noise.total())) + mean), bgr,
                 cv::COLOR_GRAY2BGR);
    return bgr;
}

/// Two pictures of a faintly patterned thing, which stands elsewhere in the second one.
struct Two
{
    PlacedPicture first;
    PlacedPicture second;

    /// @param own whether each has a background of its own, so that nothing but the thing agrees
    Two(Rect thing, Point move, bool own, double light = 1)
    {
        const Mat surface = pattern(3, 140, 11);
        for (PlacedPicture* picture : {&first, &second})
        {
            const bool is_second = picture == &second;
            Mat canvas = pattern(own && is_second ? 9 : 8, 80, 15);
            surface(thing).copyTo(canvas(thing + (is_second ? move : Point())));
            picture->corner = is_second ? SECOND : Point();
            picture->image = canvas(Rect(picture->corner, SIZE)) * (is_second ? light : 1.0);
            picture->mask = Mat(SIZE, CV_8UC1, Scalar(255));
        }
    }
};

TEST(Gcpw_Ghosts, a_thing_in_two_places_is_found_in_any_light)
{
    const Rect thing(140, 30, 60, 90);
    for (const double light : {1.0, 0.8})
    {
        const Point move(18, -6);
        const Two two(thing, move, false, light);
        const std::vector<Ghost> ghosts = findGhosts(two.first, two.second);
        EXPECT_GT(ghosts.size(), 40u) << light;
        for (const Ghost& ghost : ghosts)
            EXPECT_LE(cv::norm(ghost.in_second - ghost.in_first - move), 3) << light << ": " << ghost.in_first;
    }
}

TEST(Gcpw_Ghosts, what_is_aligned_has_none_nor_has_what_only_one_shows)
{
    const Rect thing(140, 30, 60, 90);
    EXPECT_TRUE(findGhosts(Two(thing, Point(), false).first, Two(thing, Point(), false).second).empty());
    const Two two(thing, Point(18, -6), true);
    PlacedPicture without = two.second;
    without.mask = without.mask.clone();
    without.mask((thing + Point(18, -6)) - SECOND).setTo(0);
    EXPECT_TRUE(findGhosts(two.first, without).empty()) << "hidden in the second";
    PlacedPicture apart = two.second;
    apart.corner = Point(SIZE.width, 0);
    EXPECT_TRUE(findGhosts(two.first, apart).empty());
}

TEST(Gcpw_Ghosts, are_the_same_whichever_picture_is_first)
{
    const Two two(Rect(140, 30, 60, 90), Point(18, -6), false);
    const auto places = [](const std::vector<Ghost>& ghosts, bool swapped)
    {
        std::set<std::vector<int>> all;
        for (const Ghost& g : ghosts)
            all.insert(swapped ? std::vector<int>{g.in_second.x, g.in_second.y, g.in_first.x, g.in_first.y}
                               : std::vector<int>{g.in_first.x, g.in_first.y, g.in_second.x, g.in_second.y});
        return all;
    };
    EXPECT_EQ(places(findGhosts(two.first, two.second), false), places(findGhosts(two.second, two.first), true));
}

TEST(Gcpw_Ghosts, a_cut_leaves_the_thing_to_one_picture_though_it_would_show_least_in_its_middle)
{
    // From top to bottom of what both share, before backgrounds that agree nowhere.
    const Rect thing(145, 0, 50, 160);
    const Point move(20, 0);
    Two two(thing, move, true);
    Two blind = two;
    blind.first.mask = two.first.mask.clone();
    blind.second.mask = two.second.mask.clone();
    const auto share = [&](const Two& pictures)
    {
        const Rect both = (thing | (thing + move)) & SHARED;
        return countNonZero(pictures.first.mask(both)) / static_cast<double>(both.area());
    };
    cutBetween(two.first, two.second, findGhosts(two.first, two.second));
    EXPECT_TRUE(share(two) < 0.1 || share(two) > 0.9) << share(two);
    cutBetween(blind.first, blind.second, {});
    EXPECT_TRUE(share(blind) > 0.1 && share(blind) < 0.9) << share(blind) << ": else this test shows nothing";
}

} // namespace
} // namespace opencv_test
