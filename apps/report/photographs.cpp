// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <algorithm>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include "evaluation/tone.hpp"
#include "report/html.hpp"
#include "report/sections.hpp"

namespace report
{

namespace
{

const int THUMBNAIL = 220;        ///< px, longer side
const double ALL_KILOBYTES = 500; ///< of all thumbnails together
const int MOST_KILOBYTES = 16;    ///< of one
const int LEAST_KILOBYTES = 2;

std::string thumbnail(const cv::Mat& image, const cv::Mat& mask, const std::string& alt, int kilobytes)
{
    cv::Mat shown = image;
    if (!mask.empty())
    {
        shown = cv::Mat(image.size(), CV_8UC3, BACKDROP);
        image.copyTo(shown, mask);
    }
    const double scale = std::min(1.0, static_cast<double>(THUMBNAIL) / std::max(image.cols, image.rows));
    cv::Mat small;
    cv::resize(shown, small,
               cv::Size(std::max(1, cvRound(scale * image.cols)), std::max(1, cvRound(scale * image.rows))), 0, 0,
               cv::INTER_AREA);
    return cv::format("<img class=\"thumbnail\" width=\"%d\" height=\"%d\" alt=\"", small.cols, small.rows) +
           escaped(alt) + "\" src=\"" + jpegUri(small, kilobytes).text + "\">";
}

} // namespace

std::string photographs(const Page& page)
{
    Table table;
    table.heads = {"",         "Photograph", "As it was taken", "As it is shown", "Light",
                   "Red (Cr)", "Blue (Cb)",  "Black",           "White"};
    table.classes = {"number", "name", "", "", "number", "number", "number", "number", "number"};
    const double share = ALL_KILOBYTES / (2 * std::max<double>(1, static_cast<double>(page.photographs.size())));
    const int kilobytes = std::min(std::max(static_cast<int>(share), LEAST_KILOBYTES), MOST_KILOBYTES);
    for (size_t k = 0; k < page.photographs.size(); ++k)
    {
        const Photograph& photograph = page.photographs[k];
        const std::string name = std::filesystem::path(photograph.path).filename().string();
        std::vector<std::string> row = {std::to_string(k + 1),
                                        escaped(name) + cv::format("<br><small>%d &times; %d px</small>",
                                                                   photograph.image.cols, photograph.image.rows)};
        if (photograph.shown < 0 || page.after.images.empty())
        {
            row.push_back(thumbnail(photograph.image, cv::Mat(), name, kilobytes));
            row.emplace_back(page.after.images.empty() ? "" : "<strong>not in the picture</strong>");
            row.insert(row.end(), 5, "");
        }
        else
        {
            const evaluation::WarpedImage& image = page.after.images[static_cast<size_t>(photograph.shown)];
            row.push_back(thumbnail(image.image, image.mask, name + ", warped, its colours untouched", kilobytes));
            row.push_back(thumbnail(image.corrected, image.mask, name + ", warped, its colours corrected", kilobytes));
            const evaluation::Tone tone = evaluation::toneOf({image});
            for (int c = 0; c < 3; ++c)
                row.push_back(image.fixed ? "kept" : change(tone.cast[c]));
            row.push_back(cv::format("%.1f %%", tone.crushed));
            row.push_back(cv::format("%.1f %%", tone.blown));
        }
        table.rows.push_back(row);
    }
    return table.html();
}

} // namespace report
