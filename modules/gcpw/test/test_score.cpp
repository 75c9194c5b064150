// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include "imaging/score.hpp"
#include "seeded.hpp"

namespace opencv_test { namespace {

using namespace cv::gcpw;

const int HALF_WINDOW = 2;
const int HALF_BORDER = 3;

/// Smooth enough to correlate, in [lowest, highest].
Mat texture(Size size, uint64_t seed, double lowest = 0, double highest = 255)
{
    Mat image(size, CV_8UC3);
    seeded(seed).fill(image, RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(image, image, Size(5, 5), 1);
    cv::normalize(image, image, lowest, highest, NORM_MINMAX);
    return image;
}

/// The definition, window by window.
Score bruteForce(const Mat& a, const Mat& b, const Mat& mask)
{
    Mat gray[2];
    cv::cvtColor(a, gray[0], COLOR_BGR2GRAY);
    cv::cvtColor(b, gray[1], COLOR_BGR2GRAY);
    double ncc = 0;
    double zncc = 0;
    int windows = 0;
    int textured = 0;
    for (int y = HALF_BORDER; y + HALF_BORDER < mask.rows; ++y)
        for (int x = HALF_BORDER; x + HALF_BORDER < mask.cols; ++x)
        {
            if (countNonZero(mask(Rect(x - HALF_BORDER, y - HALF_BORDER, 7, 7))) < 49)
                continue;
            double p = 0, q = 0, pp = 0, qq = 0, pq = 0;
            for (int v = y - HALF_WINDOW; v <= y + HALF_WINDOW; ++v)
                for (int u = x - HALF_WINDOW; u <= x + HALF_WINDOW; ++u)
                {
                    const double i = gray[0].at<uchar>(v, u);
                    const double j = gray[1].at<uchar>(v, u);
                    p += i / 25;
                    q += j / 25;
                    pp += i * i / 25;
                    qq += j * j / 25;
                    pq += i * j / 25;
                }
            ncc += std::pow(1 - pq / std::sqrt(pp * qq), 2);
            ++windows;
            const double vp = pp - p * p;
            const double vq = qq - q * q;
            if (vp > 16 && vq > 16)
            {
                zncc += std::pow(1 - (pq - p * q) / std::sqrt(vp * vq), 2);
                ++textured;
            }
        }
    Score score;
    score.ncc = 100 * std::sqrt(ncc / windows);
    score.zncc = 100 * std::sqrt(zncc / textured);
    return score;
}

TEST(Gcpw_Score, it_is_the_definition)
{
    const Mat a = texture(Size(80, 60), 1);
    Mat b;
    cv::addWeighted(a, 0.7, texture(Size(80, 60), 2), 0.3, 0, b);
    b(Rect(10, 10, 20, 20)).setTo(Scalar::all(90)); // flat windows count for ncc only
    Mat mask(60, 80, CV_8UC1, Scalar(0));
    mask(Rect(3, 5, 70, 50)).setTo(255);
    mask.at<uchar>(30, 50) = 0;
    const Score score = scoreOverlap(a, b, mask);
    const Score expected = bruteForce(a, b, mask);
    EXPECT_GT(score.zncc, 5);
    EXPECT_NEAR(score.ncc, expected.ncc, 1e-6);
    EXPECT_NEAR(score.zncc, expected.zncc, 1e-6);
}

TEST(Gcpw_Score, identical_images_are_perfect)
{
    const Mat a = texture(Size(80, 60), 3);
    const Score score = scoreOverlap(a, a, Mat(a.size(), CV_8UC1, Scalar(255)));
    EXPECT_NEAR(score.ncc, 0, 1e-6);
    EXPECT_NEAR(score.zncc, 0, 1e-6);
}

TEST(Gcpw_Score, zncc_does_not_feel_gain_and_bias_but_ncc_does)
{
    const Mat a = texture(Size(80, 60), 4, 5, 105);
    Mat b;
    a.convertTo(b, CV_8U, 1.2, 100);
    const Score score = scoreOverlap(a, b, Mat(a.size(), CV_8UC1, Scalar(1)));
    EXPECT_LT(score.zncc, 0.5); // gray levels are rounded
    EXPECT_GT(score.ncc, 0.2);
}

TEST(Gcpw_Score, a_shift_makes_it_worse)
{
    const Mat wide = texture(Size(90, 60), 5);
    const Mat mask(60, 80, CV_8UC1, Scalar(255));
    const Rect place(0, 0, 80, 60);
    double last = 0;
    for (int shift = 1; shift <= 3; ++shift)
    {
        const double zncc = scoreOverlap(wide(place), wide(place + Point(shift, 0)), mask).zncc;
        EXPECT_GT(zncc, last + 5);
        last = zncc;
    }
}

TEST(Gcpw_Score, pixels_near_the_border_of_the_mask_or_image_do_not_count)
{
    const Mat a = texture(Size(80, 60), 6);
    Mat b = a.clone();
    b.row(0).setTo(0);
    b.col(30).setTo(0);
    Mat mask(a.size(), CV_8UC1, Scalar(255));
    mask.col(30).setTo(0);
    EXPECT_NEAR(scoreOverlap(a, b, mask).zncc, 0, 1e-6);
}

TEST(Gcpw_Score, nothing_to_compare_is_not_a_number)
{
    const Mat a = texture(Size(80, 60), 7);
    const Score none = scoreOverlap(a, a, Mat(a.size(), CV_8UC1, Scalar(0)));
    EXPECT_TRUE(cvIsNaN(none.ncc));
    EXPECT_TRUE(cvIsNaN(none.zncc));
    const Mat flat(a.size(), CV_8UC3, Scalar::all(80));
    const Score untextured = scoreOverlap(flat, flat, Mat(a.size(), CV_8UC1, Scalar(255)));
    EXPECT_NEAR(untextured.ncc, 0, 1e-9);
    EXPECT_TRUE(cvIsNaN(untextured.zncc));
}

}} // namespace
