// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_EQUATION_BUFFER_HPP
#define OPENCV_GCPW_EQUATION_BUFFER_HPP

#include <vector>
#include "solver/normal_equations.hpp"

namespace cv
{
namespace gcpw
{

/** @brief Keeps what terms add, to be added to a system later.

Several threads fill a buffer each; added in a fixed order, the sums are the same bits for any number of threads. */
class EquationBuffer : public NormalEquations
{
public:
    struct Photometric
    {
        QuadId quad;
        PhotometricBlock block;
    };
    struct Cross
    {
        QuadId a;
        QuadId b;
        CrossBlock block;
    };

    /// Keeps its memory.
    void clear()
    {
        rows_.clear();
        blocks_.clear();
        groups_.clear();
        photometric_.clear();
        cross_.clear();
        differences_.clear();
        priors_.clear();
    }

    void addRow(QuadId quad, const QuadRow& row, double residual, double weight) override
    {
        rows_.push_back({quad, row, QuadId(), QuadRow(), residual, weight});
    }
    void addRow(QuadId a, const QuadRow& row_a, QuadId b, const QuadRow& row_b, double residual, double weight) override
    {
        rows_.push_back({a, row_a, b, row_b, residual, weight});
    }
    void addBlock(QuadId quad, const QuadBlock& block, const QuadRow& gradient, double energy) override
    {
        blocks_.push_back({quad, block, gradient, energy});
    }
    void addGroup(int image, const RowGroup& group, const std::vector<double>& residuals, double weight) override
    {
        groups_.push_back({image, &group, residuals, weight});
    }
    void addPhotometric(QuadId quad, const PhotometricBlock& block) override { photometric_.push_back({quad, block}); }
    void addCross(QuadId a, QuadId b, const CrossBlock& block) override { cross_.push_back({a, b, block}); }
    void addColorDifference(QuadId a, QuadId b, const ColorBlock& block) override { differences_.push_back({a, b, block}); }
    void addColorPrior(QuadId quad, double weight, const ColorGrid::Quad& reference) override
    {
        priors_.push_back({quad, weight, reference});
    }

    /// Adds all of it, kind by kind, each in the order it came.
    void addTo(NormalEquations& equations) const
    {
        for (const Row& item : rows_)
            if (item.b.image < 0)
                equations.addRow(item.a, item.row_a, item.residual, item.weight);
            else
                equations.addRow(item.a, item.row_a, item.b, item.row_b, item.residual, item.weight);
        for (const Block& item : blocks_)
            equations.addBlock(item.quad, item.block, item.gradient, item.energy);
        for (const Group& item : groups_)
            equations.addGroup(item.image, *item.group, item.residuals, item.weight);
        for (const Photometric& item : photometric_)
            equations.addPhotometric(item.quad, item.block);
        for (const Cross& item : cross_)
            equations.addCross(item.a, item.b, item.block);
        for (const Difference& item : differences_)
            equations.addColorDifference(item.a, item.b, item.block);
        for (const Prior& item : priors_)
            equations.addColorPrior(item.quad, item.weight, item.reference);
    }

private:
    struct Row
    {
        QuadId a;
        QuadRow row_a;
        QuadId b; ///< image -1: no second quad
        QuadRow row_b;
        double residual;
        double weight;
    };
    struct Block
    {
        QuadId quad;
        QuadBlock block;
        QuadRow gradient;
        double energy;
    };
    struct Group
    {
        int image;
        const RowGroup* group;
        std::vector<double> residuals;
        double weight;
    };
    struct Difference
    {
        QuadId a;
        QuadId b;
        ColorBlock block;
    };
    struct Prior
    {
        QuadId quad;
        double weight;
        ColorGrid::Quad reference;
    };

    std::vector<Row> rows_;
    std::vector<Block> blocks_;
    std::vector<Group> groups_;
    std::vector<Photometric> photometric_;
    std::vector<Cross> cross_;
    std::vector<Difference> differences_;
    std::vector<Prior> priors_;
};

} // namespace gcpw
} // namespace cv

#endif
