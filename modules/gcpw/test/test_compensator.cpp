// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "test_precomp.hpp"

#include <limits>
#include "color/color_correction.hpp"
#include "refusal.hpp"
#include "rig_scene.hpp"

namespace opencv_test { namespace {

/// Two pictures of one texture on a canvas, the second with a light that varies over it.
struct Pair
{
    std::vector<Point> corners{Point(0, 0), Point(120, 10)};
    std::vector<UMat> images;
    std::vector<UMat> masks;

    Pair()
    {
        const Texture texture(11);
        for (size_t i = 0; i < 2; ++i)
        {
            Mat image(200, 240, CV_8UC3);
            for (int y = 0; y < image.rows; ++y)
                for (int x = 0; x < image.cols; ++x)
                {
                    Vec3d color = texture.at(Point2d(corners[i] + Point(x, y)));
                    if (i == 1)
                        color = color * (0.75 + 0.25 * std::sin(y / 40.0)) + Vec3d(0.05, 0, 0.02);
                    image.at<Vec3b>(y, x) = Vec3b(color * 255.0);
                }
            images.push_back(image.getUMat(ACCESS_READ).clone());
            masks.push_back(UMat(image.size(), CV_8UC1, Scalar(255)));
        }
    }

    /// RMS difference in the overlap of the corrected, blurred pictures, gray levels.
    double differenceAfter(cv::detail::ExposureCompensator& compensator) const
    {
        compensator.feed(corners, images, masks);
        Mat blurred[2];
        for (int i = 0; i < 2; ++i)
        {
            Mat picture;
            images[i].copyTo(picture);
            compensator.apply(i, corners[i], picture, masks[i]);
            blur(picture, blurred[i], Size(9, 9));
        }
        const Rect shared = Rect(corners[0], blurred[0].size()) & Rect(corners[1], blurred[1].size());
        return cv::norm(blurred[0](shared - corners[0]), blurred[1](shared - corners[1]), NORM_L2) / std::sqrt(3.0 * shared.area());
    }
};

TEST(Gcpw_Compensator, alone_it_beats_the_block_compensators)
{
    typedef cv::detail::ExposureCompensator E;
    const Pair pair;
    gcpw::GcpwCompensator ours;
    const double difference = pair.differenceAfter(ours);
    for (const int type : {E::NO, E::GAIN, E::GAIN_BLOCKS, E::CHANNELS, E::CHANNELS_BLOCKS})
        EXPECT_LT(difference, pair.differenceAfter(*E::createDefault(type))) << type;
    EXPECT_LT(difference, 5);
}

TEST(Gcpw_Compensator, correction_is_that_of_the_colour_grid)
{
    gcpw::GcpwCompensator compensator;
    std::vector<Mat> gains(1, Mat(5, 6, CV_32FC(6)));
    for (int row = 0; row < 5; ++row)
        for (int col = 0; col < 6; ++col)
            gains[0].at<Vec<float, 6>>(row, col) = Vec<float, 6>(0.8F + 0.06F * static_cast<float>(col), 1.1F, 0.9F, 0.02F * static_cast<float>(row), 0.01F, -0.02F);
    compensator.setMatGains(gains);
    Mat picture = photographOf(cameraAt(0), 0, 0);
    Mat position(picture.size(), CV_32FC2);
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x)
            position.at<Vec2f>(y, x) = Vec2f(static_cast<float>(x), static_cast<float>(y));
    const Mat expected = gcpw::correctColors(picture, position, Mat(picture.size(), CV_8UC1, Scalar(255)), gains[0], picture.size());
    compensator.apply(0, Point(), picture, noArray());
    EXPECT_LE(cv::norm(picture, expected, NORM_INF), 3);
    EXPECT_LE(cv::norm(picture, expected, NORM_L1) / (3.0 * static_cast<double>(picture.total())), 0.6);
}

TEST(Gcpw_Compensator, colours_of_one_scale_are_those_of_another)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const gcpw::Rig rig = bentRig(base, {cameraAt(-0.3), cameraAt(0.3)}, 6);
    const gcpw::GcpwWarper creator(base, rig);
    const Ptr<gcpw::GcpwCompensator> compensator = creator.compensator();
    Mat pictures[2];
    const double scales[] = {rig.scale * 0.5, rig.scale * 1.5};
    for (int i = 0; i < 2; ++i)
    {
        const Ptr<cv::detail::RotationWarper> warper = creator.create(static_cast<float>(scales[i]));
        const double zoom = scales[i] / rig.scale;
        const Size size(cvRound(RIG_IMAGE.width * zoom), cvRound(RIG_IMAGE.height * zoom));
        const Point corner = warper->warp(Mat(size, CV_8UC3, Scalar(90, 120, 150)), intrinsics(rig.cameras[1], zoom), rig.cameras[1].R, INTER_LINEAR, BORDER_REFLECT, pictures[i]);
        compensator->apply(1, corner, pictures[i], noArray());
    }
    resize(pictures[1], pictures[1], pictures[0].size(), 0, 0, INTER_AREA);
    const Rect middle(10, 10, pictures[0].cols - 20, pictures[0].rows - 20);
    EXPECT_LE(cv::norm(pictures[0](middle), pictures[1](middle), NORM_INF), 3);
    EXPECT_GT(cv::norm(pictures[0](middle), Mat(middle.size(), CV_8UC3, Scalar(90, 120, 150)), NORM_INF), 10);
}

