// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_REPORT_PAGE_HPP
#define GCPW_APPS_REPORT_PAGE_HPP

#include <limits>
#include <string>
#include <vector>
#include <opencv2/gcpw/alignment.hpp>
#include "report/picture.hpp"

namespace report
{

/// One of the photographs that were given.
struct Photograph
{
    std::string path;
    cv::Mat image;  ///< CV_8UC3
    int shown = -1; ///< which of Picture::images it is; -1 for one that is not in the picture
};

/// What one stage of the work took.
struct Timing
{
    std::string stage;
    double ms = 0;
};

/// A score of both pictures; NaN where it was not measured.
struct Scores
{
    double before = std::numeric_limits<double>::quiet_NaN();
    double after = std::numeric_limits<double>::quiet_NaN();
};

/// All that a page shows.
struct Page
{
    std::string program;
    std::string method;      ///< as a reader says it: "GCPW"
    std::string before_name; ///< what `before` is: "cv::Stitcher"
    std::string status;      ///< one sentence: how it ended
    bool stitched = false;   ///< whether there is a picture
    std::vector<Photograph> photographs;
    Picture before; ///< to compare with; without an image there is none
    Picture after;
    cv::Rect frame;          ///< canvas pixels that are shown: see showWritten()
    cv::Size size;           ///< of the picture that was written, px
    Scores zncc;             ///< see cv::gcpw::Score
    evaluation::Bend bend;   ///< of the segments of images that move
    cv::gcpw::Report report; ///< its pairs count Picture::images
    std::vector<Timing> timings;
    std::vector<std::string> messages; ///< sentences, in order
};

/** @brief Sets what a page with pictures shows: what was written of the finished one, so that page and file agree. Cuts beside it count no
more.
@param crop the part that was written, px of Picture::whole; empty where all of it was: then both pictures are shown as a whole */
void showWritten(const cv::Rect& crop, Page& page);

/// The whole page, without a reference to any other file.
std::string htmlOf(const Page& page);

} // namespace report

#endif
