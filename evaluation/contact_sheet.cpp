// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/contact_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include "evaluation/external.hpp"

namespace evaluation
{

namespace
{

using cv::gcpw::PairCanvas;

const int PATCHES = 3;
const int TILE = 240;           ///< px: height of a row; patches are enlarged to it
const int MARGIN = 8;           ///< px between tiles
const int LABEL = 150;          ///< px: width of the column of names
const int PANORAMA = 640;       ///< px: largest width of a panorama
const double PATCH_SHARE = 0.11; ///< side of a patch as a share of the target's diagonal
const double MIN_COVERED = 0.9; ///< share of a patch that lies in every method's overlap
const int STEPS = 3;            ///< patches are tried at every third of their side
const cv::Scalar PAPER(255, 255, 255);
const cv::Scalar INK(0, 0, 0);
const cv::Scalar FRAMES[PATCHES] = {{40, 40, 230}, {40, 160, 40}, {230, 120, 20}};

/// A rectangle of an image; what lies outside of the image is filled.
cv::Mat crop(const cv::Mat& image, cv::Rect rect, const cv::Scalar& fill)
{
    cv::Mat result(rect.size(), image.type(), fill);
    const cv::Rect inside = rect & cv::Rect(cv::Point(), image.size());
    if (!inside.empty())
        image(inside).copyTo(result(cv::Rect(inside.tl() - rect.tl(), inside.size())));
    return result;
}

/// A rectangle of the canvas; what lies outside of it is empty and masked out.
PairCanvas cropped(const PairCanvas& canvas, cv::Rect rect)
{
    const cv::Scalar nothing;
    PairCanvas result;
    result.source = crop(canvas.source, rect, nothing);
    result.source_mask = crop(canvas.source_mask, rect, nothing);
    result.target = crop(canvas.target, rect, nothing);
    result.target_mask = crop(canvas.target_mask, rect, nothing);
    return result;
}

/// One row of the sheet.
struct Entry
{
    std::string label;
    std::string score;
    PairCanvas canvas;
    cv::Mat picture; ///< where there is no canvas
};

/// What all panoramas show: both images, but no more than half a target beyond the target on each side.
cv::Rect shownFrame(const std::vector<PairCanvas>& canvases, cv::Size target)
{
    cv::Rect shown(cv::Point(), target);
    for (const PairCanvas& canvas : canvases)
        shown |= cv::Rect(-canvas.target_origin, canvas.source.size());
    const cv::Rect limit(-target.width, -target.height / 2, 3 * target.width, 2 * target.height);
    return shown & limit;
}

/// A row of a picture alone.
cv::Mat pictureRow(const Entry& entry, cv::Size size)
{
    const double scale = std::min({1.0, static_cast<double>(size.width) / entry.picture.cols,
                                   static_cast<double>(size.height) / entry.picture.rows});
    cv::Mat picture;
    cv::resize(entry.picture, picture, cv::Size(), scale, scale, cv::INTER_AREA);
    cv::Mat row(std::max(TILE, size.height) + MARGIN, LABEL + size.width + PATCHES * (TILE + MARGIN) + MARGIN, CV_8UC3,
                PAPER);
    cv::putText(row, entry.label, cv::Point(MARGIN, 24), cv::FONT_HERSHEY_SIMPLEX, 0.6, INK, 1, cv::LINE_AA);
    picture.copyTo(row(cv::Rect(cv::Point(LABEL, 0), picture.size())));
    return row;
}

cv::Mat rowOf(const Entry& entry, cv::Rect shown, const std::vector<cv::Rect>& patches, double scale)
{
    cv::Mat mean = cv::gcpw::blendPair(entry.canvas, cv::gcpw::Blend::AVERAGE);
    mean.setTo(PAPER, (entry.canvas.source_mask | entry.canvas.target_mask) == 0);
    const cv::Point origin = entry.canvas.target_origin;
    cv::Mat panorama;
    cv::resize(crop(mean, shown + origin, PAPER), panorama, cv::Size(), scale, scale, cv::INTER_AREA);
    cv::Mat row(std::max(TILE, panorama.rows) + MARGIN, LABEL + panorama.cols + PATCHES * (TILE + MARGIN) + MARGIN, CV_8UC3, PAPER);
    cv::putText(row, entry.label, cv::Point(MARGIN, 24), cv::FONT_HERSHEY_SIMPLEX, 0.6, INK, 1, cv::LINE_AA);
    cv::putText(row, entry.score, cv::Point(MARGIN, 48), cv::FONT_HERSHEY_SIMPLEX, 0.5, INK, 1, cv::LINE_AA);
    int left = LABEL + panorama.cols + MARGIN;
    for (size_t k = 0; k < patches.size(); ++k)
    {
        cv::Mat patch;
        cv::resize(crop(mean, patches[k] + origin, PAPER), patch, cv::Size(TILE, TILE), 0, 0, cv::INTER_CUBIC);
        cv::rectangle(patch, cv::Rect(cv::Point(), patch.size()), FRAMES[k], 3);
        patch.copyTo(row(cv::Rect(left, 0, TILE, TILE)));
        left += TILE + MARGIN;
        const cv::Rect2d there((patches[k].x - shown.x) * scale, (patches[k].y - shown.y) * scale, patches[k].width * scale,
                               patches[k].height * scale);
        cv::rectangle(panorama, there, FRAMES[k], 2);
    }
    panorama.copyTo(row(cv::Rect(cv::Point(LABEL, 0), panorama.size())));
    return row;
}

} // namespace

std::vector<cv::Rect> worstPatches(const std::vector<PairCanvas>& canvases, cv::Size target_size, int side, int count)
{
    struct Candidate
    {
        double error;
        cv::Rect place;
    };
    std::vector<Candidate> candidates;
    const int step = std::max(1, side / STEPS);
    for (int y = 0; y + side <= target_size.height; y += step)
        for (int x = 0; x + side <= target_size.width; x += step)
        {
            Candidate candidate = {0, cv::Rect(x, y, side, side)};
            for (const PairCanvas& canvas : canvases)
            {
                const PairCanvas part = cropped(canvas, candidate.place + canvas.target_origin);
                const int covered = cv::countNonZero(part.source_mask & part.target_mask);
                candidate.error += covered < MIN_COVERED * side * side ? std::nan("") : cv::gcpw::scorePair(part).ncc;
            }
            if (std::isfinite(candidate.error))
                candidates.push_back(candidate);
        }
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) { return a.error > b.error; });
    std::vector<cv::Rect> worst;
    for (const Candidate& candidate : candidates)
        if (static_cast<int>(worst.size()) < count &&
            std::none_of(worst.begin(), worst.end(), [&](const cv::Rect& taken) { return (taken & candidate.place).area() > 0; }))
            worst.push_back(candidate.place);
    return worst;
}

