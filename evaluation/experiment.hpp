// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_EXPERIMENT_HPP
#define GCPW_EVALUATION_EXPERIMENT_HPP

#include <functional>
#include "evaluation/input_jitter.hpp"
#include "evaluation/methods.hpp"
#include "evaluation/pair_folder.hpp"
#include "evaluation/results.hpp"

namespace evaluation
{

/// Both experiments of the paper: degree 0 is the comparison on the photographs as they are, the others recolour the source.
struct Experiment
{
    std::vector<PairFiles> pairs;
    std::vector<const PairMethod*> methods;
    std::vector<int> degrees; ///< of colour variation, see varyColors(); methods that do not look at pixels run at 0 only
    int inputs = INPUTS;      ///< how many of the inputs of each pair, 1 to INPUTS, see jitteredInput()
    double max_megapix = 0.48;
    cv::gcpw::Params params;
    int workers = 1;    ///< threads, each with inputs of its own; results do not depend on it
    std::string folder; ///< alignments of degree 0 of input 1 are kept in folder/alignments
};

/// Called after each run, by one thread at a time.
typedef std::function<void(int done, int total)> RunCallback;

/** @brief Makes the runs of an experiment that the results do not have yet.

The matches of an input are found once, on the photographs as they are, and serve all its runs. Methods see the source
recoloured; what is rendered and scored is the source as it is. Call cv::setNumThreads(1) before, or workers disturb each
other. A run that throws is a row with status "failed". A pair whose photographs cannot be read or matched
gets no rows, so that it is tried again once it is mended. Neither keeps the others from being run. Results of other programs are
read anew each time.
@return messages of the runs and pairs that failed
@throws cv::Exception if results cannot be written, workers are fewer than 1, or there are no such inputs */
std::vector<std::string> run(const Experiment& experiment, ResultsFile& results, const RunCallback& progress);

/// Where the alignment of a run at degree 0 of input 1 is kept.
std::string alignmentPath(const std::string& folder, const std::string& pair, const std::string& method);

} // namespace evaluation

#endif
