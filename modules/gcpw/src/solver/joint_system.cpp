// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "solver/joint_system.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double STEP_TOLERANCE = 0.1; ///< many images: the next Gauss-Newton step corrects what remains

} // namespace

JointSystem::JointSystem(const std::vector<Lattice>& lattices, const std::vector<bool>& mesh_fixed,
                         const std::vector<bool>& color_fixed)
    : lattices_(lattices), meshes_(lattices, mesh_fixed), colors_(lattices, color_fixed)
{
}

void JointSystem::setZero()
{
    meshes_.setZero();
    colors_.setZero();
    photometric_.clear();
    cross_.clear();
    eliminated_ = false;
}

void JointSystem::addRow(QuadId quad, const QuadRow& row, double residual, double weight)
{
    meshes_.addRow(quad, row, residual, weight);
}

void JointSystem::addRow(QuadId a, const QuadRow& row_a, QuadId b, const QuadRow& row_b, double residual, double weight)
{
    meshes_.addRow(a, row_a, b, row_b, residual, weight);
}

void JointSystem::addBlock(QuadId quad, const QuadBlock& block, const QuadRow& gradient, double energy)
{
    meshes_.addBlock(quad, block, gradient, energy);
}

void JointSystem::addPhotometric(QuadId quad, const PhotometricBlock& block)
{
    photometric_.push_back({quad, block});
}

void JointSystem::addCross(QuadId a, QuadId b, const CrossBlock& block)
{
    meshes_.addCross(a, b, block);
    cross_.push_back({a, b, block});
}

void JointSystem::gatherSamples(const MeshStep* step, const std::vector<ColorGrid>& colors)
{
    colors_.clearSamples();
    for (const EquationBuffer::Photometric& item : photometric_)
    {
        SampleColor moved = item.block;
        const int vertices = step ? static_cast<int>((*step)[item.quad.image].size()) : 0;
        for (int i = 0; vertices > 0 && i < 8; ++i)
        {
            const Point2d vertex = (*step)[item.quad.image][lattices_[item.quad.image].vertexOf(item.quad.cell, i >> 1)];
            const double d = (i & 1) ? vertex.y : vertex.x;
            for (int c = 0; c < CHANNELS; ++c)
                for (int k = 0; k < 2; ++k)
                    moved.color_gradient[c][k] += item.block.mesh_color[i][2 * c + k] * d;
        }
        colors_.addSamples(item.quad, moved, colors[item.quad.image].quad(item.quad.cell));
    }
    for (const Cross& item : cross_)
        colors_.addCross(item.a, colors[item.a.image].quad(item.a.cell), item.b,
                           colors[item.b.image].quad(item.b.cell), item.color);
}

SolveStatus JointSystem::solveColors(std::vector<ColorGrid>& colors)
{
    gatherSamples(nullptr, colors);
    return colors_.solve(colors);
}

SolveStatus JointSystem::solveMeshes(const std::vector<ColorGrid>& colors, MeshStep& step)
{
    if (!eliminated_)
    {
        // A quad tied to a moving target keeps its colour for this step: taking the colour out of one side alone would
        // leave a matrix that is no sum of squares.
        std::vector<std::vector<bool>> tied(lattices_.size());
        for (const Cross& item : cross_)
        {
            tied[item.a.image].resize(lattices_[item.a.image].cellCount());
            tied[item.a.image][item.a.cell] = true;
        }
        for (const EquationBuffer::Photometric& item : photometric_)
        {
            const std::vector<bool>& ties = tied[item.quad.image];
            PhotometricBlock block = item.block;
            if (ties.empty() || !ties[item.quad.cell])
                colors_.eliminate(item.quad, colors, block);
            meshes_.addPhotometric(item.quad, block);
        }
        eliminated_ = true;
    }
    return meshes_.solve(step, STEP_TOLERANCE);
}

SolveStatus JointSystem::solveColorsAfter(const MeshStep& step, std::vector<ColorGrid>& colors)
{
    gatherSamples(&step, colors);
    return colors_.solve(colors);
}

} // namespace gcpw
} // namespace cv
