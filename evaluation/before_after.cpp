// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/before_after.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include "evaluation/bend.hpp"
#include "evaluation/seam_visibility.hpp"
#include "evaluation/warped_image.hpp"

namespace evaluation
{

namespace
{

using cv::gcpw::AlignedImage;
using cv::gcpw::Rig;

const int GAP = 16;             ///< px between the parts
const int LABEL = 34;           ///< px above a panorama for its name
const double CROP = 0.14;       ///< width of an enlarged place as a share of the panorama's
const double CROP_ASPECT = 0.7; ///< height over width
const cv::Scalar PAPER(255, 255, 255);
const cv::Scalar INK(0, 0, 0);
const cv::Scalar HELD(60, 190, 0);
const cv::Scalar BENT(30, 30, 235);
const cv::Scalar FRAMES[] = {{220, 110, 20}, {0, 140, 255}};

typedef cv::Mat AlignedImage::*Grid; ///< mesh or rough

/// One panorama, and what its dump says of it.
struct Panorama
{
    cv::Mat picture; ///< white where there is no image
    cv::Mat mean;    ///< plain mean of the warped images: what does not line up is double
    cv::Point origin; ///< canvas pixel of its top-left pixel
    SeamVisibility seams;
    // canvas pixel = scale * working pixel + shift, for each axis
    cv::Vec2d scale = cv::Vec2d(1, 1);
    cv::Vec2d shift;

