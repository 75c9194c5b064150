// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/run_tiled.hpp"

#include <algorithm>
#include "common/deep_exposure.hpp"
#include "common/deep_zoom.hpp"
#include "common/exit_code.hpp"
#include "common/held_signals.hpp"
#include "common/paths.hpp"
#include "common/read_all.hpp"
#include "common/tile_rows.hpp"
#include "common/tiled_tiff.hpp"
#include "common/write_file.hpp"
#include "stitch/canvas_picture.hpp"
#include "stitch/join_parts.hpp"
#include "stitch/model.hpp"
#include "stitch/reduced_photographs.hpp"
#include "stitch/stand_up.hpp"
#include "stitch/steps.hpp"

namespace
{

const char* const WARPING = "warping";
const char* const WRITING = "blending, writing";

/// Pixels of all photographs from which on a TIFF file is made in tiles: in memory they and the picture would take some 3 GB.
const double MANY_PIXELS = 2e8;
const int BLENDED = 1024; ///< px a side of what is blended at once: three times the usual margin
const int AT_ONCE = 4;    ///< such tiles, each with 100 MB of bands
const int HANDED = 256;   ///< rows that the output gets at a time

/// Shares of the time that stages take, of 40 photographs of 24 Mpx on two cores.
std::vector<ProgressLine::Stage> stagesOf(const StitchJob& job)
{
    const double aligning = job.load_model.empty() ? 1 : 0;
    return {{READING, 3}, {MATCHING, aligning}, {ALIGNING, aligning}, {SEAMS, 0.3}, {WARPING, 6}, {WRITING, 6}};
}

/// Thrown where the user has asked to end: what is unfinished is removed on the way out.
struct GivenUp
{
};

/// Whether another photograph has the same camera: they are told apart by their order, and none may be left out.
bool isAlike(const Layout& layout, size_t k)
{
    for (size_t i = 0; i < layout.cameras.size(); ++i)
        if (i != k && cv::norm(layout.cameras[i].R, layout.cameras[k].R, cv::NORM_INF) == 0)
            return true;
    return false;
}

/// Warps photographs into a store, each read anew.
/// @param needed the canvas that is going to be looked at
void warpAll(const ReducedPhotographs& reduced, const Layout& layout, Warping& warping, std::vector<cv::UMat>& seams,
             cv::Rect needed, int margin, bool deep, WarpedStore& store, ProgressLine& progress)
{
    progress.begin(WARPING);
    for (size_t k = 0; k < layout.cameras.size(); ++k)
    {
        if (!isAlike(layout, k) && (cv::Rect(warping.corners()[k], warping.sizes()[k]) & needed).empty())
            continue;
        const Photograph& photograph = reduced.photographs[static_cast<size_t>(layout.component[k])];
        cv::Mat image = readImage(photograph.path);
        if (image.size() != photograph.size())
            throw FileTrouble(shortened(photograph.path) +
                              " has changed since it was read first; leave it until the picture is done");
        Warping::Warped warped = warping.warp(k, image);
        image.release();
        correctExposure(*layout.compensator, static_cast<int>(k), warped.corner, warped.image, warped.mask);
        const cv::Mat mask = cutMask(seams[k], warped.mask);
        seams[k].release();
        store.add(deep ? fedImage(warped.image, true) : warped.image, mask, warped.corner, margin);
        progress.show(static_cast<double>(k + 1) / static_cast<double>(layout.cameras.size()));
    }
}

/// Rows of a picture, made of tiles side by side.
cv::Mat rowsOf(const CanvasPicture& picture, cv::Rect rows, int type)
{
    cv::Mat result(rows.size(), type);
    const int count = (rows.width + BLENDED - 1) / BLENDED;
    cv::parallel_for_(
        cv::Range(0, count),
        [&](const cv::Range& range)
        {
        for (int i = range.start; i < range.end; ++i)
        {
            const cv::Rect tile = cv::Rect(rows.x + i * BLENDED, rows.y, BLENDED, rows.height) & rows;
            cv::Mat place = result(tile - rows.tl());
            picture.pixels(tile).copyTo(place);
        }
        },
        AT_ONCE);
    return result;
}

/// The rows of tiles of a picture that a job makes.
cv::Range tileRowsOf(const StitchJob& job, cv::Size picture)
{
    const int all = (picture.height + TiledTiff::TILE - 1) / TiledTiff::TILE;
    return job.tiles.empty() ? cv::Range(0, all) : TileRows(job.tiles).in(all);
}

/// @param picture its size  @param made rows of it that are written
std::unique_ptr<PictureSink> sinkOf(const StitchJob& job, cv::Size picture, int made, int type,
                                    const Metadata& metadata)
{
    if (endingOf(job.output) == ".dzi")
        return std::make_unique<DeepZoom>(job.output, picture, job.format.quality);
    const std::string description = job.tiles.empty() ? "" : describePart(tileRowsOf(job, picture), picture);
    return std::make_unique<TiledTiff>(job.output, cv::Size(picture.width, made), type, job.format, metadata.profile(),
                                       description);
}

/// The rows of a picture that a job makes. @param shown the part of the picture that remains when it is cropped
cv::Rect madeRows(const StitchJob& job, cv::Rect shown)
{
    const cv::Range rows = tileRowsOf(job, shown.size());
    const int top = rows.start * TiledTiff::TILE;
    const int bottom = std::min(rows.end * TiledTiff::TILE, shown.height);
    return {shown.x, shown.y + top, shown.width, bottom - top};
}

/// @param shown the part of the picture that remains when it is cropped
void write(const StitchJob& job, const CanvasPicture& picture, cv::Rect shown, int type, const Metadata& metadata,
           ProgressLine& progress)
{
    progress.begin(WRITING);
    const cv::Rect made = madeRows(job, shown);
    const HeldSignals signals;
    const std::unique_ptr<PictureSink> sink = sinkOf(job, shown.size(), made.height, type, metadata);
    for (int y = 0; y < made.height; y += BLENDED)
    {
        const cv::Rect band(made.x, made.y + y, made.width, std::min(BLENDED, made.height - y));
        const cv::Mat rows = rowsOf(picture, band, type);
        for (int top = 0; top < rows.rows; top += HANDED)
        {
            if (signals.asked())
                throw GivenUp();
            sink->add(rows.rowRange(top, std::min(top + HANDED, rows.rows)));
        }
        progress.show(static_cast<double>(y + band.height) / made.height);
    }
    sink->finish();
}

void tellAll(const Layout& layout, const Console& console)
{
    tellDecisions(layout, console);
    if (!layout.rig.alignment.report().message.empty())
        console.tell(layout.rig.alignment.report().message);
}

/// Makes and writes one panorama. @param rest gets the photographs that are not in it @return why there is none, empty if there is
std::string makeOne(const StitchJob& job, const Console& console, std::vector<std::string>& rest)
{
    cv::TickMeter clock;
    clock.start();
    ProgressLine progress(stagesOf(job), console.loudness() != Console::Loudness::QUIET);
    progress.begin(READING);
    ReducedPhotographs reduced = readReduced(job, console, progress);
    const std::vector<Photograph>& photographs = reduced.photographs;
    requireAllOfModel(job, photographs);
    MatchLog log(static_cast<int>(photographs.size()));
    Layout layout = layOut(job, photographs, log, progress);
    rest.clear();
    for (size_t i = 0; i < photographs.size(); ++i)
        if (std::find(layout.component.begin(), layout.component.end(), static_cast<int>(i)) == layout.component.end())
            rest.push_back(photographs[i].path);
    writeGraph(job, photographs, log);
    if (!layout.ok())
    {
        ProgressLine::erase();
        return layout.trouble + (photographs.size() == 2 ? "; as a pair they are stitched with --tiled=no" : "");
    }
    if (!job.save_model.empty())
        saveModel(layout, photographs, job.save_model);
    if (job.tiles == "none")
    {
        ProgressLine::erase();
        tellAll(layout, console);
        console.tell(job.save_model + cv::format(": model of %zu images", layout.component.size()));
        return {};
    }
    progress.begin(SEAMS);
    std::vector<cv::UMat> seams =
        findSeams(layout, reduced.seam_scale, [&](size_t i) { return reduced.seam_copies[i]; }, progress);
    reduced.seam_copies.clear();
    const bool deep = reduced.deep && endingOf(job.output) != ".dzi";
    Warping warping(job, photographs, layout, deep, true);
    const cv::Rect canvas = cv::detail::resultRoi(warping.corners(), warping.sizes());
    const Blending blending = blendingOf(job.setup, static_cast<double>(canvas.width) * canvas.height);
    const int turns = layout.turned ? turnsToStand(photographs[0], layout.decisions) : 0;
    WarpedStore store(folderOf(job.output).string());
    const CanvasPicture picture(store, canvas, blending, deep, turns);
    const cv::Rect whole(cv::Point(), picture.size());
    // Where it is cropped depends on all photographs.
    const cv::Rect needed = job.crop == "auto" ? canvas : picture.reach(madeRows(job, whole));
    warpAll(reduced, layout, warping, seams, needed, CanvasPicture::marginOf(blending), deep, store, progress);
    cv::Rect shown = job.crop == "auto" ? picture.largestRectangle() : cv::Rect();
    if (shown.empty())
        shown = whole;
    else
        console.detail(cv::format("cropped from %d x %d to %d x %d px", picture.size().width, picture.size().height,
                                  shown.width, shown.height));
    write(job, picture, shown, deep ? CV_16UC3 : CV_8UC3, sharedMetadata(photographs, layout.component, console),
          progress);
    ProgressLine::erase();
    tellAll(layout, console);
    clock.stop();
    console.tell(cv::format("%s: %d x %d of %zu images, %d ms", job.output.c_str(), shown.width, shown.height,
                            layout.component.size(), cvRound(clock.getTimeMilli())));
    return {};
}

} // namespace

