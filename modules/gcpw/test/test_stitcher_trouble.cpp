// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <atomic>
#include <set>
#include "refusal.hpp"
#include "stitch_scene.hpp"

namespace opencv_test { namespace {

/// Large empty pictures take minutes to cut.
Ptr<Stitcher> withoutSeams(const Ptr<WarperCreator>& warper)
{
    const Ptr<Stitcher> stitcher = makeStitcher();
    stitcher->setWarper(warper);
    stitcher->setSeamFinder(makePtr<cv::detail::NoSeamFinder>());
    stitcher->setBlender(cv::detail::Blender::createDefault(cv::detail::Blender::NO));
    return stitcher;
}

/// The panorama of OpenCV's own warper and compensator.
Mat plainPanorama(const std::vector<Mat>& images, const std::vector<cv::detail::CameraParams>& cameras,
                  const Ptr<WarperCreator>& warper = makePtr<cv::SphericalWarper>())
{
    const Ptr<Stitcher> plain = withoutSeams(warper);
    Mat panorama;
    CV_CheckEQ(images.size(), cameras.size(), "an image was dropped: a plain stitcher would read beyond its cameras");
    EXPECT_EQ(plain->setTransform(images, cameras), Stitcher::OK);
    EXPECT_EQ(plain->composePanorama(panorama), Stitcher::OK);
    return panorama;
}

/// The same with GCPW attached, which is to find no answer and say so in `message`.
Mat fallenBack(const std::vector<Mat>& images, const std::vector<cv::detail::CameraParams>& cameras, std::string& message,
               const Ptr<WarperCreator>& warper = makePtr<cv::SphericalWarper>())
{
    const Ptr<Stitcher> stitcher = withoutSeams(warper);
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    binding->setImages(images);
    Mat panorama;
    EXPECT_EQ(stitcher->setTransform(images, cameras), Stitcher::OK);
    EXPECT_EQ(stitcher->composePanorama(panorama), Stitcher::OK);
    EXPECT_FALSE(binding->rig().usable());
    message = binding->rig().alignment.report().message;
    return panorama;
}

/// Hands every Mat's memory on to OpenCV's allocator and remembers the largest piece.
class Watch : public MatAllocator
{
public:
    Watch() { Mat::setDefaultAllocator(this); }
    ~Watch() override { Mat::setDefaultAllocator(Mat::getStdAllocator()); }

    size_t largest() const { return largest_; }

