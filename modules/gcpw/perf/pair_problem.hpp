// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PERF_PAIR_PROBLEM_HPP
#define OPENCV_GCPW_PERF_PAIR_PROBLEM_HPP

#include "perf_precomp.hpp"

#include <vector>
#include "solver/equation_buffer.hpp"
#include "scene.hpp"
#include "energy/anchor_term.hpp"
#include "energy/photometric_term.hpp"
#include "energy/similarity_term.hpp"

namespace opencv_test
{

/// The scene of all measurements of a pair: 880 x 660 px, so that nothing is scaled; recoloured and noisy.
SceneOptions pairOptions();

/// That scene, made once.
const Scene& pairScene();

/** @brief The first Gauss-Newton step on the finest level of that scene, with the default constants.

The source lies where the true homography has it, and the target is undeformed if it is fixed, else bent by half a pixel. */
class PairProblem
{
public:
    /// @param target_moves false: only the source has unknowns, 8322 with its colours; true: both have
    explicit PairProblem(bool target_moves);

    const std::vector<gcpw::Lattice>& lattices() const { return lattices_; }
    const std::vector<gcpw::ImageState>& states() const { return states_; }
    std::vector<bool> fixed() const { return std::vector<bool>(lattices_.size(), false); }

    gcpw::OverlapSamples samples(int step) const;
    gcpw::PhotometricTerm::Options options() const;

    /// Adds the samples of every second pixel, summed up beforehand, and the terms that keep the meshes' shape.
    void accumulate(gcpw::NormalEquations& equations) const { equations_.addTo(equations); }

private:
    void holdShapes();

    bool target_moves_;
    std::vector<gcpw::PyramidLevel> levels_;
    gcpw::State states_;
    std::vector<gcpw::Lattice> lattices_; ///< of the images that have unknowns
    gcpw::EquationBuffer equations_;
};

} // namespace opencv_test

#endif
