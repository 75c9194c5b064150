// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_PRECOMP_HPP
#define OPENCV_GCPW_TEST_PRECOMP_HPP

// Inside OpenCV's build this is its ts module, elsewhere a shim over GoogleTest: the tests do not notice.
#include <opencv2/ts.hpp>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
// boundingRect(), part of imgproc before OpenCV 5.
#if CV_VERSION_MAJOR >= 5
#include <opencv2/geometry.hpp>
#endif

#include <opencv2/gcpw.hpp>

// The GoogleTest inside OpenCV 4.x knows only the older name.
#ifndef INSTANTIATE_TEST_SUITE_P
#define INSTANTIATE_TEST_SUITE_P INSTANTIATE_TEST_CASE_P
#endif

#endif
