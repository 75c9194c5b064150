// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "solver/color_system.hpp"

#include <cmath>
#include <opencv2/core/utility.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

typedef std::array<double, 2> Pair;

const double CG_TOLERANCE = 1e-4; ///< far below one gray level
const int CG_MAX_ITERATIONS = 1000;

void add(ColorBlock& sum, const ColorBlock& block)
{
    sum.gain_gain += block.gain_gain;
    sum.gain_bias += block.gain_bias;
    sum.bias_bias += block.bias_bias;
}

Pair multiply(const ColorBlock& block, double gain, double bias)
{
    return {{block.gain_gain * gain + block.gain_bias * bias, block.gain_bias * gain + block.bias_bias * bias}};
}

double determinant(const ColorBlock& block)
{
    return block.gain_gain * block.bias_bias - block.gain_bias * block.gain_bias;
}

Pair solve2(const ColorBlock& block, double gain, double bias)
{
    const double inverse = 1 / determinant(block);
    return {{inverse * (block.bias_bias * gain - block.gain_bias * bias),
             inverse * (block.gain_gain * bias - block.gain_bias * gain)}};
}

ColorBlock toBlock(const std::array<double, 3>& moments)
{
    return {moments[0], moments[1], moments[2]};
}

} // namespace

ColorSystem::ColorSystem(const std::vector<Lattice>& lattices, const std::vector<bool>& fixed)
{
    CV_Assert(fixed.size() == lattices.size());
    first_.push_back(0);
    for (size_t image = 0; image < lattices.size(); ++image)
    {
        Node node;
        node.fixed = fixed[image];
        nodes_.insert(nodes_.end(), lattices[image].cellCount(), node);
        first_.push_back(static_cast<int>(nodes_.size()));
    }
}

void ColorSystem::addColorDifference(QuadId a, QuadId b, const ColorBlock& block)
{
    const int edge = static_cast<int>(edges_.size());
    edges_.push_back({nodeOf(a), nodeOf(b), block});
    for (const int node : {nodeOf(a), nodeOf(b)})
    {
        nodes_[node].edges.push_back(edge);
        add(nodes_[node].edge_sum, block);
    }
}

void ColorSystem::addColorPrior(QuadId quad, double weight, const ColorGrid::Quad& reference)
{
    Node& node = nodes_[nodeOf(quad)];
    node.prior += weight;
    for (int c = 0; c < CHANNELS; ++c)
    {
        node.wanted[c][0] += weight * reference[c].gain;
        node.wanted[c][1] += weight * reference[c].bias;
    }
}

void ColorSystem::setZero()
{
    clearSamples();
    edges_.clear();
    for (Node& node : nodes_)
    {
        node.prior = 0;
        node.wanted.fill(Pair{});
        node.edge_sum = ColorBlock();
        node.edges.clear();
    }
}

void ColorSystem::clearSamples()
{
    couplings_.clear();
    for (Node& node : nodes_)
    {
        node.samples.fill(ColorBlock());
        node.right.fill(Pair{});
    }
}

void ColorSystem::addSamples(QuadId quad, const SampleColor& block, const ColorGrid::Quad& now)
{
    Node& node = nodes_[nodeOf(quad)];
    for (int c = 0; c < CHANNELS; ++c)
    {
        const ColorBlock data = toBlock(block.color_color[c]);
        const Pair present = gcpw::multiply(data, now[c].gain, now[c].bias);
        add(node.samples[c], data);
        for (int k = 0; k < 2; ++k)
            node.right[c][k] += present[k] - block.color_gradient[c][k];
    }
}

void ColorSystem::addCross(QuadId a, const ColorGrid::Quad& now_a, QuadId b, const ColorGrid::Quad& now_b,
                             const CrossColor& block)
{
    Node& mine = nodes_[nodeOf(a)];
    Node& other = nodes_[nodeOf(b)];
    for (int c = 0; c < CHANNELS; ++c)
    {
        const ColorBlock data = toBlock(block.color_color[c]);
        const Pair present = gcpw::multiply(data, now_b[c].gain, now_b[c].bias);
        const std::array<double, 4>& cross = block.color_cross[c];
        add(other.samples[c], data);
        // The gradients were taken with both colours in place, so both right-hand sides carry the cross part too.
        other.right[c][0] += present[0] + cross[0] * now_a[c].gain + cross[2] * now_a[c].bias - block.color_gradient[c][0];
        other.right[c][1] += present[1] + cross[1] * now_a[c].gain + cross[3] * now_a[c].bias - block.color_gradient[c][1];
        mine.right[c][0] += cross[0] * now_b[c].gain + cross[1] * now_b[c].bias;
        mine.right[c][1] += cross[2] * now_b[c].gain + cross[3] * now_b[c].bias;
    }
    couplings_.push_back({nodeOf(a), nodeOf(b), block.color_cross});
}

