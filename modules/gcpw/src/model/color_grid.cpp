// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "model/color_grid.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

ColorGrid::Quad ColorGrid::at(Point2d rest_px) const
{
    const Size2d cell = lattice_.cellSize();
    const double x = std::min(std::max((rest_px.x + 0.5) / cell.width - 0.5, 0.0), lattice_.cols() - 1.0);
    const double y = std::min(std::max((rest_px.y + 0.5) / cell.height - 0.5, 0.0), lattice_.rows() - 1.0);
    const int col = std::min(static_cast<int>(x), std::max(lattice_.cols() - 2, 0));
    const int row = std::min(static_cast<int>(y), std::max(lattice_.rows() - 2, 0));
    const int right = std::min(col + 1, lattice_.cols() - 1) - col;
    const int below = (std::min(row + 1, lattice_.rows() - 1) - row) * lattice_.cols();
    const int first = row * lattice_.cols() + col;
    const std::array<int, 4> cells{{first, first + right, first + below, first + right + below}};
    const std::array<double, 4> weight = bilinearWeights(x - col, y - row);
    Quad mixed;
    for (int c = 0; c < CHANNELS; ++c)
    {
        mixed[c] = {0, 0};
        for (int k = 0; k < 4; ++k)
        {
            mixed[c].gain += weight[k] * quads_[cells[k]][c].gain;
            mixed[c].bias += weight[k] * quads_[cells[k]][c].bias;
        }
    }
    return mixed;
}

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
