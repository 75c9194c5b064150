// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_EQUATION_BUFFER_HPP
#define OPENCV_GCPW_EQUATION_BUFFER_HPP

#include <vector>
#include <opencv2/core.hpp>
#include "solver/normal_equations.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Keeps the colour-carrying blocks accumulated into it, to be accumulated on later.

Several threads fill a buffer each; accumulated on in a fixed order, the sums are the same bits for any number of threads. */
class EquationBuffer : public NormalEquations
{
public:
    struct Photometric
    {
        QuadId quad;
        PhotometricBlock block;
    };
    struct Partner
    {
        QuadId a;
        QuadId b;
        CrossBlock block;
    };

    /// Keeps its memory.
    void clear()
    {
        photometric_.clear();
        targets_.clear();
    }

    void addPhotometric(QuadId quad, const PhotometricBlock& block) override { photometric_.push_back({quad, block}); }
    void addCross(QuadId a, QuadId b, const CrossBlock& block) override { targets_.push_back({a, b, block}); }
    void addRow(QuadId, const QuadRow&, double, double) override { CV_DbgAssert(!NOT_KEPT); }
    void addRow(QuadId, const QuadRow&, QuadId, const QuadRow&, double, double) override { CV_DbgAssert(!NOT_KEPT); }
    void addBlock(QuadId, const QuadBlock&, const QuadRow&, double) override { CV_DbgAssert(!NOT_KEPT); }

    void addTo(NormalEquations& equations) const
    {
        for (const Photometric& item : photometric_)
            equations.addPhotometric(item.quad, item.block);
        for (const Partner& item : targets_)
            equations.addCross(item.a, item.b, item.block);
    }

private:
    static constexpr const char* NOT_KEPT = "only blocks that carry colour are kept";

    std::vector<Photometric> photometric_;
    std::vector<Partner> targets_;
};

} // namespace gcpw
} // namespace cv

#endif
