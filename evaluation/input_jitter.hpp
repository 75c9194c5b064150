// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_INPUT_JITTER_HPP
#define GCPW_EVALUATION_INPUT_JITTER_HPP

#include <string>
#include <opencv2/core.hpp>

namespace evaluation
{

const int INPUTS = 5;      ///< how many inputs a photograph is brought to
const int INPUT_GIVEN = 1; ///< number of the first: the photograph as it is given

/** @brief One of the inputs that a photograph is brought to: they show the same and differ by less than anyone would see.

A pixel more or less can move an alignment from one local minimum to another, so that a score of one input is a draw. The
spread of the scores over these inputs says how much of a difference is chance.

| input | what it is |
|---|---|
| 1 | the photograph, scaled down (area average) to at most `megapix` million pixels, never up |
| 2 | input 1 without its outermost pixel on all four sides |
| 3 | scaled to one column more than input 1 |
| 4 | scaled to 47/48 of the pixels of input 1 |
| 5 | scaled to 46/48 of the pixels of input 1 |

Both photographs of a pair are brought to the same input.
@param photograph CV_8UC3, 3 x 3 px or more
@param input 1 to INPUTS
@return CV_8UC3; input 1 of a small photograph shares its pixels, input 2 those of input 1
@throws cv::Exception that names the value if the photograph is of another type or smaller, megapix is not above 0 or leaves
less than 3 x 3 px, or there is no such input */
cv::Mat jitteredInput(const cv::Mat& photograph, double megapix, int input);

/** @brief The same of an image file.
@throws cv::Exception that names the file if it cannot be read, or as above */
cv::Mat readInput(const std::string& path, double megapix, int input);

} // namespace evaluation

#endif
