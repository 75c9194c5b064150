// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "model/color_grid.hpp"

namespace cv
{
namespace gcpw
{

bool ColorGrid::isIdentity() const
{
    for (const Quad& quad : quads_)
        for (const ChannelAffine& map : quad)
            if (map.gain != 1 || map.bias != 0)
                return false;
    return true;
}

Mat ColorGrid::toMat() const
{
    Mat grid(lattice_.rows(), lattice_.cols(), CV_32FC(2 * CHANNELS));
    for (int cell = 0; cell < lattice_.cellCount(); ++cell)
    {
        float* out = grid.ptr<float>(cell / lattice_.cols()) + 2 * CHANNELS * (cell % lattice_.cols());
        for (int c = 0; c < CHANNELS; ++c)
        {
            out[c] = static_cast<float>(quads_[cell][c].gain);
            out[CHANNELS + c] = static_cast<float>(quads_[cell][c].bias);
        }
    }
    return grid;
}

void checkColorGrid(const Mat& grid, const std::string& name)
{
    if (grid.type() != CV_32FC(2 * CHANNELS) || grid.dims != 2 || grid.rows < 1 || grid.cols < 1)
        CV_Error(Error::StsBadArg, "gcpw: " + name + " is not rows x cols, CV_32FC(6): gain and bias of Y, Cr, Cb of each quad");
    if (!checkRange(grid))
        CV_Error(Error::StsOutOfRange, "gcpw: " + name + " holds values that are not finite");
}

ColorGrid mixed(const ColorGrid& a, const ColorGrid& b, double share)
{
    CV_DbgAssert(a.lattice().cols() == b.lattice().cols() && a.lattice().rows() == b.lattice().rows());
    ColorGrid result = a;
    for (int cell = 0; cell < a.lattice().cellCount(); ++cell)
        for (int c = 0; c < CHANNELS; ++c)
        {
            ChannelAffine& map = result.quad(cell)[c];
            map.gain += share * (b.quad(cell)[c].gain - map.gain);
            map.bias += share * (b.quad(cell)[c].bias - map.bias);
        }
    return result;
}

} // namespace gcpw
} // namespace cv
