// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_MESH_SYSTEM_HPP
#define OPENCV_GCPW_MESH_SYSTEM_HPP

#include <memory>
#include <vector>
#include "solver/conjugate_gradient.hpp"
#include "solver/cross_matrix.hpp"
#include "solver/low_rank.hpp"
#include "solver/normal_equations.hpp"
#include "geometry/lattice.hpp"

namespace cv
{
namespace gcpw
{

class QuadMatrix;

/// One vertex step per vertex of every image; empty for an image that is fixed.
typedef std::vector<std::vector<Point2d>> MeshStep;

/** @brief Normal equations of all mesh vertices of all images (a Gauss-Newton step), assembled quad by quad.

Every term of GCPW lives in one quad of each image it meets. So the matrix is a sum of 8 x 8 blocks: those of one image
make a block-tridiagonal system, those between quads of two images tie them together. Images without ties are solved
directly, else conjugate gradients run over all images with each image's own factor as the preconditioner: work is linear
in overlapping pairs, memory in images. Colour is not known here (see JointSystem). */
class MeshSystem : public NormalEquations
{
public:
    /// @param lattices one per image  @param fixed images whose mesh does not move
    MeshSystem(const std::vector<Lattice>& lattices, const std::vector<bool>& fixed);
    ~MeshSystem() override;

    void setZero();
    void addRow(QuadId quad, const QuadRow& row, double residual, double weight) override;
    void addRow(QuadId a, const QuadRow& row_a, QuadId b, const QuadRow& row_b, double residual,
                double weight) override;
    void addBlock(QuadId quad, const QuadBlock& block, const QuadRow& gradient, double energy) override;
    void addGroup(int image, const RowGroup& group, const std::vector<double>& residuals, double weight) override;
    /// Takes the mesh part only.
    void addPhotometric(QuadId quad, const PhotometricBlock& block) override;
    /// Takes the mesh part only.
    void addCross(QuadId a, QuadId b, const CrossBlock& block) override;
    void addColorDifference(QuadId, QuadId, const ColorBlock&) override {} ///< not about meshes
    void addColorPrior(QuadId, double, const ColorGrid::Quad&) override {} ///< not about meshes

    /// weight * |step|^2 for every vertex: keeps motions finite that no term constrains.
    void addDamping(double weight);

    /** @brief Minimises the summed energy.
    @param step set unless NotPositiveDefinite is returned
    @param tolerance of conjugate gradients, where images are tied: share of the residual that may remain */
    SolveStatus solve(MeshStep& step, double tolerance = 1e-4);

private:
    /// What ties two images that both move.
    struct Tie
    {
        int a; ///< image of the rows
        int b; ///< image of the columns
        CrossMatrix matrix;
        bool used; ///< anything was added since setZero()
    };
    bool fixed(QuadId quad) const { return !matrices_[quad.image]; }
    void tie(QuadId a, QuadId b, const QuadBlock& block);
    bool isDirect() const; ///< the factors alone give the answer
    void multiply(const Eigen::VectorXd& in, Eigen::VectorXd& out) const;
    /// Calls work(image) for every image that moves, several at a time.
    template <typename Work>
    void forEachMoving(Work work) const;

    std::vector<Lattice> lattices_;
    std::vector<std::unique_ptr<QuadMatrix>> matrices_; ///< null where fixed
    std::vector<LowRank> groups_;                       ///< one per image: what the groups' own unknowns take off
    std::vector<int> offsets_;                          ///< first column of every image, and one past the last
    std::vector<Tie> ties_;
};

} // namespace gcpw
} // namespace cv

#endif
