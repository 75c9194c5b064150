// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_MESH_SYSTEM_HPP
#define OPENCV_GCPW_MESH_SYSTEM_HPP

#include <memory>
#include <vector>
#include "energy/residual_sink.hpp"
#include "geometry/lattice.hpp"

namespace cv
{
namespace gcpw
{

/// One vertex step per vertex of every image; empty for an image that is held.
typedef std::vector<std::vector<Point2d>> MeshStep;

enum class SolveStatus
{
    Solved,
    NotPositiveDefinite, ///< the data and the regularisers leave a motion free, or are not finite
    NotConverged         ///< the iteration over coupled images ran out; the step is still a descent step
};

/** @brief Normal equations of all mesh vertices of all images (a Gauss-Newton step), assembled quad by quad.

Every term of GCPW lives in one quad, so the matrix is a sum of 8 x 8 blocks; an image is a block-tridiagonal system
and images are tied by cross blocks of quad pairs. Colour unknowns are eliminated before they get here (ColorSystem). */
class MeshSystem : public ResidualSink
{
public:
    /// @param lattices one per image  @param held images whose mesh does not move
    MeshSystem(const std::vector<Lattice>& lattices, const std::vector<bool>& held);
    ~MeshSystem() override;

    void setZero();
    void addRow(QuadId quad, const QuadRow& row, double residual, double weight) override;
    void addRow(QuadId a, const QuadRow& row_a, QuadId b, const QuadRow& row_b, double residual,
                double weight) override;
    void addBlock(QuadId quad, const QuadBlock& block, const QuadRow& gradient, double energy) override;
    void addColored(QuadId quad, const ColoredBlock& block) override;
    void addCross(QuadId a, QuadId b, const QuadBlock& block) override;

    /// weight * |step of vertex|^2 for every vertex of every moving image: keeps motions finite that no term feels.
    void addDamping(double weight);

    /// Minimises the summed energy; `step` is set unless NotPositiveDefinite is returned.
    SolveStatus solve(MeshStep& step);

private:
    struct Image;
    struct Cross;

    std::vector<Image> images_;
    std::vector<Cross> cross_;
};

} // namespace gcpw
} // namespace cv

#endif
