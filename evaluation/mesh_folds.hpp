// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_EVALUATION_MESH_FOLDS_HPP
#define GCPW_EVALUATION_MESH_FOLDS_HPP

#include <opencv2/core.hpp>

namespace evaluation
{

/** @brief Quads of a mesh whose bilinear map is not one-to-one: a corner turned over, or a vertex that is not finite.
@param mesh (rows + 1) x (cols + 1), CV_64FC2, as cv::gcpw::Alignment::Image::mesh */
int countFoldedQuads(const cv::Mat& mesh);

} // namespace evaluation

#endif
