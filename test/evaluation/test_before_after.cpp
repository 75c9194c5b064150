// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <opencv2/gcpw/rig.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include "evaluation/before_after.hpp"
#include "moved_mesh.hpp"
#include "scratch_folder.hpp"

namespace
{

const cv::Size SIZE(400, 300);

/// One photograph, a black rectangle on white, stitched both ways; GCPW bends it by a bow of so many pixels.
class Evaluation_BeforeAfter : public ::testing::Test
{
protected:
    cv::Mat draw(double height)
    {
        cv::Mat photograph(SIZE, CV_8UC3, cv::Scalar::all(230));
        cv::rectangle(photograph, cv::Rect(60, 80, 280, 140), cv::Scalar::all(20), cv::FILLED);
        cv::imwrite(folder_.path("photograph.png"), photograph);
        cv::gcpw::Rig rig;
        rig.scale = 350;
        rig.cameras.resize(1);
        rig.cameras[0].focal = 350;
        rig.cameras[0].ppx = 200;
        rig.cameras[0].ppy = 150;
        rig.cameras[0].R = cv::Mat::eye(3, 3, CV_32F);
        rig.image_sizes = {SIZE};
        cv::Mat K;
        rig.cameras[0].K().convertTo(K, CV_32F);
        const cv::Rect roi = cv::PyRotationWarper("plane", rig.scale).warpRoi(SIZE, K, rig.cameras[0].R);
        cv::gcpw::AlignedImage image = movedMesh(roi.size(), [&](const cv::Vec2d& p)
        { return cv::Vec2d(p[0], p[1] + height * std::sin(CV_PI * (p[0] + 0.5) / roi.width)); }, 32);
        cv::add(image.rough, cv::Scalar(roi.x, roi.y), image.rough);
        cv::add(image.mesh, cv::Scalar(roi.x, roi.y), image.mesh);
        rig.alignment = cv::gcpw::Alignment({image}, cv::Size2d(1, 1), cv::gcpw::Report());
        dump("none", roi);
        dump("gcpw", roi + cv::Size(0, cvRound(height)));
        rig.save(folder_.path("gcpw/model.yml.gz"));
        return evaluation::beforeAfter(folder_.path("none"), folder_.path("gcpw"), {folder_.path("photograph.png")}, 800);
    }

    void dump(const std::string& method, const cv::Rect& place) const
    {
        folder_.write(method + "/corners.csv", cv::format("000,%d,%d\n", place.x, place.y));
        const cv::Mat picture(place.size(), CV_8UC3, cv::Scalar::all(128));
        for (const char* name : {"/000_image.png", "/000_corrected.png", "/panorama.png"})
            cv::imwrite(folder_.path(method) + name, picture);
        cv::imwrite(folder_.path(method) + "/000_mask.png", cv::Mat(place.size(), CV_8UC1, cv::Scalar(255)));
    }

    /// Pixels of one half that are clearly more of this channel (of B, G, R) than of the other two.
    static int colored(const cv::Mat& picture, bool left, int channel)
    {
        std::vector<cv::Mat> planes;
        cv::split(picture.colRange(left ? 0 : picture.cols / 2, left ? picture.cols / 2 : picture.cols).rowRange(40, 300), planes);
        for (cv::Mat& plane : planes)
            plane.convertTo(plane, CV_32F);
        const cv::Mat a = planes[channel] - planes[(channel + 1) % 3] > 120; // the orange of a frame is not red
        const cv::Mat b = planes[channel] - planes[(channel + 2) % 3] > 120;
        return cv::countNonZero(a & b);
    }

    ScratchFolder folder_;
};

TEST_F(Evaluation_BeforeAfter, what_bends_is_red_and_only_in_the_picture_that_bends_it)
{
    const cv::Mat picture = draw(14);
    EXPECT_NEAR(picture.cols, 800, 2);
    EXPECT_GT(colored(picture, true, 1), 300) << "held";
    EXPECT_EQ(colored(picture, true, 2), 0);
    EXPECT_GT(colored(picture, false, 1), 100) << "upright edges are only shifted";
    EXPECT_GT(colored(picture, false, 2), 300) << "bent";
}

TEST_F(Evaluation_BeforeAfter, what_is_held_is_green_in_both)
{
    const cv::Mat picture = draw(0);
    EXPECT_GT(colored(picture, false, 1), 300);
    EXPECT_EQ(colored(picture, false, 2), 0);
}

TEST_F(Evaluation_BeforeAfter, a_missing_file_is_named)
{
    draw(3);
    std::filesystem::remove(folder_.path("none/panorama.png"));
    try
    {
        evaluation::beforeAfter(folder_.path("none"), folder_.path("gcpw"), {folder_.path("photograph.png")}, 800);
        FAIL();
    }
    catch (const cv::Exception& error)
    {
        EXPECT_NE(error.err.find("panorama"), std::string::npos) << error.err;
    }
}

} // namespace
