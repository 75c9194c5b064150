// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <limits>
#include "rendering/color_field.hpp"
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

TEST(Gcpw_Compensator, a_square_in_one_of_two_equal_photographs_changes_neither)
{
    const Mat photograph = photographOf(cameraAt(0), 0, 0);
    for (const Scalar& color : {Scalar(0, 0, 255), Scalar::all(0), Scalar::all(255)})
    {
        Mat painted = photograph.clone();
        painted(Rect(20, 20, 30, 30)).setTo(color);
        const Mat pictures[] = {photograph, painted};
        std::vector<UMat> images;
        for (const Mat& picture : pictures)
            images.push_back(picture.getUMat(ACCESS_READ).clone());
        const std::vector<UMat> masks(2, UMat(photograph.size(), CV_8UC1, Scalar(255)));
        const std::vector<Point> corners(2);
        gcpw::GcpwCompensator compensator;
        compensator.feed(corners, images, masks);
        for (int i = 0; i < 2; ++i)
        {
            Mat corrected = pictures[i].clone();
            compensator.apply(i, corners[i], corrected, masks[i]);
            EXPECT_GT(cv::PSNR(corrected, pictures[i]), 45) << color;
            const Rect far(150, 0, photograph.cols - 150, photograph.rows);
            Mat change;
            cv::absdiff(corrected(far), pictures[i](far), change);
            const Scalar means = cv::mean(change);
            EXPECT_LT(std::max(std::max(means[0], means[1]), means[2]), 1) << color;
        }
    }
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
    Mat expected = picture.clone();
    gcpw::ColorField(gains[0]).apply(expected, Mat(), [&](Point p)
    {
        return Point2f((static_cast<float>(p.x) + 0.5F) * 6 / static_cast<float>(picture.cols),
                       (static_cast<float>(p.y) + 0.5F) * 5 / static_cast<float>(picture.rows));
    });
    compensator.apply(0, Point(), picture, noArray());
    EXPECT_LE(cv::norm(picture, expected, NORM_INF), 1);
    EXPECT_LE(cv::norm(picture, expected, NORM_L1) / (3.0 * static_cast<double>(picture.total())), 0.05);
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

TEST(Gcpw_Compensator, colours_do_not_depend_on_which_warper_was_made_last)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const double turn = cvRound(CV_PI * RIG_FOCAL) / RIG_FOCAL;
    for (const bool straddles : {false, true})
    {
        const double yaw = straddles ? turn : 0.3;
        const gcpw::Rig rig = bentRig(base, {cameraAt(yaw - 0.6), cameraAt(yaw)}, 6, {0, straddles ? turn : 0});
        const auto corrected = [&](double picture_zoom, const std::vector<double>& zooms)
        {
            const gcpw::GcpwWarper creator(base, rig);
            const Ptr<gcpw::GcpwCompensator> compensator = creator.compensator();
            const Ptr<cv::detail::RotationWarper> warper =
                gcpw::GcpwWarper(base, rig).create(static_cast<float>(rig.scale * picture_zoom));
            const Size size(cvRound(RIG_IMAGE.width * picture_zoom), cvRound(RIG_IMAGE.height * picture_zoom));
            Mat picture;
            const Point corner = warper->warp(Mat(size, CV_8UC3, Scalar(90, 120, 150)), intrinsics(rig.cameras[1], picture_zoom),
                                              rig.cameras[1].R, INTER_LINEAR, BORDER_REFLECT, picture);
            for (const double zoom : zooms)
                creator.create(static_cast<float>(rig.scale * zoom));
            compensator->apply(1, corner, picture, noArray());
            return picture;
        };
        for (const double zoom : {0.4, 1.0, 1.7})
        {
            const Mat expected = corrected(zoom, {zoom});
            EXPECT_GT(cv::norm(expected, Mat(expected.size(), CV_8UC3, Scalar(90, 120, 150)), NORM_INF), 10);
            EXPECT_EQ(cv::norm(expected, corrected(zoom, {0.4, 1.0, 1.7}), NORM_INF), 0) << zoom << straddles;
            EXPECT_EQ(cv::norm(expected, corrected(zoom, {1.7, 1.0, 0.4}), NORM_INF), 0) << zoom << straddles;
            // Before any warper, and after others, the place tells the scale as well as it can.
            EXPECT_LE(cv::norm(expected, corrected(zoom, {}), NORM_INF), 4) << zoom << straddles;
            EXPECT_LE(cv::norm(expected, corrected(zoom, {0.1}), NORM_INF), 4) << zoom << straddles;
        }
    }
}

TEST(Gcpw_Compensator, a_part_of_a_picture_has_the_colours_of_the_whole)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const gcpw::Rig rig = bentRig(base, {cameraAt(-0.3), cameraAt(0.3)}, 6);
    const gcpw::GcpwWarper creator(base, rig);
    const Ptr<gcpw::GcpwCompensator> compensator = creator.compensator();
    const Ptr<cv::detail::RotationWarper> warper = creator.create(rig.scale);
    creator.create(rig.scale * 0.4F);
    Mat picture;
    const Point corner = warper->warp(Mat(RIG_IMAGE, CV_8UC3, Scalar(90, 120, 150)), intrinsics(rig.cameras[1]), rig.cameras[1].R,
                                      INTER_LINEAR, BORDER_REFLECT, picture);
    const Rect part(160, 80, 120, 96); // whole steps of the colour map
    Mat piece = picture(part).clone();
    compensator->apply(1, corner, picture, noArray());
    compensator->apply(1, corner + part.tl(), piece, noArray());
    EXPECT_LE(cv::norm(picture(part), piece, NORM_INF), 1);
}

