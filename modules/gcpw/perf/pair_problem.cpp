// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
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
    pixels(params.sampleStep).linearize(states_, target_moves, loss(), samples_);
}

void PairProblem::holdShapes()
{
    const gcpw::Params params;
    for (int i = 0; i < static_cast<int>(lattices_.size()); ++i)
    {
        similarity_.emplace_back(i, states_[i].mesh, params.similarityWeight);
        std::vector<int> cells(lattices_[i].cellCount());
        std::iota(cells.begin(), cells.end(), 0);
        if (target_moves_) // as where several images move: nothing else says where the canvas is
            shape_priors_.emplace_back(i, states_[i].mesh, cells, params.restWeight);
    }
}

gcpw::PhotometricTerm PairProblem::pixels(int step) const
{
    const gcpw::Params params;
    gcpw::PhotometricTerm::Options options;
    options.step = step;
    options.weight = params.photometricWeight;
    options.contrast_floor = params.contrastFloor;
    options.gain_support = params.gainSupport;
    return {0, 1, levels_[0], levels_[1], states_[0].mesh.lattice(), options};
}

gcpw::RobustLoss PairProblem::loss() const
{
    return gcpw::RobustLoss(0.1 * gcpw::Params().robustScale); // in local standard deviations, as on the finest level
}

void PairProblem::accumulate(gcpw::NormalEquations& equations) const
{
    samples_.addTo(equations);
    for (size_t i = 0; i < similarity_.size(); ++i)
        similarity_[i].linearize(states_[i].mesh, equations);
    for (const gcpw::AnchorTerm& reference : shape_priors_)
        reference.linearize(states_[reference.image()].mesh, equations);
}

} // namespace opencv_test
