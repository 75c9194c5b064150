// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_COLOR_SMOOTHNESS_TERM_HPP
#define OPENCV_GCPW_COLOR_SMOOTHNESS_TERM_HPP

#include "solver/color_system.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Keeps the colour maps of neighbouring quads alike on all intensities (eq. colorterm).

    E_c = weight * sum_i sum_{j in N8(i)} sum_{x = 0, 0.1 .. 1} ((g_i x + b_i) - (g_j x + b_j))^2

The sum over x is the quadratic form of [sum x^2, sum x; sum x, n] in (g_i - g_j, b_i - b_j), the same for every pair. */
void addColorSmoothness(int image, const Lattice& lattice, double weight, ColorSystem& system);

} // namespace gcpw
} // namespace cv

#endif
