// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <csignal>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <opencv2/gcpw/alignment.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include "common/held_signals.hpp"
#include "common/write_file.hpp"
#include "scratch_folder.hpp"

namespace
{

/// How a process of its own that makes the call ends: as waitpid() tells it.
int endOf(const std::function<void()>& call)
{
    const pid_t child = fork();
    if (child == 0)
    {
        call();
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

bool endedBy(int status, int signal)
{
    return WIFSIGNALED(status) && WTERMSIG(status) == signal;
}

TEST(HeldSignals, end_the_program_once_the_work_is_done)
{
    const ScratchFolder folder;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    {
        const int status = endOf(
            [&]
            {
            const HeldSignals held;
            std::raise(signal);
            folder.write("done" + std::to_string(signal), "yes");
        });
        EXPECT_TRUE(endedBy(status, signal)) << status;
        EXPECT_EQ(folder.read("done" + std::to_string(signal)), "yes");
    }
}

TEST(HeldSignals, whoever_asks_twice_does_not_wait)
{
    const int status = endOf(
        []
        {
        const HeldSignals held;
        std::raise(SIGTERM);
        std::raise(SIGTERM);
        _exit(1);
    });
    EXPECT_TRUE(endedBy(status, SIGTERM)) << status;
}

TEST(HeldSignals, leave_alone_what_is_ignored_and_what_comes_later)
{
    const int ignoring = endOf(
        []
        {
        std::signal(SIGHUP, SIG_IGN); // as nohup does
        {
            const HeldSignals held;
            std::raise(SIGHUP);
        }
        std::raise(SIGHUP);
        _exit(7);
    });
    EXPECT_TRUE(WIFEXITED(ignoring) && WEXITSTATUS(ignoring) == 7) << ignoring;
    const int later = endOf(
        []
        {
        {
            const HeldSignals held;
        }
        std::raise(SIGINT);
        _exit(7);
    });
    EXPECT_TRUE(endedBy(later, SIGINT)) << later;
}

/// Sends SIGTERM in the middle of writing: where a file grows beyond the limit, in a process that calls this.
void endAfter(rlim_t bytes)
{
    std::signal(SIGXFSZ, [](int) { std::raise(SIGTERM); });
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
}

std::vector<std::string> namesIn(const ScratchFolder& folder)
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        names.push_back(entry.path().filename().string());
    return names;
}

TEST(HeldSignals, nothing_unfinished_is_left_of_a_picture_a_text_or_a_model)
{
    cv::Mat image(100, 100, CV_8UC3);
    cv::RNG(3).fill(image, cv::RNG::UNIFORM, 0, 256);
    cv::gcpw::Alignment::Image view;
    view.full_size = view.work_size = image.size();
    view.mesh = view.rough = cv::Mat(4, 4, CV_64FC2, cv::Scalar::all(1.0 / 3));
    view.color = cv::Mat(3, 3, CV_32FC(6));
    cv::Mat channels = view.color.reshape(1);
    channels.setTo(0.3);
    const cv::gcpw::Alignment model({view, view}, cv::Size2d(1, 1), cv::gcpw::Report());
    const std::vector<std::pair<std::string, std::function<void(const std::string&)>>> writers = {
        {"picture.png", [&](const std::string& path) { writeImage(path, image); }},
        {"report.json", [](const std::string& path) { writeText(path, std::string(5000, ' ')); }},
        {"model.yml",
         [&](const std::string& path) { writeModel(path, [&](const std::string& name) { model.save(name); }); }},
        {"model.yml.gz",
         [&](const std::string& path) { writeModel(path, [&](const std::string& name) { model.save(name); }); }}};
    for (const auto& writer : writers)
    {
        const ScratchFolder folder;
        folder.write(writer.first, "older");
        const int status = endOf(
            [&]
            {
            endAfter(300);
            try
            {
                writer.second(folder.path(writer.first));
            }
            catch (const std::exception&) // the limit is a full disk, too
            {
            }
        });
        EXPECT_TRUE(endedBy(status, SIGTERM)) << writer.first << ": " << status;
        EXPECT_EQ(namesIn(folder), std::vector<std::string>{writer.first});
        EXPECT_EQ(folder.read(writer.first), "older");
    }
}

} // namespace
