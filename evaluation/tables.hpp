// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_TABLES_HPP
#define GCPW_EVALUATION_TABLES_HPP

#include <string>
#include <vector>
#include "evaluation/methods.hpp"
#include "evaluation/results.hpp"

namespace evaluation
{

/** @brief A Markdown page of both experiments.

Pairs by methods for zncc and ncc, each the median over the inputs (in bold the least of a row and those of which it is not
ahead, see isAhead(); means below), GCPW's place on each pair, the spread of zncc over the inputs, the appearance of each
method in the mean and of the last one on each pair, folds and time of each method, and mean zncc by degree. Where the median is
of a run that is missing or failed there is a dash, and the pair does not enter the means of any method, so that all means of a
measure are of the same pairs.
@param methods the columns, in this order
@param inputs the first so many inputs of each pair, 1 to INPUTS; rows of others are left out
@throws cv::Exception if there are no such inputs */
std::string markdownPage(const RunTable& rows, const std::vector<const PairMethod*>& methods, int inputs);

} // namespace evaluation

#endif
