// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "energy/color_system.hpp"

#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

typedef std::array<double, 2> Pair;

const double CG_TOLERANCE = 1e-5; ///< relative residual in the preconditioned norm; far below one gray level
const int CG_MAX_ITERATIONS = 1000;

void add(ColorBlock& sum, const ColorBlock& block)
{
    sum.gain_gain += block.gain_gain;
    sum.gain_bias += block.gain_bias;
    sum.bias_bias += block.bias_bias;
}

Pair multiply(const ColorBlock& block, const Pair& x)
{
    return {{block.gain_gain * x[0] + block.gain_bias * x[1], block.gain_bias * x[0] + block.bias_bias * x[1]}};
}

double determinant(const ColorBlock& block)
{
    return block.gain_gain * block.bias_bias - block.gain_bias * block.gain_bias;
}

Pair solve2(const ColorBlock& block, const Pair& x)
{
    const double inverse = 1 / determinant(block);
    return {{inverse * (block.bias_bias * x[0] - block.gain_bias * x[1]),
             inverse * (block.gain_gain * x[1] - block.gain_bias * x[0])}};
}

} // namespace

ColorSystem::ColorSystem(const std::vector<Lattice>& lattices, const std::vector<bool>& held) : held_(held)
{
    CV_Assert(held.size() == lattices.size());
    first_.push_back(0);
    for (const Lattice& lattice : lattices)
        first_.push_back(first_.back() + lattice.cellCount());
    nodes_.resize(first_.back());
}

void ColorSystem::setZero()
{
    nodes_.assign(nodes_.size(), Node());
}

void ColorSystem::clearSamples()
{
    for (Node& node : nodes_)
    {
        node.samples.fill(ColorBlock());
        node.right.fill(Pair{});
    }
}

void ColorSystem::clearPulls()
{
    for (Node& node : nodes_)
        node.pull = 0;
}

void ColorSystem::addDifference(QuadId a, QuadId b, const ColorBlock& block)
{
    const int nodes[2] = {nodeOf(a), nodeOf(b)};
    for (int k = 0; k < 2; ++k)
    {
        Edge edge;
        edge.other = nodes[1 - k];
        edge.block = block;
        nodes_[nodes[k]].edges.push_back(edge);
        add(nodes_[nodes[k]].edge_sum, block);
    }
}

void ColorSystem::addPull(QuadId quad, double weight)
{
    nodes_[nodeOf(quad)].pull += weight;
}

void ColorSystem::addSamples(QuadId quad, const ColoredBlock& block, const ColorGrid::Quad& now)
{
    Node& node = nodes_[nodeOf(quad)];
    for (int c = 0; c < CHANNELS; ++c)
    {
        const ColorBlock data{block.color_color[c][0], block.color_color[c][1], block.color_color[c][2]};
        const Pair present = multiply(data, {{now[c].gain, now[c].bias}});
        add(node.samples[c], data);
        for (int k = 0; k < 2; ++k)
            node.right[c][k] += present[k] - block.color_gradient[c][k];
    }
}

ColorBlock ColorSystem::diagonal(const Node& node, int channel) const
{
    ColorBlock sum = node.samples[channel];
    add(sum, node.edge_sum);
    sum.gain_gain += node.pull;
    sum.bias_bias += node.pull;
    return sum;
}

void ColorSystem::eliminate(QuadId quad, const std::vector<ColorGrid>& now, ColoredBlock& block) const
{
    const Node& node = nodes_[nodeOf(quad)];
    for (int c = 0; c < CHANNELS; ++c)
    {
        ColorBlock own{block.color_color[c][0], block.color_color[c][1], block.color_color[c][2]};
        add(own, node.edge_sum);
        own.gain_gain += node.pull;
        own.bias_bias += node.pull;
        if (!(determinant(own) > 0))
            continue; // nothing holds this colour: leave it where it is
        const ChannelAffine& mine = now[quad.image].quad(quad.cell)[c];
        Pair gradient{{block.color_gradient[c][0] + node.pull * (mine.gain - 1),
                       block.color_gradient[c][1] + node.pull * mine.bias}};
        for (const Edge& edge : node.edges)
        {
            const ChannelAffine& other = now[quad.image].quad(edge.other - first_[quad.image])[c];
            const Pair g = multiply(edge.block, {{mine.gain - other.gain, mine.bias - other.bias}});
            gradient[0] += g[0];
            gradient[1] += g[1];
        }
        const Pair shift = solve2(own, gradient);
        for (int i = 0; i < 8; ++i)
        {
            const Pair coupling{{block.mesh_color[i][2 * c], block.mesh_color[i][2 * c + 1]}};
            const Pair solved = solve2(own, coupling);
            block.mesh_gradient[i] -= coupling[0] * shift[0] + coupling[1] * shift[1];
            for (int j = i; j < 8; ++j)
                block.mesh_mesh[i][j] -= solved[0] * block.mesh_color[j][2 * c] + solved[1] * block.mesh_color[j][2 * c + 1];
        }
    }
}

