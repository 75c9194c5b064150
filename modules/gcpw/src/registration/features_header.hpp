// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
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
