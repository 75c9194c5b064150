// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/job.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include "common/deep_zoom.hpp"
#include "common/input_list.hpp"
#include "common/output_plan.hpp"
#include "common/paths.hpp"
#include "common/program.hpp"
#include "common/tile_rows.hpp"
#include "report/report.hpp"

namespace fs = std::filesystem;

namespace
{

// What --preview takes: small and coarse enough for a look within a second or two.
const double PREVIEW_WORK_MEGAPIX = 0.1;
const double PREVIEW_COMPOSE_MEGAPIX = 0.2;
const double PREVIEW_SEAM_MEGAPIX = 0.05;
const char* const PREVIEW_SEAM = "dp_color";
const int PREVIEW_MESH = 16; ///< quads a side
const int PREVIEW_SAMPLE_STEP = 3;

const Range MEGAPIX = {LEAST_MEGAPIX, MOST_MEGAPIX, "million pixels"};
const int MOST_ROWS = 1000000; ///< of tiles, of any picture
const double UNLIMITED = std::numeric_limits<double>::infinity();

const CommandLine::Texts TEXTS = {
    "gcpw_stitch",
    "Stitches photographs with OpenCV's pipeline and Generalized Content-Preserving Warps.\n"
    "Exit code: 0 stitched, 1 no answer (they do not match), 2 wrong use, 3 could not read or write a file.",
    "gcpw_stitch PHOTOGRAPH PHOTOGRAPH.. [options]\n"
    "  A PHOTOGRAPH is a file, a folder, a pattern in quotes or @LIST, a text file with one of these a line.",
    {"gcpw_stitch left.jpg middle.jpg right.jpg --output pano.jpg", "three photographs",
     "gcpw_stitch holiday/ -o pano.tif --skip-bad", "all pictures of a folder, those that cannot be read left out",
     "gcpw_stitch 'IMG_*.jpg' --preview", "a small picture within seconds",
     "gcpw_stitch a0.jpg b0.jpg --save_model rig.yml.gz -o first.jpg", "keeps cameras, meshes and colours",
     "gcpw_stitch a1.jpg b1.jpg --load_model rig.yml.gz -o next.jpg",
     "uses them for the next photographs of the same cameras"}};

void checkModelName(const std::string& option, const std::string& path)
{
    std::string name = path;
    if (endingOf(name) == ".gz")
        name.resize(name.size() - 3);
    const std::string ending = endingOf(name);
    if (!path.empty() && ending != ".yml" && ending != ".yaml" && ending != ".xml" && ending != ".json")
        throw WrongUse(option + "=" + path +
                       ": a model is a file that ends in .yml, .xml or .json, with .gz behind it if compressed");
}

void planPicture(OutputPlan& plan, const std::string& path)
{
    if (endingOf(path) != ".dzi")
    {
        plan.writesPicture("--output", path);
        return;
    }
    const DeepZoomFiles files(path);
    plan.writesFile("--output", files.description);
    plan.writesFile("--output", files.page);
    plan.writesFolder("--output", files.tiles);
}

} // namespace

std::string StitchJob::outputOf(int panorama) const
{
    if (panorama == 1 || isDevice(output))
        return output;
    const fs::path path(output);
    return (path.parent_path() / (path.stem().string() + "-" + std::to_string(panorama) + path.extension().string()))
        .string();
}

StitchJob StitchJob::further(int panorama) const
{
    StitchJob job = *this;
    job.output = outputOf(panorama);
    job.report = job.dump = job.save_model = job.save_graph = job.timelapse = std::string();
    job.params.referenceImage = -1;
    return job;
}

std::string StitchJob::obstacleToTiles() const
{
    if (!report.empty() || !dump.empty() || !timelapse.empty())
        return "--report, --dump and --timelapse need photographs and picture in memory";
    if (!gcpw)
        return "--method=none holds photographs and picture in memory, as OpenCV does";
    if (setup.mode != "auto" && load_model.empty())
        return "--mode=" + setup.mode + " holds all photographs in memory, as OpenCV does; --mode=auto does not";
    return {};
}

std::string StitchJob::frameOf(const std::string& photograph) const
{
    return (folderOf(output) / ("fixed_" + fs::path(photograph).filename().string())).string();
}

