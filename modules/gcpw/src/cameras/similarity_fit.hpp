// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_SIMILARITY_FIT_HPP
#define OPENCV_GCPW_SIMILARITY_FIT_HPP

#include <vector>
#include "cameras/linked_images.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Lays flat photographs (scans, a facade, the ground from the air) on a plane, each turned, scaled and shifted.

    sum over links and matches of rho(|S_a p_a - S_b p_b|), S p = (x s - y t + u, x t + y s + v),

a linear problem at fixed weights: nothing can run away. Weights are those of log(1 + d^2 / s^2), and undo that a smaller picture has
smaller errors. The most linked image is upright; the scales are 1 in the geometric mean.
@param sizes of the images, px  @param links that connect all of them
@param canvas_from_image one a image
@return false if the links do not connect them */
bool fitSimilarities(const std::vector<Size>& sizes, const std::vector<Link>& links,
                     std::vector<Matx33d>& canvas_from_image);

} // namespace gcpw
} // namespace cv

#endif
