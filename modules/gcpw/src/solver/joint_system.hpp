// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_JOINT_SYSTEM_HPP
#define OPENCV_GCPW_JOINT_SYSTEM_HPP

#include "solver/equation_buffer.hpp"
#include "solver/color_system.hpp"
#include "solver/mesh_system.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Meshes and colours of all images as one Gauss-Newton step.

The colours of a quad are eliminated from its mesh block with the neighbouring colours fixed, the mesh unknowns are
solved, then the three colour systems exactly, at the new mesh. Repeated, it ends where steps by a factorisation of all
unknowns end (doc/speed.md), in a fraction of the time. Use: setZero(), add the terms, then solveColors(), or solveMeshes() and
solveColorsAfter(). */
class JointSystem : public NormalEquations
{
public:
    JointSystem(const std::vector<Lattice>& lattices, const std::vector<bool>& mesh_fixed,
                const std::vector<bool>& color_fixed);

    void setZero();

    void addRow(QuadId quad, const QuadRow& row, double residual, double weight) override;
    void addRow(QuadId a, const QuadRow& row_a, QuadId b, const QuadRow& row_b, double residual,
                double weight) override;
    void addBlock(QuadId quad, const QuadBlock& block, const QuadRow& gradient, double energy) override;
    void addGroup(int image, const RowGroup& group, const std::vector<double>& residuals, double weight) override
    {
        meshes_.addGroup(image, group, residuals, weight);
    }
    void addPhotometric(QuadId quad, const PhotometricBlock& block) override;
    void addCross(QuadId a, QuadId b, const CrossBlock& block) override;
    void addColorDifference(QuadId a, QuadId b, const ColorBlock& block) override { colors_.addColorDifference(a, b, block); }
    void addColorPrior(QuadId quad, double weight, const ColorGrid::Quad& reference) override
    {
        colors_.addColorPrior(quad, weight, reference);
    }
    void addDamping(double weight) { meshes_.addDamping(weight); }

    /// The colours that are best while the meshes stand still (eq. initialfunction); unchanged if there is no answer.
    SolveStatus solveColors(std::vector<ColorGrid>& colors);

    /// The mesh step; may be called again after further blocks were added.
    SolveStatus solveMeshes(const std::vector<ColorGrid>& colors, MeshStep& step);

    /// The colours that are best after a mesh step, by the linearisation; unchanged if there is no answer.
    SolveStatus solveColorsAfter(const MeshStep& step, std::vector<ColorGrid>& colors);

private:
    struct Cross
    {
        QuadId a;
        QuadId b;
        CrossColor color;
    };
    void gatherSamples(const MeshStep* step, const std::vector<ColorGrid>& colors);

    std::vector<Lattice> lattices_;
    MeshSystem meshes_;
    ColorSystem colors_;
    std::vector<EquationBuffer::Photometric> photometric_;
    std::vector<Cross> cross_;
    bool eliminated_ = false;
};

} // namespace gcpw
} // namespace cv

#endif
