// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "energy/energy.hpp"

#include <algorithm>
#include <opencv2/core/utility.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const int PARTS_AT_ONCE = 32; ///< linearised into buffers before these are emptied: bounds the memory

} // namespace

double totalEnergy(const std::vector<TermEnergy>& energies)
{
    double total = 0;
    for (const TermEnergy& energy : energies)
        total += energy.value;
    return total;
}

std::vector<Energy::Part> Energy::partsOfAll() const
{
    std::vector<Part> parts;
    for (size_t k = 0; k < terms_.size(); ++k)
        for (int part = 0; part < terms_[k]->parts(); ++part)
            parts.push_back({k, part});
    return parts;
}

std::vector<TermEnergy> Energy::sumByName(const std::vector<Part>& parts, const std::vector<double>& values) const
{
    std::vector<TermEnergy> sums;
    for (size_t i = 0; i < parts.size(); ++i)
    {
        const char* name = terms_[parts[i].term]->name();
        auto found = std::find_if(sums.begin(), sums.end(), [name](const TermEnergy& sum) { return sum.name == name; });
        if (found == sums.end())
            found = sums.insert(found, TermEnergy(name));
        found->value += values[i];
    }
    return sums;
}

std::vector<TermEnergy> Energy::evaluate(const State& state) const
{
    const std::vector<Part> parts = partsOfAll();
    std::vector<double> values(parts.size());
    parallel_for_(Range(0, static_cast<int>(parts.size())), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; ++i)
            values[i] = terms_[parts[i].term]->evaluatePart(state, parts[i].part);
    });
    return sumByName(parts, values);
}

std::vector<TermEnergy> Energy::linearize(const State& state, NormalEquations& equations)
{
    const std::vector<Part> parts = partsOfAll();
    std::vector<double> values(parts.size());
    std::vector<size_t> shared; // parts of terms that threads work on side by side
    for (size_t i = 0; i < parts.size(); ++i)
    {
        EnergyTerm& term = *terms_[parts[i].term];
        if (term.parts() > 1)
            shared.push_back(i);
        else
            values[i] = term.linearize(state, equations); // quick: not worth a buffer
    }
    buffers_.resize(PARTS_AT_ONCE);
    for (size_t first = 0; first < shared.size(); first += PARTS_AT_ONCE)
    {
        const int count = static_cast<int>(std::min(shared.size() - first, static_cast<size_t>(PARTS_AT_ONCE)));
        parallel_for_(Range(0, count), [&](const Range& range)
        {
            for (int i = range.start; i < range.end; ++i)
            {
                const Part& part = parts[shared[first + i]];
                buffers_[i].clear();
                values[shared[first + i]] = terms_[part.term]->linearizePart(state, part.part, buffers_[i]);
            }
        }, count);
        for (int i = 0; i < count; ++i)
            buffers_[i].addTo(equations);
    }
    return sumByName(parts, values);
}

} // namespace gcpw
} // namespace cv
