// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/pair_folder.hpp"

#include <algorithm>
#include <opencv2/core.hpp>

namespace fs = std::filesystem;

namespace evaluation
{

namespace
{

/// The first file, by name, of this stem; empty if there is none.
std::string fileOfStem(const fs::path& folder, const std::string& stem)
{
    std::string found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().stem() == stem && (found.empty() || entry.path().string() < found))
            found = entry.path().string();
    return found;
}

} // namespace

std::vector<fs::path> subfolders(const std::string& folder)
{
    std::error_code error;
    if (!fs::is_directory(folder, error))
        CV_Error(cv::Error::StsObjectNotFound, "there is no folder " + folder);
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.is_directory())
            found.push_back(entry.path());
    for (const fs::path& path : found)
        if (path.filename().string().find_first_of(",\n\r|") != std::string::npos)
            CV_Error(cv::Error::StsBadArg, "the name of the folder " + path.string() + " must not hold , or | or a line end: tables name it");
    std::sort(found.begin(), found.end(), [](const fs::path& a, const fs::path& b) { return a.filename() < b.filename(); });
    return found;
}

std::vector<PairFiles> findPairs(const std::string& folder, std::vector<std::string>& complaints)
{
    std::vector<PairFiles> pairs;
    for (const fs::path& path : subfolders(folder))
    {
        PairFiles pair;
        pair.name = path.filename().string();
        pair.source = fileOfStem(path, "01");
        pair.target = fileOfStem(path, "02");
        if (pair.source.empty() || pair.target.empty())
            complaints.push_back(
                path.string() + " holds no pair and is left out; it needs photographs 01.* (source) and 02.* (target)");
        else
            pairs.push_back(pair);
    }
    if (pairs.empty())
        CV_Error(cv::Error::StsObjectNotFound, folder + " holds no pairs; it needs a folder a pair, each with 01.* and 02.*");
    return pairs;
}

void makeFolder(const std::string& path)
{
    std::error_code error;
    fs::create_directories(path, error);
    if (!fs::is_directory(path))
        CV_Error(cv::Error::StsError, "cannot make the folder " + path);
}

} // namespace evaluation
