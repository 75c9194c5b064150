// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_PAIR_RUN_HPP
#define GCPW_APPS_PAIR_RUN_HPP

#include "pair/job.hpp"

/// Does what gcpw_pair is asked to do. Returns the exit code.
int runPair(const PairJob& job, const Console& console);

#endif