cv::Mat contactSheet(const Experiment& experiment, const PairFiles& pair, const RunTable& rows)
{
    const cv::Mat source = readInput(pair.source, experiment.max_megapix, INPUT_GIVEN);
    const cv::Mat target = readInput(pair.target, experiment.max_megapix, INPUT_GIVEN);
    std::vector<Entry> entries;
    std::vector<PairCanvas> canvases;
    for (const PairMethod* method : experiment.methods)
    {
        const auto row = rows.find({pair.name, method->name, 0, INPUT_GIVEN});
        const bool picture = row != rows.end() && row->second.status == "picture";
        if (!picture && (row == rows.end() || !std::isfinite(row->second.zncc)))
            continue;
        Entry entry;
        entry.label = method->label;
        if (!method->results.empty())
        {
            const ExternalResult found =
                readExternal(*method, pair.name, INPUT_GIVEN, source, target, cv::Matx33d::eye());
            entry.canvas = found.canvas;
            entry.picture = found.panorama;
        }
        else
            entry.canvas = cv::gcpw::renderPair(
                cv::gcpw::Alignment::load(alignmentPath(experiment.folder, pair.name, method->name)), source, target);
        if (!picture)
        {
            entry.score = cv::format("zncc %.1f", row->second.zncc);
            canvases.push_back(entry.canvas);
        }
        entries.push_back(entry);
    }
    if (entries.empty())
        return cv::Mat();
    const int side = cvRound(PATCH_SHARE * std::hypot(target.cols, target.rows));
    const std::vector<cv::Rect> patches = worstPatches(canvases, target.size(), side, PATCHES);
    const cv::Rect shown = shownFrame(canvases, target.size());
    const double scale = std::min(1.0, std::min(static_cast<double>(PANORAMA) / shown.width, static_cast<double>(TILE) / shown.height));
    std::vector<cv::Mat> parts;
    for (const Entry& entry : entries)
        parts.push_back(entry.picture.empty()
                            ? rowOf(entry, shown, patches, scale)
                            : pictureRow(entry, {cvRound(shown.width * scale), cvRound(shown.height * scale)}));
    cv::Mat sheet;
    cv::vconcat(parts, sheet);
    return sheet;
}

} // namespace evaluation
