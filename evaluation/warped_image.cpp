// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/warped_image.hpp"

#include <cstdio>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

namespace evaluation
{

namespace
{

cv::Mat readPart(const std::string& path, int flags, cv::Size size)
{
    const cv::Mat image = cv::imread(path, flags);
    if (image.empty() || (!size.empty() && image.size() != size))
        CV_Error(cv::Error::StsUnmatchedSizes, path + " is missing or does not fit its image");
    return image;
}

} // namespace

cv::Rect canvasOf(const std::vector<WarpedImage>& images)
{
    cv::Rect canvas = images.at(0).place;
    for (const WarpedImage& image : images)
        canvas |= image.place;
    return canvas;
}

std::vector<WarpedImage> readDump(const std::string& folder)
{
    std::ifstream corners(folder + "/corners.csv");
    if (!corners)
        CV_Error(cv::Error::StsObjectNotFound, "there is no " + folder + "/corners.csv");
    std::vector<WarpedImage> dump;
    for (std::string line; std::getline(corners, line);)
    {
        char number[32];
        WarpedImage item;
        if (std::sscanf(line.c_str(), "%31[^,],%d,%d", number, &item.place.x, &item.place.y) != 3)
            CV_Error(cv::Error::StsParseError, folder + "/corners.csv: '" + line + "' is not k,x,y");
        const std::string stem = folder + "/" + number;
        item.image = readPart(stem + "_image.png", cv::IMREAD_COLOR, cv::Size());
        item.corrected = readPart(stem + "_corrected.png", cv::IMREAD_COLOR, item.image.size());
        item.mask = readPart(stem + "_mask.png", cv::IMREAD_GRAYSCALE, item.image.size()) > 127;
        item.place = cv::Rect(item.place.tl(), item.image.size());
        dump.push_back(item);
    }
    return dump;
}

std::vector<WarpedImage> imagesOf(const cv::gcpw::PairCanvas& canvas)
{
    WarpedImage source;
    source.place = cv::Rect(cv::Point(), canvas.source.size());
    WarpedImage target = source;
    source.image = canvas.source;
    source.corrected = canvas.source_corrected;
    source.mask = canvas.source_mask;
    target.image = target.corrected = canvas.target;
    target.mask = canvas.target_mask;
    target.fixed = true;
    return {source, target};
}

} // namespace evaluation
