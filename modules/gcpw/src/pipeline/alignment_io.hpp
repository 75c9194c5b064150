// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_ALIGNMENT_IO_HPP
#define OPENCV_GCPW_ALIGNMENT_IO_HPP

#include <string>
#include "opencv2/gcpw/alignment.hpp"

namespace cv
{
namespace gcpw
{

/// A file to write to. @throws cv::Exception StsError that names it
FileStorage openForWriting(const std::string& path);

/// A file to read from. @throws cv::Exception StsError if there is none, StsParseError if it is not one of `kind`
FileStorage openForReading(const std::string& path, const std::string& kind);

/// Into the open map of a file, and back. Reading throws cv::Exception if a part is missing or has a wrong type or size.
void writeAlignment(FileStorage& file, const Alignment& alignment);
Alignment readAlignment(const FileNode& node);

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

} // namespace gcpw
} // namespace cv

#endif