ColorBlock ColorSystem::diagonal(const Node& node, int channel) const
{
    ColorBlock sum = node.samples[channel];
    add(sum, node.edge_sum);
    sum.gain_gain += node.prior;
    sum.bias_bias += node.prior;
    return sum;
}

void ColorSystem::eliminate(QuadId quad, const std::vector<ColorGrid>& now, PhotometricBlock& block) const
{
    const int index = nodeOf(quad);
    const Node& node = nodes_[index];
    if (node.fixed)
        return;
    const ColorGrid& grid = now[quad.image];
    for (int c = 0; c < CHANNELS; ++c)
    {
        ColorBlock own = toBlock(block.color_color[c]);
        add(own, node.edge_sum);
        own.gain_gain += node.prior;
        own.bias_bias += node.prior;
        if (!(determinant(own) > 0))
            continue; // neither data nor prior: the colour stays as it is
        const ChannelAffine& mine = grid.quad(quad.cell)[c];
        Pair gradient{{block.color_gradient[c][0] + node.prior * mine.gain - node.wanted[c][0],
                       block.color_gradient[c][1] + node.prior * mine.bias - node.wanted[c][1]}};
        for (const int e : node.edges)
        {
            const int neighbour = edges_[e].a == index ? edges_[e].b : edges_[e].a;
            const ChannelAffine& other = grid.quad(neighbour - first_[quad.image])[c];
            const Pair g = gcpw::multiply(edges_[e].block, mine.gain - other.gain, mine.bias - other.bias);
            gradient[0] += g[0];
            gradient[1] += g[1];
        }
        const Pair shift = solve2(own, gradient[0], gradient[1]);
        for (int i = 0; i < 8; ++i)
        {
            const double gain = block.mesh_color[i][2 * c];
            const double bias = block.mesh_color[i][2 * c + 1];
            const Pair solved = solve2(own, gain, bias);
            block.mesh_gradient[i] -= gain * shift[0] + bias * shift[1];
            for (int j = i; j < 8; ++j)
                block.mesh_mesh[i][j] -=
                    solved[0] * block.mesh_color[j][2 * c] + solved[1] * block.mesh_color[j][2 * c + 1];
        }
    }
}

Eigen::VectorXd ColorSystem::values(const std::vector<ColorGrid>& grids, int channel) const
{
    Eigen::VectorXd x(2 * nodes_.size());
    for (size_t image = 0; image + 1 < first_.size(); ++image)
        for (int node = first_[image]; node < first_[image + 1]; ++node)
        {
            const ChannelAffine& map = grids[image].quad(node - first_[image])[channel];
            x[2 * node] = map.gain;
            x[2 * node + 1] = map.bias;
        }
    return x;
}

void ColorSystem::multiply(int channel, const std::vector<ColorBlock>& diagonals, const Eigen::VectorXd& in,
                           Eigen::VectorXd& out) const
{
    for (size_t i = 0; i < nodes_.size(); ++i)
    {
        const Pair y = gcpw::multiply(diagonals[i], in[2 * i], in[2 * i + 1]);
        out[2 * i] = y[0];
        out[2 * i + 1] = y[1];
    }
    for (const Edge& edge : edges_)
    {
        const Pair to_a = gcpw::multiply(edge.block, in[2 * edge.b], in[2 * edge.b + 1]);
        const Pair to_b = gcpw::multiply(edge.block, in[2 * edge.a], in[2 * edge.a + 1]);
        out[2 * edge.a] -= to_a[0];
        out[2 * edge.a + 1] -= to_a[1];
        out[2 * edge.b] -= to_b[0];
        out[2 * edge.b + 1] -= to_b[1];
    }
    for (const Coupling& coupling : couplings_)
    {
        const std::array<double, 4>& m = coupling.block[channel];
        const int a = 2 * coupling.a;
        const int b = 2 * coupling.b;
        out[a] += m[0] * in[b] + m[1] * in[b + 1];
        out[a + 1] += m[2] * in[b] + m[3] * in[b + 1];
        out[b] += m[0] * in[a] + m[2] * in[a + 1];
        out[b + 1] += m[1] * in[a] + m[3] * in[a + 1];
    }
}

