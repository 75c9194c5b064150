// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "test_precomp.hpp"

#include <cstdio>
#include <fstream>
#include "rig_scene.hpp"

namespace opencv_test { namespace {

gcpw::Rig irregularRig()
{
    gcpw::Rig rig = bentRig(makePtr<cv::SphericalWarper>(), {cameraAt(-0.3, 0.1), cameraAt(1.0 / 3, -0.1)}, CV_PI, {0, 0.1});
    rig.component = {2, 5};
    rig.work_scale = 1.0 / 3;
    return rig;
}

void expectSame(const gcpw::Alignment& a, const gcpw::Alignment& b)
{
    ASSERT_EQ(a.imageCount(), b.imageCount());
    EXPECT_EQ(a.canvasScale(), b.canvasScale());
    EXPECT_EQ(a.report().status, b.report().status);
    EXPECT_EQ(a.report().message, b.report().message);
    for (int i = 0; i < a.imageCount(); ++i)
    {
        EXPECT_EQ(a.image(i).full_size, b.image(i).full_size);
        EXPECT_EQ(a.image(i).work_size, b.image(i).work_size);
        EXPECT_EQ(cv::norm(a.image(i).mesh, b.image(i).mesh, NORM_INF), 0);
        EXPECT_EQ(cv::norm(a.image(i).rough, b.image(i).rough, NORM_INF), 0);
        EXPECT_EQ(cv::norm(a.image(i).color, b.image(i).color, NORM_INF), 0);
    }
}

class Gcpw_AlignmentIo : public testing::TestWithParam<const char*>
{
};

TEST_P(Gcpw_AlignmentIo, what_is_loaded_is_what_was_saved_bit_for_bit)
{
    const std::string path = cv::tempfile(GetParam());
    const gcpw::Rig rig = irregularRig();
    rig.alignment.save(path);
    expectSame(rig.alignment, gcpw::Alignment::load(path));
    rig.save(path);
    const gcpw::Rig loaded = gcpw::Rig::load(path);
    expectSame(rig.alignment, loaded.alignment);
    EXPECT_TRUE(loaded.usable());
    EXPECT_TRUE(loaded.fits(rig.cameras));
    EXPECT_EQ(loaded.component, rig.component);
    EXPECT_EQ(loaded.turns, rig.turns);
    EXPECT_EQ(loaded.scale, rig.scale);
    EXPECT_EQ(loaded.work_scale, rig.work_scale);
    std::remove(path.c_str());
}

INSTANTIATE_TEST_SUITE_P(endings, Gcpw_AlignmentIo, testing::Values(".yml", ".json", ".xml", ".yml.gz", ".json.gz"));

TEST(Gcpw_AlignmentIo, a_missing_file_is_named)
{
    try
    {
        gcpw::Alignment::load("no_such_folder/model.yml");
        FAIL();
    }
    catch (const cv::Exception& e)
    {
        EXPECT_NE(e.err.find("no_such_folder/model.yml"), std::string::npos) << e.err;
    }
    EXPECT_THROW(irregularRig().save("no_such_folder/model.yml"), cv::Exception);
}

TEST(Gcpw_AlignmentIo, a_file_of_another_kind_or_a_damaged_one_is_refused)
{
    const std::string path = cv::tempfile(".yml");
    irregularRig().alignment.save(path);
    EXPECT_THROW(gcpw::Rig::load(path), cv::Exception);
    std::ifstream in(path);
    const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    in.close();
    std::ofstream(path) << text.substr(0, text.size() / 2);
    EXPECT_THROW(gcpw::Alignment::load(path), cv::Exception);
    std::ofstream(path) << "not a model";
    EXPECT_THROW(gcpw::Alignment::load(path), cv::Exception);
    std::remove(path.c_str());
}

TEST(Gcpw_AlignmentIo, another_camera_does_not_fit)
{
    const gcpw::Rig rig = irregularRig();
    std::vector<cv::detail::CameraParams> others = rig.cameras;
    EXPECT_TRUE(rig.fits(others));
    others[1].R = others[1].R.clone();
    others[1].R.at<float>(0, 1) += 1e-6F;
    EXPECT_FALSE(rig.fits(others));
    others = rig.cameras;
    others[0].focal += 1e-9;
    EXPECT_FALSE(rig.fits(others));
}

}} // namespace
