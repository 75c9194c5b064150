// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_PERF_PRECOMP_HPP
#define OPENCV_GCPW_PERF_PRECOMP_HPP

#include <opencv2/ts.hpp>

#include <opencv2/gcpw.hpp>

#endif