bool isTiled(const StitchJob& job)
{
    const std::string ending = endingOf(job.output);
    if (ending == ".dzi" || job.tiled == "yes" || !job.tiles.empty())
        return true;
    const bool may = job.tiled == "auto" && (ending == ".tif" || ending == ".tiff") && job.obstacleToTiles().empty() &&
                     !isDevice(job.output);
    if (!may)
        return false;
    double pixels = 0;
    for (const std::string& path : job.paths)
        pixels += Metadata::pixelsOf(path);
    return pixels > MANY_PIXELS;
}

int runTiled(const StitchJob& job, const Console& console)
{
    StitchJob present = job;
    const bool go_on = job.panoramas == "all" && job.load_model.empty() && job.tiles.empty();
    for (int number = 1; number == 1 || (go_on && present.paths.size() >= 2); ++number)
    {
        std::vector<std::string> rest;
        if (number > 1)
        {
            const std::vector<std::string> paths = present.paths;
            present = job.further(number);
            present.paths = paths;
        }
        const std::string trouble = makeOne(present, console, rest);
        if (!trouble.empty() && number == 1)
        {
            console.warn(trouble);
            return EXIT_NO_ANSWER;
        }
        if (!trouble.empty())
            break;
        present.paths = rest;
    }
    for (const std::string& path : present.paths)
        tellDropped(path, console);
    return EXIT_STITCHED;
}
