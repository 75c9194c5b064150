// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef GCPW_EVALUATION_TABLES_HPP
#define GCPW_EVALUATION_TABLES_HPP

#include <string>
#include <vector>
#include "evaluation/methods.hpp"
#include "evaluation/results.hpp"

namespace evaluation
{

/** @brief A Markdown page of both experiments.

Pairs by methods for zncc and ncc (the best of a row in bold, means below), GCPW's place on each pair, folds and time of
each method, and mean zncc by degree. A run that is missing or failed is a dash, and its pair does not enter the means of
any method, so that all means are of the same pairs.
@param methods the columns, in this order */
std::string markdownPage(const RunTable& rows, const std::vector<const PairMethod*>& methods);

} // namespace evaluation

#endif
