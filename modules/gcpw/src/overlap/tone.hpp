// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TONE_HPP
#define OPENCV_GCPW_TONE_HPP

#include <algorithm>

namespace cv
{
namespace gcpw
{

const double NEUTRAL = 0.5; ///< Cr and Cb of gray

/// How far the brightest and the darkest of B, G and R are from Y, >= 0; intensities in [0, 1].
struct ToneSpread
{
    double above;
    double below;
};

inline ToneSpread toneSpread(double cr, double cb)
{
    const double red = 1.403 * (cr - NEUTRAL);
    const double green = -0.714 * (cr - NEUTRAL) - 0.344 * (cb - NEUTRAL);
    const double blue = 1.773 * (cb - NEUTRAL);
    return {std::max(std::max(red, green), std::max(blue, 0.0)), std::max(std::max(-red, -green), std::max(-blue, 0.0))};
}

/// Whether the sensor may have met its limits: a channel of 250 or more, or none above 5 gray levels.
inline bool isClipped(const float* ycrcb)
{
    const double brightest = ycrcb[0] + toneSpread(ycrcb[1], ycrcb[2]).above;
    return brightest >= 250.0 / 255 || brightest <= 5.0 / 255;
}

} // namespace gcpw
} // namespace cv

#endif
