// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_COLOR_SYSTEM_HPP
#define OPENCV_GCPW_COLOR_SYSTEM_HPP

#include <vector>
#include "energy/conjugate_gradient.hpp"
#include "energy/residual_sink.hpp"
#include "model/color_grid.hpp"

namespace cv
{
namespace gcpw
{

/// Symmetric 2 x 2 block over (gain, bias) of one channel.
struct ColorBlock
{
    double gain_gain = 0;
    double gain_bias = 0;
    double bias_bias = 0;
};

/** @brief The quadratic energy of all colour grids while the meshes stand still, and its exact minimum.

The channels do not meet, so they are three systems of one shape: 2 x 2 blocks on the quads (samples, pulls to rest) and
between quads (smoothness within an image; samples between images). eliminate() also serves the mesh step: it removes the
six colour unknowns of one quad from its mesh block (Schur complement) with its neighbours held at the present value. */
class ColorSystem
{
public:
    /// @param lattices one per image  @param held images whose colour does not change
    ColorSystem(const std::vector<Lattice>& lattices, const std::vector<bool>& held);

    /// (color_a - color_b)^T block (color_a - color_b) in every channel; kept for good.
    void addDifference(QuadId a, QuadId b, const ColorBlock& block);

    /// weight * ((gain - rest gain)^2 + (bias - rest bias)^2) in every channel; one for a quad; kept until clearPulls().
    void addPull(QuadId quad, double weight, const ColorGrid::Quad& rest = ColorGrid::Quad());
    void clearPulls();

    /// What the samples of a quad say about its colour, linearised at `now`; kept until clearSamples().
    void addSamples(QuadId quad, const ColoredBlock& block, const ColorGrid::Quad& now);
    /// What they say about the colour of the quad they are compared with.
    void addPartner(QuadId a, const ColorGrid::Quad& now_a, QuadId b, const ColorGrid::Quad& now_b,
                    const PartnerColor& block);
    void clearSamples();

    /// Takes the quad's colour unknowns out of `block`'s mesh part.
    void eliminate(QuadId quad, const std::vector<ColorGrid>& now, ColoredBlock& block) const;

    /** Minimises; starts from the grids given and overwrites those that are not held.
    @return NotPositiveDefinite if a system has no unique finite answer; the grids are then unchanged */
    SolveStatus solve(std::vector<ColorGrid>& grids) const;

    /// Energy of differences and pulls (samples are not counted: the photometric term knows their robust energy).
    double regularEnergy(const std::vector<ColorGrid>& grids) const;

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
        std::array<std::array<double, 2>, CHANNELS> right{}; ///< right-hand side of the samples
        double pull = 0;
        ColorGrid::Quad rest;
        ColorBlock edge_sum;
        bool held = false;
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
