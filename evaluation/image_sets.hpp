// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_IMAGE_SETS_HPP
#define GCPW_EVALUATION_IMAGE_SETS_HPP

#include <functional>
#include <string>
#include <vector>
#include <opencv2/core.hpp>
#include "evaluation/methods.hpp"
#include "evaluation/row_file.hpp"

namespace evaluation
{

/// Photographs of one panorama.
struct ImageSet
{
    std::string name; ///< of the folder that holds them
    std::vector<std::string> images;
};

/** @brief The sets of a folder: one folder for each, with two images or more.
@return sorted by name, as are the images
@throws cv::Exception that names the folder if there is none, or it holds no set */
std::vector<ImageSet> findSets(const std::string& folder);

/// How well the images of a panorama line up, over all pairs that overlap in 2000 px or more, weighted by that area.
struct SetScore
{
    int images = 0;
    int pairs = 0;
    double ncc = 0; ///< of the warped images, see cv::gcpw::Score; NaN without pairs
    double zncc = 0;
    double color_difference = 0; ///< mean of |a - b| of the corrected images over pixels and channels, gray levels
};

/** @brief Scores what gcpw_stitch --dump has written.
@param folder holds corners.csv with lines `k,x,y` (top-left pixel on the canvas), and for each k: k_image.png (warped,
colours untouched), k_corrected.png (the same with its colours corrected) and k_mask.png
@throws cv::Exception that names the file if one is missing or does not fit */
SetScore scoreDump(const std::string& folder);

/** @brief Stitches sets with OpenCV alone and with GCPW, and scores both.
@param externals methods of externalMethod(): of each set in FOLDER/SET what gcpw_stitch --dump would have written is scored; of
a panorama.png or panorama.jpg alone nothing can be measured
@param program path of gcpw_stitch  @param arguments further options for both
@param folder for sets.csv, and for panoramas and dumps in folder/sets; sets that sets.csv has already are left out
@param progress called before each run
@param complaints a sentence for each run that failed; it has no row and does not stop the others
@return Markdown table of all rows
@throws cv::Exception if the table cannot be written */
std::string stitchSets(const std::vector<ImageSet>& sets, const std::vector<PairMethod>& externals,
                       const std::string& program, const std::vector<std::string>& arguments, const std::string& folder,
                       bool fresh,
                       const std::function<void(const std::string& set, const std::string& method)>& progress,
                       std::vector<std::string>& complaints);

} // namespace evaluation

#endif
