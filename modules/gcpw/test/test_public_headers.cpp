// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
// Both namespaces at once, as a user's file may have them: no public name of ours hides one of OpenCV's.
#include "test_precomp.hpp"

#include <type_traits>
#include "opencv2/gcpw.hpp"

namespace opencv_test
{
namespace
{

using namespace cv;
using namespace cv::gcpw;

TEST(Gcpw_PublicHeaders, both_namespaces_can_be_used_together)
{
    const detail::CameraParams camera;
    const Ptr<detail::RotationWarper> base = makePtr<detail::SphericalWarper>(100.F);
    const GcpwRotationWarper warper(base);
    EXPECT_EQ(camera.R.type(), CV_64FC1);
    EXPECT_EQ(warper.getScale(), 100.F);
}

TEST(Gcpw_PublicHeaders, private_types_make_no_public_class)
{
    EXPECT_FALSE((std::is_constructible<GcpwWarper, const std::shared_ptr<cv::gcpw::SharedState>&>::value));
    EXPECT_FALSE((std::is_constructible<GcpwCompensator, const Params&, const std::shared_ptr<cv::gcpw::SharedState>&>::value));
    EXPECT_FALSE((std::is_constructible<GcpwRotationWarper, const Ptr<detail::RotationWarper>&,
                                        const std::shared_ptr<const cv::gcpw::RigModel>&>::value));
}

TEST(Gcpw_PublicHeaders, a_rotation_warper_of_one_s_own_is_that_of_its_creator)
{
    EXPECT_THROW(GcpwRotationWarper(Ptr<detail::RotationWarper>()), cv::Exception);
    const Ptr<detail::RotationWarper> base = makePtr<detail::SphericalWarper>(100.F);
    GcpwRotationWarper warper(base);
    const Ptr<detail::RotationWarper> created = GcpwWarper(makePtr<SphericalWarper>()).create(100.F);
    Mat K = (Mat_<float>(3, 3) << 100, 0, 40, 0, 100, 30, 0, 0, 1);
    const Mat R = Mat::eye(3, 3, CV_32F);
    EXPECT_EQ(warper.warpRoi(Size(80, 60), K, R), created->warpRoi(Size(80, 60), K, R));
}

TEST(Gcpw_PublicHeaders, blended_pictures_are_the_same_returned_or_handed_out)
{
    PairCanvas canvas;
    canvas.source = Mat(40, 60, CV_8UC3, Scalar(10, 20, 30));
    canvas.source_corrected = canvas.source + Scalar::all(50);
    canvas.target = Mat(40, 60, CV_8UC3, Scalar(90, 80, 70));
    canvas.source_mask = Mat(40, 60, CV_8UC1, Scalar(255));
    canvas.target_mask = canvas.source_mask.clone();
    for (const Blend blend : {Blend::AVERAGE, Blend::MULTIBAND})
    {
        UMat picture;
        blendPair(canvas, blend, picture);
        EXPECT_EQ(cv::norm(picture, blendPair(canvas, blend), NORM_INF), 0);
    }
}

TEST(Gcpw_PublicHeaders, a_base_warper_may_be_named_and_unknown_names_are_refused)
{
    const std::vector<Mat> images(2, Mat(60, 80, CV_8UC3, Scalar::all(128)));
    std::vector<detail::CameraParams> cameras(2);
    for (detail::CameraParams& camera : cameras)
    {
        camera.focal = 100;
        camera.ppx = 40;
        camera.ppy = 30;
        camera.R = Mat::eye(3, 3, CV_32F);
    }
    for (const char* name : {"plane", "affine", "cylindrical", "spherical", "fisheye", "stereographic", "compressedPlaneA2B1",
                             "compressedPlaneA1.5B1", "compressedPlanePortraitA2B1", "compressedPlanePortraitA1.5B1", "paniniA2B1",
                             "paniniA1.5B1", "paniniPortraitA2B1", "paniniPortraitA1.5B1", "mercator", "transverseMercator"})
    {
        EXPECT_NO_THROW(PyRotationWarper(name, 100.F)) << name;
        EXPECT_EQ(alignRigByName(images, cameras, name).cameras.size(), cameras.size()) << name;
    }
    EXPECT_THROW(alignRigByName(images, cameras, "sperical"), cv::Exception);
}

} // namespace
} // namespace opencv_test