SolveStatus ColorSystem::solveChannel(int channel, Eigen::VectorXd& x) const
{
    // Solved for the change from x, which is zero on the nodes that are fixed.
    const size_t count = nodes_.size();
    std::vector<ColorBlock> diagonals(count);
    for (size_t i = 0; i < count; ++i)
    {
        diagonals[i] = diagonal(nodes_[i], channel);
        if (!nodes_[i].fixed && !(determinant(diagonals[i]) > 0))
            return SolveStatus::NotPositiveDefinite;
    }
    const auto clearFixed = [&](Eigen::VectorXd& v)
    {
        for (size_t i = 0; i < count; ++i)
            if (nodes_[i].fixed)
                v[2 * i] = v[2 * i + 1] = 0;
    };
    Eigen::VectorXd right(2 * count);
    for (size_t i = 0; i < count; ++i)
    {
        right[2 * i] = nodes_[i].right[channel][0] + nodes_[i].wanted[channel][0];
        right[2 * i + 1] = nodes_[i].right[channel][1] + nodes_[i].wanted[channel][1];
    }
    const auto product = [&](const Eigen::VectorXd& in, Eigen::VectorXd& out)
    {
        multiply(channel, diagonals, in, out);
        clearFixed(out);
    };
    const auto blockJacobi = [&](const Eigen::VectorXd& in, Eigen::VectorXd& out)
    {
        for (size_t i = 0; i < count; ++i)
        {
            const Pair y = nodes_[i].fixed ? Pair{} : solve2(diagonals[i], in[2 * i], in[2 * i + 1]);
            out[2 * i] = y[0];
            out[2 * i + 1] = y[1];
        }
    };
    // Fixed colours act on the others through the right-hand side; as unknowns they are zero.
    Eigen::VectorXd fixed = x;
    for (size_t i = 0; i < count; ++i)
        if (!nodes_[i].fixed)
            fixed[2 * i] = fixed[2 * i + 1] = 0;
    Eigen::VectorXd moved(2 * count);
    multiply(channel, diagonals, fixed, moved);
    right -= moved;
    clearFixed(right);
    Eigen::VectorXd unknown = x - fixed;
    const SolveStatus status =
        conjugateGradient(right, unknown, product, blockJacobi, CG_TOLERANCE, CG_MAX_ITERATIONS);
    x = unknown + fixed;
    return status;
}

SolveStatus ColorSystem::solve(std::vector<ColorGrid>& grids) const
{
    SolveStatus status = SolveStatus::Solved;
    std::array<Eigen::VectorXd, CHANNELS> solution;
    std::array<SolveStatus, CHANNELS> statuses;
    parallel_for_(Range(0, CHANNELS), [&](const Range& range)
    {
        for (int c = range.start; c < range.end; ++c)
        {
            solution[c] = values(grids, c);
            statuses[c] = solveChannel(c, solution[c]);
            if (!solution[c].allFinite())
                statuses[c] = SolveStatus::NotPositiveDefinite;
        }
    });
    for (const SolveStatus channel : statuses)
    {
        if (channel == SolveStatus::NotPositiveDefinite)
            return channel;
        if (channel == SolveStatus::NotConverged)
            status = channel;
    }
    for (size_t image = 0; image + 1 < first_.size(); ++image)
        for (int node = first_[image]; !nodes_[first_[image]].fixed && node < first_[image + 1]; ++node)
            for (int c = 0; c < CHANNELS; ++c)
                grids[image].quad(node - first_[image])[c] = {solution[c][2 * node], solution[c][2 * node + 1]};
    return status;
}

} // namespace gcpw
} // namespace cv
