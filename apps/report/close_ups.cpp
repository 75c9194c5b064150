// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <opencv2/imgproc.hpp>
#include "evaluation/seam_visibility.hpp"
#include "report/html.hpp"
#include "report/viewer.hpp"

namespace report
{

namespace
{

const double CROP = 0.16;        ///< width of an enlarged place as a share of the frame's longer side
const double CROP_ASPECT = 0.75; ///< height over width
const int TILE = 560;            ///< px, largest width of an enlarged place
const int TILE_KILOBYTES = 60;

/// The rectangle around a place, moved into the frame.
cv::Rect around(const cv::Point& place, const cv::Rect& frame)
{
    const int width = std::min(cvRound(CROP * std::max(frame.width, frame.height)), frame.width);
    const cv::Size size(width, std::min(cvRound(CROP_ASPECT * width), frame.height));
    const cv::Point corner(std::min(std::max(place.x - size.width / 2, frame.x), frame.br().x - size.width),
                           std::min(std::max(place.y - size.height / 2, frame.y), frame.br().y - size.height));
    return {corner, size};
}

/// A rectangle of the canvas in all the pixels that the picture was made with.
cv::Mat enlarged(const Picture& picture, const cv::Rect& crop)
{
    const cv::Mat& whole = picture.whole.empty() ? picture.image : picture.whole;
    const double scale = static_cast<double>(whole.cols) / picture.image.cols;
    const cv::Point corner = crop.tl() - picture.origin;
    const cv::Rect there(cvRound(scale * corner.x), cvRound(scale * corner.y), cvRound(scale * crop.width),
                         cvRound(scale * crop.height));
    cv::Mat tile = framed(whole, cv::Point(), there);
    const cv::Size size(TILE, cvRound(static_cast<double>(TILE) * crop.height / crop.width));
    cv::resize(tile, tile, size, 0, 0, tile.cols > size.width ? cv::INTER_AREA : cv::INTER_CUBIC);
    cv::Mat inside;
    cv::resize(covered(picture.images, crop), inside, size, 0, 0, cv::INTER_NEAREST);
    tile.setTo(BACKDROP, inside == 0);
    return tile;
}

std::string tile(const Picture& picture, const cv::Rect& crop, const std::string& name)
{
    const cv::Mat pixels = enlarged(picture, crop);
    return cv::format("<div><img width=\"%d\" height=\"%d\" alt=\"", pixels.cols, pixels.rows) +
           escaped("The place in the picture by " + name) + "\" src=\"" + jpegUri(pixels, TILE_KILOBYTES).text +
           "\"><span>" + escaped(name) + "</span></div>\n";
}

std::string figure(const Page& page, const cv::Rect& crop, const std::string& caption)
{
    return "<figure class=\"close-up\">\n<div class=\"tiles\">" +
           (page.before.image.empty() ? std::string() : tile(page.before, crop, page.before_name)) +
           tile(page.after, crop, page.method) + "</div><figcaption>" + caption + "</figcaption>\n</figure>\n";
}

} // namespace

std::string closeUps(const Page& page)
{
    std::string html;
    cv::Rect taken;
    for (const bool before : {true, false})
    {
        const Picture& picture = before ? page.before : page.after;
        if (picture.image.empty() || picture.labels.of.empty())
            continue;
        const evaluation::SeamVisibility seams = evaluation::seamVisibility(picture.images, picture.labels);
        if (!(seams.worst > 0))
            continue;
        const cv::Rect crop = around(seams.strongest_place, page.frame);
        if (2 * (crop & taken).area() > crop.area())
            continue; // the same place
        taken = crop;
        html +=
            figure(page, crop, "The worst place of the cut of: " + escaped(before ? page.before_name : page.method));
    }
    return html.empty() ? html : "<div class=\"close-ups\">\n" + html + "</div>\n";
}

} // namespace report
