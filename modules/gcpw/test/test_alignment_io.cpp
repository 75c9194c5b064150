// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <cstdio>
#include <fstream>
#include "refusal.hpp"
#include "rig_scene.hpp"
#ifndef _WIN32
#include <csignal>
#include <sys/resource.h>
#endif

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

std::string textOf(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    return std::string((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
}

/// Loads a rig's file in which `from` was replaced.
void expectDamaged(const std::string& text, const std::string& from, const std::string& to, const std::string& part)
{
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::string damaged = text;
    damaged.replace(at, from.size(), to);
    const std::string path = cv::tempfile(".yml");
    std::ofstream(path, std::ios::binary) << damaged;
    expectRefused([&] { gcpw::Rig::load(path); }, part);
    expectRefused([&] { gcpw::Rig::load(path); }, path);
    std::remove(path.c_str());
}

TEST(Gcpw_AlignmentIo, a_text_that_nests_too_deep_for_the_parser_is_refused)
{
    const int deep = 300000;
    std::string tags;
    for (int i = 0; i < deep; ++i)
        tags += "<a>";
    std::string steps;
    for (int i = 0; i < 2000; ++i)
        steps += std::string(static_cast<size_t>(i), ' ') + "a:\n";
    const std::string brackets = std::string(deep, '[') + std::string(deep, ']');
    const std::pair<const char*, std::string> texts[] = {{".yml", "%YAML:1.0\n---\nx: " + brackets + "\n"},
                                                         {".yml", "%YAML:1.0\n---\n" + steps},
                                                         {".json", "{ \"x\": " + brackets + "}\n"},
                                                         {".xml", "<?xml version=\"1.0\"?>\n<opencv_storage>\n" + tags}};
    for (const auto& text : texts)
    {
        const std::string path = cv::tempfile(text.first);
        std::ofstream(path) << text.second;
        expectRefused([&] { gcpw::Rig::load(path); }, "deeper");
        expectRefused([&] { gcpw::Alignment::load(path); }, path);
        std::remove(path.c_str());
    }
}

TEST(Gcpw_AlignmentIo, a_text_that_ends_anywhere_is_refused)
{
    for (const char* ending : {".yml", ".json", ".xml"})
    {
        const std::string path = cv::tempfile(ending);
        irregularRig().save(path);
        const std::string whole = textOf(path);
        const size_t head = 1500; // it has every kind of tag
        for (size_t length = 0; length < head; length += ending == std::string(".xml") ? 1 : 31)
        {
            std::ofstream(path) << whole.substr(0, length);
            expectRefused([&] { gcpw::Rig::load(path); }, path);
        }
        std::remove(path.c_str());
    }
}

TEST(Gcpw_AlignmentIo, brackets_and_quotes_in_a_message_are_only_characters)
{
    for (const char* ending : {".yml", ".json", ".xml"})
    {
        gcpw::Report report;
        report.message = "it's [ { < \" ' ] of 'x[0]' <tag> </end> {{{";
        const std::string path = cv::tempfile(ending);
        const gcpw::Alignment rough(std::vector<gcpw::Alignment::Image>(), Size2d(1, 1), report);
        rough.save(path);
        EXPECT_EQ(gcpw::Alignment::load(path).report().message, report.message) << ending;
        std::remove(path.c_str());
    }
}

TEST(Gcpw_AlignmentIo, values_that_no_rig_has_are_refused)
{
    const std::string path = cv::tempfile(".yml");
    gcpw::Rig rig = irregularRig();
    rig.turns = {0, 0};
    rig.save(path);
    const std::string text = textOf(path);
    std::remove(path.c_str());
    expectDamaged(text, "status: 0", "status: 77", "status is 77");
    expectDamaged(text, "status: 0", "status: -1", "status is -1");
    expectDamaged(text, "turns: [ 0., 0. ]", "turns: [ .Nan, 0. ]", "turns[0]");
    expectDamaged(text, "turns: [ 0., 0. ]", "turns: [ 1e300, 0. ]", "turns[0]");
    expectDamaged(text, "turns: [ 0., 0. ]", "turns: [ 0. ]", "turns");
    expectDamaged(text, "component: [ 2, 5 ]", "component: [ 2, 2 ]", "component[1]");
    expectDamaged(text, "component: [ 2, 5 ]", "component: [ 0, 1, 0 ]", "component");
    expectDamaged(text, "component: [ 2, 5 ]", "component: [ 2, -5 ]", "component[1]");
    expectDamaged(text, "scale: 420.", "scale: -420.", "scale");
    expectDamaged(text, "scale: 420.", "scale: .Inf", "scale");
    expectDamaged(text, "focal: 420.", "focal: 0.", "focal");
    expectDamaged(text, "aspect: 1.", "aspect: 0.", "aspect");
    expectDamaged(text, "canvas_scale: [ 1., 1. ]", "canvas_scale: [ .Inf, 1. ]", "canvas scale");
    expectDamaged(text, "canvas_scale: [ 1., 1. ]", "canvas_scale: [ 1. ]", "canvas_scale");
}

TEST(Gcpw_AlignmentIo, a_matrix_is_refused_by_its_header)
{
    const std::string path = cv::tempfile(".yml");
    irregularRig().save(path);
    const std::string text = textOf(path);
    std::remove(path.c_str());
    for (const char* rows : {"rows: 2147483647", "rows: 258", "rows: -3"})
        expectDamaged(text, "rows: 7", rows, "mesh is a matrix of");
    expectDamaged(text, "cols: 9", "cols: 1000000000", "mesh is a matrix of");
    expectDamaged(text, "rows: 3", "rows: 2147483647", "R of a camera is a matrix of");
    expectDamaged(text, "dt: \"2d\"", "dt: \"512d\"", "mesh is a matrix of");
    expectDamaged(text, "dt: \"6f\"", "dt: \"6d\"", "color is a matrix of");
}

/// Names of a folder's files that start with `stem`.
std::vector<std::string> filesLike(const std::string& stem)
{
    std::vector<String> found;
    cv::glob(stem + "*", found, false);
    return std::vector<std::string>(found.begin(), found.end());
}

TEST(Gcpw_AlignmentIo, saving_leaves_the_one_file_and_replaces_an_older_one)
{
    const std::string stem = cv::tempfile("_model");
    const gcpw::Rig rig = irregularRig();
    for (const char* ending : {".yml", ".json.gz"})
    {
        std::ofstream(stem + ending) << "older";
        rig.save(stem + ending);
        EXPECT_TRUE(gcpw::Rig::load(stem + ending).usable());
        EXPECT_EQ(filesLike(stem).size(), 1u) << ending;
        std::remove((stem + ending).c_str());
    }
}

TEST(Gcpw_AlignmentIo, a_neighbour_of_any_name_is_not_touched)
{
    const std::string stem = cv::tempfile("_model");
    std::ofstream(stem + ".part0.yml") << "mine";
    irregularRig().save(stem + ".yml");
    EXPECT_EQ(textOf(stem + ".part0.yml"), "mine");
    EXPECT_EQ(filesLike(stem).size(), 2u);
    std::remove((stem + ".part0.yml").c_str());
    std::remove((stem + ".yml").c_str());
}

TEST(Gcpw_AlignmentIo, a_file_that_cannot_be_written_is_an_error)
{
    for (const char* ending : {".yml", ".json", ".xml", ".yml.gz"})
    {
        const std::string path = std::string("no_such_folder/model") + ending;
        expectRefused([&] { irregularRig().alignment.save(path); }, path);
        expectRefused([&] { irregularRig().save(path); }, path);
    }
}

#ifndef _WIN32
/// While it lives, no file may grow beyond some bytes: what a full disk does.
class FullDisk
{
public:
    explicit FullDisk(rlim_t bytes)
    {
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk()
    {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

TEST(Gcpw_AlignmentIo, a_full_disk_is_an_error_and_keeps_the_older_file)
{
    const gcpw::Rig rig = irregularRig();
    for (const char* ending : {".yml", ".json", ".xml", ".yml.gz"})
    {
        const std::string stem = cv::tempfile("_model");
        std::ofstream(stem + ending) << "older";
        for (const bool whole : {false, true})
        {
            std::string refusal;
            {
                const FullDisk full(whole ? 2048 : 512);
                refusal = refusalOf([&]
                {
                    if (whole)
                        rig.save(stem + ending);
                    else
                        rig.alignment.save(stem + ending);
                });
            }
            EXPECT_NE(refusal.find(stem + ending), std::string::npos) << ending << refusal;
            EXPECT_EQ(textOf(stem + ending), "older") << ending;
            EXPECT_EQ(filesLike(stem).size(), 1u) << ending;
        }
        std::remove((stem + ending).c_str());
    }
}
#endif

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
