// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_FEATURES_HEADER_HPP
#define OPENCV_GCPW_FEATURES_HEADER_HPP

// OpenCV 5 calls the module features, and refuses the old header inside its own build.
#include <opencv2/core/version.hpp>
#if CV_VERSION_MAJOR >= 5
#include <opencv2/features.hpp>
#else
#include <opencv2/features2d.hpp>
#endif

#endif
