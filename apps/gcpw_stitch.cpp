// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
//
// Stitches any number of photographs with cv::Stitcher, plain or with GCPW inside.
#include <algorithm>
#include <iostream>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <opencv2/gcpw/stitcher.hpp>
#include "common/json.hpp"
#include "common/model_check.hpp"
#include "common/program.hpp"
#include "common/stitch_setup.hpp"

using namespace cv::gcpw;

namespace
{

const char* const KEYS =
    "{help h usage ?  |             | this text }"
    "{output          | result.png  | the panorama }"
    "{method          | gcpw        | gcpw, or none: OpenCV's own pipeline with the same features and cameras }"
    "{mode            | auto        | auto: cameras and projection that keep proportions and photographs; or panorama or scans }"
    "{warp            |             | spherical, cylindrical, plane, affine, fisheye, stereographic, mercator, .. }"
    "{features        | sift        | sift, orb or akaze }"
    "{seam            | gc_color    | no, voronoi, gc_color, gc_colorgrad, dp_color or dp_colorgrad }"
    "{blend           | multiband   | no, feather or multiband }"
    "{expos_comp      | gain_blocks | no, gain, gain_blocks, channels or channels_blocks; gcpw falls back on it }"
    "{ba              |             | bundle adjustment of mode panorama: ray (the default there), reproj, affine or no }"
    "{wave_correct    |             | of mode panorama: horiz (the default there), vert or no }"
    "{work_megapix    | 0.6         | resolution of features and alignment, million pixels }"
    "{seam_megapix    | 0.1         | resolution of the seams, million pixels }"
    "{compose_megapix | -1          | resolution of the panorama; -1 keeps the photographs' own }"
    "{conf_thresh     | 1           | confidence that two images belong together; more drops more images }"
    "{match_conf      | 0.65        | confidence of a feature match }"
    "{rangewidth      | -1          | match only images this near to each other in the list; -1 all }"
    "{reference       | -1          | number of the image that keeps its place, 1-based; -1 chooses }"
    "{dump            |             | folder for the warped images: 000_image.png, 000_corrected.png, 000_mask.png, corners.csv }"
    "{report          |             | JSON file with timings and what happened }"
    "{save_model      |             | file for cameras, meshes and colours: .yml, .json, also with .gz }"
    "{load_model      |             | use such a file instead of estimating }"
    "{threads         | -1          | threads to use; -1 leaves it to OpenCV }"
    "{set             |             | further parameters, name=value,name=value; see gcpw::Params }";

const int MIN_SIDE = 8; ///< px of a photograph: cv::SIFT fails on images of one or two

/// Everything one run is asked to do.
struct Job
{
    std::vector<std::string> paths;
    std::string output;
    std::string dump;
    std::string report;
    std::string save_model;
    std::string load_model;
    bool gcpw = true;
    int reference = -1;
    StitchSetup setup;
    Params params;
};

/// Milliseconds of wall time by stage.
struct Stages
{
    double read = 0;
    double cameras = 0;
    double compose = 0;
};

Job parse(const cv::CommandLineParser& parser, int argc, const char* const* argv)
{
    Job job;
    for (int i = 1; i < argc; ++i)
        if (argv[i][0] != '-')
            job.paths.emplace_back(argv[i]);
    job.output = parser.get<std::string>("output");
    job.dump = parser.get<std::string>("dump");
    job.report = parser.get<std::string>("report");
    job.save_model = parser.get<std::string>("save_model");
    job.load_model = parser.get<std::string>("load_model");
    const std::string method = parser.get<std::string>("method");
    if (method != "gcpw" && method != "none")
        throw WrongUse("unknown method '" + method + "'; there are gcpw, none");
    job.gcpw = method == "gcpw";
    StitchSetup& setup = job.setup;
    setup.mode = parser.get<std::string>("mode");
    setup.warp = parser.get<std::string>("warp");
    setup.features = parser.get<std::string>("features");
    setup.seam = parser.get<std::string>("seam");
    setup.blend = parser.get<std::string>("blend");
    setup.expos_comp = parser.get<std::string>("expos_comp");
    setup.ba = parser.get<std::string>("ba");
    setup.wave_correct = parser.get<std::string>("wave_correct");
    setup.work_megapix = parser.get<double>("work_megapix");
    setup.seam_megapix = parser.get<double>("seam_megapix");
    setup.compose_megapix = parser.get<double>("compose_megapix");
    setup.conf_thresh = parser.get<double>("conf_thresh");
    setup.match_conf = parser.get<double>("match_conf");
    setup.range_width = parser.get<int>("rangewidth");
    job.reference = parser.get<int>("reference");
    const int threads = parser.get<int>("threads");
    applySettings(parser.get<std::string>("set"), job.params);
    if (!parser.check())
    {
        parser.printErrors();
        throw WrongUse("--help lists the options");
    }
    if (threads >= 0)
        cv::setNumThreads(threads);
    if (job.paths.size() < 2)
        throw WrongUse("two photographs or more are needed: gcpw_stitch IMAGE IMAGE..; --help lists the options");
    if (job.reference != -1 && (job.reference < 1 || job.reference > static_cast<int>(job.paths.size())))
        throw WrongUse("--reference is the number of an image, 1 to " + std::to_string(job.paths.size()));
    if (!(std::min(setup.work_megapix, setup.seam_megapix) >= LEAST_MEGAPIX))
        throw WrongUse(cv::format("--work_megapix and --seam_megapix are million pixels, at least %g", LEAST_MEGAPIX));
    if (!job.gcpw && (!job.save_model.empty() || !job.load_model.empty()))
        throw WrongUse("there is a model only with --method=gcpw");
    if (job.reference != -1)
        job.params.referenceImage = job.reference - 1;
    checkSetup(setup);
    job.params.check();
    std::vector<std::string> inputs = job.paths;
    if (!job.load_model.empty())
        inputs.push_back(job.load_model);
    checkOutputs(inputs, {job.output}, {job.report, job.save_model}, job.dump);
    return job;
}

std::vector<cv::Mat> readAll(const std::vector<std::string>& paths)
{
    std::vector<cv::Mat> images;
    for (const std::string& path : paths)
    {
        images.push_back(readBgr(path));
        if (std::min(images.back().cols, images.back().rows) < MIN_SIDE)
            throw WrongUse(path + cv::format(" is %d x %d px; %d px a side are needed", images.back().cols, images.back().rows, MIN_SIDE));
    }
    return images;
}

/// Writes the warped images of a finished stitcher at compose scale, with their colours untouched and corrected.
void dumpWarped(const std::string& folder, cv::Stitcher& stitcher, const std::vector<cv::Mat>& images)
{
    makeFolder(folder);
    const std::vector<int> component = stitcher.component();
    const std::vector<cv::detail::CameraParams> cameras = stitcher.cameras();
    const double full = stitcher.compositingResol();
    const double compose_scale =
        full > 0 ? std::min(1.0, std::sqrt(full * 1e6 / static_cast<double>(images[component[0]].total()))) : 1.0;
    const double aspect = compose_scale / stitcher.workScale();
    std::vector<double> focals;
    for (const cv::detail::CameraParams& camera : cameras)
        focals.push_back(camera.focal);
    std::sort(focals.begin(), focals.end());
    const size_t half = focals.size() / 2;
    const double median = focals.size() % 2 == 1 ? focals[half] : 0.5 * (focals[half - 1] + focals[half]);
    const cv::Ptr<cv::detail::RotationWarper> warper = stitcher.warper()->create(static_cast<float>(median * aspect));
    std::string corners;
    for (size_t k = 0; k < cameras.size(); ++k)
    {
        cv::Mat image = images[component[k]];
        if (std::abs(compose_scale - 1) > 0.1)
            cv::resize(image, image, cv::Size(), compose_scale, compose_scale, cv::INTER_LINEAR_EXACT);
        cv::detail::CameraParams camera = cameras[k];
        camera.focal *= aspect;
        camera.ppx *= aspect;
        camera.ppy *= aspect;
        cv::Mat K;
        camera.K().convertTo(K, CV_32F);
        cv::Mat warped;
        cv::Mat mask;
        const cv::Point corner = warper->warp(image, K, camera.R, cv::INTER_LINEAR, cv::BORDER_REFLECT, warped);
        warper->warp(cv::Mat(image.size(), CV_8UC1, cv::Scalar(255)), K, camera.R, cv::INTER_NEAREST, cv::BORDER_CONSTANT, mask);
        const std::string number = cv::format("%03d", component[k]);
        writeImage(folder + "/" + number + "_image.png", warped);
        writeImage(folder + "/" + number + "_mask.png", mask);
        stitcher.exposureCompensator()->apply(static_cast<int>(k), corner, warped, mask);
        writeImage(folder + "/" + number + "_corrected.png", warped);
        corners += cv::format("%s,%d,%d\n", number.c_str(), corner.x, corner.y);
    }
    writeText(folder + "/corners.csv", corners);
}

/// What a run found out, for report and terminal.
struct Outcome
{
    cv::Stitcher::Status status = cv::Stitcher::OK;
    std::string reason;                 ///< why there is no picture
    std::vector<int> kept;              ///< photographs in the picture
    std::vector<std::string> decisions; ///< of mode auto
    bool turned = false;                ///< the picture is to be turned to the right
    int estimations = 0;                ///< of the alignment
};

std::string reportText(const Job& job, const Outcome& outcome, const StitcherBinding* binding, const Stages& stages, cv::Size size)
{
    Json json;
    json.beginObject().add("status", outcome.reason).add("method", job.gcpw ? "gcpw" : "none");
    json.add("width", size.width).add("height", size.height).add("images", static_cast<int>(job.paths.size()));
    json.beginArray("dropped");
    for (size_t i = 0; i < job.paths.size(); ++i)
        if (std::find(outcome.kept.begin(), outcome.kept.end(), static_cast<int>(i)) == outcome.kept.end())
            json.add("", job.paths[i]);
    json.endArray();
    json.beginArray("decisions");
    for (const std::string& decision : outcome.decisions)
        json.add("", decision);
    json.endArray();
    if (binding)
    {
        const Report& report = binding->rig().alignment.report();
        json.beginObject("alignment").add("status", nameOf(report.status)).add("message", report.message);
        json.add("estimations", outcome.estimations + binding->estimations()).add("folds", report.folds);
        json.add("max_displacement_px", report.max_displacement_px);
        json.add("gain_min", report.gain_min).add("gain_max", report.gain_max);
        json.beginArray("pairs");
        for (const PairReport& pair : report.pairs)
        {
            json.beginObject().add("a", pair.a).add("b", pair.b).add("points", pair.points).add("lines", pair.lines);
            json.add("miss_before", pair.miss_before).add("miss_after", pair.miss_after).endObject();
        }
        json.endArray();
        const Timings& t = report.timings_ms;
        json.beginObject("timings_ms").add("features", t.features).add("matching", t.homography).add("align", t.align);
        json.add("total", t.total).endObject().endObject();
    }
    json.beginObject("timings_ms").add("read", stages.read).add("cameras", stages.cameras).add("compose", stages.compose);
    json.add("total", stages.read + stages.cameras + stages.compose).endObject().endObject();
    return json.text();
}

cv::Ptr<StitcherBinding> attachTo(const cv::Ptr<cv::Stitcher>& stitcher, const Job& job)
{
    return job.gcpw ? attach(stitcher, job.params, terminalProgress()) : cv::Ptr<StitcherBinding>();
}

/// Gives memory that features and matches have left behind back to the system, where the allocator keeps it.
void releaseFreedMemory()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

/// Takes the cameras of a saved rig.
void useModel(const Job& job, const std::vector<cv::Mat>& images, cv::Ptr<cv::Stitcher>& stitcher, cv::Ptr<StitcherBinding>& binding,
              Outcome& outcome)
{
    const Rig rig = Rig::load(job.load_model);
    const std::vector<int> component = checkModel(rig, images, job.load_model);
    StitchSetup setup = job.setup;
    if (setup.warp.empty())
        setup.warp = rig.projection;
    outcome.turned = rig.turned;
    stitcher = makeStitcher(setup);
    binding = attachTo(stitcher, job);
    binding->setRig(rig);
    outcome.status = stitcher->setTransform(images, rig.cameras, component);
    checkWorkScale(rig, *stitcher, job.load_model);
}

/// Looks for cameras and a projection in mode auto.
void findCameras(const Job& job, const std::vector<cv::Mat>& images, cv::Ptr<cv::Stitcher>& stitcher,
                 cv::Ptr<StitcherBinding>& binding, Outcome& outcome)
{
    const CameraEstimate estimate = estimateCameras(images, cameraOptions(job.setup));
    releaseFreedMemory();
    outcome.decisions = estimate.decisions;
    stitcher = makeStitcher(job.setup);
    if (!estimate.ok())
    {
        outcome.status = cv::Stitcher::ERR_NEED_MORE_IMGS;
        outcome.reason = estimate.decisions.back();
        return;
    }
    outcome.turned = estimate.turned;
    stitcher->setWarper(estimate.warper());
    binding = attachTo(stitcher, job);
    if (binding)
    {
        binding->setRig(alignRig(estimate, job.params, terminalProgress()));
        outcome.estimations = 1;
    }
    outcome.status = stitcher->setTransform(images, estimate.cameras, estimate.component);
}

/// A stitcher that knows its cameras, with GCPW's rig if it is to have one.
void prepare(const Job& job, const std::vector<cv::Mat>& images, cv::Ptr<cv::Stitcher>& stitcher, cv::Ptr<StitcherBinding>& binding,
             Outcome& outcome)
{
    if (!job.load_model.empty())
        useModel(job, images, stitcher, binding, outcome);
    else if (job.setup.mode == "auto")
        findCameras(job, images, stitcher, binding, outcome);
    else
    {
        stitcher = makeStitcher(job.setup);
        binding = attachTo(stitcher, job);
        outcome.status = stitcher->estimateTransform(images);
    }
    if (outcome.status == cv::Stitcher::OK)
        outcome.kept = stitcher->component();
}

/** Turns a column's picture, which comes out turned to the left by 90 degrees, back.

Cameras store photographs lying and note the turn of those that were taken upright. A note that lays photographs on their side that were stored
upright is a stale one, as programs leave it that turn the pixels and forget the note: where such photographs stand in a column,
it is undone. */
void standUp(const Job& job, cv::Mat& panorama, Outcome& outcome)
{
    const cv::Size photograph = readImage(job.paths[0]).size();
    const int noted = photograph.width > photograph.height ? notedTurn(job.paths[0]) : 0;
    if (noted != 0)
        outcome.decisions.push_back("the picture does without the turn that is noted in the photographs: it lays on their side what was "
                                    "stored upright, and they stand in a column");
    // Turned to the right once, and to the left as often as the note did to the right.
    const int turns = (1 - noted + 4) % 4;
    if (turns == 1)
        cv::rotate(panorama, panorama, cv::ROTATE_90_CLOCKWISE);
    if (turns == 2)
        cv::rotate(panorama, panorama, cv::ROTATE_180);
}

int stitch(const Job& job)
{
    Stages stages;
    cv::TickMeter clock;
    const auto lap = [&clock]
    {
        clock.stop();
        const double ms = clock.getTimeMilli();
        clock.reset();
        clock.start();
        return ms;
    };
    clock.start();
    const std::vector<cv::Mat> images = readAll(job.paths);
    stages.read = lap();
    cv::Ptr<cv::Stitcher> stitcher;
    cv::Ptr<StitcherBinding> binding;
    Outcome outcome;
    prepare(job, images, stitcher, binding, outcome);
    releaseFreedMemory();
    stages.cameras = lap();
    cv::Mat panorama;
    if (outcome.status == cv::Stitcher::OK)
        outcome.status = stitcher->composePanorama(panorama);
    if (outcome.turned && !panorama.empty())
        standUp(job, panorama, outcome);
    stages.compose = lap();
    endProgress();
    if (outcome.reason.empty())
        outcome.reason = explain(outcome.status);
    if (!job.report.empty())
        writeText(job.report, reportText(job, outcome, binding.get(), stages, panorama.size()));
    for (const std::string& decision : outcome.decisions)
        std::cout << decision << '\n';
    if (outcome.status != cv::Stitcher::OK)
    {
        std::cerr << "gcpw_stitch: " << outcome.reason << '\n';
        return EXIT_NO_ALIGNMENT;
    }
    for (size_t i = 0; i < job.paths.size(); ++i)
        if (std::find(outcome.kept.begin(), outcome.kept.end(), static_cast<int>(i)) == outcome.kept.end())
            std::cout << "dropped " << job.paths[i] << ": it matches none of the others well enough\n";
    if (binding && !binding->rig().alignment.report().message.empty())
        std::cout << binding->rig().alignment.report().message << '\n';
    writeImage(job.output, panorama);
    if (!job.save_model.empty())
        writeModel(job.save_model, [&](const std::string& path) { binding->rig().save(path); });
    if (!job.dump.empty())
        dumpWarped(job.dump, *stitcher, images);
    std::cout << job.output << ": " << panorama.cols << " x " << panorama.rows << " of " << outcome.kept.size() << " images, "
              << cvRound(stages.read + stages.cameras + stages.compose) << " ms\n";
    return EXIT_STITCHED;
}

} // namespace

int main(int argc, char** argv)
{
    const std::string about = "Stitches photographs with cv::Stitcher and Generalized Content-Preserving Warps.\n"
                              "gcpw_stitch IMAGE IMAGE.. [--option=value..]. Exit code: 0 stitched, 1 no alignment, 2 wrong use or a file that\ncannot be read or written.";
    return runProgram("gcpw_stitch", argc, argv, KEYS, about,
                      [&](const cv::CommandLineParser& parser) { return stitch(parse(parser, argc, argv)); });
}
