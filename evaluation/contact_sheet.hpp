// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_CONTACT_SHEET_HPP
#define GCPW_EVALUATION_CONTACT_SHEET_HPP

#include "evaluation/experiment.hpp"

namespace evaluation
{

/** @brief A picture that compares the methods on one pair, as the paper's figures do.

One row a method: its name and zncc, its panorama (plain mean in the overlap), and the same three patches of the target's
frame for all of them, enlarged and framed in the panorama. The patches are those with the largest ncc, which looks at
strong edges first, in the mean over all methods, so that none of them has chosen.
@param rows results of the experiment; alignments are read from experiment.folder
@return CV_8UC3; empty if no method of the experiment has an alignment of the pair
@throws cv::Exception if photographs or alignments cannot be read */
cv::Mat contactSheet(const Experiment& experiment, const PairFiles& pair, const RunTable& rows);

/** @brief The patches of an overlap in which the canvases line up worst.
@param canvases of one pair, by any methods
@param target_size of the frame that all canvases share
@param side of a patch, px
@param count at most so many, the worst first; they do not overlap
@return rectangles in target pixels; none where no texture overlaps */
std::vector<cv::Rect> worstPatches(const std::vector<cv::gcpw::PairCanvas>& canvases, cv::Size target_size, int side, int count);

} // namespace evaluation

#endif
