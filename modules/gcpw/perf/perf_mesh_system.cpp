// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "perf_precomp.hpp"

#include "solver/block_tridiagonal.hpp"
#include "solver/mesh_system.hpp"
#include "pair_problem.hpp"
#include "sparse_reference.hpp"
#include "thread_count.hpp"

namespace opencv_test { namespace {

const double DAMPING = 1e-4; // of a vertex step, as in the optimiser
const double SLACK = 1e-3;   // share of the gain that an iterative solution may leave

/// Checks that a mesh step is as good as the exact one.
void checkMinimum(SparseReference& reference, const gcpw::MeshStep& step)
{
    Eigen::VectorXd exact;
    CV_Assert(reference.solve(exact));
    Eigen::VectorXd found(reference.unknowns());
    int column = 0;
    for (const std::vector<Point2d>& image : step)
        for (const Point2d& vertex : image)
        {
            found[column++] = vertex.x;
            found[column++] = vertex.y;
        }
    CV_Assert(column == reference.unknowns());
    CV_Assert(reference.energy(found) <= (1 - SLACK) * reference.energy(exact));
}

/// The same matrix, block by block: a block is a row of vertices.
gcpw::BlockTridiagonal blocksOf(const Eigen::SparseMatrix<double>& lower, const gcpw::Lattice& lattice)
{
    const int size = 2 * (lattice.cols() + 1);
    gcpw::BlockTridiagonal blocks(lattice.rows() + 1, size);
    for (int col = 0; col < lower.cols(); ++col)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, col); entry; ++entry)
        {
            const int row = static_cast<int>(entry.row());
            Eigen::MatrixXd& block = row / size == col / size ? blocks.diagonal(col / size) : blocks.below(col / size);
            block(row % size, col % size) = entry.value();
        }
    return blocks;
}

PERF_TEST(Gcpw_BlockTridiagonal, factor_of_a_mesh)
{
    const PairProblem problem(false);
    SparseReference reference(problem, SparseReference::MESHES, DAMPING);
    const gcpw::BlockTridiagonal blocks = blocksOf(reference.lowerTriangle(), problem.lattices()[0]);
    Eigen::VectorXd x;
    bool solved = true;
    TEST_CYCLE()
    {
        gcpw::BlockTridiagonal factor = blocks;
        solved = factor.factorize() && solved;
        x = reference.right();
        factor.solve(x);
    }
    Eigen::VectorXd exact;
    CV_Assert(solved && reference.solve(exact) && (x - exact).norm() < 1e-6 * exact.norm());
    SANITY_CHECK_NOTHING();
}

PERF_TEST(Gcpw_BlockTridiagonal, sparse_factor_of_a_mesh)
{
    const PairProblem problem(false);
    SparseReference reference(problem, SparseReference::MESHES, DAMPING);
    Eigen::VectorXd step;
    TEST_CYCLE() reference.solve(step);
    CV_Assert(reference.solve(step));
    SANITY_CHECK_NOTHING();
}

void solveMeshes(const PairProblem& problem, gcpw::MeshSystem& system, gcpw::MeshStep& step)
{
    system.setZero();
    system.addDamping(DAMPING);
    problem.accumulate(system);
    CV_Assert(system.solve(step) == gcpw::SolveStatus::Solved);
}

PERF_TEST(Gcpw_MeshSystem, one_image)
{
    const ThreadCount threads(1);
    const PairProblem problem(false);
    gcpw::MeshSystem system(problem.lattices(), problem.fixed());
    gcpw::MeshStep step;
    TEST_CYCLE() solveMeshes(problem, system, step);
    SparseReference reference(problem, SparseReference::MESHES, DAMPING);
    checkMinimum(reference, step);
    SANITY_CHECK_NOTHING();
}

PERF_TEST(Gcpw_MeshSystem, two_tied_images)
{
    const ThreadCount threads(1);
    const PairProblem problem(true);
    gcpw::MeshSystem system(problem.lattices(), problem.fixed());
    gcpw::MeshStep step;
    TEST_CYCLE() solveMeshes(problem, system, step);
    SparseReference reference(problem, SparseReference::MESHES, DAMPING);
    checkMinimum(reference, step);
    SANITY_CHECK_NOTHING();
}

PERF_TEST(Gcpw_MeshSystem, sparse_factor_of_two_tied_images)
{
    const PairProblem problem(true);
    SparseReference reference(problem, SparseReference::MESHES, DAMPING);
    Eigen::VectorXd step;
    TEST_CYCLE() reference.solve(step);
    CV_Assert(reference.solve(step));
    SANITY_CHECK_NOTHING();
}

}} // namespace