StitchOptions::StitchOptions() : line_(TEXTS)
{
    line_.arguments(arguments_);
    declareOutputs();
    declareEstimation();
    declareComposition();
}

void StitchOptions::declareOutputs()
{
    line_.group("Photographs");
    line_.texts("-l,--list", lists_, "FILE",
                "text file with one photograph, folder or pattern a line, as @FILE; may be given often");
    line_.flag("--skip-bad", job_.skip_bad,
               "leave out photographs that cannot be read, and say which; without it they stop the program");
    line_.integer("--reference", reference_, {-1, 1e6},
                  "number of the photograph that keeps its colours, from 1 on; -1 keeps the light of all");
    line_.group("Outputs");
    line_.text("-o,--output", job_.output, "FILE",
               "the panorama: .jpg, .png, .tif, .webp, ..; .dzi is a Deep Zoom pyramid with a page that shows it; - is "
               "standard output, as PNG. 16 bits a channel go into PNG "
               "and TIFF, "
               "profile and EXIF of the photographs into all that take them");
    line_.choice("--crop", job_.crop, {"auto", "none"},
                 "auto: the largest rectangle without empty corners; none: everything");
    line_.choice("--panoramas", job_.panoramas, {"all", "largest"},
                 "where the photographs are of several scenes: all write one picture each, NAME, NAME-2, ..");
    line_.choice(
        "--tiled", job_.tiled, {"auto", "yes", "no"},
        "make a picture larger than memory, in tiles, the same pixels: auto does for .dzi, and for .tif of more "
        "than 200 million pixels of photographs");
    line_.text("--tiles", job_.tiles, "A-B",
               "of such a picture the rows of tiles A to B alone, from 1 on, or the share K/N, into a file that --join "
               "takes; with --load_model. none: only --save_model");
    line_.flag("--join", job_.join,
               "put the files that --tiles has written together; give them instead of photographs");
    line_.flag("-p,--preview", job_.preview, "a small picture in a short time");
    declareFormat(line_, job_.format);
    line_.text("--report", job_.report, "FOLDER",
               "for a page that shows the result, index.html, and report.json; a name ending in .json is a file, for "
               "that alone");
    line_.text("--dump", job_.dump, "FOLDER",
               "for the warped photographs: 000_image.png, 000_corrected.png, 000_mask.png, .., corners.csv");
    line_.text("--save_model", job_.save_model, "FILE",
               "cameras, meshes and colours: .yml, .xml or .json, also with .gz");
    line_.text("--load_model", job_.load_model, "FILE", "use such a file instead of estimating");
    line_.text("--save_graph", job_.save_graph, "FILE", "which photographs match, in the DOT language");
    line_.choice(
        "--timelapse", job_.timelapse, {"as_is", "crop"},
        "write each warped photograph beside the output as fixed_NAME: on the whole canvas, or on what all show");
}

void StitchOptions::declareEstimation()
{
    StitchSetup& setup = job_.setup;
    line_.group("Cameras and alignment");
    line_.choice("-m,--method", method_, {"gcpw", "none"},
                 "none: OpenCV's own pipeline with the same features and cameras");
    line_.choice("--mode", setup.mode, {"auto", "panorama", "scans"},
                 "auto: cameras and projection that keep proportions and photographs; panorama and scans as in OpenCV");
    line_.number("--work_megapix", setup.work_megapix, MEGAPIX, "resolution of features and alignment, million pixels");
    line_.choice("--features", setup.features, featureNames(), "kind of keypoints; surf where OpenCV has it");
    line_.choice("--matcher", setup.matcher, {"homography", "affine"}, "of modes by name: what links two photographs");
    line_.choice("--estimator", setup.estimator, {"homography", "affine"},
                 "of modes by name: what cameras are first estimated from");
    line_.number("--match_conf", setup.match_conf, {-1, 1},
                 "confidence of a feature match; -1: 0.3 for orb, else 0.65");
    line_.number("--conf_thresh", setup.conf_thresh, {1e-6, 1e6},
                 "confidence that two photographs belong together; more drops more");
    line_.choice("--ba", setup.ba, {"ray", "reproj", "affine", "no"}, "of modes by name: bundle adjustment");
    line_.text("--ba_refine_mask", setup.ba_refine_mask, "MASK",
               "of modes by name: x refines and _ keeps fx, skew, ppx, aspect, ppy");
    line_.choice("--wave_correct", setup.wave_correct, {"horiz", "vert", "no"}, "of modes by name: straightening");
    line_.integer("--rangewidth", setup.range_width, {-1, 1e6},
                  "match only photographs this near to each other in the list; -1 all");
    line_.text("--set", settings_, "NAME=VALUE,..", "further parameters; see gcpw::Params");
    line_.choice("--try_cuda", try_cuda_, {"yes", "no"},
                 "taken for the sake of stitching_detailed; nothing here uses CUDA");
}

