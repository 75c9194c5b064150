// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_TILE_ROWS_HPP
#define GCPW_APPS_TILE_ROWS_HPP

#include <string>
#include <opencv2/core.hpp>

/// A range of a picture's rows of tiles, as --tiles names it: "A-B", from 1 on, or "K/N", the K-th of N ranges of nearly one height.
class TileRows
{
public:
    /// @throws WrongUse if the text is neither
    explicit TileRows(const std::string& text);

    /** @brief Which of a picture's rows of tiles, 0-based.
    @param count rows of tiles of the picture  @return not empty; what lies beyond the last is left away
    @throws WrongUse if none is left */
    cv::Range in(int count) const;

private:
    std::string text_;
    int first_ = 0;
    int second_ = 0;
    bool is_share_ = false;
};

#endif
