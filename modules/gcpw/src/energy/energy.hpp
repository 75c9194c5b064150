// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_ENERGY_HPP
#define OPENCV_GCPW_ENERGY_HPP

#include <memory>
#include <vector>
#include "energy/energy_term.hpp"
#include "opencv2/gcpw/alignment.hpp"
#include "solver/equation_buffer.hpp"

namespace cv
{
namespace gcpw
{

/** @brief The sum of terms that is minimised. Threads work on parts of terms side by side; every sum has one order,
whatever their number. */
class Energy
{
public:
    void add(std::unique_ptr<EnergyTerm> term) { terms_.push_back(std::move(term)); }

    /// By name, in the order in which the names were added.
    std::vector<TermEnergy> evaluate(const State& state) const;

    /// The same; adds the rows and blocks of all terms to the equations.
    std::vector<TermEnergy> linearize(const State& state, NormalEquations& equations);

private:
    struct Part
    {
        size_t term;
        int part;
    };
    std::vector<Part> partsOfAll() const;
    std::vector<TermEnergy> sumByName(const std::vector<Part>& parts, const std::vector<double>& values) const;

    std::vector<std::unique_ptr<EnergyTerm>> terms_;
    std::vector<EquationBuffer> buffers_; ///< of the parts that are worked on at once
};

} // namespace gcpw
} // namespace cv

#endif
