// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_CROP_HPP
#define GCPW_APPS_CROP_HPP

#include <vector>
#include <opencv2/core.hpp>

/// largestRectangle() of a picture that comes in strips of rows, from top to bottom.
class RectangleSearch
{
public:
    /// @param width of the picture, px
    explicit RectangleSearch(int width);

    /// The next rows. @param shown CV_8UC1 of that width, not 0 where the picture has pixels
    void add(const cv::Mat& shown);

    cv::Rect best() const { return best_; }

private:
    std::vector<int> heights_; ///< of the pixels shown without a gap above the present row; the last one stays 0
    int rows_ = 0;             ///< so far
    cv::Rect best_;
};

/** @brief The largest upright rectangle, by area, that holds pixels of a picture only.
@param shown CV_8UC1, not 0 where the picture has pixels
@return the topmost, then leftmost of equal ones; empty if nothing is shown */
cv::Rect largestRectangle(const cv::Mat& shown);

#endif