    UMatData* allocate(int dims, const int* sizes, int type, void* data, size_t* step, AccessFlag flags,
                       UMatUsageFlags usage) const override
    {
        UMatData* made = Mat::getStdAllocator()->allocate(dims, sizes, type, data, step, flags, usage);
        size_t known = largest_; // Mats are made in OpenCV's threads too
        while (known < made->size && !largest_.compare_exchange_weak(known, made->size)) {}
        return made;
    }
    bool allocate(UMatData* data, AccessFlag flags, UMatUsageFlags usage) const override
    {
        return Mat::getStdAllocator()->allocate(data, flags, usage);
    }
    void deallocate(UMatData* data) const override { Mat::getStdAllocator()->deallocate(data); }

private:
    mutable std::atomic<size_t> largest_{0};
};

TEST(Gcpw_StitcherTrouble, cancelling_gives_the_plain_panorama)
{
    for (const std::string stage : {"features", "homography", "align"})
    {
        const Ptr<Stitcher> stitcher = withoutSeams(makePtr<cv::SphericalWarper>());
        const Ptr<gcpw::StitcherBinding> binding =
            gcpw::attach(stitcher, quick(), [&](const std::string& now, double) { return now != stage; });
        Mat panorama;
        ASSERT_EQ(stitcher->stitch(frameOf(), panorama), Stitcher::OK);
        EXPECT_EQ(binding->rig().alignment.report().status, gcpw::Status::CANCELLED);
        std::vector<Mat> stitched; // the stitcher leaves out what it could not match
        for (const int index : stitcher->component())
            stitched.push_back(frameOf()[static_cast<size_t>(index)]);
        expectSame(plainPanorama(stitched, stitcher->cameras()), panorama);
    }
}


TEST(Gcpw_StitcherTrouble, a_camera_that_is_none_leads_to_a_message)
{
    std::vector<cv::detail::CameraParams> cameras{cameraAt(-0.45), cameraAt(0), cameraAt(0.45)};
    cameras[1].R.at<float>(2, 2) = std::numeric_limits<float>::quiet_NaN();
    const gcpw::Rig rig = gcpw::alignRig(frameOf(), cameras, makePtr<cv::SphericalWarper>(), quick());
    EXPECT_FALSE(rig.usable());
    EXPECT_NE(rig.alignment.report().message.find("camera 1"), std::string::npos);
    // A picture of half the sphere's plane: out of proportion.
    cameras[1] = cameraAt(1.45);
    const gcpw::Rig stretched = gcpw::alignRig(frameOf(), cameras, makePtr<cv::PlaneWarper>(), quick());
    EXPECT_FALSE(stretched.usable());
}


TEST(Gcpw_StitcherTrouble, an_affine_map_beyond_any_canvas_is_refused_and_not_wrapped_around)
{
    const Ptr<cv::detail::RotationWarper> warper = gcpw::GcpwWarper(makePtr<cv::AffineWarper>()).create(1);
    cv::detail::CameraParams close_by; // the canvas is the image
    close_by.R = Mat::eye(3, 3, CV_32F);
    for (const float shift : {3e9F, -2147483648.F, 1e30F})
    {
        cv::detail::CameraParams distant = close_by;
        distant.R = close_by.R.clone();
        distant.R.at<float>(0, 2) = shift;
        expectRefused([&] { warper->warpRoi(RIG_IMAGE, intrinsics(distant), distant.R); }, "beyond any canvas");
        const std::vector<Mat> images(2, Mat(RIG_IMAGE, CV_8UC3, Scalar::all(90)));
        const gcpw::Rig rig = gcpw::alignRig(images, {distant, close_by}, makePtr<cv::AffineWarper>());
        EXPECT_NE(rig.alignment.report().message.find("beyond any canvas"), std::string::npos) << rig.alignment.report().message;
    }
}

TEST(Gcpw_StitcherTrouble, each_status_is_explained_in_words_of_its_own)
{
    std::set<std::string> sentences;
    for (const Stitcher::Status status : {Stitcher::OK, Stitcher::ERR_NEED_MORE_IMGS, Stitcher::ERR_HOMOGRAPHY_EST_FAIL,
                                          Stitcher::ERR_CAMERA_PARAMS_ADJUST_FAIL})
        sentences.insert(gcpw::explain(status));
    EXPECT_EQ(sentences.size(), size_t(4));
    EXPECT_EQ(sentences.count("unknown status"), size_t(0));
}

TEST(Gcpw_StitcherTrouble, too_few_images_are_refused_as_ever)
{
    const Ptr<Stitcher> stitcher = makeStitcher();
    gcpw::attach(stitcher, quick());
    Mat panorama;
    EXPECT_EQ(stitcher->stitch(std::vector<Mat>(), panorama), Stitcher::ERR_NEED_MORE_IMGS);
    EXPECT_EQ(stitcher->stitch(std::vector<Mat>(1, frameOf()[0]), panorama), Stitcher::ERR_NEED_MORE_IMGS);
    EXPECT_THROW(gcpw::attach(Ptr<Stitcher>()), cv::Exception);
}


TEST(Gcpw_StitcherTrouble, unrelated_images_are_refused_as_ever)
{
    const std::vector<Mat> images{photographOf(cameraAt(0), 0, 0, 21), photographOf(cameraAt(0), 0, 0, 22)};
    for (const bool attached : {false, true})
    {
        const Ptr<Stitcher> stitcher = makeStitcher();
        if (attached)
            gcpw::attach(stitcher, quick());
        Mat panorama;
        EXPECT_EQ(stitcher->stitch(images, panorama), Stitcher::ERR_NEED_MORE_IMGS);
        EXPECT_TRUE(panorama.empty());
    }
}

TEST(Gcpw_StitcherTrouble, images_that_do_not_overlap_give_the_plain_panorama)
{
    const std::vector<cv::detail::CameraParams> cameras{cameraAt(-0.6), cameraAt(0.6)};
    const std::vector<Mat> images{photographOf(cameras[0], 0, 0), photographOf(cameras[1], 0, 0)};
    std::string message;
    const Mat panorama = fallenBack(images, cameras, message);
    expectSame(plainPanorama(images, cameras), panorama);
    EXPECT_NE(message.find("overlap"), std::string::npos) << message;
}

TEST(Gcpw_StitcherTrouble, a_camera_out_of_proportion_gives_the_plain_panorama)
{
    const std::vector<cv::detail::CameraParams> cameras{cameraAt(0), cameraAt(0.5), cameraAt(0.95)};
    const Ptr<WarperCreator> plane = makePtr<cv::PlaneWarper>();
    std::string message;
    const Mat panorama = fallenBack(frameOf(), cameras, message, plane);
    expectSame(plainPanorama(frameOf(), cameras, plane), panorama);
    EXPECT_NE(message.find("camera 2"), std::string::npos) << message;
}

TEST(Gcpw_StitcherTrouble, a_panorama_wider_than_32767_px_is_the_plain_one)
{
    std::vector<cv::detail::CameraParams> cameras{cameraAt(-1.4), cameraAt(1.4)};
    const std::vector<Mat> images{photographOf(cameras[0], 0, 0), photographOf(cameras[1], 0, 0)};
    for (cv::detail::CameraParams& camera : cameras)
        camera.focal = 12000;
    std::string message;
    const Mat panorama = fallenBack(images, cameras, message);
    EXPECT_GT(panorama.cols, 32767);
    expectSame(plainPanorama(images, cameras), panorama);
}

TEST(Gcpw_StitcherTrouble, a_camera_that_is_not_finite_is_named_in_an_exception)
{
    std::vector<cv::detail::CameraParams> cameras{cameraAt(-0.45), cameraAt(0), cameraAt(0.45)};
    cameras[1].R.at<float>(2, 2) = std::numeric_limits<float>::quiet_NaN();
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    binding->setImages(frameOf());
    ASSERT_EQ(stitcher->setTransform(frameOf(), cameras), Stitcher::OK);
    Mat panorama;
    try
    {
        stitcher->composePanorama(panorama);
        FAIL() << "there is no picture of such a camera";
    }
    catch (const cv::Exception& e)
    {
        EXPECT_NE(e.err.find("not finite"), std::string::npos) << e.err;
    }
    EXPECT_NE(binding->rig().alignment.report().message.find("camera 1"), std::string::npos);
}

TEST(Gcpw_StitcherTrouble, equal_rotations_are_stitched)
{
    const std::vector<cv::detail::CameraParams> cameras(2, cameraAt(0));
    const std::vector<Mat> images{photographOf(cameras[0], 0, 0), photographOf(cameras[0], 3, 1)};
    const Ptr<Stitcher> stitcher = makeStitcher();
    const Ptr<gcpw::StitcherBinding> binding = gcpw::attach(stitcher, quick());
    binding->setImages(images);
    Mat first;
    Mat again;
    ASSERT_EQ(stitcher->setTransform(images, cameras), Stitcher::OK);
    ASSERT_EQ(stitcher->composePanorama(first), Stitcher::OK);
    EXPECT_TRUE(binding->rig().usable()) << binding->rig().alignment.report().message;
    ASSERT_EQ(stitcher->composePanorama(images, again), Stitcher::OK);
    expectSame(first, again);
}

TEST(Gcpw_StitcherTrouble, bad_cameras_do_not_eat_the_memory)
{
    const size_t limit = 32 << 20; // the images have 0.4 MB each
    std::vector<cv::detail::CameraParams> cameras{cameraAt(-0.2), cameraAt(0.2)};
    const std::vector<Mat> images{photographOf(cameras[0], 0, 0), photographOf(cameras[1], 0, 0)};
    const auto expectFrugal = [&](const Ptr<WarperCreator>& base, float scale)
    {
        const Watch watch;
        EXPECT_FALSE(gcpw::alignRig(images, cameras, base, quick()).usable());
        const Ptr<cv::detail::RotationWarper> warper = gcpw::GcpwWarper(base).create(scale);
        const Mat K = intrinsics(cameras[1]);
        Mat picture;
        Mat x_map;
        Mat y_map;
        EXPECT_THROW(warper->warpRoi(images[1].size(), K, cameras[1].R), cv::Exception);
        EXPECT_THROW(warper->buildMaps(images[1].size(), K, cameras[1].R, x_map, y_map), cv::Exception);
        EXPECT_THROW(warper->warp(images[1], K, cameras[1].R, INTER_LINEAR, BORDER_REFLECT, picture), cv::Exception);
        EXPECT_LT(watch.largest(), limit);
    };
    // One camera's picture is out of all proportion to its image.
    cameras[0].focal = cameras[1].focal = 1e7;
    cameras[1].R = cameraAt(1.57).R;
    expectFrugal(makePtr<cv::PlaneWarper>(), 1e7F);
    cameras[1] = cameraAt(0);
    cameras[0].focal = 1e9;
    expectFrugal(makePtr<cv::SphericalWarper>(), 1e6F);
    // An image across the seam of a circle of more than 32767 px.
    cameras[0] = cameraAt(0);
    cameras[1] = cameraAt(CV_PI);
    expectFrugal(makePtr<cv::SphericalWarper>(), 5300);
}

}} // namespace
