// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_COLOR_GRID_HPP
#define OPENCV_GCPW_COLOR_GRID_HPP

#include <array>
#include <string>
#include <vector>
#include "geometry/lattice.hpp"

namespace cv
{
namespace gcpw
{

const int CHANNELS = 3; ///< Y, Cr, Cb

/// The colour map y = gain * x + bias of one channel; intensities in [0, 1].
struct ChannelAffine
{
    double gain = 1;
    double bias = 0;
};

/** @brief One affine colour map per channel on every quad of a lattice (the paper's G and B), in YCrCb.

Estimated constant in a quad; shown bilinearly between quad centres (rendering/color_field.hpp). */
class ColorGrid
{
public:
    typedef std::array<ChannelAffine, CHANNELS> Quad;

    ColorGrid() = default;
    explicit ColorGrid(const Lattice& lattice) : lattice_(lattice), quads_(lattice.cellCount()) {}

    const Lattice& lattice() const { return lattice_; }
    const Quad& quad(int cell) const { return quads_[cell]; }
    Quad& quad(int cell) { return quads_[cell]; }

    /// Whether every quad leaves colours as they are.
    bool isIdentity() const;

    /// The grid as rows x cols, CV_32FC(6): gain Y, Cr, Cb, bias Y, Cr, Cb.
    Mat toMat() const;

private:
    Lattice lattice_;
    std::vector<Quad> quads_;
};

/** @brief Refuses a Mat that is no colour grid: rows x cols, CV_32FC(6), at least 1 x 1 and of finite values.
@param name for the message
@throws cv::Exception */
void checkColorGrid(const Mat& grid, const std::string& name);

/// (1 - share) * a + share * b, quad by quad, of two grids over one lattice.
ColorGrid mixed(const ColorGrid& a, const ColorGrid& b, double share);

} // namespace gcpw
} // namespace cv

#endif
