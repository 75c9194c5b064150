// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/two_photographs.hpp"

#include <opencv2/gcpw/pair.hpp>
#include "common/encode_picture.hpp"

using namespace cv::gcpw;

bool stitchTwo(const StitchJob& job, const std::vector<Photograph>& photographs, Layout& layout,
               Composition& composition)
{
    const cv::Mat source = toBytes(photographs[0].image);
    const cv::Mat target = toBytes(photographs[1].image);
    const Alignment alignment = alignPair(source, target, job.params);
    if (alignment.report().status == Status::NO_ALIGNMENT)
        return false;
    const bool deep = keepsDeepPixels(job.output);
    const PairCanvas canvas = renderPair(alignment, deep ? photographs[0].image : source,
                                         deep ? photographs[1].image : target, View::NATURAL);
    composition.picture = blendPair(canvas, Blend::MULTIBAND);
    composition.shown = canvas.source_mask | canvas.target_mask;
    layout.component = {0, 1};
    layout.decisions.emplace_back(
        "no cameras were found for the two photographs, but a homography was: they are stitched as gcpw_pair does");
    return true;
}
