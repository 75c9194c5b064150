// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_SHAPE_HPP
#define GCPW_EVALUATION_SHAPE_HPP

#include <opencv2/gcpw/alignment.hpp>

namespace evaluation
{

/// How meshes change shapes, beyond what their rough alignment does; all 0 where they only shift, turn or scale.
struct Shape
{
    double stretch = 0; ///< RMS over all quads of ln(s1 / s2), s1 >= s2 the singular values of mesh against rough
    double area = 0;    ///< RMS of ln(s1 s2) less its mean over the image
    double largest = 1; ///< s1 / s2
};

/// Of all images that move.
Shape shapeOf(const cv::gcpw::Alignment& alignment);

} // namespace evaluation

#endif
