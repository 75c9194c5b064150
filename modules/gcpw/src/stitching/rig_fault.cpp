// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitching/rig_fault.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

const double MAX_EXTENT = 1 << 20; ///< px of a mesh on the base warper's canvas; OpenCV can remap 32767 px a side
const double MAX_PLACE = 1e9;      ///< px from the canvas's origin: corners are int

RigFault positiveFault(const std::string& name, double value)
{
    if (value > 0 && std::isfinite(value))
        return {};
    return {Error::StsOutOfRange, format("gcpw: %s is %g; it must be finite and above 0", name.c_str(), value)};
}

RigFault countFault(const char* name, size_t count, size_t images)
{
    if (count == 0 || count == images)
        return {};
    return {Error::StsUnmatchedSizes,
            format("gcpw: %s of a rig has %zu entries; it has one for each of the %zu images, or none", name, count, images)};
}

RigFault cameraFault(const cv::detail::CameraParams& camera, size_t index)
{
    const std::string of = format(" of camera %zu", index);
    if (camera.R.size() != Size(3, 3) || camera.R.channels() != 1 || camera.R.dims != 2)
        return {Error::StsBadArg, "gcpw: R" + of + " is not a 3 x 3 matrix"};
    if (!checkRange(camera.R))
        return {Error::StsOutOfRange, "gcpw: R" + of + " holds values that are not finite"};
    if (!std::isfinite(camera.ppx) || !std::isfinite(camera.ppy))
        return {Error::StsOutOfRange,
                format("gcpw: the principal point%s is (%g, %g); it must be finite", of.c_str(), camera.ppx, camera.ppy)};
    const RigFault focal = positiveFault("focal" + of, camera.focal);
    return focal.message.empty() ? positiveFault("aspect" + of, camera.aspect) : focal;
}

RigFault sizeFault(Size size, size_t index)
{
    if (size.width >= 1 && size.height >= 1)
        return {};
    return {Error::StsOutOfRange,
            format("gcpw: image_sizes[%zu] of a rig is %d x %d px; both must be at least 1", index, size.width, size.height)};
}

RigFault componentFault(const std::vector<int>& component, size_t index)
{
    const auto end = component.begin() + static_cast<std::ptrdiff_t>(index);
    if (component[index] >= 0 && std::find(component.begin(), end, component[index]) == end)
        return {};
    return {Error::StsOutOfRange,
            format("gcpw: component[%zu] of a rig is %d; indices start at 0 and none comes twice", index, component[index])};
}

RigFault turnFault(double turn, size_t index)
{
    if (std::abs(turn) <= 2 * CV_PI)
        return {};
    return {Error::StsOutOfRange,
            format("gcpw: turns[%zu] of a rig is %g; radians of at most one circle are taken", index, turn)};
}

RigFault placeFault(const Alignment& alignment, int index)
{
    const Size2d scale = alignment.canvasScale();
    Mat xy[2];
    split(alignment.image(index).mesh, xy);
    for (int k = 0; k < 2; ++k)
    {
        double least = 0;
        double most = 0;
        minMaxLoc(xy[k], &least, &most);
        least /= k == 0 ? scale.width : scale.height;
        most /= k == 0 ? scale.width : scale.height;
        if (!(most - least <= MAX_EXTENT && -least <= MAX_PLACE && most <= MAX_PLACE))
            return {Error::StsOutOfRange, format("gcpw: the mesh of image %d of a rig reaches from %g to %g px, beyond any canvas",
                                                 index, least, most)};
    }
    return {};
}

/// Of the first entry that has one.
template <typename Entries, typename EntryFault>
RigFault firstFault(const Entries& entries, const EntryFault& fault_of)
{
    for (size_t i = 0; i < entries.size(); ++i)
    {
        const RigFault fault = fault_of(i);
        if (!fault.message.empty())
            return fault;
    }
    return {};
}

} // namespace

RigFault findFault(const Rig& rig)
{
    const size_t images = static_cast<size_t>(rig.alignment.imageCount());
    if (images == 0 || !rig.alignment.ok())
        return {}; // it promises nothing
    if (rig.cameras.size() != images)
        return {Error::StsUnmatchedSizes, format("gcpw: a rig of %zu images has %zu cameras", images, rig.cameras.size())};
    const RigFault faults[] = {
        firstFault(rig.cameras, [&](size_t i) { return cameraFault(rig.cameras[i], i); }),
        countFault("image_sizes", rig.image_sizes.size(), images),
        firstFault(rig.image_sizes, [&](size_t i) { return sizeFault(rig.image_sizes[i], i); }),
        countFault("component", rig.component.size(), images),
        firstFault(rig.component, [&](size_t i) { return componentFault(rig.component, i); }),
        countFault("turns", rig.turns.size(), images),
        firstFault(rig.turns, [&](size_t i) { return turnFault(rig.turns[i], i); }),
        positiveFault("scale of a rig", rig.scale),
        positiveFault("work_scale of a rig", rig.work_scale),
        firstFault(rig.cameras, [&](size_t i) { return placeFault(rig.alignment, static_cast<int>(i)); })};
    return *std::find_if(std::begin(faults), std::end(faults) - 1, [](const RigFault& fault) { return !fault.message.empty(); });
}

} // namespace gcpw
} // namespace cv
