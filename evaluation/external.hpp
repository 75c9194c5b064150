// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_EXTERNAL_HPP
#define GCPW_EVALUATION_EXTERNAL_HPP

#include <opencv2/gcpw/pair.hpp>
#include "evaluation/methods.hpp"

namespace evaluation
{

/// What another program made of a pair; the first that there is of an alignment, a canvas and a picture.
struct ExternalResult
{
    cv::gcpw::Alignment alignment; ///< of warp.csv; else without images
    cv::gcpw::PairCanvas canvas;   ///< of the alignment, or of warped images
    cv::Mat panorama;              ///< CV_8UC3, of a picture alone: it is shown, and nothing of it can be measured
};

/** @brief The method of an option "NAME:FOLDER".
@throws cv::Exception StsBadArg if it is not of that form, the name is taken or cannot stand in a table, or there is no folder */
PairMethod externalMethod(const std::string& option);

/** @brief Reads what another program left for an input of a pair, in FOLDER/PAIR/INPUT, or for input 1 in FOLDER/PAIR.

- `warp.csv`: a grid of points, a line `x,y,u,v` each in any order: pixel (x, y) of the source lies at pixel (u, v) of the target.
  x and y take the same values in every row and column, 2 to 257 of them; beyond the grid the warp goes on as at its border.
- or `source.png` and `target.png`, both warped onto a canvas of one size, as gcpw_pair --dump writes them. What they cover is
  their alpha, or `source_mask.png` and `target_mask.png`.
- or `panorama.png` or `panorama.jpg`.

@param method of externalMethod()
@param source, target the input, CV_8UC3  @param target_from_source the rough homography, against which a warp bends
@throws cv::Exception that names the file if there is none, or it is not as described */
ExternalResult readExternal(const PairMethod& method, const std::string& pair, int input, const cv::Mat& source,
                            const cv::Mat& target, const cv::Matx33d& target_from_source);

/** @brief A grid of points as an alignment.
@param rows x, y, u, v each
@throws cv::Exception StsParseError if they are no grid, or not finite */
cv::gcpw::Alignment alignmentOf(const std::vector<cv::Vec4d>& rows, cv::Size source, cv::Size target,
                                const cv::Matx33d& target_from_source);

} // namespace evaluation

#endif