TEST(Gcpw_Compensator, a_rig_keeps_its_colours_whatever_is_fed)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const gcpw::Rig rig = bentRig(base, {cameraAt(-0.3), cameraAt(0.3)}, 6);
    const gcpw::GcpwWarper creator(base, rig);
    const Ptr<gcpw::GcpwCompensator> compensator = creator.compensator();
    creator.create(rig.scale);
    const Pair pair;
    compensator->feed(pair.corners, pair.images, pair.masks);
    std::vector<Mat> gains;
    compensator->getMatGains(gains);
    ASSERT_EQ(gains.size(), size_t(2));
    EXPECT_EQ(cv::norm(gains[1], rig.alignment.image(1).color, NORM_INF), 0);
}

TEST(Gcpw_Compensator, gains_travel_and_stay_without_update)
{
    const Pair pair;
    gcpw::GcpwCompensator first;
    first.feed(pair.corners, pair.images, pair.masks);
    std::vector<Mat> gains;
    first.getMatGains(gains);
    ASSERT_EQ(gains.size(), size_t(2));
    gcpw::GcpwCompensator second;
    second.setMatGains(gains);
    second.setUpdateGain(false);
    std::vector<UMat> swapped{pair.images[1], pair.images[0]};
    second.feed(pair.corners, swapped, pair.masks);
    std::vector<Mat> kept;
    second.getMatGains(kept);
    for (size_t i = 0; i < 2; ++i)
        EXPECT_EQ(cv::norm(gains[i], kept[i], NORM_INF), 0);
    Mat a = pair.images[1].getMat(ACCESS_READ).clone();
    Mat b = a.clone();
    first.apply(1, pair.corners[1], a, noArray());
    second.apply(1, pair.corners[1], b, noArray());
    EXPECT_EQ(cv::norm(a, b, NORM_INF), 0);
    std::vector<Mat> wrong(2, Mat(3, 3, CV_64F));
    EXPECT_THROW(second.setMatGains(wrong), cv::Exception);
}

TEST(Gcpw_Compensator, images_that_do_not_overlap_stay_as_they_are)
{
    Pair pair;
    pair.corners[1] = Point(5000, 0);
    gcpw::GcpwCompensator compensator;
    compensator.feed(pair.corners, pair.images, pair.masks);
    Mat picture;
    pair.images[1].copyTo(picture);
    compensator.apply(1, pair.corners[1], picture, noArray());
    EXPECT_LE(cv::norm(picture, pair.images[1].getMat(ACCESS_READ), NORM_INF), 1);
}

/// A colour grid of ones.
Mat gridOf(int rows, int cols)
{
    return Mat(Mat::ones(rows, 6 * cols, CV_32F)).reshape(6);
}

TEST(Gcpw_Compensator, gains_that_are_no_colour_grid_are_refused_and_change_nothing)
{
    gcpw::GcpwCompensator compensator;
    const Mat good = gridOf(3, 4);
    std::vector<Mat> gains(2, good);
    compensator.setMatGains(gains);
    const int sizes[] = {2, 3, 4};
    std::vector<Mat> bad = {Mat(), Mat(0, 0, CV_32FC(6)), Mat(3, 4, CV_32FC(3), Scalar::all(1)), Mat(3, sizes, CV_32FC(6))};
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
    {
        bad.push_back(good.clone());
        bad.back().ptr<float>(2)[23] = value;
    }
    for (const Mat& grid : bad)
    {
        std::vector<Mat> mixed = {gridOf(2, 2), grid};
        expectRefused([&] { compensator.setMatGains(mixed); }, "colour grid 1");
        std::vector<Mat> kept;
        compensator.getMatGains(kept);
        ASSERT_EQ(kept.size(), size_t(2));
        EXPECT_EQ(kept[0].size(), good.size());
    }
}

}} // namespace
