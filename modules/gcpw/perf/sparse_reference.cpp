// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "sparse_reference.hpp"

#include <algorithm>
#include <vector>
#include "recording_equations.hpp"

namespace opencv_test
{

namespace
{

/// The lower triangle of a symmetric matrix, entry by entry.
class Entries
{
public:
    void add(int row, int col, double value) { entries_.emplace_back(std::max(row, col), std::min(row, col), value); }

    /// value * (x_a - x_b) * (y_a - y_b), from both sides unless x and y are the same unknown.
    void addDifference(int x_a, int x_b, int y_a, int y_b, double value)
    {
        add(x_a, y_a, value);
        add(x_b, y_b, value);
        add(x_a, y_b, -value);
        if (x_a != y_a)
            add(x_b, y_a, -value);
    }
    Eigen::SparseMatrix<double> matrix(int size) const
    {
        Eigen::SparseMatrix<double> result(size, size);
        result.setFromTriplets(entries_.begin(), entries_.end());
        return result;
    }

private:
    std::vector<Eigen::Triplet<double>> entries_;
};

void addMesh(const RecordingEquations& record, gcpw::QuadId quad, const gcpw::QuadBlock& block, Entries& entries)
{
    for (int i = 0; i < 8; ++i)
        for (int j = i; j < 8; ++j)
            entries.add(record.meshColumn(quad, i), record.meshColumn(quad, j), block[i][j]);
}

void addPairs(const RecordingEquations& record, Entries& entries)
{
    for (const RecordingEquations::Target& item : record.targets)
    {
        addMesh(record, item.b, item.block.mesh_mesh, entries);
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 8; ++j)
                entries.add(record.meshColumn(item.a, i), record.meshColumn(item.b, j), item.block.cross[i][j]);
    }
}

/// Of one quad each.
void addRows(const RecordingEquations& record, Entries& entries)
{
    for (const RecordingEquations::Row& item : record.rows)
        for (int i = 0; i < 8; ++i)
            for (int j = i; j < 8; ++j)
                if (item.row_a[i] != 0 && item.row_a[j] != 0)
                    entries.add(record.meshColumn(item.a, i), record.meshColumn(item.a, j),
                                item.weight * item.row_a[i] * item.row_a[j]);
}

void addColors(const RecordingEquations& record, Entries& entries)
{
    for (const RecordingEquations::Block& item : record.blocks)
    {
        if (item.block.samples == 0)
            continue;
        for (int k = 0; k < 6; ++k)
            for (int i = 0; i < 8; ++i)
                entries.add(record.meshColumn(item.quad, i), record.colorColumn(item.quad, k),
                            item.block.mesh_color[i][k]);
        for (int c = 0; c < 3; ++c)
            for (int i = 0; i < 2; ++i)
                for (int j = i; j < 2; ++j)
                    entries.add(record.colorColumn(item.quad, 2 * c + i), record.colorColumn(item.quad, 2 * c + j),
                                item.block.color_color[c][i + j]);
    }
}

/// See ColorSmoothnessTerm: 2 * weight * sum over x of (gain x + bias)^2, between neighbours.
void addSmoothness(const RecordingEquations& record, const gcpw::Lattice& lattice, Entries& entries)
{
    const double weight = 2 * gcpw::Params().colorSmoothnessWeight;
    const double form[3] = {3.85 * weight, 5.5 * weight, 11 * weight}; // sums of x^2, x and 1 over 0, 0.1 .. 1
    std::array<int, 8> near{};
    for (int cell = 0; cell < lattice.cellCount(); ++cell)
        for (int n = 0, count = lattice.neighbours(cell, near); n < count; ++n)
            for (int k = 0; near[n] > cell && k < 6; ++k)
                for (int other = k; other <= (k | 1); ++other)
                    entries.addDifference(record.colorColumn({0, cell}, k), record.colorColumn({0, near[n]}, k),
                                          record.colorColumn({0, cell}, other), record.colorColumn({0, near[n]}, other),
                                          form[k % 2 + other % 2]);
}

} // namespace

SparseReference::SparseReference(const PairProblem& problem, Unknowns unknowns, double damping)
{
    RecordingEquations record(problem.lattices());
    problem.accumulate(record);
    Entries entries;
    for (const RecordingEquations::Block& item : record.blocks)
        addMesh(record, item.quad, item.block.mesh_mesh, entries);
    addPairs(record, entries);
    addRows(record, entries);
    for (int i = 0; i < record.meshColumns(); ++i)
        entries.add(i, i, damping);
    if (unknowns == MESHES_AND_COLORS)
    {
        addColors(record, entries);
        addSmoothness(record, problem.lattices()[0], entries);
    }
    const int size = unknowns == MESHES ? record.meshColumns() : record.columns();
    matrix_ = entries.matrix(size);
    gradient_ = record.gradient().head(size);
    solver_.analyzePattern(matrix_);
}

bool SparseReference::solve(Eigen::VectorXd& step)
{
    solver_.factorize(matrix_);
    if (solver_.info() != Eigen::Success)
        return false;
    step = solver_.solve(-gradient_);
    return true;
}

double SparseReference::energy(const Eigen::VectorXd& step) const
{
    return 2 * gradient_.dot(step) + step.dot(matrix_.selfadjointView<Eigen::Lower>() * step);
}

} // namespace opencv_test
