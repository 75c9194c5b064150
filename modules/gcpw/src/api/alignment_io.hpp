// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_ALIGNMENT_IO_HPP
#define OPENCV_GCPW_ALIGNMENT_IO_HPP

#include "opencv2/gcpw/alignment.hpp"

namespace cv
{
namespace gcpw
{

/// Writes into the open map of a file, and reads from it. Reading throws cv::Exception if a part is missing or has a wrong type
/// or size.
void writeAlignment(FileStorage& file, const Alignment& alignment);
Alignment readAlignment(const FileNode& node);

} // namespace gcpw
} // namespace cv

#endif