    cv::Point2d fromWork(const cv::Point2d& p) const
    {
        return {scale[0] * p.x + shift[0] - origin.x, scale[1] * p.y + shift[1] - origin.y};
    }
    cv::Point2d toWork(const cv::Point2d& p) const
    {
        return {(p.x + origin.x - shift[0]) / scale[0], (p.y + origin.y - shift[1]) / scale[1]};
    }
};

cv::Mat readPanorama(const std::string& folder)
{
    for (const char* name : {"/panorama.png", "/panorama.jpg"})
        if (std::filesystem::exists(folder + name))
            return cv::imread(folder + name);
    CV_Error(cv::Error::StsObjectNotFound, "there is no panorama.png and no panorama.jpg in " + folder);
}

/// Finds where the working canvas of a rig lies on a dump's canvas: both have the same outermost pixels.
void fit(const Rig& rig, Grid grid, const cv::Rect& canvas, Panorama& panorama)
{
    const double far = std::numeric_limits<double>::infinity();
    cv::Vec2d low(far, far);
    cv::Vec2d high(-far, -far);
    for (int k = 0; k < rig.alignment.imageCount(); ++k)
        for (const cv::Vec2d& p : cv::Mat_<cv::Vec2d>(rig.alignment.image(k).*grid))
            for (int c : {0, 1})
            {
                low[c] = std::min(low[c], p[c]);
                high[c] = std::max(high[c], p[c]);
            }
    panorama.scale = {canvas.width / (high[0] - low[0]), canvas.height / (high[1] - low[1])};
    panorama.shift = {canvas.x - 0.5 - panorama.scale[0] * low[0], canvas.y - 0.5 - panorama.scale[1] * low[1]};
}

cv::Mat meanOf(const std::vector<WarpedImage>& images, const cv::Rect& canvas)
{
    cv::Mat sum(canvas.size(), CV_32FC3, cv::Scalar::all(0));
    cv::Mat count(canvas.size(), CV_32FC3, cv::Scalar::all(0));
    for (const WarpedImage& image : images)
    {
        const cv::Rect place = image.place - canvas.tl();
        cv::Mat part = sum(place);
        cv::Mat counted = count(place);
        cv::add(part, image.corrected, part, image.mask, CV_32F);
        cv::add(counted, cv::Scalar::all(1), counted, image.mask);
    }
    cv::Mat mean;
    cv::divide(sum, count, mean);
    mean.convertTo(mean, CV_8U);
    return mean;
}

Panorama readAll(const std::string& folder, const Rig& rig, Grid grid)
{
    const std::vector<WarpedImage> images = readDump(folder);
    if (images.empty())
        CV_Error(cv::Error::StsBadArg, folder + "/corners.csv names no image");
    const cv::Rect canvas = canvasOf(images);
    cv::Mat covered(canvas.size(), CV_8UC1, cv::Scalar(0));
    for (const WarpedImage& image : images)
        covered(image.place - canvas.tl()).setTo(255, image.mask);
    Panorama panorama;
    panorama.origin = canvas.tl();
    panorama.picture = readPanorama(folder);
    if (panorama.picture.size() != canvas.size())
        cv::resize(panorama.picture, panorama.picture, canvas.size(), 0, 0, cv::INTER_AREA);
    panorama.mean = meanOf(images, canvas);
    panorama.picture.setTo(PAPER, covered == 0);
    panorama.mean.setTo(PAPER, covered == 0);
    panorama.seams = seamVisibility(images);
    if (rig.alignment.imageCount() > 0)
        fit(rig, grid, canvas, panorama);
    return panorama;
}

/// A place of one panorama in the other: as the nearest vertex of a mesh is moved.
cv::Point2d otherPlace(const cv::Point2d& place, const Rig& rig, const Panorama& from, Grid from_grid, const Panorama& to, Grid to_grid)
{
    const cv::Point2d p = from.toWork(place);
    double nearest = std::numeric_limits<double>::infinity();
    cv::Point2d moved = p;
    for (int k = 0; k < rig.alignment.imageCount(); ++k)
    {
        const cv::Mat_<cv::Vec2d> here = rig.alignment.image(k).*from_grid;
        const cv::Mat_<cv::Vec2d> there = rig.alignment.image(k).*to_grid;
        for (int row = 0; row < here.rows; ++row)
            for (int col = 0; col < here.cols; ++col)
            {
                const cv::Point2d vertex(here(row, col));
                const double distance = cv::norm(vertex - p);
                if (distance < nearest)
                    moved = p + cv::Point2d(there(row, col)) - vertex;
                nearest = std::min(nearest, distance);
            }
    }
    return to.fromWork(moved);
}

/// Segments over a panorama that is about to be shrunk.
void drawLines(const std::vector<std::vector<SegmentBend>>& bends, bool plain, double shrink, Panorama& panorama)
{
    const int thickness = std::max(1, cvRound(1.7 / shrink));
    for (const std::vector<SegmentBend>& image : bends)
        for (const SegmentBend& bend : image)
        {
            std::vector<cv::Point> path;
            for (const cv::Point2d& p : plain ? bend.rough_path : bend.path)
                path.emplace_back(panorama.fromWork(p));
            cv::polylines(panorama.picture, path, false, !plain && bend.largest > VISIBLE_BEND ? BENT : HELD, thickness, cv::LINE_AA);
        }
}

cv::Rect frameAt(const cv::Point2d& place, double width)
{
    const cv::Size size(cvRound(width), cvRound(CROP_ASPECT * width));
    return {cv::Point(cvRound(place.x) - size.width / 2, cvRound(place.y) - size.height / 2), size};
}

cv::Mat enlarged(const cv::Mat& picture, const cv::Rect& frame, cv::Size size, const cv::Scalar& color)
{
    cv::Mat crop(frame.size(), CV_8UC3, PAPER);
    const cv::Rect inside = frame & cv::Rect(cv::Point(), picture.size());
    if (!inside.empty())
        picture(inside).copyTo(crop(inside - frame.tl()));
    cv::resize(crop, crop, size, 0, 0, cv::INTER_CUBIC);
    cv::rectangle(crop, cv::Rect(cv::Point(), size), color, 3);
    return crop;
}

std::string labelOf(const char* name, const Panorama& panorama, const Bend* bend)
{
    std::string label = name;
    if (std::isfinite(panorama.seams.structure_p95))
        label += cv::format(": broken edges along the cut %.2f", panorama.seams.structure_p95);
    if (bend)
        label += cv::format(", bent lines %.0f %%", bend->share);
    return label;
}

/// One half of the picture.
cv::Mat columnOf(const Panorama& lined, const std::string& label, const cv::Point2d places[2], double crop, double shrink,
                 cv::Size top)
{
    const cv::Size tile((top.width - GAP) / 2, cvRound(CROP_ASPECT * (top.width - GAP) / 2));
    cv::Mat column(LABEL + top.height + GAP + tile.height, top.width, CV_8UC3, PAPER);
    cv::putText(column, label, cv::Point(2, LABEL - 12), cv::FONT_HERSHEY_SIMPLEX, 0.55, INK, 1, cv::LINE_AA);
    cv::Mat panorama = lined.picture.clone();
    for (int k = 0; k < 2; ++k)
    {
        const cv::Rect frame = frameAt(places[k], crop);
        cv::rectangle(panorama, frame, FRAMES[k], std::max(1, cvRound(3 / shrink)));
        const cv::Point corner(k * (tile.width + GAP), LABEL + top.height + GAP);
        enlarged(lined.mean, frame, tile, FRAMES[k]).copyTo(column(cv::Rect(corner, tile)));
    }
    cv::resize(panorama, panorama, cv::Size(), shrink, shrink, cv::INTER_AREA);
    panorama.copyTo(column(cv::Rect(cv::Point(0, LABEL), panorama.size())));
    return column;
}

} // namespace

cv::Mat beforeAfter(const std::string& plain_folder, const std::string& gcpw_folder, const std::vector<std::string>& photographs, int width)
{
    CV_CheckGE(width, 200, "a picture needs 200 px or more");
    const Rig rig = Rig::load(gcpw_folder + "/model.yml.gz");
    const Panorama plain = readAll(plain_folder, rig, &AlignedImage::rough);
    const Panorama gcpw = readAll(gcpw_folder, rig, &AlignedImage::mesh);
    const auto photograph = [&](int index)
    {
        const cv::Mat image = cv::imread(photographs.at(static_cast<size_t>(index)));
        if (image.empty())
            CV_Error(cv::Error::StsObjectNotFound, photographs[static_cast<size_t>(index)] + " is not an image");
        return image;
    };
    const std::vector<std::vector<SegmentBend>> bends = bendsOf(rig, photograph, true);
    std::vector<SegmentBend> moving;
    for (size_t k = 0; k < bends.size(); ++k)
        if (moves(rig.alignment.image(static_cast<int>(k))))
            moving.insert(moving.end(), bends[k].begin(), bends[k].end());
    const Bend bend = summary(moving);

    const int half = (width - GAP) / 2;
    const double shrink = static_cast<double>(half) / std::max(plain.picture.cols, gcpw.picture.cols);
    const cv::Size top(half + 1, static_cast<int>(std::ceil(shrink * std::max(plain.picture.rows, gcpw.picture.rows))) + 1);
    const cv::Point2d worst_plain = plain.seams.strongest_place - plain.origin;
    const cv::Point2d worst_gcpw = gcpw.seams.strongest_place - gcpw.origin;
    const cv::Point2d in_plain[] = {
        worst_plain, otherPlace(worst_gcpw, rig, gcpw, &AlignedImage::mesh, plain, &AlignedImage::rough)};
    const cv::Point2d in_gcpw[] = {
        otherPlace(worst_plain, rig, plain, &AlignedImage::rough, gcpw, &AlignedImage::mesh), worst_gcpw};
    Panorama plain_lines = plain;
    plain_lines.picture = plain.picture.clone();
    Panorama gcpw_lines = gcpw;
    gcpw_lines.picture = gcpw.picture.clone();
    drawLines(bends, true, shrink, plain_lines);
    drawLines(bends, false, shrink, gcpw_lines);
    const double crop = CROP * plain.picture.cols;
    cv::Mat result;
    cv::hconcat(std::vector<cv::Mat>{columnOf(plain_lines, labelOf("cv::Stitcher", plain, nullptr), in_plain, crop, shrink, top),
                                     cv::Mat(LABEL + top.height + GAP + cvRound(CROP_ASPECT * (top.width - GAP) / 2), GAP, CV_8UC3, PAPER),
                                     columnOf(gcpw_lines, labelOf("GCPW", gcpw, &bend), in_gcpw, crop, shrink, top)},
                result);
    return result;
}

} // namespace evaluation
