// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "geometry/curve.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

double lengthOf(const Curve& curve)
{
    double length = 0;
    for (size_t k = 1; k < curve.size(); ++k)
        length += std::hypot(curve[k].x - curve[k - 1].x, curve[k].y - curve[k - 1].y);
    return length;
}

Curve resampled(const Curve& curve, double step_px)
{
    Curve result;
    const double length = lengthOf(curve);
    if (!(length > 0) || !std::isfinite(length))
        return result;
    const int count = static_cast<int>(std::min(std::max(std::round(length / step_px), 1.0), MAX_SAMPLES));
    size_t piece = 1;
    double passed = 0;
    for (int k = 0; k <= count; ++k)
    {
        const double at = length * k / count;
        double along = std::hypot(curve[piece].x - curve[piece - 1].x, curve[piece].y - curve[piece - 1].y);
        while (piece + 1 < curve.size() && passed + along < at)
        {
            passed += along;
            ++piece;
            along = std::hypot(curve[piece].x - curve[piece - 1].x, curve[piece].y - curve[piece - 1].y);
        }
        const double share = along > 0 ? std::min((at - passed) / along, 1.0) : 0;
        result.push_back(curve[piece - 1] + share * (curve[piece] - curve[piece - 1]));
    }
    return result;
}

} // namespace gcpw
} // namespace cv
