// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
// The binding generator's names of types that our headers have to write in full.
#include <vector>
#include <opencv2/stitching/detail/camera.hpp>

typedef std::vector<cv::detail::CameraParams> vector_detail_CameraParams;
