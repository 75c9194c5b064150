// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_REPORT_PICTURE_HPP
#define GCPW_APPS_REPORT_PICTURE_HPP

#include <string>
#include <vector>
#include "evaluation/bend.hpp"
#include "evaluation/cut.hpp"

namespace report
{

typedef std::vector<cv::Point2d> Path;

/// A straight segment of a photograph, where a picture shows it.
struct Line
{
    Path path;
    bool bent = false; ///< by more than evaluation::VISIBLE_BEND
};

/// A picture and how it is composed, in pixels of a canvas that all pictures of a page share.
struct Picture
{
    cv::Mat image;                               ///< CV_8UC3
    cv::Mat whole;                               ///< the same in all pixels that it was made with; may be empty
    cv::Point origin;                            ///< canvas pixel of the top-left pixel of `image`
    std::vector<evaluation::WarpedImage> images; ///< the photographs as they lie on the canvas
    evaluation::Labels labels;                   ///< which of `images` is seen where; empty if they are averaged
    std::vector<std::vector<Path>> meshes;       ///< lines of the mesh of each image that has one
    std::vector<Line> lines;

    cv::Rect place() const { return cv::Rect(origin, image.size()); }
};

/// Colour around photographs, BGR: neither they nor the page, light or dark, look like it.
const cv::Scalar BACKDROP(38, 34, 32);

/// Pixels of a page per pixel of a picture: enough to look at, few enough for a page that is sent by mail.
double pageScale(cv::Size picture);

/// Rows and columns of a mesh's vertices.
/// @param grid CV_64FC2
std::vector<Path> gridLines(const cv::Mat& grid);

/// Turns a picture with all its parts to the right, so many times by 90 degrees.
void turnRight(Picture& picture, int times);

/// What `frame`, a rectangle of the canvas, shows of an image at a place; BACKDROP beside it.
cv::Mat framed(const cv::Mat& image, cv::Point origin, const cv::Rect& frame);

/// Canvas pixels of `frame` that some photograph covers, CV_8UC1: 255 or 0.
cv::Mat covered(const std::vector<evaluation::WarpedImage>& images, const cv::Rect& frame);

/// Paints `picture`, which shows `frame`, as BACKDROP where no photograph is.
void clearBeside(const std::vector<evaluation::WarpedImage>& images, const cv::Rect& frame, cv::Mat& picture);

/// The plain mean of the photographs in the colours that are shown, CV_8UC3 as large as `frame`: what does not line up is double.
cv::Mat meanOf(const std::vector<evaluation::WarpedImage>& images, const cv::Rect& frame);

} // namespace report

#endif
