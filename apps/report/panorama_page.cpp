// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "report/panorama_page.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include "common/read_photograph.hpp"

namespace report
{

namespace
{

using cv::gcpw::AlignedImage;
using cv::gcpw::Rig;

/// Where a rig's canvas lies on the page.
class RigPlace
{
public:
    /// @param scale of the warper that made the page's pictures
    RigPlace(const Rig& rig, double scale) : rig_(rig), ratio_(scale / rig.scale), period_(2 * CV_PI * scale) {}

    /// Paths of working pixels of an image; those of one that crosses the seam of a full turn are there on both sides.
    void add(int image, const Path& work, std::vector<Path>& paths) const
    {
        const bool turned = !rig_.turns.empty() && rig_.turns[static_cast<size_t>(image)] != 0;
        for (int k = turned ? -1 : 0; k <= (turned ? 1 : 0); ++k)
        {
            Path path;
            for (const cv::Point2d& p : work)
                path.push_back(place(p) + cv::Point2d(k * period_, 0));
            paths.push_back(path);
        }
    }

private:
    cv::Point2d place(const cv::Point2d& work) const
    {
        const cv::Size2d s = rig_.alignment.canvasScale();
        return {((work.x + 0.5) / s.width - 0.5) * ratio_, ((work.y + 0.5) / s.height - 0.5) * ratio_};
    }

    const Rig& rig_;
    double ratio_;
    double period_;
};

std::vector<Path> meshOf(const cv::Mat& grid, int image, const RigPlace& place)
{
    std::vector<Path> paths;
    for (const Path& path : gridLines(grid))
        place.add(image, path, paths);
    return paths;
}

/// Meshes and straight lines of a rig, in both pictures.
void addRig(const PanoramaRun& run, double scale, Page& page)
{
    const Rig& rig = *run.rig;
    const RigPlace place(rig, scale);
    for (int k = 0; k < rig.alignment.imageCount(); ++k)
    {
        page.before.meshes.push_back(meshOf(rig.alignment.image(k).rough, k, place));
        page.after.meshes.push_back(meshOf(rig.alignment.image(k).mesh, k, place));
    }
    std::vector<std::vector<evaluation::SegmentBend>> bends;
    try
    {
        bends = evaluation::bendsOf(
            rig, [&](int index) { return withoutAlpha(run.cameras.photographs.at(static_cast<size_t>(index))); }, true);
    }
    catch (const cv::Exception& error)
    {
        if (error.code != cv::Error::StsBadArg)
            throw;
        page.messages.push_back("Straight lines are not shown: " + error.err + ".");
    }
    std::vector<evaluation::SegmentBend> moving;
    for (size_t k = 0; k < bends.size(); ++k)
    {
        const int image = static_cast<int>(k);
        if (evaluation::moves(rig.alignment.image(image)))
            moving.insert(moving.end(), bends[k].begin(), bends[k].end());
        for (const evaluation::SegmentBend& bend : bends[k])
        {
            std::vector<Path> rough;
            std::vector<Path> bent;
            place.add(image, bend.rough_path, rough);
            place.add(image, bend.path, bent);
            for (const Path& path : rough)
                page.before.lines.push_back({path, false});
            for (const Path& path : bent)
                page.after.lines.push_back({path, bend.largest > evaluation::VISIBLE_BEND});
        }
    }
    page.bend = evaluation::summary(moving);
}

Picture pictureOf(const PanoramaRun& run, const Composed& composed, double page_scale)
{
    Picture picture;
    picture.images = warpedPhotographs(run.cameras, *composed.warper, *composed.compensator, page_scale);
    const cv::Rect canvas = evaluation::canvasOf(picture.images);
    picture.origin = canvas.tl();
    picture.whole = toBytes(composed.picture);
    cv::resize(picture.whole, picture.image, canvas.size(), 0, 0,
               cv::INTER_AREA); // both have the same outermost pixels
    picture.labels = composed.seams->labelsOf(picture.images);
    return picture;
}

void addPictures(const PanoramaRun& run, Page& page)
{
    const double shrink = pageScale(run.shown.picture.size());
    const double page_scale = shrink * run.compose_scale;
    page.after = pictureOf(run, run.shown, page_scale);
    if (!run.plain.picture.empty())
        page.before = pictureOf(run, run.plain, page_scale);
    if (run.rig && run.rig->alignment.imageCount() > 0)
        addRig(run, warperScale(run.cameras, page_scale), page);
    turnRight(page.after, run.turns);
    if (!run.plain.picture.empty())
        turnRight(page.before, run.turns);
    showWritten(run.crop, page);
}

/// Means over the pairs that can be compared.
Scores znccOf(const cv::gcpw::Report& report)
{
    Scores sum = {0, 0};
    int count = 0;
    for (const cv::gcpw::PairReport& pair : report.pairs)
        if (std::isfinite(pair.miss_before) && std::isfinite(pair.miss_after))
        {
            sum.before += pair.miss_before;
            sum.after += pair.miss_after;
            ++count;
        }
    return count == 0 ? Scores() : Scores{sum.before / count, sum.after / count};
}

} // namespace

Page pageOf(const PanoramaRun& run)
{
    Page page;
    page.program = run.program;
    page.before_name = "cv::Stitcher";
    page.method = run.method;
    page.status = run.status;
    page.stitched = !run.shown.picture.empty();
    page.messages = run.messages;
    page.timings = run.timings;
    for (size_t k = 0; k < run.paths.size(); ++k)
        page.photographs.push_back({run.paths[k], withoutAlpha(run.cameras.photographs[k]), -1});
    if (run.rig)
    {
        page.report = run.rig->alignment.report();
        page.zncc = znccOf(page.report);
    }
    if (!page.stitched)
        return page;
    for (size_t k = 0; k < run.cameras.component.size(); ++k)
        page.photographs.at(static_cast<size_t>(run.cameras.component[k])).shown = static_cast<int>(k);
    addPictures(run, page);
    return page;
}

} // namespace report
