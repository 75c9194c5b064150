// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_STRAIGHTEN_HPP
#define OPENCV_GCPW_STRAIGHTEN_HPP

#include <vector>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

/// How the photographs of turning cameras lie beside each other.
enum class SetShape
{
    SPOT,  ///< all look almost the same way: nothing says where up is but the photographs themselves
    STRIP, ///< the camera turned about its own vertical axis, perhaps in several rows
    COLUMN, ///< it turned about its own horizontal axis: a sweep upwards, or a strip of photographs that lie on their side
};

/// Says along which axis of the cameras the set is longer. @param rotations world from camera
SetShape shapeOf(const std::vector<Matx33d>& rotations);

/** @brief The rotation of the world that makes a set straight (wave correction @cite BL07 by the shape of the set).

STRIP: the axis that the cameras' x axes are perpendicular to becomes vertical, the mean view looks ahead. COLUMN: the same for their
y axes, and the column lies along the equator: its pictures lie on their side there, their left side down, far from the poles. SPOT: the mean
of the cameras is upright.
@return R to be multiplied from the left onto every rotation */
Matx33d straightening(const std::vector<Matx33d>& rotations, SetShape shape);

/// The rotation after which the mean of the cameras looks straight ahead and is upright.
Matx33d centring(const std::vector<Matx33d>& rotations);

} // namespace gcpw
} // namespace cv

#endif
