// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_SCENE_HPP
#define OPENCV_GCPW_TEST_SCENE_HPP

#include "test_precomp.hpp"

#include <array>
#include <cstdint>
#include <vector>
#include "geometry/matches.hpp"
#include "model/mesh_grid.hpp"
#include "seeded.hpp"

namespace opencv_test
{

/** @brief A picture that is a formula: colour at any canvas point, so that images of it are sampled exactly.

Smooth blobs of several sizes (keypoints), soft-edged bars (line segments) and a few long waves, none finer than about
2 px, so that bilinear sampling hardly errs. */
class Texture
{
public:
    explicit Texture(uint64_t seed) : seed_(seed) {}

    /// B, G, R in [0.25, 0.6]: room for every gain in 0.6..1.4 and bias in +-0.15 without clipping.
    Vec3d at(Point2d canvas_px) const;

private:
    uint64_t seed_;
};

/// A shift to the right, a slight turn and a slight zoom.
Matx33d slightHomography(double shift_px);

/// What a scene is made of. The canvas is the target's frame.
struct SceneOptions
{
    Size source_size{480, 360};
    Size target_size{480, 360};
    uint64_t seed = 1;                    ///< of the texture
    uint64_t warp_seed = 1;               ///< of displacement and colours
    Matx33d rough = slightHomography(96); ///< the global part of the warp
    double displacement_px = 8;           ///< largest length of the smooth displacement added to it
    int mesh_cells = 0;     ///< if > 0, the displacement is that of a bilinear mesh of this many quads a side
    bool recolored = false; ///< gain 0.6..1.4 and bias +-0.15, both varying over the source
    bool tinted = false;    ///< if recolored: each of B, G, R has gain and bias of its own
    double noise = 0;       ///< gray levels, standard deviation, in both images
    bool occluder = false;  ///< a disc in front of the source and another in front of the target
};

/// 320 x 240 px, for tests that ask for speed more than for accuracy.
SceneOptions smallScene();

/** @brief A source and a target photograph and all that is true about them.

Noise and occluders are in the images only, never in the truth. */
class Scene
{
public:
    explicit Scene(const SceneOptions& options);

    const Mat& source() const { return source_; } ///< CV_8UC3
    const Mat& target() const { return target_; } ///< CV_8UC3

    /// Where a source pixel lies on the canvas.
    Point2d canvasAt(Point2d source_px) const;

    /// The gain and the bias that made the source's colours of the texture's: source = gain * texture + bias; B, G, R.
    void colorAt(Point2d source_px, Vec3d& gain, Vec3d& bias) const;

    /// Matches of source (a) and target (b), spread evenly over the overlap.
    std::vector<gcpw::PointMatch> pointMatches(int count, uint64_t seed, double jitter_px = 0,
                                               double outlier_share = 0) const;

    /// Straight in the target; the source's target is the chord of what the warp makes of it.
    std::vector<gcpw::LineMatch> lineMatches(int count, uint64_t seed, double outlier_share = 0) const;

    /// Mean distance, canvas px, of a mesh from the truth over the source pixels that the target shows too.
    double meanError(const Mat& mesh) const;

    /// Whether a canvas point is at least `margin` px inside the target.
    bool insideTarget(Point2d canvas_px, double margin = 0) const;

private:
    Point2d smoothCanvasAt(Point2d source_px) const;
    Point2d sourceAt(Point2d canvas_px) const;
    void paint();
    void spoil(Mat& image, Point2d disc, uint64_t seed) const;

    SceneOptions options_;
    Texture texture_;
    std::array<double, 24> phases_{};
    gcpw::MeshGrid mesh_;
    Mat source_;
    Mat target_;
};

} // namespace opencv_test

#endif
