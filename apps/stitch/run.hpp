// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_RUN_HPP
#define GCPW_APPS_STITCH_RUN_HPP

#include "stitch/job.hpp"

/// Does what gcpw_stitch is asked to do. Returns the exit code.
int runStitch(const StitchJob& job, const Console& console);

#endif
