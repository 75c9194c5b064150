// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_SHARED_LIGHT_HPP
#define OPENCV_GCPW_SHARED_LIGHT_HPP

#include "opencv2/gcpw/pair.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Corrects the colours of both photographs of a canvas, so that they agree and together keep the light of both.

The colours of an alignment give the source the light of the target. Between both views neither is the reference: the colours are
those of a panorama without one, found anew with the photographs where they stand (estimateColors()).
@param canvas its pictures and masks are read; source_corrected and target_corrected are set */
void shareLight(PairCanvas& canvas);

} // namespace gcpw
} // namespace cv

#endif