void StitchOptions::declareComposition()
{
    StitchSetup& setup = job_.setup;
    line_.group("Composition");
    line_.choice("--warp", setup.warp, warpNames(),
                 "the projection; mode auto chooses, panorama takes spherical, scans affine");
    line_.number("--seam_megapix", setup.seam_megapix, MEGAPIX, "resolution of the seams, million pixels");
    line_.choice("--seam", setup.seam, seamNames(), "where one photograph ends and the next begins");
    line_.number("--compose_megapix", setup.compose_megapix, {-1, MOST_MEGAPIX, "million pixels"},
                 "resolution of the panorama; -1 keeps the photographs' own");
    line_.choice("--expos_comp", setup.expos_comp, compensatorNames(),
                 "exposures: of --method=none, and with gcpw where given, in place of its colours");
    line_.integer("--expos_comp_nr_feeds", setup.expos_comp_nr_feeds, {1, 100}, "times that exposures are estimated");
    line_.integer("--expos_comp_nr_filtering", setup.expos_comp_nr_filtering, {0, 1000},
                  "times that gains of blocks are smoothed");
    line_.integer("--expos_comp_block_size", setup.expos_comp_block_size, {4, 10000, "px"}, "side of a block");
    line_.choice("--blend", setup.blend, {"multiband", "feather", "no"}, "how photographs are mixed along the seams");
    line_.number("--blend_strength", setup.blend_strength, {-1, 100},
                 "width of the mixing, percent of the picture's side; -1: five bands, as cv::Stitcher");
}

void StitchOptions::checkTiles() const
{
    const std::string ending = endingOf(job_.output);
    const bool zoomable = ending == ".dzi";
    if (job_.join && !zoomable && ending != ".tif" && ending != ".tiff")
        throw WrongUse("--join writes .tif or .dzi; got --output=" + job_.output);
    if (job_.tiled == "no" && zoomable)
        throw WrongUse("--tiled=no: a Deep Zoom picture is made of tiles; choose .tif, .png or .jpg for --output");
    const bool makes_tiles = job_.tiled == "yes" || !job_.tiles.empty();
    if (makes_tiles && job_.tiles != "none" && !zoomable && ending != ".tif" && ending != ".tiff")
        throw WrongUse("--tiled=yes and --tiles write .tif or .dzi; got --output=" + job_.output);
    if (makes_tiles || zoomable)
    {
        const std::string obstacle = job_.obstacleToTiles();
        if (!obstacle.empty())
            throw WrongUse(obstacle + ", and " + (zoomable ? "a .dzi" : "a picture in tiles") +
                           " is made without; leave one of them out");
    }
    const bool part = !job_.tiles.empty() && job_.tiles != "none";
    if (part)
        TileRows(job_.tiles).in(MOST_ROWS);
    if (part && (zoomable || job_.tiled == "no" || job_.load_model.empty()))
        throw WrongUse(
            "--tiles=" + job_.tiles +
            " writes a part of a tiled .tif, of a model: --load_model=FILE --output=part.tif; --join puts parts "
            "together, also to a .dzi");
    if (job_.tiles == "none" && job_.save_model.empty())
        throw WrongUse("--tiles=none makes no picture, but a model: add --save_model=FILE");
}

