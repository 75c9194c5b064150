// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_NORMAL_EQUATIONS_HPP
#define OPENCV_GCPW_NORMAL_EQUATIONS_HPP

#include <array>
#include <vector>
#include "model/color_grid.hpp"
#include "solver/row_group.hpp"

namespace cv
{
namespace gcpw
{

/// One quad of one image.
struct QuadId
{
    int image = -1;
    int cell = -1;
};

/// A symmetric 8 x 8 block over the same unknowns; only its upper triangle is used unless said otherwise.
typedef std::array<std::array<double, 8>, 8> QuadBlock;

/// Symmetric 2 x 2 block over (gain, bias) of one channel.
struct ColorBlock
{
    double gain_gain = 0;
    double gain_bias = 0;
    double bias_bias = 0;
};

const int COLOR_UNKNOWNS = 2 * CHANNELS; ///< of a quad: gain, bias per channel

/// What the samples of one quad say about its colour.
struct SampleColor
{
    std::array<std::array<double, 3>, CHANNELS> color_color{};    ///< per channel: gain-gain, gain-bias, bias-bias
    std::array<std::array<double, 2>, CHANNELS> color_gradient{}; ///< per channel: J_color^T r
};

/** @brief What the photometric samples of one quad say about its mesh and its colour, summed up (normal form).

Mesh unknowns are ordered as in QuadRow, colour unknowns gain, bias per channel. */
struct PhotometricBlock : SampleColor
{
    QuadBlock mesh_mesh{};                                             ///< upper triangle
    QuadRow mesh_gradient{};                                           ///< J^T r
    std::array<std::array<double, COLOR_UNKNOWNS>, 8> mesh_color{};    ///< J_mesh^T J_color
    double energy = 0;
    int samples = 0;
};

/// What the same samples say about the colour of one quad of the target.
struct CrossColor
{
    std::array<std::array<double, 4>, CHANNELS> color_cross{};    ///< per channel: gain-gain', gain-bias', bias-gain', bias-bias'
    std::array<std::array<double, 3>, CHANNELS> color_color{};    ///< of the target
    std::array<std::array<double, 2>, CHANNELS> color_gradient{}; ///< of the target
};

/// What the same samples say about one quad of the target, where that moves too.
struct CrossBlock : CrossColor
{
    QuadBlock cross{};       ///< J_mesh^T J_target_mesh, all 64 numbers
    QuadBlock mesh_mesh{};   ///< of the target, upper triangle
    QuadRow mesh_gradient{}; ///< of the target
};

/// Receives quadratic energies of mesh vertices. Rows of an image that is fixed are dropped by the receiver.
class MeshEquations
{
public:
    virtual ~MeshEquations() = default;

    /// weight * (residual + row . d)^2
    virtual void addRow(QuadId quad, const QuadRow& row, double residual, double weight) = 0;

    /// weight * (residual + row_a . d_a + row_b . d_b)^2
    virtual void addRow(QuadId a, const QuadRow& row_a, QuadId b, const QuadRow& row_b, double residual,
                        double weight) = 0;

    /// energy + 2 gradient . d + d^T block d
    virtual void addBlock(QuadId quad, const QuadBlock& block, const QuadRow& gradient, double energy) = 0;

    /** @brief The least of weight * sum_k (residual_k + row_k . d + shared_k . z)^2 over z, the unknowns of the group alone.
    @param group outlives the equations' use of it  @param residuals one for each row, as RowGroup::project() leaves them */
    virtual void addGroup(int image, const RowGroup& group, const std::vector<double>& residuals, double weight) = 0;
};

/// Receives quadratic energies of colours, in their values rather than in a step from the present ones.
class ColorEquations
{
public:
    virtual ~ColorEquations() = default;

    /// (color_a - color_b)^T block (color_a - color_b) in every channel
    virtual void addColorDifference(QuadId a, QuadId b, const ColorBlock& block) = 0;

    /// weight * ((gain - reference gain)^2 + (bias - reference bias)^2) in every channel
    virtual void addColorPrior(QuadId quad, double weight, const ColorGrid::Quad& reference) = 0;
};

/** @brief The normal equations of a Gauss-Newton step on meshes and colours: where terms add their squared residuals, as rows or
as small summed blocks.

A term never learns what becomes of them; tests put a recorder in the place of a solver. */
class NormalEquations : public MeshEquations, public ColorEquations
{
public:
    /// Photometric samples of a quad; its mesh and its colour are the unknowns.
    virtual void addPhotometric(QuadId quad, const PhotometricBlock& block) = 0;

    /// The target's side of samples whose own side went to addPhotometric(a, ..).
    virtual void addCross(QuadId a, QuadId b, const CrossBlock& block) = 0;
};

} // namespace gcpw
} // namespace cv

#endif
