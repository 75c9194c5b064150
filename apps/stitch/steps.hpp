// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_STEPS_HPP
#define GCPW_APPS_STITCH_STEPS_HPP

#include <string>
#include <vector>
#include "common/console.hpp"
#include "stitch/job.hpp"
#include "stitch/layout.hpp"
#include "stitch/match_log.hpp"

/// What a panorama in memory and one in tiles have in common.

/// @throws FileTrouble if a model is to be used and photographs that it was made of could not be read
void requireAllOfModel(const StitchJob& job, const std::vector<Photograph>& photographs);

/// Writes what matched what, if that is asked for.
void writeGraph(const StitchJob& job, const std::vector<Photograph>& photographs, const MatchLog& log);

void tellDecisions(const Layout& layout, const Console& console);

void tellDropped(const std::string& path, const Console& console);

#endif
