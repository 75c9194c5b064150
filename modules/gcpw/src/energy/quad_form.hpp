// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_QUAD_FORM_HPP
#define OPENCV_GCPW_QUAD_FORM_HPP

#include <array>
#include "solver/normal_equations.hpp"

namespace cv
{
namespace gcpw
{

typedef std::array<Point2d, 4> QuadPoints; ///< of the corners of a quad

/** @brief x^T block x of the corners' coordinates x, and half its slope.
@param block full, symmetric, and blind to a shift of the whole quad */
inline double quadForm(const QuadBlock& block, const QuadPoints& corners, QuadRow& gradient)
{
    QuadRow x{};
    // The first corner as origin keeps the numbers small.
    for (size_t k = 0; k < 4; ++k)
    {
        x[2 * k] = corners[k].x - corners[0].x;
        x[2 * k + 1] = corners[k].y - corners[0].y;
    }
    gradient = QuadRow{};
    double energy = 0;
    for (size_t i = 0; i < 8; ++i)
    {
        for (size_t j = 0; j < 8; ++j)
            gradient[i] += block[i][j] * x[j];
        energy += gradient[i] * x[i];
    }
    return energy;
}

} // namespace gcpw
} // namespace cv

#endif
