// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TARGET_LOOKUP_HPP
#define OPENCV_GCPW_TARGET_LOOKUP_HPP

#include <algorithm>
#include <cmath>
#include "imaging/sampler.hpp"
#include "model/image_state.hpp"

namespace cv
{
namespace gcpw
{

/// Finds the target's pixel under a canvas point, with a short cut for an undeformed target, in which no quad has to be searched.
class TargetLookup
{
public:
    /** @param state of the target; must outlive the lookup  @param shift canvas px by which it is seen beside its own place
    @param want_cell whether point() and the colour of its quad are needed */
    TargetLookup(const ImageState& state, Point2d shift, bool want_cell)
        : state_(state), shift_(shift), is_translation_(state.mesh.isTranslation(origin_)),
          want_cell_(want_cell || !state.color.isIdentity()), bounds_(state.mesh.bounds())
    {
        point_.cell = 0;
        bounds_ += shift;
    }

    /// Whether a quad of the source can meet the target at all.
    bool near(const Point2d (&corner)[4]) const
    {
        const auto x = std::minmax({corner[0].x, corner[1].x, corner[2].x, corner[3].x});
        const auto y = std::minmax({corner[0].y, corner[1].y, corner[2].y, corner[3].y});
        return x.second >= bounds_.x && x.first <= bounds_.br().x && y.second >= bounds_.y && y.first <= bounds_.br().y;
    }

    bool find(Point2d canvas)
    {
        if (is_translation_)
        {
            reference_ = canvas - shift_ - origin_;
            if (!state_.mesh.lattice().contains(reference_))
                return false;
            if (want_cell_)
                point_ = state_.mesh.lattice().locate(reference_);
            return true;
        }
        // A search that ends outside the mesh is slow, and many pixels lie outside its box.
        if (!bounds_.contains(canvas) || !state_.mesh.invert(canvas - shift_, hint_, point_))
            return false;
        reference_ = state_.mesh.lattice().referencePoint(point_);
        return true;
    }
    Point2d reference() const { return reference_; }
    const CellPoint& point() const { return point_; }
    const ColorGrid::Quad& color() const { return state_.color.quad(point_.cell); }

    /** @brief d / d canvas of the corrected target at the point found, from its gradient in the reference frame.

    A quad without area has no inverse; there the gradient is zero, so that the sample moves no vertex. */
    void gradient(const PixelSample& pixel, double* gx, double* gy) const
    {
        for (int c = 0; c < CHANNELS; ++c)
        {
            gx[c] = color()[c].gain * pixel.dx[c];
            gy[c] = color()[c].gain * pixel.dy[c];
        }
        if (is_translation_)
            return;
        const Matx22d inverse = inverseOf(state_.mesh.jacobian(point_));
        for (int c = 0; c < CHANNELS; ++c)
        {
            const double dx = gx[c];
            const double dy = gy[c];
            gx[c] = dx * inverse(0, 0) + dy * inverse(1, 0);
            gy[c] = dx * inverse(0, 1) + dy * inverse(1, 1);
        }
    }

private:
    static Matx22d inverseOf(const Matx22d& m)
    {
        const double determinant = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
        if (!(std::abs(determinant) > FLAT * m.dot(m)))
            return Matx22d::zeros();
        return (1 / determinant) * Matx22d(m(1, 1), -m(0, 1), -m(1, 0), m(0, 0));
    }

    /// Area of a quad over the square of its size, below which it is a line to rounding.
    static constexpr double FLAT = 1e-12;

    const ImageState& state_;
    Point2d shift_;
    Point2d origin_;
    bool is_translation_;
    bool want_cell_;
    Rect2d bounds_; ///< of the target's mesh on the canvas
    int hint_ = -1;
    Point2d reference_;
    CellPoint point_;
};

} // namespace gcpw
} // namespace cv

#endif
