// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "report/page.hpp"

#include <algorithm>
#include "report/html.hpp"
#include "report/page_files.hpp"
#include "report/sections.hpp"

namespace report
{

namespace
{

std::string section(const std::string& id, const std::string& title, const std::string& words,
                    const std::string& content)
{
    if (content.empty())
        return {};
    return "<section id=\"" + id + "\">\n<h2>" + title + "</h2>\n" + (words.empty() ? "" : "<p>" + words + "</p>\n") +
           content + "</section>\n";
}

/// Of a picture in all its pixels.
cv::Size sizeOf(const Picture& picture)
{
    return picture.whole.empty() ? picture.image.size() : picture.whole.size();
}

std::string subtitle(const Page& page)
{
    const auto shown = std::count_if(page.photographs.begin(), page.photographs.end(),
                                     [](const Photograph& p) { return p.shown >= 0; });
    std::string text = cv::format("%d of %zu photographs", static_cast<int>(shown), page.photographs.size());
    const cv::Size whole = sizeOf(page.after);
    if (!page.size.empty())
        text += cv::format(", %d &times; %d px", page.size.width, page.size.height);
    if (page.size != whole)
        text += cv::format(", cropped from %d &times; %d", whole.width, whole.height);
    return text + ", by " + escaped(page.program) + " with " + escaped(page.method);
}

std::string titleOf(const Page& page)
{
    return page.stitched ? "How the picture was stitched" : "Why there is no picture";
}

} // namespace

void showWritten(const cv::Rect& crop, Page& page)
{
    page.size = sizeOf(page.after);
    page.frame = page.before.image.empty() ? page.after.place() : page.after.place() | page.before.place();
    if (crop.empty())
        return;
    const double scale = static_cast<double>(page.after.image.cols) / page.size.width;
    const auto scaled = [scale](const cv::Point& p) { return cv::Point(cvRound(scale * p.x), cvRound(scale * p.y)); };
    page.frame = (cv::Rect(scaled(crop.tl()), scaled(crop.br())) + page.after.origin) & page.after.place();
    page.size = crop.size();
    for (evaluation::Labels* labels : {&page.before.labels, &page.after.labels})
    {
        if (labels->of.empty())
            continue;
        cv::Mat kept(labels->of.size(), CV_16SC1, cv::Scalar(-1));
        const cv::Rect inside = (page.frame - labels->origin) & cv::Rect(cv::Point(), kept.size());
        labels->of(inside).copyTo(kept(inside));
        labels->of = kept;
    }
}

std::string htmlOf(const Page& page)
{
    std::map<std::string, std::string> values = {
        {"title", titleOf(page)}, {"style", page_files::STYLE}, {"script", page_files::SCRIPT}};
    values["subtitle"] = subtitle(page);
    values["status"] =
        "<p class=\"status " + std::string(page.stitched ? "good" : "bad") + "\">" + escaped(page.status) + "</p>";
    std::string sections;
    if (page.stitched)
    {
        const Viewer viewer = viewerOf(page);
        const bool compared = !page.before.image.empty();
        values["cards"] = "<div class=\"cards\">\n" + cards(page, viewer.before, viewer.after) + "</div>\n";
        sections += section("picture", compared ? "Before and after" : "The picture",
                            compared ? "Left of the line: " + escaped(page.before_name) +
                                           ". Right of it: " + escaped(page.method) +
                                           ". Drag the line, or move the slider with the arrow keys."
                                     : "",
                            viewer.html);
        sections += section(
            "close-ups", "Look closely",
            "Where the cut between two photographs breaks the strongest edges: what a critical eye finds first.",
            closeUps(page));
    }
    else
        values["cards"] = "";
    sections += section(
        "photographs", "Photographs and their colours",
        page.stitched
            ? "Means over the photograph of what the colour correction adds, of 255 gray levels; black and white are "
              "the shares of its pixels that became so dark or so bright that nothing is told apart."
            : "",
        photographs(page));
    sections += section("pairs", "Pairs",
                        "Points and lines that match, misalignment before and after the meshes moved (zncc: 100 times "
                        "the RMS of one minus "
                        "the zero-mean normalised correlation, over windows of 5 x 5 px; 0 is perfect), and the mean "
                        "difference of colours "
                        "where both overlap, gray levels.",
                        pairs(page));
    sections += section("messages", "Messages", "", messages(page));
    sections += section("timings", "Time", "", timings(page));
    const std::string table = levels(page);
    if (!table.empty())
        sections += section("levels", "Estimation", "",
                            "<details><summary>Levels, coarse to fine, and the energy of each term</summary>\n" +
                                table + "</details>\n");
    values["sections"] = sections;
    return filled(page_files::PAGE, values);
}

} // namespace report
