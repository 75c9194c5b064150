// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/alignment.hpp"

#include <cmath>
#include "model/color_grid.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int MIN_QUADS = 2; ///< a side, as Params has it
const int MAX_QUADS = 256;
const int MAX_SIDE = 1 << 20; ///< px: cv::imread takes no larger image

void checkSize(Size size, const std::string& name)
{
    if (size.width < 1 || size.height < 1 || size.width > MAX_SIDE || size.height > MAX_SIDE)
        CV_Error(Error::StsOutOfRange, format("gcpw: %s is %d x %d px; both sides must be at least 1 and at most %d",
                                              name.c_str(), size.width, size.height, MAX_SIDE));
}

void checkVertices(const Mat& mat, Size vertices, const std::string& name)
{
    if (mat.type() != CV_64FC2 || mat.dims != 2 || mat.size() != vertices)
        CV_Error(Error::StsUnmatchedSizes,
                 format("gcpw: %s is not CV_64FC2 of one row and one column more than its colour grid, %d x %d",
                        name.c_str(), vertices.height, vertices.width));
    if (!checkRange(mat))
        CV_Error(Error::StsOutOfRange, "gcpw: " + name + " holds values that are not finite");
}

void checkImage(const Alignment::Image& image, size_t index)
{
    const auto name = [index](const char* part) { return format("%s of the alignment's image %zu", part, index); };
    checkSize(image.full_size, name("full_size"));
    checkSize(image.work_size, name("work_size"));
    checkColorGrid(image.color, name("color"));
    const Size quads = image.color.size();
    if (quads.width < MIN_QUADS || quads.height < MIN_QUADS || quads.width > MAX_QUADS || quads.height > MAX_QUADS)
        CV_Error(Error::StsOutOfRange, format("gcpw: %s has %d x %d quads; a mesh has %d to %d a side",
                                              name("color").c_str(), quads.height, quads.width, MIN_QUADS, MAX_QUADS));
    checkVertices(image.mesh, quads + Size(1, 1), name("mesh"));
    checkVertices(image.rough, quads + Size(1, 1), name("rough"));
}

} // namespace

const char* toString(Status status)
{
    switch (status)
    {
    case Status::OK:
        return "ok";
    case Status::ROUGH:
        return "rough";
    case Status::NO_ALIGNMENT:
        return "no_alignment";
    case Status::CANCELLED:
        return "cancelled";
    }
    return "unknown";
}

const char* toString(StopReason reason)
{
    switch (reason)
    {
    case StopReason::ITERATION_LIMIT:
        return "iteration_limit";
    case StopReason::MESH_STABLE:
        return "mesh_stable";
    case StopReason::ENERGY_STABLE:
        return "energy_stable";
    case StopReason::NO_DESCENT:
        return "no_descent";
    case StopReason::SINGULAR:
        return "singular";
    case StopReason::CANCELLED:
        return "cancelled";
    }
    return "unknown";
}

Alignment::Alignment(const std::vector<Image>& images, Size2d canvas_scale, const Report& report)
    : images_(images), canvas_scale_(canvas_scale), report_(report)
{
    for (size_t i = 0; i < images.size(); ++i)
        checkImage(images[i], i);
    for (const double scale : {canvas_scale.width, canvas_scale.height})
        if (!(scale > 0) || !std::isfinite(scale))
            CV_Error(Error::StsOutOfRange,
                     format("gcpw: an alignment's canvas scale is %g; it must be finite and above 0", scale));
    const int status = static_cast<int>(report.status);
    if (status < static_cast<int>(Status::OK) || status > static_cast<int>(Status::CANCELLED))
        CV_Error(Error::StsOutOfRange,
                 format("gcpw: an alignment's status is %d; it must be one of gcpw::Status", status));
}

const Alignment::Image& Alignment::image(int index) const
{
    if (index < 0 || index >= imageCount())
        CV_Error(Error::StsOutOfRange,
                 format("gcpw: the alignment has %d images; there is no image %d", imageCount(), index));
    return images_[index];
}

} // namespace gcpw
} // namespace cv
