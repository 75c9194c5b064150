// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_COLOR_SYSTEM_HPP
#define OPENCV_GCPW_COLOR_SYSTEM_HPP

#include <vector>
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
2 x 2 blocks between quads (smoothness). eliminate() also serves the mesh step: it removes the six colour unknowns of
one quad from its mesh block (Schur complement) with its neighbours' colour held at the present value. */
class ColorSystem
{
public:
    /// @param lattices one per image  @param held images whose colour does not change
    ColorSystem(const std::vector<Lattice>& lattices, const std::vector<bool>& held);

    /// Forgets everything.
    void setZero();
    /// Forgets the pulls.
    void clearPulls();
    /// Forgets the samples, keeps differences and pulls.
    void clearSamples();

    /// weight of (color_a - color_b)^T block (color_a - color_b), the same for every channel.
    void addDifference(QuadId a, QuadId b, const ColorBlock& block);

    /// weight * ((gain - 1)^2 + bias^2) in every channel.
    void addPull(QuadId quad, double weight);

    /// What the samples of a quad say about its colour, linearised at `now`.
    void addSamples(QuadId quad, const ColoredBlock& block, const ColorGrid::Quad& now);

    /// Takes the quad's colour unknowns out of `block`'s mesh part.
    void eliminate(QuadId quad, const std::vector<ColorGrid>& now, ColoredBlock& block) const;

    /** Minimises; starts from the grids given and overwrites those that are not held.
    @return false if a system is not positive definite or not finite; the grids are then unchanged */
    bool solve(std::vector<ColorGrid>& grids) const;

    /// Energy of differences and pulls (samples are not counted: the photometric term knows their robust energy).
    double regularEnergy(const std::vector<ColorGrid>& grids) const;

private:
    struct Edge
    {
        int other = -1; ///< node
        ColorBlock block;
    };
    struct Node
    {
        std::array<ColorBlock, CHANNELS> samples;
        std::array<std::array<double, 2>, CHANNELS> right{}; ///< right-hand side of the samples
        double pull = 0;
        ColorBlock edge_sum;
        std::vector<Edge> edges;
    };

    int nodeOf(QuadId quad) const { return first_[quad.image] + quad.cell; }
    ColorBlock diagonal(const Node& node, int channel) const;
    bool solveChannel(int channel, std::vector<std::array<double, 2>>& x) const;
    std::vector<std::array<double, 2>> values(const std::vector<ColorGrid>& grids, int channel) const;

    std::vector<int> first_; ///< first node of every image, and one past the last
    std::vector<bool> held_;
    std::vector<Node> nodes_;
};

} // namespace gcpw
} // namespace cv

#endif
