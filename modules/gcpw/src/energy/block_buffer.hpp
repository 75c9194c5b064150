// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_BLOCK_BUFFER_HPP
#define OPENCV_GCPW_BLOCK_BUFFER_HPP

#include <vector>
#include <opencv2/core.hpp>
#include "energy/residual_sink.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Keeps the colour-carrying blocks poured into it, to be poured on later.

Several threads fill a buffer each; poured on in a fixed order, the sums are the same bits for any number of threads. */
class BlockBuffer : public ResidualSink
{
public:
    struct Colored
    {
        QuadId quad;
        ColoredBlock block;
    };
    struct Partner
    {
        QuadId a;
        QuadId b;
        PartnerBlock block;
    };

    /// Keeps its memory.
    void clear()
    {
        colored_.clear();
        partners_.clear();
    }

    void addColored(QuadId quad, const ColoredBlock& block) override { colored_.push_back({quad, block}); }
    void addPartner(QuadId a, QuadId b, const PartnerBlock& block) override { partners_.push_back({a, b, block}); }
    void addRow(QuadId, const QuadRow&, double, double) override { CV_DbgAssert(!NOT_KEPT); }
    void addRow(QuadId, const QuadRow&, QuadId, const QuadRow&, double, double) override { CV_DbgAssert(!NOT_KEPT); }
    void addBlock(QuadId, const QuadBlock&, const QuadRow&, double) override { CV_DbgAssert(!NOT_KEPT); }

    void pourInto(ResidualSink& sink) const
    {
        for (const Colored& item : colored_)
            sink.addColored(item.quad, item.block);
        for (const Partner& item : partners_)
            sink.addPartner(item.a, item.b, item.block);
    }

private:
    static constexpr const char* NOT_KEPT = "only blocks that carry colour are kept";

    std::vector<Colored> colored_;
    std::vector<Partner> partners_;
};

} // namespace gcpw
} // namespace cv

#endif