TEST(Gcpw_Compensator, a_rigs_colours_are_there_before_the_first_warper)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const gcpw::Rig rig = bentRig(base, {cameraAt(-0.3), cameraAt(0.3)}, 6);
    const gcpw::GcpwWarper creator(base, rig);
    const Ptr<gcpw::GcpwCompensator> compensator = creator.compensator();
    const Pair pair;
    compensator->feed(pair.corners, pair.images, pair.masks);
    std::vector<Mat> gains;
    compensator->getMatGains(gains);
    ASSERT_EQ(gains.size(), size_t(2));
    EXPECT_EQ(cv::norm(gains[1], rig.alignment.image(1).color, NORM_INF), 0);
}

TEST(Gcpw_Compensator, what_was_fed_before_gives_way_to_a_rig)
{
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    const gcpw::Rig rig = bentRig(base, {cameraAt(-0.3), cameraAt(0.3)}, 6);
    gcpw::GcpwWarper creator(base);
    const Ptr<gcpw::GcpwCompensator> compensator = creator.compensator();
    const Pair pair;
    compensator->feed(pair.corners, pair.images, pair.masks);
    std::vector<Mat> fed;
    compensator->getMatGains(fed);
    ASSERT_EQ(fed.size(), size_t(2));
    creator.setRig(rig);
    std::vector<Mat> gains;
    compensator->getMatGains(gains);
    EXPECT_EQ(cv::norm(gains[1], rig.alignment.image(1).color, NORM_INF), 0);
    // But what was set stays, also for more images than the rig has.
    fed.push_back(fed[0]);
    compensator->setMatGains(fed);
    compensator->getMatGains(gains);
    ASSERT_EQ(gains.size(), size_t(3));
    EXPECT_EQ(cv::norm(gains[1], fed[1], NORM_INF), 0);
    Mat picture;
    pair.images[0].copyTo(picture);
    EXPECT_NO_THROW(compensator->apply(2, Point(), picture, noArray()));
}

TEST(Gcpw_Compensator, while_the_fallback_is_in_use_gains_are_the_fallbacks)
{
    typedef cv::detail::ExposureCompensator E;
    const Pair pair;
    for (const int type : {E::GAIN, E::GAIN_BLOCKS, E::CHANNELS, E::CHANNELS_BLOCKS})
    {
        const Ptr<E> plain = E::createDefault(type);
        plain->feed(pair.corners, pair.images, pair.masks);
        std::vector<Mat> expected;
        plain->getMatGains(expected);
        gcpw::GcpwCompensator compensator;
        compensator.setFallback(E::createDefault(type));
        compensator.feed(pair.corners, pair.images, pair.masks);
        std::vector<Mat> gains;
        compensator.getMatGains(gains);
        ASSERT_EQ(gains.size(), size_t(2)) << type;
        EXPECT_EQ(cv::norm(gains[1].reshape(1), expected[1].reshape(1), NORM_INF), 0) << type;

        gcpw::GcpwCompensator second;
        second.setFallback(E::createDefault(type));
        second.setMatGains(gains);
        Mat pictures[2];
        for (Mat& picture : pictures)
            pair.images[1].copyTo(picture);
        plain->apply(1, pair.corners[1], pictures[0], noArray());
        second.apply(1, pair.corners[1], pictures[1], noArray());
        EXPECT_EQ(cv::norm(pictures[0], pictures[1], NORM_INF), 0) << type;
    }
    // Colour grids are nobody's but ours.
    gcpw::GcpwCompensator first;
    first.feed(pair.corners, pair.images, pair.masks);
    std::vector<Mat> grids;
    first.getMatGains(grids);
    gcpw::GcpwCompensator compensator;
    compensator.setFallback(E::createDefault(E::GAIN));
    compensator.setMatGains(grids);
    std::vector<Mat> kept;
    compensator.getMatGains(kept);
    ASSERT_EQ(kept.size(), size_t(2));
    EXPECT_EQ(cv::norm(kept[1], grids[1], NORM_INF), 0);
}

TEST(Gcpw_Compensator, feed_refuses_what_apply_would_refuse)
{
    const Pair pair;
    gcpw::GcpwCompensator compensator;
    compensator.feed(pair.corners, pair.images, pair.masks);
    std::vector<Mat> before;
    compensator.getMatGains(before);
    const Size size = pair.images[0].size();
    for (const int type : {CV_8UC4, CV_16UC3, CV_16UC1, CV_32FC3})
        EXPECT_THROW(compensator.feed(pair.corners, {UMat(size, type, Scalar::all(9)), UMat(size, type, Scalar::all(9))}, pair.masks), cv::Exception) << type;
    for (const int type : {CV_32FC1, CV_8SC1, CV_8UC3})
        EXPECT_THROW(compensator.feed(pair.corners, pair.images, std::vector<UMat>(2, UMat(size, type, Scalar::all(255)))), cv::Exception) << type;
    std::vector<Mat> after;
    compensator.getMatGains(after);
    EXPECT_EQ(cv::norm(before[1], after[1], NORM_INF), 0);
}

TEST(Gcpw_Compensator, an_image_without_pixels_or_a_mask_of_another_size_is_named)
{
    const Pair pair;
    gcpw::GcpwCompensator compensator;
    std::vector<UMat> images = pair.images;
    images[1] = UMat();
    expectRefused([&] { compensator.feed(pair.corners, images, pair.masks); }, "image 1 given to feed() is 0 x 0 px");
    std::vector<UMat> masks = pair.masks;
    masks[0] = UMat(1000, 2000, CV_8UC1, Scalar(255));
    expectRefused([&] { compensator.feed(pair.corners, pair.images, masks); }, "its mask 2000 x 1000 px");
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
