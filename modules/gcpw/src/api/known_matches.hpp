// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_KNOWN_MATCHES_HPP
#define OPENCV_GCPW_KNOWN_MATCHES_HPP

#include <vector>
#include "api/work_image.hpp"
#include "geometry/curve.hpp"
#include "geometry/matches.hpp"
#include "opencv2/gcpw/aligner.hpp"
#include "opencv2/gcpw/pair_matches.hpp"
#include "registration/pair_matcher.hpp"

namespace cv
{
namespace gcpw
{

// Converts what callers know of their images between pixels as given and working pixels.

/// The keypoints that lie inside the image's mask.
Keypoints toWork(const KnownKeypoints& known, const WorkImage& image);

/// Curves of KnownLines, in working pixels.
std::vector<Curve> toWork(const std::vector<std::vector<Point2f>>& curves, const WorkImage& image);

/// The correspondences of images a and b, whichever of the two comes first in them.
std::vector<PointMatch> toWork(const std::vector<Correspondences>& all, int a, int b,
                               const std::vector<WorkImage>& images);

/// @param images source and target
MatchSet toWork(const PairMatches& matches, MatchKinds kinds, const std::vector<WorkImage>& images);

/// target_from_source between working pixels.
Matx33d workHomography(const PairMatches& matches, const std::vector<WorkImage>& images);

/// Sets homography, points and lines of `found`; the arguments are in working pixels.
void setMatches(const Matx33d& target_from_source, const MatchSet& matches, const std::vector<WorkImage>& images,
                PairMatches& found);

} // namespace gcpw
} // namespace cv

#endif
