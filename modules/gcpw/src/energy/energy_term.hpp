// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_ENERGY_TERM_HPP
#define OPENCV_GCPW_ENERGY_TERM_HPP

#include "model/image_state.hpp"
#include "solver/normal_equations.hpp"

namespace cv
{
namespace gcpw
{

/** @brief One energy of the sum that is minimised (eq. totalfunction): a weighted sum of squared, perhaps robust residuals.

A new term is a class in a file of its own, a line in buildEnergy(), a weight in Params and a test. It knows the state and the
equations, and neither the optimiser nor the solver. */
class EnergyTerm
{
public:
    virtual ~EnergyTerm() = default;

    /// What reports call it; the energies of terms of one name are added up.
    virtual const char* name() const = 0;

    /// The value at a state, as the line search compares it: of the function that the last linearize() stands for.
    virtual double evaluate(const State& state) const = 0;

    /** @brief Adds rows or blocks of a Gauss-Newton step from a state, and returns the value there.

    A term that re-weights its residuals (iteratively re-weighted least squares beyond a RobustLoss) chooses its weights here and
    keeps them until the next call, so that the step and its line search see one function. */
    virtual double linearize(const State& state, NormalEquations& equations) = 0;

    /// @name Parts that threads may work on side by side; a term of one part need not know of them
    /// @{
    virtual int parts() const { return 1; }
    virtual double evaluatePart(const State& state, int part) const
    {
        CV_DbgAssert(part == 0);
        return part == 0 ? evaluate(state) : 0;
    }
    virtual double linearizePart(const State& state, int part, NormalEquations& equations)
    {
        CV_DbgAssert(part == 0);
        return part == 0 ? linearize(state, equations) : 0;
    }
    /// @}
};

} // namespace gcpw
} // namespace cv

#endif
