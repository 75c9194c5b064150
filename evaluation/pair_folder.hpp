// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_PAIR_FOLDER_HPP
#define GCPW_EVALUATION_PAIR_FOLDER_HPP

#include <filesystem>
#include <string>
#include <vector>

namespace evaluation
{

/// Two photographs to be aligned.
struct PairFiles
{
    std::string name;   ///< of the folder that holds them
    std::string source; ///< path of 01.*
    std::string target; ///< path of 02.*
};

/// The folders in a folder, sorted by name. Throws cv::Exception that names the folder if there is none, or one whose name
/// cannot stand in a table.
std::vector<std::filesystem::path> subfolders(const std::string& folder);

/** @brief The pairs of a folder: one folder for each pair, with a photograph 01.* (source) and one 02.* (target).
@param complaints a sentence for each folder in which a photograph is missing: it is left out
@return sorted by name
@throws cv::Exception that names the folder if there is none, or it holds no pair */
std::vector<PairFiles> findPairs(const std::string& folder, std::vector<std::string>& complaints);

/** @brief Makes a folder and its parents. @throws cv::Exception that names it */
void makeFolder(const std::string& path);

} // namespace evaluation

#endif
