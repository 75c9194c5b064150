// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_NORMAL_EQUATIONS_HPP
#define OPENCV_GCPW_NORMAL_EQUATIONS_HPP

#include <array>

namespace cv
{
namespace gcpw
{

/// A quad of the mesh of an image.
struct QuadId
{
    int image = -1;
    int cell = -1;
};

/// Derivatives by the eight vertex coordinates of one quad: x0 y0 x1 y1 x2 y2 x3 y3, corners in lattice order.
typedef std::array<double, 8> QuadRow;

/// Normal block over the eight vertex coordinates of one quad; only the upper triangle (row <= column) is read.
typedef std::array<std::array<double, 8>, 8> QuadBlock;

/** @brief Everything the colour-carrying samples of one quad say, already summed up (normal form).

Colour unknowns are ordered gain, bias per channel: six numbers. Mesh unknowns as in QuadRow. */
struct PhotometricBlock
{
    QuadBlock mesh_mesh{};                                 ///< upper triangle
    QuadRow mesh_gradient{};                               ///< J^T r
    std::array<std::array<double, 6>, 8> mesh_color{};     ///< J_mesh^T J_color
    std::array<std::array<double, 3>, 3> color_color{};    ///< per channel: gain-gain, gain-bias, bias-bias
    std::array<std::array<double, 2>, 3> color_gradient{}; ///< per channel: J_color^T r
    double energy = 0;
    int samples = 0;
};

/** @brief What the same samples say about the colour of one quad of the image they are compared with. */
struct CrossColor
{
    std::array<std::array<double, 4>, 3> color_cross{};    ///< per channel: gain-gain', gain-bias', bias-gain', bias-bias'
    std::array<std::array<double, 3>, 3> color_color{};    ///< of the target
    std::array<std::array<double, 2>, 3> color_gradient{}; ///< of the target
};

/** @brief What the same samples say about one quad of the image they are compared with, where that moves too. */
struct CrossBlock : CrossColor
{
    QuadBlock cross{};       ///< J_mesh^T J_partner_mesh, all 64 numbers
    QuadBlock mesh_mesh{};   ///< of the target, upper triangle
    QuadRow mesh_gradient{}; ///< of the target
};

/** @brief Where terms accumulate what they know: weighted squared residuals, as rows or as small summed blocks.

A term never learns what becomes of them. Rows of an image that is fixed are dropped by the receiver. */
class NormalEquations
{
public:
    virtual ~NormalEquations() = default;

    /// weight * (residual + row . d)^2
    virtual void addRow(QuadId quad, const QuadRow& row, double residual, double weight) = 0;

    /// weight * (residual + row_a . d_a + row_b . d_b)^2
    virtual void addRow(QuadId a, const QuadRow& row_a, QuadId b, const QuadRow& row_b, double residual,
                        double weight) = 0;

    /// energy + 2 gradient . d + d^T block d
    virtual void addBlock(QuadId quad, const QuadBlock& block, const QuadRow& gradient, double energy) = 0;

    /// The same with the colour of that quad as further unknowns.
    virtual void addPhotometric(QuadId quad, const PhotometricBlock& block) = 0;

    /// The target's side of samples whose own side went to addPhotometric(a, ..).
    virtual void addCross(QuadId a, QuadId b, const CrossBlock& block) = 0;
};

/// Takes everything and keeps nothing: for energies alone.
class NullEquations : public NormalEquations
{
public:
    void addRow(QuadId, const QuadRow&, double, double) override {}
    void addRow(QuadId, const QuadRow&, QuadId, const QuadRow&, double, double) override {}
    void addBlock(QuadId, const QuadBlock&, const QuadRow&, double) override {}
    void addPhotometric(QuadId, const PhotometricBlock&) override {}
    void addCross(QuadId, QuadId, const CrossBlock&) override {}
};

} // namespace gcpw
} // namespace cv

#endif
