// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_OVERLAP_SAMPLES_HPP
#define OPENCV_GCPW_OVERLAP_SAMPLES_HPP

#include <vector>
#include "geometry/lattice.hpp"
#include "imaging/pyramid.hpp"
#include "imaging/sampler.hpp"
#include "overlap/target_lookup.hpp"

namespace cv
{
namespace gcpw
{

/** @brief The pixels by which two images of one pyramid level are compared; the one place that reads them.

Samples are material points: every `step`-th pixel of the source level inside its mask, fixed in a quad of the source's
reference lattice, so that bilinear weights and sparsity never change. What the target shows at a sample depends on both meshes.
The photometric term, the correlation and the colour moments of an overlap all stand on visit(). */
class OverlapSamples
{
public:
    struct Sample
    {
        float weight[4];  ///< bilinear, of the corners of its quad
        float value[3];   ///< Y, Cr, Cb of the source, in [0, 1]
        float importance; ///< 0.01 / (v + f^2), v the variance of Y in 5 x 5 px and f the contrast floor; 1 without a floor
    };

    OverlapSamples() = default; ///< no samples

    /** @param source_image, target_image indices of the two images
    @param source, target their levels, of equal scale  @param lattice of the source
    @param step px of the level between samples, > 0
    @param contrast_floor f above, in [0, 1]; 0 lets all samples count alike
    @param target_shift canvas px by which the target is seen beside its own place (a canvas that wraps around) */
    OverlapSamples(int source_image, int target_image, const PyramidLevel& source, const PyramidLevel& target,
                   const Lattice& lattice, int step, double contrast_floor = 0, Point2d target_shift = Point2d());

    int sourceImage() const { return source_image_; }
    int targetImage() const { return target_image_; }
    const Lattice& lattice() const { return lattice_; }

    /// How the target is looked up in a state. @param want_cell whether visitors ask for the target's quad
    TargetLookup targetIn(const State& state, bool want_cell) const
    {
        return TargetLookup(state[target_image_], target_shift_, want_cell);
    }

    /** @brief Calls visit(sample, pixel) for the samples of a quad whose position lies inside the target.
    @param target from targetIn(state); during a call it is at the sample
    @param sampler samplePixel(), or sampleValue() where no gradient is asked for: they succeed at the same positions */
    template <typename Visit>
    void visit(const State& state, int cell, TargetLookup& target, Visit visit,
               bool (*sampler)(const PyramidLevel&, Point2d, PixelSample&) = sampleValue) const
    {
        const MeshGrid& mesh = state[source_image_].mesh;
        const Point2d corner[4] = {mesh.vertex(cell, 0), mesh.vertex(cell, 1), mesh.vertex(cell, 2), mesh.vertex(cell, 3)};
        if (!target.near(corner))
            return;
        PixelSample pixel;
        for (int i = first_[cell]; i < first_[cell + 1]; ++i)
        {
            const Sample& sample = samples_[i];
            Point2d canvas;
            for (int k = 0; k < 4; ++k)
            {
                canvas.x += sample.weight[k] * corner[k].x;
                canvas.y += sample.weight[k] * corner[k].y;
            }
            if (target.find(canvas) && sampler(target_, target.reference(), pixel))
                visit(sample, pixel);
        }
    }

private:
    int source_image_ = -1;
    int target_image_ = -1;
    PyramidLevel target_;
    Lattice lattice_;
    Point2d target_shift_;
    std::vector<Sample> samples_; ///< sorted by cell
    std::vector<int> first_;      ///< first sample of every cell, and one past the last
};

} // namespace gcpw
} // namespace cv

#endif
