// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "perf_precomp.hpp"

CV_PERF_TEST_MAIN(gcpw)
