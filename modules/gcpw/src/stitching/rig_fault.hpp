// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_RIG_FAULT_HPP
#define OPENCV_GCPW_RIG_FAULT_HPP

#include <string>
#include "opencv2/gcpw/rig.hpp"

namespace cv
{
namespace gcpw
{

/// Why a rig cannot be rendered though it says that it is refined; without a message for nothing.
struct RigFault
{
    int code = 0; ///< of the cv::Exception that Rig::check() throws
    std::string message;
};

/// The first fault of those that Rig::check() lists.
RigFault findFault(const Rig& rig);

} // namespace gcpw
} // namespace cv

#endif
