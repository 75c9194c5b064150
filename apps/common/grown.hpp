// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_GROWN_HPP
#define GCPW_APPS_GROWN_HPP

#include <opencv2/core.hpp>

/// A rectangle with a margin all around, px.
inline cv::Rect grown(cv::Rect rect, int margin)
{
    return {rect.x - margin, rect.y - margin, rect.width + 2 * margin, rect.height + 2 * margin};
}

#endif
