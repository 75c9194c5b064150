// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_FEATURES_SCENE_HPP
#define OPENCV_GCPW_TEST_FEATURES_SCENE_HPP

#include "test_precomp.hpp"

#include "registration/features.hpp"

namespace opencv_test
{

/// Segments of an image beside keypoints that are known, in reference pixels.
inline gcpw::Features knownFeatures(const Mat& image, const Mat& mask, Size2d to_reference,
                                    const gcpw::Keypoints& keypoints)
{
    gcpw::Features features;
    features.keypoints = keypoints;
    features.segments = gcpw::segmentsOf(image, mask, to_reference);
    return features;
}

/// Keypoints and segments of an image.
inline gcpw::Features detectFeatures(const Mat& image, const Mat& mask, Size2d to_reference,
                                     const gcpw::Params& params)
{
    return knownFeatures(image, mask, to_reference, gcpw::keypointsOf(image, mask, to_reference, params));
}

} // namespace opencv_test

#endif
