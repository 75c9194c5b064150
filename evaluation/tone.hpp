// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_TONE_HPP
#define GCPW_EVALUATION_TONE_HPP

#include "evaluation/warped_image.hpp"

namespace evaluation
{

/// What the colour correction does to the photographs themselves; all 0 where it does nothing.
struct Tone
{
    cv::Vec3d cast;     ///< mean change of Y, Cr and Cb over all images, gray levels: what the whole picture gains in light and tint
    double local = 0;   ///< largest mean change of Cr or Cb of a block of 64 x 64 px against that of its image: a tint of a part
    double crushed = 0; ///< per cent of the pixels that became darker than 24 in all channels
    double blown = 0;   ///< per cent of the pixels that became brighter than 250 in all channels

    /// Of the three, the largest without its sign.
    double largestCast() const { return cv::norm(cast, cv::NORM_INF); }
};

/// Over all images that are not fixed; 0 if there are none.
Tone toneOf(const std::vector<WarpedImage>& images);

} // namespace evaluation

#endif
