// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_REPORT_HTML_HPP
#define GCPW_APPS_REPORT_HTML_HPP

#include <map>
#include <string>
#include <vector>
#include <opencv2/core.hpp>

namespace report
{

/// Text as it stands between tags or in quotation marks; bytes that are no UTF-8 become question marks.
std::string escaped(const std::string& text);

/// A number by printf's format, or a dash where there is none.
std::string numberOrDash(double value, const char* form);

/// A change in tenths: "+1.5", "-2.0", and "0.0" for what is less than half a tenth.
std::string change(double value);

/** @brief Replaces each {{name}} of a template by its value; values are not looked through.
@throws cv::Exception that names what has no value, or the value that no place asks for */
std::string filled(const std::string& page, const std::map<std::string, std::string>& values);

/// An image that is part of the page.
struct DataUri
{
    std::string text; ///< data:image/jpeg;base64,..
    int quality = 0;  ///< of JPEG, 0..100
};

/** @brief A picture as JPEG in a data URI.
@param picture CV_8UC3  @param kilobytes it is compressed until the JPEG file has no more, or its quality is 40 */
DataUri jpegUri(const cv::Mat& picture, int kilobytes);

/// @param bytes any  @return of RFC 4648, with padding
std::string base64(const std::vector<uchar>& bytes);

/// A table of a page; cells are HTML.
struct Table
{
    std::vector<std::string> heads;
    std::vector<std::string> classes; ///< of each column: "number" is set flush right
    std::vector<std::vector<std::string>> rows;

    std::string html() const;
};

} // namespace report

#endif
