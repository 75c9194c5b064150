// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "pair_problem.hpp"

#include <numeric>
#include "bent_mesh.hpp"
#include "geometry/homography.hpp"

namespace opencv_test
{

SceneOptions pairOptions()
{
    SceneOptions options;
    options.source_size = options.target_size = Size(880, 660);
    options.rough = slightHomography(170); // a fifth of the width
    options.recolored = true;
    options.noise = 2;
    return options;
}

const Scene& pairScene()
{
    static const Scene scene(pairOptions());
    return scene;
}

PairProblem::PairProblem(bool target_moves) : target_moves_(target_moves)
{
    const gcpw::Params params;
    const Mat images[] = {pairScene().source(), pairScene().target()};
    for (int i = 0; i < 2; ++i)
    {
        const gcpw::Lattice lattice(images[i].size(), params.meshCols, params.meshRows);
        levels_.push_back(gcpw::buildPyramid(images[i], Mat(), 1)[0]);
        states_.push_back({gcpw::MeshGrid(lattice), gcpw::ColorGrid(lattice)});
        if (i == 0 || target_moves)
            lattices_.push_back(lattice);
    }
    for (Point2d& vertex : states_[0].mesh.vertices())
        vertex = gcpw::applyHomography(pairOptions().rough, vertex);
    if (target_moves)
        states_[1].mesh = bentMesh(lattices_[1], 0.5, 1);
    holdShapes();
    const gcpw::OverlapSamples overlap = samples(params.sampleStep);
    gcpw::PhotometricTerm(overlap, options()).linearize(states_, equations_);
}

/// Similarity and, where both images move, the shape prior: nothing else says where the canvas is then.
void PairProblem::holdShapes()
{
    const gcpw::Params params;
    for (int i = 0; i < static_cast<int>(lattices_.size()); ++i)
    {
        gcpw::SimilarityTerm(i, states_[i].mesh, params.similarityWeight).linearize(states_, equations_);
        std::vector<int> cells(lattices_[i].cellCount());
        std::iota(cells.begin(), cells.end(), 0);
        if (target_moves_)
            gcpw::AnchorTerm(i, states_[i].mesh, cells, params.restWeight).linearize(states_, equations_);
    }
}

gcpw::OverlapSamples PairProblem::samples(int step) const
{
    return {0, 1, levels_[0], levels_[1], states_[0].mesh.lattice(), step, gcpw::Params().contrastFloor};
}

gcpw::PhotometricTerm::Options PairProblem::options() const
{
    const gcpw::Params params;
    gcpw::PhotometricTerm::Options options;
    options.weight = params.photometricWeight;
    options.gain_support = params.gainSupport;
    options.target_moves = target_moves_;
    options.loss = gcpw::RobustLoss(0.1 * params.robustScale); // in local standard deviations, as on the finest level
    return options;
}

} // namespace opencv_test
