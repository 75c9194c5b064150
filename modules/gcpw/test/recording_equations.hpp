// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_RECORDING_EQUATIONS_HPP
#define OPENCV_GCPW_TEST_RECORDING_EQUATIONS_HPP

#include "test_precomp.hpp"

#include <vector>
#include <Eigen/Core>
#include "solver/normal_equations.hpp"
#include "geometry/lattice.hpp"

namespace opencv_test
{

/** @brief Keeps all that terms accumulate, and lays it out as one dense problem: energy + 2 gradient . d + d^T matrix d.

Unknowns: the vertices of image 0 (x0 y0 x1 y1 ..), of image 1, .., then the colours of every quad of image 0 (gain Y,
bias Y, gain Cr, ..), of image 1, .. */
class RecordingEquations : public cv::gcpw::NormalEquations
{
public:
    struct Row
    {
        cv::gcpw::QuadId a;
        cv::gcpw::QuadRow row_a;
        cv::gcpw::QuadId b; ///< image -1: no second quad
        cv::gcpw::QuadRow row_b;
        double residual;
        double weight;
    };
    struct Block
    {
        cv::gcpw::QuadId quad;
        cv::gcpw::PhotometricBlock block;
    };
    struct Difference
    {
        cv::gcpw::QuadId a;
        cv::gcpw::QuadId b;
        cv::gcpw::ColorBlock block;
    };
    struct Prior
    {
        cv::gcpw::QuadId quad;
        double weight;
        cv::gcpw::ColorGrid::Quad reference;
    };
    struct Target
    {
        cv::gcpw::QuadId a;
        cv::gcpw::QuadId b;
        cv::gcpw::CrossBlock block;
    };

    struct Group
    {
        int image;
        std::vector<cv::gcpw::GroupRow> rows;
        std::vector<double> residuals;
        double weight;
    };

    explicit RecordingEquations(const std::vector<cv::gcpw::Lattice>& lattices);

    void addRow(cv::gcpw::QuadId quad, const cv::gcpw::QuadRow& row, double residual, double weight) override;
    void addRow(cv::gcpw::QuadId a, const cv::gcpw::QuadRow& row_a, cv::gcpw::QuadId b, const cv::gcpw::QuadRow& row_b,
                double residual, double weight) override;
    void addBlock(cv::gcpw::QuadId quad, const cv::gcpw::QuadBlock& block, const cv::gcpw::QuadRow& gradient,
                  double energy) override;
    void addGroup(int image, const cv::gcpw::RowGroup& group, const std::vector<double>& residuals, double weight) override;
    void addPhotometric(cv::gcpw::QuadId quad, const cv::gcpw::PhotometricBlock& block) override;
    void addCross(cv::gcpw::QuadId a, cv::gcpw::QuadId b, const cv::gcpw::CrossBlock& block) override;
    void addColorDifference(cv::gcpw::QuadId a, cv::gcpw::QuadId b, const cv::gcpw::ColorBlock& block) override;
    void addColorPrior(cv::gcpw::QuadId quad, double weight, const cv::gcpw::ColorGrid::Quad& reference) override;

    bool empty() const { return rows.empty() && blocks.empty() && targets.empty() && groups.empty(); }

    /// Column of coordinate k (0..7) of a quad.
    int meshColumn(cv::gcpw::QuadId quad, int k) const;
    /// Column of colour unknown k (0..5) of a quad.
    int colorColumn(cv::gcpw::QuadId quad, int k) const;
    int meshColumns() const { return mesh_columns_; }
    int columns() const { return columns_; }

    /// Energy of all that was accumulated: squared rows times their weight, and the blocks' own energy.
    double energy() const;
    Eigen::VectorXd gradient() const;
    Eigen::MatrixXd matrix() const;

    std::vector<Row> rows;
    std::vector<Block> blocks;
    std::vector<Group> groups;
    std::vector<Target> targets;
    std::vector<Difference> differences; ///< in the values of colours: not part of the dense problem
    std::vector<Prior> priors;           ///< likewise

private:
    /// Jacobian and, as its last column, residuals of a group, after the least squares over its own unknowns.
    Eigen::MatrixXd reduced(const Group& group) const;
    void addOwn(cv::gcpw::QuadId quad, const cv::gcpw::QuadBlock& mesh,
                const std::array<std::array<double, 3>, 3>& color, Eigen::MatrixXd& m) const;

    std::vector<cv::gcpw::Lattice> lattices_;
    std::vector<int> first_mesh_;
    std::vector<int> first_color_;
    int mesh_columns_ = 0;
    int columns_ = 0;
};

} // namespace opencv_test

#endif