std::vector<Pair> ColorSystem::values(const std::vector<ColorGrid>& grids, int channel) const
{
    std::vector<Pair> x(nodes_.size());
    for (size_t image = 0; image + 1 < first_.size(); ++image)
        for (int node = first_[image]; node < first_[image + 1]; ++node)
        {
            const ChannelAffine& map = grids[image].quad(node - first_[image])[channel];
            x[node] = {{map.gain, map.bias}};
        }
    return x;
}

bool ColorSystem::solveChannel(int channel, std::vector<Pair>& x) const
{
    // Conjugate gradients with 2 x 2 block Jacobi, from the present colours.
    const int count = static_cast<int>(nodes_.size());
    std::vector<bool> free(count, true);
    for (size_t image = 0; image + 1 < first_.size(); ++image)
        if (held_[image])
            std::fill(free.begin() + first_[image], free.begin() + first_[image + 1], false);
    std::vector<ColorBlock> diagonals(count);
    for (int i = 0; i < count; ++i)
    {
        diagonals[i] = diagonal(nodes_[i], channel);
        if (free[i] && !(determinant(diagonals[i]) > 0))
            return false;
    }
    const auto apply = [&](const std::vector<Pair>& in, int i)
    {
        Pair sum = multiply(diagonals[i], in[i]);
        for (const Edge& edge : nodes_[i].edges)
        {
            const Pair part = multiply(edge.block, in[edge.other]);
            sum[0] -= part[0];
            sum[1] -= part[1];
        }
        return sum;
    };
    std::vector<Pair> r(count, Pair{}), z(count, Pair{}), p(count, Pair{}), q(count, Pair{});
    double rz = 0;
    double scale = 0;
    for (int i = 0; i < count; ++i)
    {
        if (!free[i])
            continue;
        const Pair ax = apply(x, i);
        Pair right = nodes_[i].right[channel];
        right[0] += nodes_[i].pull;
        r[i] = {{right[0] - ax[0], right[1] - ax[1]}};
        z[i] = solve2(diagonals[i], r[i]);
        rz += r[i][0] * z[i][0] + r[i][1] * z[i][1];
        const Pair scaled = solve2(diagonals[i], right);
        scale += right[0] * scaled[0] + right[1] * scaled[1];
    }
    p = z;
    const double stop = CG_TOLERANCE * CG_TOLERANCE * scale;
    for (int iteration = 0; rz > stop && iteration < CG_MAX_ITERATIONS; ++iteration)
    {
        double curvature = 0;
        for (int i = 0; i < count; ++i)
            if (free[i])
            {
                q[i] = apply(p, i);
                curvature += p[i][0] * q[i][0] + p[i][1] * q[i][1];
            }
        if (!(curvature > 0))
            return false;
        const double alpha = rz / curvature;
        double next = 0;
        for (int i = 0; i < count; ++i)
        {
            if (!free[i])
                continue;
            for (int k = 0; k < 2; ++k)
            {
                x[i][k] += alpha * p[i][k];
                r[i][k] -= alpha * q[i][k];
            }
            z[i] = solve2(diagonals[i], r[i]);
            next += r[i][0] * z[i][0] + r[i][1] * z[i][1];
        }
        const double beta = next / rz;
        rz = next;
        for (int i = 0; i < count; ++i)
            for (int k = 0; k < 2; ++k)
                p[i][k] = z[i][k] + beta * p[i][k];
    }
    return std::isfinite(rz);
}

bool ColorSystem::solve(std::vector<ColorGrid>& grids) const
{
    std::array<std::vector<Pair>, CHANNELS> solution;
    for (int c = 0; c < CHANNELS; ++c)
    {
        solution[c] = values(grids, c);
        if (!solveChannel(c, solution[c]))
            return false;
    }
    for (size_t image = 0; image + 1 < first_.size(); ++image)
        for (int node = first_[image]; !held_[image] && node < first_[image + 1]; ++node)
            for (int c = 0; c < CHANNELS; ++c)
                grids[image].quad(node - first_[image])[c] = {solution[c][node][0], solution[c][node][1]};
    return true;
}

double ColorSystem::regularEnergy(const std::vector<ColorGrid>& grids) const
{
    double energy = 0;
    for (int c = 0; c < CHANNELS; ++c)
    {
        const std::vector<Pair> x = values(grids, c);
        for (size_t i = 0; i < nodes_.size(); ++i)
        {
            energy += nodes_[i].pull * ((x[i][0] - 1) * (x[i][0] - 1) + x[i][1] * x[i][1]);
            for (const Edge& edge : nodes_[i].edges)
            {
                const Pair d{{x[i][0] - x[edge.other][0], x[i][1] - x[edge.other][1]}};
                const Pair md = multiply(edge.block, d);
                energy += 0.5 * (d[0] * md[0] + d[1] * md[1]); // every edge stands at both its ends
            }
        }
    }
    return energy;
}

} // namespace gcpw
} // namespace cv
