// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_MODEL_FILE_HPP
#define OPENCV_GCPW_MODEL_FILE_HPP

#include <functional>
#include <string>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/** @brief Writes a file as a whole or not at all: under another name beside it, which then takes its place.

A device or a pipe is written to directly. The ending of the name says which format: .yml, .xml or .json, with .gz compressed.
@param kind what the file says it is  @param write into the open root
@throws cv::Exception StsError that names the file if not every byte could be written; what was there before is untouched */
void writeFile(const std::string& path, const std::string& kind, const std::function<void(FileStorage&)>& write);

/// A file to read from. @throws cv::Exception StsError if there is none, StsParseError if it is not one of `kind`
FileStorage openForReading(const std::string& path, const std::string& kind);

/// Opens a file and runs read(root); names the file in what read() throws.
template <typename Read>
auto readFile(const std::string& path, const std::string& kind, Read read) -> decltype(read(FileNode()))
{
    const FileStorage file = openForReading(path, kind);
    try
    {
        return read(file.root());
    }
    catch (const cv::Exception& e)
    {
        CV_Error(Error::StsParseError, "gcpw: " + path + " is damaged: " + e.err);
    }
}

/** @brief A matrix of a file, refused by its header before anything is allocated.
@param rows, cols most that it may have  @param elements allowed kinds, as cv::FileStorage spells them ("2d" is CV_64FC2) */
Mat readMatrix(const FileNode& node, const char* name, int rows, int cols, const std::vector<std::string>& elements);

} // namespace gcpw
} // namespace cv

#endif
