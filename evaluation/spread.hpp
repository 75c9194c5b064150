// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_SPREAD_HPP
#define GCPW_EVALUATION_SPREAD_HPP

#include <vector>

namespace evaluation
{

/// Scores of one method on the inputs of a pair, in the order of the inputs; a run without a score is NaN and counts as the
/// worst there can be. Lower is better.
typedef std::vector<double> Scores;

/// The middle one, of an even number the mean of the two in the middle; NaN if there are none or it is no score.
double median(const Scores& scores);

/// Largest over smallest; NaN if there are none or one is no score or not above 0.
double spread(const Scores& scores);

/** @brief Whether a method is ahead of another: its score is the lower one on every input.

Then the difference is larger than what an input's pixels change in it; all other differences are counted as none. The two
are compared input by input because an input that is easier is so for both.
@param a, b as many inputs each */
bool isAhead(const Scores& a, const Scores& b);

/// The value below which so many per cent of the values lie, linear between two of them; 0 if there are none.
double percentile(std::vector<double> values, double percent);

} // namespace evaluation

#endif
