// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_RANDOM_PROBLEM_HPP
#define OPENCV_GCPW_TEST_RANDOM_PROBLEM_HPP

#include "test_precomp.hpp"

#include "solver/normal_equations.hpp"
#include "seeded.hpp"

namespace opencv_test
{

inline cv::gcpw::QuadRow randomRow(RNG& rng)
{
    cv::gcpw::QuadRow row;
    for (double& value : row)
        value = rng.uniform(-1.0, 1.0);
    return row;
}

/// Both sides of samples that compare a quad of one image with a quad of another.
struct RandomSamples
{
    cv::gcpw::PhotometricBlock own;
    cv::gcpw::CrossBlock target;
};

/** @brief Normal blocks of random samples: each channel has rows of its own, as in PhotometricTerm, so that channels
meet only through the mesh. */
inline RandomSamples randomSamples(RNG& rng, int samples)
{
    RandomSamples result;
    cv::gcpw::PhotometricBlock& own = result.own;
    cv::gcpw::CrossBlock& other = result.target;
    own.samples = samples;
    for (int s = 0; s < 3 * samples; ++s)
    {
        const int c = s % 3;
        const cv::gcpw::QuadRow row = randomRow(rng);
        const cv::gcpw::QuadRow target_row = randomRow(rng);
        const double color[2] = {rng.uniform(0.0, 1.0), 1};
        const double target_color[2] = {-rng.uniform(0.0, 1.0), -1};
        const double residual = rng.uniform(-0.3, 0.3);
        for (int i = 0; i < 8; ++i)
        {
            for (int j = 0; j < 8; ++j)
            {
                own.mesh_mesh[i][j] += j >= i ? row[i] * row[j] : 0;
                other.mesh_mesh[i][j] += j >= i ? target_row[i] * target_row[j] : 0;
                other.cross[i][j] += row[i] * target_row[j];
            }
            for (int k = 0; k < 2; ++k)
                own.mesh_color[i][2 * c + k] += row[i] * color[k];
            own.mesh_gradient[i] += row[i] * residual;
            other.mesh_gradient[i] += target_row[i] * residual;
        }
        for (int i = 0; i < 2; ++i)
        {
            for (int j = 0; j < 2; ++j)
            {
                own.color_color[c][i + j] += j >= i ? color[i] * color[j] : 0;
                other.color_color[c][i + j] += j >= i ? target_color[i] * target_color[j] : 0;
                other.color_cross[c][2 * i + j] += color[i] * target_color[j];
            }
            own.color_gradient[c][i] += color[i] * residual;
            other.color_gradient[c][i] += target_color[i] * residual;
        }
        own.energy += residual * residual;
    }
    return result;
}

inline cv::gcpw::PhotometricBlock randomPhotometricBlock(RNG& rng, int samples)
{
    return randomSamples(rng, samples).own;
}

} // namespace opencv_test

#endif
