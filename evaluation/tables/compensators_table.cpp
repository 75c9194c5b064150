// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
//
// Prints how well exposure compensators make the colours of a set of photographs agree where they overlap.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <opencv2/gcpw.hpp>
#include <opencv2/imgproc.hpp>
#include "common/program.hpp"
#include "common/read_photograph.hpp"
#include "stitch/setup.hpp"

namespace
{

typedef cv::detail::ExposureCompensator Compensator;
using cv::gcpw::Rig;

const CommandLine::Texts TEXTS = {
    "compensators_table",
    "Prints the RMS colour difference in the overlaps of sets of photographs after exposure compensation.",
    "compensators_table FOLDER.. [options]",
    {}};

/// What the command line says.
struct Options
{
    double megapix = 0.6;
    double feed_megapix = 0.1;
    int joint = 1;
    std::string settings;
};

const int BLUR = 9; ///< px: what is left of misalignment and noise must not count as colour

const std::pair<const char*, int> RIVALS[] = {{"no", Compensator::NO},
                                              {"gain", Compensator::GAIN},
                                              {"gain_blocks", Compensator::GAIN_BLOCKS},
                                              {"channels", Compensator::CHANNELS},
                                              {"channels_blocks", Compensator::CHANNELS_BLOCKS}};

/// Photographs that belong together, with their cameras.
struct Set
{
    std::vector<cv::Mat> images; ///< at the resolution of the cameras
    std::vector<cv::detail::CameraParams> cameras;
};

/// The set on a canvas.
struct Warped
{
    std::vector<cv::Point> corners;
    std::vector<cv::UMat> images;
    std::vector<cv::UMat> masks;
};

Set readSet(const std::string& folder, double megapix)
{
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<cv::Mat> images;
    for (const std::string& path : paths)
        images.push_back(withoutAlpha(toBytes(readImage(path))));
    MatchLog log(static_cast<int>(images.size()));
    StitchSetup setup;
    setup.mode = "panorama";
    setup.work_megapix = megapix;
    const cv::Ptr<cv::Stitcher> stitcher = makeStitcher(setup, log);
    const cv::Stitcher::Status status = stitcher->estimateTransform(images);
    if (status != cv::Stitcher::OK)
        throw WrongUse(folder + ": " + cv::gcpw::explain(status));
    Set set;
    set.cameras = stitcher->cameras();
    for (int index : stitcher->component())
    {
        cv::Mat image;
        const double scale = stitcher->workScale();
        cv::resize(images[static_cast<size_t>(index)], image, cv::Size(), scale, scale, cv::INTER_LINEAR_EXACT);
        set.images.push_back(image);
    }
    return set;
}

/// @param zoom px of the canvas per px at the cameras' own resolution
Warped warpAll(const Set& set, const cv::WarperCreator& creator, float scale, double zoom)
{
    const cv::Ptr<cv::detail::RotationWarper> warper = creator.create(static_cast<float>(scale * zoom));
    Warped warped;
    warped.images.resize(set.images.size());
    warped.masks.resize(set.images.size());
    for (size_t i = 0; i < set.images.size(); ++i)
    {
        cv::Mat image = set.images[i];
        if (zoom != 1)
            cv::resize(image, image, cv::Size(), zoom, zoom, cv::INTER_LINEAR_EXACT);
        cv::detail::CameraParams camera = set.cameras[i];
        camera.focal *= zoom;
        camera.ppx *= zoom;
        camera.ppy *= zoom;
        cv::Mat K;
        camera.K().convertTo(K, CV_32F);
        const cv::Mat inside(image.size(), CV_8UC1, cv::Scalar(255));
        warped.corners.push_back(warper->warp(image, K, camera.R, cv::INTER_LINEAR, cv::BORDER_REFLECT, warped.images[i]));
        warper->warp(inside, K, camera.R, cv::INTER_NEAREST, cv::BORDER_CONSTANT, warped.masks[i]);
    }
    return warped;
}

/// RMS difference of the blurred images over all overlaps, gray levels.
double difference(const Warped& warped, Compensator& compensator)
{
    std::vector<cv::Mat> blurred(warped.images.size());
    std::vector<cv::Mat> inside(warped.images.size());
    for (size_t i = 0; i < blurred.size(); ++i)
    {
        cv::Mat picture;
        warped.images[i].copyTo(picture);
        compensator.apply(static_cast<int>(i), warped.corners[i], picture, warped.masks[i]);
        cv::blur(picture, blurred[i], cv::Size(BLUR, BLUR));
        cv::erode(warped.masks[i], inside[i], cv::Mat::ones(BLUR, BLUR, CV_8U), cv::Point(-1, -1), 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    }
    double sum = 0;
    double count = 0;
    for (size_t i = 0; i < blurred.size(); ++i)
        for (size_t j = i + 1; j < blurred.size(); ++j)
        {
            const cv::Rect shared = cv::Rect(warped.corners[i], blurred[i].size()) & cv::Rect(warped.corners[j], blurred[j].size());
            if (shared.empty())
                continue;
            const cv::Rect at_i = shared - warped.corners[i];
            const cv::Rect at_j = shared - warped.corners[j];
            const cv::Mat both = inside[i](at_i) & inside[j](at_j);
            const double pair = cv::norm(blurred[i](at_i), blurred[j](at_j), cv::NORM_L2, both);
            sum += pair * pair;
            count += 3.0 * cv::countNonZero(both);
        }
    return std::sqrt(sum / count);
}

/// One row: every compensator fed with the small images, measured on the large ones.
void printRow(const std::string& name, const Warped& small, const Warped& large, const cv::Ptr<cv::gcpw::GcpwCompensator>& ours)
{
    std::printf("| %s |", name.c_str());
    for (const auto& rival : RIVALS)
    {
        const cv::Ptr<Compensator> compensator = Compensator::createDefault(rival.second);
        compensator->feed(small.corners, small.images, small.masks);
        std::printf(" %.2f |", difference(large, *compensator));
    }
    ours->feed(small.corners, small.images, small.masks);
    std::printf(" **%.2f** |\n", difference(large, *ours));
    std::fflush(stdout);
}

void printSet(const std::string& folder, const Options& options, const cv::gcpw::Params& params)
{
    const double megapix = options.megapix;
    const double zoom = std::sqrt(options.feed_megapix / megapix);
    const std::string name = std::filesystem::path(folder).filename();
    const Set set = readSet(folder, megapix);
    const cv::Ptr<cv::WarperCreator> base = cv::makePtr<cv::SphericalWarper>();
    // Any scale will do for the plain warp; the first camera's is near enough.
    const float focal = static_cast<float>(set.cameras[0].focal);
    printRow(name + ", plain warp", warpAll(set, *base, focal, zoom), warpAll(set, *base, focal, 1),
             cv::makePtr<cv::gcpw::GcpwCompensator>(params));
    if (options.joint == 0)
        return;
    const Rig rig = cv::gcpw::alignRig(set.images, set.cameras, base, params);
    if (!rig.usable())
        throw WrongUse(name + ": " + rig.alignment.report().message);
    const cv::gcpw::GcpwWarper creator(base, rig);
    const Warped small = warpAll(set, creator, rig.scale, zoom);
    const Warped large = warpAll(set, creator, rig.scale, 1); // last: the compensator works at the scale asked for last
    printRow(name + ", GCPW's warp, alone", small, large, cv::makePtr<cv::gcpw::GcpwCompensator>(params));
    printRow(name + ", GCPW's warp, joint", small, large, creator.compensator(params));
}

} // namespace

int main(int argc, char** argv)
{
    CommandLine line(TEXTS);
    Options options;
    std::vector<std::string> folders;
    line.arguments(folders);
    line.group("Comparison");
    line.number("--megapix", options.megapix, {LEAST_MEGAPIX, MOST_MEGAPIX, "million pixels"},
                "resolution of the comparison, million pixels");
    line.number("--feed_megapix", options.feed_megapix, {LEAST_MEGAPIX, MOST_MEGAPIX, "million pixels"},
                "resolution of the estimation, million pixels; cv::Stitcher's is 0.1");
    line.integer("--joint", options.joint, {0, 1}, "0: only on the plain warp, without the joint alignment");
    line.text("--set", options.settings, "NAME=VALUE,..", "parameters; see gcpw::Params");
    return runProgram(line, argc, argv,
                      [&](const Console&)
                      {
        cv::gcpw::Params params;
        applySettings(options.settings, params);
        std::printf("| set |");
        for (const auto& rival : RIVALS)
            std::printf(" %s |", rival.first);
        std::printf(" gcpw |\n|---|---|---|---|---|---|---|\n");
        for (const std::string& folder : folders)
            printSet(folder, options, params);
        return static_cast<int>(EXIT_STITCHED);
    });
}
