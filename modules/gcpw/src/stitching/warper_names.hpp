// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_WARPER_NAMES_HPP
#define OPENCV_GCPW_WARPER_NAMES_HPP

#include <opencv2/stitching/warpers.hpp>

namespace cv
{
namespace gcpw
{

/// The creator behind a name of cv::PyRotationWarper. @throws cv::Exception StsBadArg that lists the names, for any other
Ptr<WarperCreator> warperOfName(const String& name);

} // namespace gcpw
} // namespace cv

#endif
