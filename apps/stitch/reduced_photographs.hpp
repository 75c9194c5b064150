// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_REDUCED_PHOTOGRAPHS_HPP
#define GCPW_APPS_STITCH_REDUCED_PHOTOGRAPHS_HPP

#include <vector>
#include "stitch/compose.hpp"

/// What estimation and cuts need of photographs that need not fit into memory together.
struct ReducedPhotographs
{
    std::vector<Photograph> photographs; ///< their images reduced as the estimation would reduce them
    std::vector<SeamCopy> seam_copies;   ///< of each
    double seam_scale = 1;               ///< pixels of such a copy per pixel of a photograph
    bool deep = false;                   ///< one of them has 16 bits
};

/// Reads photographs one after the other, and keeps of each what is said above. As readAll().
ReducedPhotographs readReduced(const StitchJob& job, const Console& console, ProgressLine& progress);

#endif
