// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "report/sections.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include "evaluation/likeness.hpp"
#include "evaluation/seam_visibility.hpp"
#include "evaluation/tone.hpp"
#include "report/html.hpp"

namespace report
{

namespace
{

using evaluation::WarpedImage;

/// A figure of both pictures, or of one.
std::string card(const std::string& title, const std::string& value, const std::string& words)
{
    return "<div class=\"card\"><h3>" + title + "</h3><p class=\"value\">" + value + "</p><p>" + words + "</p></div>\n";
}

std::string fromTo(const Page& page, const Scores& scores, const char* form)
{
    const std::string after = "<b>" + numberOrDash(scores.after, form) + "</b>";
    return page.before.image.empty()
               ? after
               : "<span class=\"was\">" + numberOrDash(scores.before, form) + "</span> &rarr; " + after;
}

double brokenEdges(const Picture& picture)
{
    if (picture.image.empty() || picture.labels.of.empty())
        return std::numeric_limits<double>::quiet_NaN();
    return evaluation::seamVisibility(picture.images, picture.labels).structure_p95;
}

std::string stopName(cv::gcpw::StopReason reason)
{
    switch (reason)
    {
    case cv::gcpw::StopReason::ITERATION_LIMIT:
        return "as many iterations as are asked for";
    case cv::gcpw::StopReason::MESH_STABLE:
        return "the mesh stands still";
    case cv::gcpw::StopReason::ENERGY_STABLE:
        return "the energy sinks no more";
    case cv::gcpw::StopReason::NO_DESCENT:
        return "no step lowers the energy";
    case cv::gcpw::StopReason::SINGULAR:
        return "the equations are singular";
    case cv::gcpw::StopReason::CANCELLED:
        return "cancelled";
    }
    return "?";
}

std::string duration(double ms)
{
    return ms < 1000 ? cv::format("%.0f ms", ms) : cv::format("%.1f s", ms / 1000);
}

double totalOf(const Page& page)
{
    double total = 0;
    for (const Timing& timing : page.timings)
        total += timing.ms;
    return total;
}

/// Mean difference of two images where both are, gray levels; NaN if they share too little.
Scores colorDifference(const WarpedImage& a, const WarpedImage& b)
{
    Scores scores;
    const cv::Rect common = a.place & b.place;
    if (common.empty())
        return scores;
    const cv::Rect in_a = common - a.place.tl();
    const cv::Rect in_b = common - b.place.tl();
    const cv::Mat both = a.mask(in_a) & b.mask(in_b);
    if (cv::countNonZero(both) == 0)
        return scores;
    const auto difference = [&](const cv::Mat& p, const cv::Mat& q)
    {
        cv::Mat gap;
        cv::absdiff(p(in_a), q(in_b), gap);
        const cv::Scalar mean = cv::mean(gap, both);
        return (mean[0] + mean[1] + mean[2]) / 3;
    };
    scores.before = difference(a.image, b.image);
    scores.after = difference(a.corrected, b.corrected);
    return scores;
}

} // namespace

std::string numberOf(const Page& page, int image)
{
    for (size_t k = 0; k < page.photographs.size(); ++k)
        if (page.photographs[k].shown == image)
            return std::to_string(k + 1);
    return "?";
}

std::string cards(const Page& page, const Misalignment& before, const Misalignment& after)
{
    std::string html;
    if (std::isfinite(page.zncc.after))
        html += card("Misalignment, zncc", fromTo(page, page.zncc, "%.1f"),
                     "How little the warped photographs correlate in windows of 5 x 5 px where they overlap: 0 is "
                     "perfect, 100 no likeness.");
    html += card("Looks double, %", fromTo(page, {before.share, after.share}, "%.1f"),
                 "Of the overlap that has texture, the part whose correlation is below 0.6: coloured in the map of "
                 "misalignment.");
    if (page.bend.segments > 0)
        html +=
            card("Bent lines", cv::format("<b>%.0f %%</b> <small>of %d</small>", page.bend.share, page.bend.segments),
                 cv::format("Long straight lines that the mesh bends by more than 1.5 px; the worst by %.1f px.",
                            page.bend.largest));
    const Scores broken = {brokenEdges(page.before), brokenEdges(page.after)};
    if (std::isfinite(broken.after))
        html += card(
            "Broken edges", fromTo(page, broken, "%.2f"),
            "How unlike both photographs are along the cuts, 95th percentile: 0 is an unbroken edge, 0.5 no likeness.");
    const evaluation::Tone tone = evaluation::toneOf(page.after.images);
    html += card(
        "Change of light", "<b>" + change(tone.cast[0]) + "</b> <small>of 255</small>",
        cv::format(
            "Mean change by the colour correction, gray levels; %.1f %% of the pixels became black, %.1f %% white.",
            tone.crushed, tone.blown));
    if (!page.timings.empty())
        html += card("Time", "<b>" + duration(totalOf(page)) + "</b>",
                     "From reading the photographs to the finished picture.");
    return html;
}

std::string pairs(const Page& page)
{
    Table table;
    table.heads = {"Photographs",       "Points",   "Lines", "zncc of rough alignment", "zncc",
                   "Colours differ by", "corrected"};
    table.classes = {"", "number", "number", "number", "number", "number", "number"};
    for (const cv::gcpw::PairReport& pair : page.report.pairs)
    {
        Scores colors;
        const int count = static_cast<int>(page.after.images.size());
        if (pair.a >= 0 && pair.a < count && pair.b >= 0 && pair.b < count)
            colors = colorDifference(page.after.images[static_cast<size_t>(pair.a)],
                                     page.after.images[static_cast<size_t>(pair.b)]);
        const bool ordered = pair.a < pair.b; // images keep the order of the photographs
        table.rows.push_back(
            {numberOf(page, ordered ? pair.a : pair.b) + " and " + numberOf(page, ordered ? pair.b : pair.a),
             std::to_string(pair.points), std::to_string(pair.lines), numberOrDash(pair.miss_before, "%.1f"),
             numberOrDash(pair.miss_after, "%.1f"), numberOrDash(colors.before, "%.1f"),
             numberOrDash(colors.after, "%.1f")});
    }
    return table.rows.empty() ? std::string() : table.html();
}

std::string levels(const Page& page)
{
    Table table;
    table.heads = {"Level", "Iterations", "Ended because", "Energy"};
    table.classes = {"number", "number", "", "number"};
    for (const cv::gcpw::TermEnergy& term :
         page.report.levels.empty() ? std::vector<cv::gcpw::TermEnergy>() : page.report.levels[0].end)
    {
        table.heads.push_back(escaped(term.name));
        table.classes.emplace_back("number");
    }
    const auto sinking = [](double from, double to) { return cv::format("%.4g &rarr; %.4g", from, to); };
    for (const cv::gcpw::LevelReport& level : page.report.levels)
    {
        std::vector<std::string> row = {cv::format("1 : %g", level.scale), std::to_string(level.iterations),
                                        stopName(level.stop),
                                        sinking(cv::gcpw::totalEnergy(level.start), cv::gcpw::totalEnergy(level.end))};
        for (size_t k = 0; k < level.end.size(); ++k)
            row.push_back(k < level.start.size() ? sinking(level.start[k].value, level.end[k].value)
                                                 : cv::format("%.4g", level.end[k].value));
        table.rows.push_back(row);
    }
    return table.rows.empty() ? std::string() : table.html();
}

std::string timings(const Page& page)
{
    if (page.timings.empty())
        return {};
    const double total = std::max(totalOf(page), 1e-9);
    std::string html = "<ul class=\"timings\">\n";
    for (const Timing& timing : page.timings)
        html += "<li><span>" + escaped(timing.stage) +
                "</span><span class=\"bar\"><i style=\"width: " + cv::format("%.1f", 100 * timing.ms / total) +
                "%\"></i></span><span class=\"number\">" + duration(timing.ms) + "</span></li>\n";
    return html + "<li class=\"total\"><span>Together</span><span></span><span class=\"number\">" + duration(total) +
           "</span></li>\n</ul>\n";
}

std::string messages(const Page& page)
{
    std::string html;
    for (std::string message : page.messages)
    {
        if (!message.empty() && message.find('/') == std::string::npos) // not the name of a file
            message[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(message[0])));
        html += "<li>" + escaped(message) + "</li>\n";
    }
    return html.empty() ? "<p>Nothing was out of the ordinary.</p>\n" : "<ul class=\"messages\">\n" + html + "</ul>\n";
}

} // namespace report
