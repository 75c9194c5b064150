// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_METHODS_HPP
#define GCPW_EVALUATION_METHODS_HPP

#include <string>
#include <vector>
#include <opencv2/gcpw/pair.hpp>

namespace evaluation
{

/** @brief Aligns two photographs whose matches are known. All methods get the same matches, mesh and constants.
@param source, target 8-bit BGR  @param params Params::method is set by the method itself
@return as of cv::gcpw::alignPair; Timings::align holds all work after the matching, wall time as all Timings */
typedef cv::gcpw::Alignment (*AlignFunction)(const cv::Mat& source, const cv::Mat& target,
                                             const cv::gcpw::PairMatches& matches, const cv::gcpw::Params& params,
                                             const cv::gcpw::Progress& progress);

/// One system of the comparison.
struct PairMethod
{
    std::string name;     ///< as an option says it
    std::string label;    ///< as a table says it
    bool looks_at_pixels; ///< if not, recoloured photographs give the same warp
    AlignFunction align;
    std::string results =
        std::string(); ///< folder of what another program found, see readExternal(): then there is no function
};

/// Every system, from the simplest to GCPW: global, apap, cpw, dfw, mfw, lsh_mfw, ros_mfw, gcpw.
const std::vector<PairMethod>& pairMethods();

/// The method of a name; null if there is none.
const PairMethod* findPairMethod(const std::string& name);

/// Names of all methods, "global, apap, ..".
std::string pairMethodNames();

} // namespace evaluation

#endif
