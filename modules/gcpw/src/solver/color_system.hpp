// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_COLOR_SYSTEM_HPP
#define OPENCV_GCPW_COLOR_SYSTEM_HPP

#include <vector>
#include "solver/conjugate_gradient.hpp"
#include "solver/normal_equations.hpp"
#include "model/color_grid.hpp"

namespace cv
{
namespace gcpw
{

/** @brief The quadratic energy of all colour grids while the meshes stand still, and its exact minimum.

The channels are independent: three systems of one structure, with 2 x 2 blocks on the quads (samples, priors) and
between quads (smoothness within an image; samples between images). eliminate() also serves the mesh step: it removes the
six colour unknowns of one quad from its mesh block (Schur complement) with its neighbours fixed at their present values. */
class ColorSystem : public ColorEquations
{
public:
    /// @param lattices one per image  @param fixed images whose colour does not change
    ColorSystem(const std::vector<Lattice>& lattices, const std::vector<bool>& fixed);

    /// Clears everything but the lattices; keeps its memory.
    void setZero();

    void addColorDifference(QuadId a, QuadId b, const ColorBlock& block) override;
    void addColorPrior(QuadId quad, double weight, const ColorGrid::Quad& reference) override;

    /// What the samples of a quad say about its colour, linearised at `now`; kept until clearSamples().
    void addSamples(QuadId quad, const SampleColor& block, const ColorGrid::Quad& now);
    /// What they say about the colour of the quad they are compared with.
    void addCross(QuadId a, const ColorGrid::Quad& now_a, QuadId b, const ColorGrid::Quad& now_b,
                  const CrossColor& block);
    void clearSamples();

    /// Takes the quad's colour unknowns out of `block`'s mesh part.
    void eliminate(QuadId quad, const std::vector<ColorGrid>& now, PhotometricBlock& block) const;

    /** Minimises; starts from the grids given and overwrites those that are not fixed.
    @return NotPositiveDefinite if a system has no unique finite answer; the grids are then unchanged */
    [[nodiscard]] SolveStatus solve(std::vector<ColorGrid>& grids) const;

private:
    struct Edge
    {
        int a; ///< node
        int b;
        ColorBlock block;
    };
    struct Coupling ///< data between the quads of two images: a^T block b, per channel
    {
        int a;
        int b;
        std::array<std::array<double, 4>, CHANNELS> block;
    };
    struct Node
    {
        std::array<ColorBlock, CHANNELS> samples;
        std::array<std::array<double, 2>, CHANNELS> right{};  ///< right-hand side of the samples
        double prior = 0;                                     ///< sum of the weights of its priors
        std::array<std::array<double, 2>, CHANNELS> wanted{}; ///< sum of weight times reference
        ColorBlock edge_sum;
        bool fixed = false;
        std::vector<int> edges;
    };

    int nodeOf(QuadId quad) const { return first_[quad.image] + quad.cell; }
    ColorBlock diagonal(const Node& node, int channel) const;
    SolveStatus solveChannel(int channel, Eigen::VectorXd& x) const;
    void multiply(int channel, const std::vector<ColorBlock>& diagonals, const Eigen::VectorXd& in,
                  Eigen::VectorXd& out) const;
    Eigen::VectorXd values(const std::vector<ColorGrid>& grids, int channel) const;

    std::vector<int> first_; ///< first node of every image, and one past the last
    std::vector<Node> nodes_;
    std::vector<Edge> edges_;
    std::vector<Coupling> couplings_;
};

} // namespace gcpw
} // namespace cv

#endif
