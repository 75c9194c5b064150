// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "evaluation/pair_folder.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

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
    std::sort(found.begin(), found.end(), [](const fs::path& a, const fs::path& b) { return a.filename() < b.filename(); });
    return found;
}

std::vector<PairFiles> findPairs(const std::string& folder)
{
    std::vector<PairFiles> pairs;
    for (const fs::path& path : subfolders(folder))
    {
        PairFiles pair;
        pair.name = path.filename().string();
        pair.source = fileOfStem(path, "01");
        pair.target = fileOfStem(path, "02");
        if (pair.source.empty() || pair.target.empty())
            CV_Error(cv::Error::StsObjectNotFound,
                     path.string() + " holds no pair; it needs photographs 01.* (source) and 02.* (target)");
        if (pair.name.find_first_of(",\n\r|") != std::string::npos)
            CV_Error(cv::Error::StsBadArg, "the name of the pair " + path.string() + " must not hold , or |");
        pairs.push_back(pair);
    }
    if (pairs.empty())
        CV_Error(cv::Error::StsObjectNotFound, folder + " holds no pairs; it needs a folder a pair, each with 01.* and 02.*");
    return pairs;
}

cv::Mat readCapped(const std::string& path, double megapix)
{
    CV_CheckGT(megapix, 0.0, "photographs are scaled down to more than 0 million pixels");
    const cv::Mat image = cv::imread(path, cv::IMREAD_COLOR);
    if (image.empty())
        CV_Error(cv::Error::StsObjectNotFound, path + " is not an image that OpenCV can read");
    const double scale = std::sqrt(megapix * 1e6 / static_cast<double>(image.total()));
    if (scale >= 1)
        return image;
    cv::Mat small;
    cv::resize(image, small, cv::Size(std::max(cvRound(image.cols * scale), 1), std::max(cvRound(image.rows * scale), 1)), 0, 0,
               cv::INTER_AREA);
    return small;
}

void makeFolder(const std::string& path)
{
    std::error_code error;
    fs::create_directories(path, error);
    if (!fs::is_directory(path))
        CV_Error(cv::Error::StsError, "cannot make the folder " + path);
}

} // namespace evaluation
