// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
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