void StitchOptions::checkValues() const
{
    const StitchSetup& setup = job_.setup;
    if (setup.compose_megapix != -1 && !(setup.compose_megapix >= LEAST_MEGAPIX))
        throw WrongUse(
            cv::format("--compose_megapix is million pixels, at least %g, or -1 for the photographs' own; got %g",
                       LEAST_MEGAPIX, setup.compose_megapix));
    if (setup.match_conf < 0 && setup.match_conf != -1)
        throw WrongUse(cv::format("--match_conf is a number from 0 to 1, or -1; got %g", setup.match_conf));
    if (!job_.gcpw && (!job_.save_model.empty() || !job_.load_model.empty()))
        throw WrongUse("--save_model and --load_model are for --method=gcpw: there is no model without it");
    checkTiles();
    if (!job_.load_model.empty() && !job_.save_graph.empty())
        throw WrongUse("--save_graph needs matches, and with --load_model nothing is matched");
    checkModelName("--save_model", job_.save_model);
    checkModelName("--load_model", job_.load_model);
    checkSetup(setup);
}

void StitchOptions::planOutputs(Console& console) const
{
    OutputPlan plan;
    for (const std::string& path : job_.paths)
        plan.reads(path);
    for (const std::string& list : lists_)
        plan.reads(list);
    for (const std::string& argument : arguments_)
        if (argument[0] == '@')
            plan.reads(argument.substr(1));
    if (!job_.load_model.empty())
        plan.reads(job_.load_model);
    if (job_.tiles != "none")
        planPicture(plan, job_.output);
    if (job_.tiles.empty() && job_.panoramas == "all" && job_.load_model.empty() && !isDevice(job_.output))
        for (int i = 2; i <= static_cast<int>(job_.paths.size()) / 2; ++i) // a panorama takes two photographs
            planPicture(plan, job_.outputOf(i));
    if (!job_.timelapse.empty())
        for (const std::string& path : job_.paths)
            plan.writesPicture("--timelapse", job_.frameOf(path));
    report::addTo(plan, job_.report);
    plan.writesFile("--save_model", job_.save_model);
    plan.writesFile("--save_graph", job_.save_graph);
    plan.writesFolder("--dump", job_.dump);
    plan.check(line_.force);
    if (plan.usesStandardOutput())
        console.keepOutputFree();
}

void StitchOptions::makeSmall()
{
    StitchSetup& setup = job_.setup;
    if (!line_.given("--work_megapix"))
        setup.work_megapix = PREVIEW_WORK_MEGAPIX;
    if (!line_.given("--compose_megapix"))
        setup.compose_megapix = PREVIEW_COMPOSE_MEGAPIX;
    if (!line_.given("--seam_megapix"))
        setup.seam_megapix = PREVIEW_SEAM_MEGAPIX;
    if (!line_.given("--seam"))
        setup.seam = PREVIEW_SEAM;
    job_.params.meshCols = job_.params.meshRows = PREVIEW_MESH;
    job_.params.sampleStep = PREVIEW_SAMPLE_STEP;
}

StitchJob StitchOptions::job(Console& console)
{
    job_.gcpw = method_ == "gcpw";
    if (job_.preview)
        makeSmall();
    if (job_.setup.mode == "scans" && !line_.given("--expos_comp"))
        job_.setup.expos_comp = "no"; // as in OpenCV: scans have one light
    job_.plain_colors = !job_.gcpw || line_.given("--expos_comp");
    if (!job_.gcpw && !line_.given("--seam"))
        job_.setup.seam = plainSeam(job_.setup.seam);
    applySettings(settings_, job_.params);
    checkValues();
    for (const std::string& list : lists_)
        arguments_.push_back("@" + list);
    job_.paths = listPhotographs(arguments_);
    const int count = static_cast<int>(job_.paths.size());
    if (job_.join)
    {
        OutputPlan plan;
        for (const std::string& path : job_.paths)
            plan.reads(path);
        planPicture(plan, job_.output);
        plan.check(line_.force);
        return job_;
    }
    if (count < 2)
        throw WrongUse(
            "two photographs or more are needed: gcpw_stitch PHOTOGRAPH PHOTOGRAPH..; --help lists the options");
    if (reference_ == 0 || reference_ > count)
        throw WrongUse("--reference is the number of a photograph, 1 to " + std::to_string(count) + ", or -1; got " +
                       std::to_string(reference_));
    if (reference_ > 0)
        job_.params.referenceImage = reference_ - 1;
    planOutputs(console);
    return job_;
}
