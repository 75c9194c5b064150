// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "report/pair_page.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include "common/read_photograph.hpp"

namespace report
{

namespace
{

using cv::gcpw::AlignedImage;
using cv::gcpw::Alignment;
using cv::gcpw::Blend;
using cv::gcpw::PairCanvas;
using evaluation::WarpedImage;

const double CUT_PIXELS = 0.1e6; ///< while the cut is found, as blendPair() does

/// Scaling of pixel squares: page = (canvas + 0.5) * scale - 0.5.
cv::Matx33d scaling(double scale)
{
    return {scale, 0, 0.5 * scale - 0.5, 0, scale, 0.5 * scale - 0.5, 0, 0, 1};
}

cv::Point2d mapped(const cv::Matx33d& homography, const cv::Point2d& p)
{
    const cv::Vec3d q = homography * cv::Vec3d(p.x, p.y, 1);
    return {q[0] / q[2], q[1] / q[2]};
}

/// A canvas of 8 bits.
PairCanvas inBytes(const PairCanvas& canvas)
{
    PairCanvas bytes = canvas;
    for (cv::Mat* picture : {&bytes.source, &bytes.source_corrected, &bytes.target, &bytes.target_corrected})
        *picture = toBytes(*picture);
    return bytes;
}

/// A picture of one method in pixels of the page.
Picture shrunk(const PairCanvas& canvas, const cv::Mat& panorama, Blend blend, double scale)
{
    Picture picture;
    const auto shrink = [&](const cv::Mat& image)
    {
        cv::Mat result;
        cv::resize(image, result, cv::Size(), scale, scale, cv::INTER_AREA);
        return result;
    };
    picture.image = shrink(panorama);
    for (const WarpedImage& image : evaluation::imagesOf(canvas))
    {
        WarpedImage small = image;
        small.image = shrink(image.image);
        small.corrected = blend == Blend::AVERAGE ? small.image : shrink(image.corrected);
        small.mask = shrink(image.mask) == 255; // pixels that the photograph covers as a whole
        small.place = cv::Rect(cv::Point(), small.image.size());
        picture.images.push_back(small);
    }
    return picture;
}

/// Moves a picture by a homography of the page's pixels.
void move(const cv::Matx33d& homography, Picture& picture)
{
    std::vector<cv::Point2d> corners;
    for (const cv::Point2d& corner :
         {cv::Point2d(-0.5, -0.5), cv::Point2d(picture.image.cols - 0.5, -0.5),
          cv::Point2d(-0.5, picture.image.rows - 0.5), cv::Point2d(picture.image.cols - 0.5, picture.image.rows - 0.5)})
        corners.push_back(mapped(homography, corner));
    const auto x = std::minmax_element(corners.begin(), corners.end(),
                                       [](const cv::Point2d& a, const cv::Point2d& b) { return a.x < b.x; });
    const auto y = std::minmax_element(corners.begin(), corners.end(),
                                       [](const cv::Point2d& a, const cv::Point2d& b) { return a.y < b.y; });
    const cv::Rect place(cv::Point(cvFloor(x.first->x), cvFloor(y.first->y)),
                         cv::Point(cvCeil(x.second->x) + 1, cvCeil(y.second->y) + 1));
    const cv::Matx33d shifted = cv::Matx33d(1, 0, -place.x, 0, 1, -place.y, 0, 0, 1) * homography;
    const auto warp = [&](cv::Mat& image, int interpolation)
    {
        cv::Mat result;
        cv::warpPerspective(image, result, shifted, place.size(), interpolation, cv::BORDER_CONSTANT);
        image = result;
    };
    picture.origin = place.tl();
    warp(picture.image, cv::INTER_LINEAR);
    for (WarpedImage& image : picture.images)
    {
        image.place = place;
        warp(image.image, cv::INTER_LINEAR);
        warp(image.corrected, cv::INTER_LINEAR);
        warp(image.mask, cv::INTER_NEAREST);
    }
}

/// Takes working pixels of the target's frame to pixels of the page.
cv::Matx33d pageFromWork(const Alignment& alignment, const PairCanvas& canvas, double scale)
{
    const cv::Size2d s = alignment.canvasScale();
    const cv::Matx33d full_from_work(1 / s.width, 0, 0.5 / s.width - 0.5, 0, 1 / s.height, 0.5 / s.height - 0.5, 0, 0,
                                     1);
    return scaling(scale) * cv::Matx33d(canvas.canvas_from_target.ptr<double>()) * full_from_work;
}

std::vector<Path> meshOf(const cv::Mat& grid, const cv::Matx33d& homography)
{
    std::vector<Path> paths = gridLines(grid);
    for (Path& path : paths)
        for (cv::Point2d& p : path)
            p = mapped(homography, p);
    return paths;
}

void addLines(const std::vector<evaluation::SegmentBend>& bends, const cv::Matx33d& homography, bool rough,
              Picture& picture)
{
    for (const evaluation::SegmentBend& bend : bends)
    {
        Line line;
        for (const cv::Point2d& p : rough ? bend.rough_path : bend.path)
            line.path.push_back(mapped(homography, p));
        line.bent = !rough && bend.largest > evaluation::VISIBLE_BEND;
        picture.lines.push_back(line);
    }
}

void addPictures(const PairRun& run, Page& page)
{
    const double scale = pageScale(run.panorama.size());
    page.after = shrunk(inBytes(run.canvas), toBytes(run.panorama), run.blend, scale);
    page.after.whole = toBytes(run.panorama);
    const PairCanvas rough =
        cv::gcpw::renderPair(run.alignment.rough(), toBytes(run.source), toBytes(run.target), run.view);
    const cv::Mat rough_panorama = cv::gcpw::blendPair(rough, run.blend);
    page.before = shrunk(rough, rough_panorama, run.blend, scale);
    const cv::Matx33d after_from_before = cv::Matx33d(run.canvas.canvas_from_target.ptr<double>()) *
                                          cv::Matx33d(rough.canvas_from_target.ptr<double>()).inv();
    move(scaling(scale) * after_from_before * scaling(scale).inv(), page.before);
    if (run.blend == Blend::MULTIBAND)
        for (Picture* picture : {&page.before, &page.after})
            picture->labels = evaluation::graphCut(picture->images, CUT_PIXELS);

    const cv::Matx33d page_from_work = pageFromWork(run.alignment, run.canvas, scale);
    const AlignedImage& source = run.alignment.image(0);
    page.before.meshes = {meshOf(source.rough, page_from_work)};
    page.after.meshes = {meshOf(source.mesh, page_from_work)};
    for (int k : {0, 1})
    {
        const AlignedImage& image = run.alignment.image(k);
        const std::vector<evaluation::SegmentBend> bends = evaluation::bendsOf(
            image, evaluation::longSegments(withoutAlpha(toBytes(k == 0 ? run.source : run.target)), image.work_size));
        if (evaluation::moves(image))
            page.bend = evaluation::summary(bends);
        addLines(bends, page_from_work, true, page.before);
        addLines(bends, page_from_work, false, page.after);
    }
    showWritten(run.crop, page);
}

} // namespace

Page pageOf(const PairRun& run)
{
    Page page;
    page.program = run.program;
    page.method = run.method;
    page.before_name = "Homography";
    page.report = run.alignment.report();
    page.stitched = !run.panorama.empty();
    page.status = !page.stitched ? page.report.message
                  : page.report.status == cv::gcpw::Status::OK
                      ? "Stitched"
                      : "Stitched by the homography alone: " + page.report.message;
    page.photographs = {{run.paths[0], withoutAlpha(toBytes(run.source)), page.stitched ? 0 : -1},
                        {run.paths[1], withoutAlpha(toBytes(run.target)), page.stitched ? 1 : -1}};
    if (page.stitched)
        addPictures(run, page);
    page.zncc = run.zncc;
    const cv::gcpw::Timings& t = page.report.timings_ms;
    page.timings = {{"Keypoints and lines", t.features},
                    {"Matching", t.homography},
                    {"Alignment", t.align},
                    {"Rendering", run.render_ms}};
    if (!page.report.message.empty())
        page.messages.push_back(page.report.message);
    if (page.report.folds > 0)
        page.messages.push_back(cv::format("%d quads of the mesh are folded.", page.report.folds));
    return page;
}

} // namespace report
