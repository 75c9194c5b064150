// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_PICTURE_SINK_HPP
#define GCPW_APPS_PICTURE_SINK_HPP

#include <opencv2/core.hpp>

/// Where a picture goes that is made from top to bottom and never held as a whole.
class PictureSink
{
public:
    virtual ~PictureSink() = default;

    /// The next rows. @param rows BGR of 8 or 16 bits, as wide as the picture  @throws FileTrouble
    virtual void add(const cv::Mat& rows) = 0;

    /// After the last row: gives the output its name. Without it nothing is left. @throws FileTrouble
    virtual void finish() = 0;
};

#endif
