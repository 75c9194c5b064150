// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_CORRELATION_HPP
#define OPENCV_GCPW_CORRELATION_HPP

#include <vector>
#include "energy/photometric_term.hpp"

namespace cv
{
namespace gcpw
{

/** @brief The quads in which one mesh lines its image up worse than another does.

Judged by plain correlation of the two images around each quad, which neither a colour model nor a squeezed mesh can
flatter: what moves or changes between the photographs priors the photometric term to wrong places, and here it shows.
@param term tells how each mesh correlates
@param images the present state  @param other the same images with the meshes to compare with
@param ratio how much worse counts, >= 1 */
std::vector<int> worseQuads(const PhotometricTerm& term, const std::vector<ImageState>& images,
                            const std::vector<ImageState>& other, double ratio);

} // namespace gcpw
} // namespace cv

#endif
