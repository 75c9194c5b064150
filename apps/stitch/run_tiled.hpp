// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_RUN_TILED_HPP
#define GCPW_APPS_STITCH_RUN_TILED_HPP

#include "common/console.hpp"
#include "stitch/job.hpp"

/// Whether a job is done without holding photographs and picture in memory, as --tiled and the output say.
bool isTiled(const StitchJob& job);

/** @brief Does a job so: the same picture, bit for bit, into a tiled TIFF file or a Deep Zoom pyramid.

Photographs are read one after the other for the estimation, and once more to be warped. Warped, they lie on disk, from where each tile
of the picture takes what it needs. Returns the exit code. */
int runTiled(const StitchJob& job, const Console& console);

#endif
