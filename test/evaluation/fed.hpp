// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_TEST_FED_HPP
#define GCPW_TEST_FED_HPP

#include <vector>
#include <opencv2/core.hpp>

/// What a blender is fed with.
struct Fed
{
    cv::Mat image;
    cv::Mat mask;
    cv::Point corner;
};

inline cv::Rect canvasOf(const std::vector<Fed>& fed)
{
    cv::Rect canvas;
    for (const Fed& one : fed)
        canvas |= cv::Rect(one.corner, one.image.size());
    return canvas;
}

#endif
