// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
// The binding generator's names of types that our headers have to write in full.
#include <vector>
#include <opencv2/stitching/detail/camera.hpp>

typedef std::vector<cv::detail::CameraParams> vector_detail_CameraParams;
