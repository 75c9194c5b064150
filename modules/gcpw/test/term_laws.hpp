// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_TERM_LAWS_HPP
#define OPENCV_GCPW_TEST_TERM_LAWS_HPP

#include "test_precomp.hpp"

#include <functional>
#include <memory>
#include <vector>
#include "energy/energy_term.hpp"
#include "model/color_grid.hpp"
#include "model/mesh_grid.hpp"
#include "recording_equations.hpp"
#include "seeded.hpp"

namespace opencv_test
{

/// Meshes and colours of all images: what an energy is a function of.
struct TermState
{
    std::vector<cv::gcpw::MeshGrid> meshes;
    std::vector<cv::gcpw::ColorGrid> colors;

    explicit TermState(const std::vector<cv::gcpw::MeshGrid>& all) : meshes(all)
    {
        for (const cv::gcpw::MeshGrid& mesh : all)
            colors.emplace_back(mesh.lattice());
    }

    std::vector<cv::gcpw::Lattice> lattices() const
    {
        std::vector<cv::gcpw::Lattice> all;
        for (const cv::gcpw::MeshGrid& mesh : meshes)
            all.push_back(mesh.lattice());
        return all;
    }

    cv::gcpw::State state() const
    {
        cv::gcpw::State all;
        for (size_t i = 0; i < meshes.size(); ++i)
            all.push_back({meshes[i], colors[i]});
        return all;
    }

    /// The state displaced by `d`, whose columns are those of RecordingEquations.
    TermState moved(const Eigen::VectorXd& d) const
    {
        TermState next = *this;
        Eigen::Index k = 0;
        for (cv::gcpw::MeshGrid& mesh : next.meshes)
            for (Point2d& vertex : mesh.vertices())
            {
                vertex.x += d[k++];
                vertex.y += d[k++];
            }
        for (cv::gcpw::ColorGrid& grid : next.colors)
            for (int cell = 0; cell < grid.lattice().cellCount(); ++cell)
                for (cv::gcpw::ChannelAffine& map : grid.quad(cell))
                {
                    map.gain += d[k++];
                    map.bias += d[k++];
                }
        return next;
    }
};

/// Accumulates a term at a state and returns the energy it reports.
typedef std::function<double(const TermState&, cv::gcpw::NormalEquations&)> LinearizeTerm;

/// A random displacement of the unknowns [first, last) of a equations, of unit length per unknown, zero elsewhere.
/// A term as the laws below take it. Along the way: what the line search evaluates is what was linearised.
inline LinearizeTerm linearizing(const std::shared_ptr<cv::gcpw::EnergyTerm>& term)
{
    return [term](const TermState& at, cv::gcpw::NormalEquations& equations)
    {
        const cv::gcpw::State state = at.state();
        const double energy = term->linearize(state, equations);
        const double value = term->evaluate(state);
        EXPECT_TRUE(std::isnan(energy) ? std::isnan(value) : std::abs(value - energy) <= 1e-9 * std::max(1.0, std::abs(energy)))
            << value << " is evaluated, " << energy << " linearised";
        return energy;
    };
}

/// The same in parts.
inline LinearizeTerm linearizingParts(const std::shared_ptr<cv::gcpw::EnergyTerm>& term)
{
    return [term](const TermState& at, cv::gcpw::NormalEquations& equations)
    {
        double energy = 0;
        for (int part = 0; part < term->parts(); ++part)
            energy += term->linearizePart(at.state(), part, equations);
        return energy;
    };
}

inline Eigen::VectorXd randomMotion(const RecordingEquations& equations, int first, int last, uint64_t seed)
{
    RNG rng = seeded(seed);
    Eigen::VectorXd d = Eigen::VectorXd::Zero(equations.columns());
    for (int k = first; k < last; ++k)
        d[k] = rng.uniform(-1.0, 1.0);
    return d;
}

/** @brief The gradient that a term accumulates is the slope of the energy it reports, along random motions of the unknowns
[first, last).
@param step of the central difference  @param tolerance relative to the steepest of all slopes */
inline void expectGradientIsSlope(const LinearizeTerm& accumulate, const TermState& state, int first, int last, double step,
                                  double tolerance)
{
    RecordingEquations equations(state.lattices());
    accumulate(state, equations);
    const Eigen::VectorXd gradient = 2 * equations.gradient();
    ASSERT_GT(gradient.segment(first, last - first).norm(), 0) << "nothing to differentiate";
    for (int trial = 0; trial < 20; ++trial)
    {
        const Eigen::VectorXd d = randomMotion(equations, first, last, trial);
        RecordingEquations ignored(state.lattices());
        const double high = accumulate(state.moved(step * d), ignored);
        const double low = accumulate(state.moved(-step * d), ignored);
        EXPECT_NEAR((high - low) / (2 * step), gradient.dot(d),
                    tolerance * gradient.segment(first, last - first).norm())
            << "trial " << trial;
    }
}

/** @brief What a term accumulates says its energy at every other state too: energy + 2 gradient . d + d^T matrix d.

True where residuals are linear and the loss is the square: then it holds every Jacobian to account.
@param size of the random displacement of each unknown  @param tolerance relative to the energy there */
inline void expectExactlyQuadratic(const LinearizeTerm& accumulate, const TermState& state, int first, int last, double size,
                                   double tolerance)
{
    RecordingEquations equations(state.lattices());
    const double energy = accumulate(state, equations);
    const Eigen::VectorXd gradient = equations.gradient();
    const Eigen::MatrixXd matrix = equations.matrix();
    double change = 0;
    for (int trial = 0; trial < 10; ++trial)
    {
        const Eigen::VectorXd d = size * randomMotion(equations, first, last, trial);
        RecordingEquations ignored(state.lattices());
        const double expected = energy + 2 * gradient.dot(d) + d.dot(matrix * d);
        const double found = accumulate(state.moved(d), ignored);
        EXPECT_NEAR(found, expected, tolerance * found) << "trial " << trial;
        change = std::max(change, std::abs(found - energy));
    }
    EXPECT_GT(change, 100 * tolerance * energy) << "nothing changes";
}

/// The energy that a term reports is what the accumulated rows and blocks add up to.
inline void expectEnergyIsSumOfRows(const LinearizeTerm& accumulate, const TermState& state)
{
    RecordingEquations equations(state.lattices());
    const double energy = accumulate(state, equations);
    EXPECT_GT(energy, 0);
    EXPECT_NEAR(equations.energy(), energy, 1e-9 * energy);
}

} // namespace opencv_test

#endif
