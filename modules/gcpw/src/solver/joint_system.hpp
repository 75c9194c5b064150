// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
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
solved, then the three colour systems exactly, at the new mesh. This reaches the minimum that a factorisation of all
unknowns reaches, in a thirtieth of the time. Use: setZero(), accumulate the terms, solveColors() and/or solve(). */
class JointSystem : public NormalEquations
{
public:
    JointSystem(const std::vector<Lattice>& lattices, const std::vector<bool>& mesh_fixed,
                const std::vector<bool>& color_fixed);

    /// The regular part of the colours: filled once, kept by setZero().
    ColorSystem& colors() { return colors_; }

    /// Forgets all rows, blocks and samples.
    void setZero();

    void addRow(QuadId quad, const QuadRow& row, double residual, double weight) override;
    void addRow(QuadId a, const QuadRow& row_a, QuadId b, const QuadRow& row_b, double residual,
                double weight) override;
    void addBlock(QuadId quad, const QuadBlock& block, const QuadRow& gradient, double energy) override;
    void addPhotometric(QuadId quad, const PhotometricBlock& block) override;
    void addCross(QuadId a, QuadId b, const CrossBlock& block) override;
    void addDamping(double weight) { meshes_.addDamping(weight); }

    /// The colours that are best while the meshes stand still (eq. initialfunction); unchanged if there is no answer.
    SolveStatus solveColors(std::vector<ColorGrid>& colors);

    /// The mesh step; may be called again after further blocks were added.
    SolveStatus solveMeshes(const std::vector<ColorGrid>& colors, MeshStep& step);

    /// The colours that are best after a mesh step, by the linearisation; unchanged if there is no answer.
    SolveStatus solveColorsAfter(const MeshStep& step, std::vector<ColorGrid>& colors);

private:
    struct Partner
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
    std::vector<Partner> targets_;
    bool eliminated_ = false;
};

} // namespace gcpw
} // namespace cv

#endif
