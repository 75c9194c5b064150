// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_GZIP_HPP
#define OPENCV_GCPW_GZIP_HPP

#include <istream>
#include <string>

namespace cv
{
namespace gcpw
{

/** @brief Unpacks a gzip file (RFC 1952) of one member into memory.

cv::FileStorage unpacks such files by itself while it parses them. This is for looking at the text before, without a further
library; it accepts no file that zlib, which OpenCV uses, would refuse.
@param packed from its first byte to its end
@param most bytes of text that are unpacked, so that a small file cannot fill the memory
@throws cv::Exception StsParseError that says what is wrong: cut short, damaged, more than `most` bytes, something behind the
end */
std::string gunzip(std::istream& packed, size_t most);

} // namespace gcpw
} // namespace cv

#endif
