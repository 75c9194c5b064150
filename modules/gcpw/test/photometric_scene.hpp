// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_PHOTOMETRIC_SCENE_HPP
#define OPENCV_GCPW_TEST_PHOTOMETRIC_SCENE_HPP

#include "test_precomp.hpp"

#include <functional>
#include "bent_mesh.hpp"
#include "term_laws.hpp"
#include "energy/photometric_term.hpp"

namespace opencv_test
{

const cv::gcpw::Lattice SOURCE(Size(60, 45), 4, 3);
const cv::gcpw::Lattice TARGET(Size(120, 90), 5, 4);
const double WEIGHT = 100;
const int SOURCE_MESH = 2 * SOURCE.vertexCount();

typedef std::function<double(Point2d reference_px, int channel)> Picture;

/// A level whose pixels show a picture exactly, at their reference positions; inside everywhere.
inline cv::gcpw::PyramidLevel levelOf(const cv::gcpw::Lattice& lattice, double scale, const Picture& picture)
{
    cv::gcpw::PyramidLevel level;
    level.scale = scale;
    level.pixels.create(cvRound(lattice.imageSize().height / scale), cvRound(lattice.imageSize().width / scale),
                        CV_32FC4);
    for (int y = 0; y < level.pixels.rows; ++y)
        for (int x = 0; x < level.pixels.cols; ++x)
            for (int c = 0; c < 4; ++c)
                level.pixels.at<Vec4f>(y, x)[c] =
                    c == 3 ? 1.0F : static_cast<float>(picture(Point2d(x * scale, y * scale), c));
    return level;
}

/// Bilinear sampling reads a ramp without error, and residuals are then linear in all unknowns.
inline double ramp(Point2d p, int c)
{
    return 0.2 + 0.003 * (c + 1) * p.x + 0.004 * (2 - c) * p.y;
}

/// Waves so long that bilinear sampling hardly errs.
inline double waves(Point2d p, int c)
{
    return 0.5 + 0.1 * std::sin(p.x / 7 + c) + 0.1 * std::sin(p.y / 6 - c) + 0.1 * std::sin((p.x + p.y) / 9 + 2 * c);
}

/// A picture of the same kind that fits nowhere.
inline double otherWaves(Point2d p, int c)
{
    return 0.4 + 0.12 * std::sin(p.x / 8 - 2 * c) + 0.1 * std::cos(p.y / 7 + c);
}

/// Source bent over the middle of the target, which is undeformed.
inline TermState bentState()
{
    return TermState({bentMesh(SOURCE, 1.5, 1, Point2d(30, 20)), cv::gcpw::MeshGrid(TARGET)});
}

/// Target bent too, with colours of its own on both sides.
inline TermState movedState()
{
    TermState state({bentMesh(SOURCE, 1.5, 2, Point2d(50, 5)),
                     affineMesh(cv::gcpw::MeshGrid(TARGET), Matx22d(1.2, 0.1, -0.1, 0.9), Point2d(12, -8))});
    RNG rng = seeded(3);
    for (cv::gcpw::ColorGrid& grid : state.colors)
    {
        const cv::gcpw::ChannelAffine map{rng.uniform(0.7, 1.3), rng.uniform(-0.1, 0.1)};
        for (int cell = 0; cell < grid.lattice().cellCount(); ++cell)
            for (int c = 0; c < cv::gcpw::CHANNELS; ++c)
                grid.quad(cell)[c] = {map.gain + 0.1 * c, map.bias - 0.02 * c};
    }
    return state;
}

/// A photometric term that owns its samples, of source level and target level.
inline std::shared_ptr<cv::gcpw::EnergyTerm> photometricTerm(const cv::gcpw::PyramidLevel& source, const cv::gcpw::PyramidLevel& target,
                                                             const cv::gcpw::PhotometricTerm::Options& options, int step = 3,
                                                             double contrast_floor = 0)
{
    struct Owner
    {
        cv::gcpw::OverlapSamples samples;
        cv::gcpw::PhotometricTerm term;
        Owner(const cv::gcpw::OverlapSamples& s, const cv::gcpw::PhotometricTerm::Options& o) : samples(s), term(samples, o) {}
    };
    const auto owner =
        std::make_shared<Owner>(cv::gcpw::OverlapSamples(0, 1, source, target, SOURCE, step, contrast_floor), options);
    return std::shared_ptr<cv::gcpw::EnergyTerm>(owner, &owner->term);
}

} // namespace opencv_test

#endif
