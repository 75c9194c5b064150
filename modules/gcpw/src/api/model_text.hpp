// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_MODEL_TEXT_HPP
#define OPENCV_GCPW_MODEL_TEXT_HPP

#include <istream>
#include <string>

namespace cv
{
namespace gcpw
{

/** @brief What is wrong with the text of a file that OpenCV's parsers would crash at; empty for nothing.

They call themselves for every bracket, tag and indentation, so that deep nesting overflows the stack, and they read beyond an
XML text that ends inside a tag. Brackets in strings may be counted although they nest nothing.
@param text YAML, JSON or XML, not compressed */
std::string textFault(std::istream& text);

} // namespace gcpw
} // namespace cv

#endif
