// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "registration/features.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include "registration/corners.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double MIN_SEGMENT_LENGTH = 20; ///< px
const double CORNERS_PER_QUAD = 4;    ///< tell how it shears; with three a recoloured scene is found a little less exactly
const int TRACKING_LEVELS = 5;        ///< the coarsest of 0.6 Mpx has 60 px a side: a quarter of it is a window

Mat grayOf(const Mat& image)
{
    Mat gray;
    cvtColor(image, gray, COLOR_BGR2GRAY);
    return gray;
}

} // namespace

std::vector<Segment> segmentsOf(const Mat& image, const Mat& mask, Size2d to_reference)
{
    return detectSegments(grayOf(image), mask, to_reference, MIN_SEGMENT_LENGTH);
}

Keypoints keypointsOf(const Mat& image, const Mat& mask, Size2d to_reference, const Params& params)
{
    return detectKeypoints(grayOf(image), mask, to_reference, params.contrastThreshold);
}

void prepareCorners(const Mat& image, const Mat& mask, const Params& params, Features& features)
{
    const Mat gray = grayOf(image);
    const double quads = static_cast<double>(params.meshCols) * params.meshRows;
    const double spacing = std::sqrt(static_cast<double>(gray.total()) / (CORNERS_PER_QUAD * quads));
    features.corners = findCorners(gray, mask, std::max(cvRound(spacing), 2));
    features.pyramid = GrayPyramid(gray, mask, TRACKING_LEVELS);
}

} // namespace gcpw
} // namespace cv
