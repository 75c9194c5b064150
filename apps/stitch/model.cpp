// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/model.hpp"

#include <cmath>
#include <numeric>
#include "common/exit_code.hpp"
#include "common/paths.hpp"
#include "common/write_file.hpp"
#include "stitch/layout.hpp"

using cv::gcpw::Rig;

namespace
{

const double ROUNDING = 1; ///< px at the resolution of the estimation, at which sizes are whole

Rig load(const std::string& path)
{
    try
    {
        return Rig::load(path);
    }
    catch (const cv::Exception& error)
    {
        throw FileTrouble("cannot read the model " + shortened(path) + ": " + error.err);
    }
}

/// Of a rig of one program of old, which has none, all photographs are meant.
void completeComponent(Rig& rig, size_t photographs, const std::string& path)
{
    if (rig.component.empty() && rig.cameras.size() == photographs)
    {
        rig.component.resize(photographs);
        std::iota(rig.component.begin(), rig.component.end(), 0);
    }
    if (rig.component.empty() || rig.component.size() != rig.cameras.size())
        throw WrongUse("the model " + path + " is of " + std::to_string(rig.cameras.size()) +
                       " other photographs than these " + std::to_string(photographs) +
                       "; give it those of the same cameras, in the same order");
    for (const int index : rig.component)
        if (index < 0 || index >= static_cast<int>(photographs))
            throw WrongUse("the model " + path + " is of photograph " + std::to_string(index + 1) + ", and " +
                           std::to_string(photographs) + " are given");
}

/// Throws WrongUse unless a photograph, scaled, has the size of the one that was estimated from.
void checkShape(const Photograph& photograph, cv::Size made, double scale, const std::string& path)
{
    const cv::Size size = photograph.size();
    if (std::abs(size.width * scale - made.width) > ROUNDING || std::abs(size.height * scale - made.height) > ROUNDING)
        throw WrongUse(cv::format(
            "the model %s is of photographs of another size: %s is %d x %d px, and its cameras took pictures of the "
            "shape %d x %d, all scaled alike",
            path.c_str(), photograph.path.c_str(), size.width, size.height, made.width, made.height));
}

} // namespace

Rig modelFor(const std::vector<Photograph>& photographs, const std::string& path, const std::string& warp)
{
    Rig rig = load(path);
    completeComponent(rig, photographs.size(), path);
    if (!rig.projection.empty() && !warp.empty() && rig.projection != warp)
        throw WrongUse("the model " + path + " is of the projection " + rig.projection + "; leave out --warp=" + warp);
    if (rig.projection.empty())
        rig.projection = warp.empty() ? "spherical" : warp;
    const bool has_sizes = rig.image_sizes.size() == rig.component.size() && !rig.image_sizes[0].empty();
    if (has_sizes)
    {
        // The first photograph gives one scale for all, as where the model was made.
        const int width = photographs[static_cast<size_t>(rig.component[0])].size().width;
        const int made = rig.image_sizes[0].width;
        if (std::abs(width * rig.work_scale - made) > ROUNDING)
            rig.work_scale = static_cast<double>(made) / width;
        for (size_t i = 0; i < rig.component.size(); ++i)
            checkShape(photographs[static_cast<size_t>(rig.component[i])], rig.image_sizes[i], rig.work_scale, path);
    }
    return rig;
}

void saveModel(const Layout& layout, const std::vector<Photograph>& photographs, const std::string& path)
{
    Rig rig = layout.rig;
    rig.cameras = layout.cameras;
    rig.component = layout.component;
    rig.work_scale = layout.work_scale;
    rig.projection = layout.projection;
    rig.turned = layout.turned;
    if (rig.image_sizes.empty()) // where the refinement had no answer, and cameras are all there is
        for (const int index : rig.component)
        {
            const cv::Size size = photographs[static_cast<size_t>(index)].size();
            rig.image_sizes.emplace_back(cvRound(size.width * rig.work_scale), cvRound(size.height * rig.work_scale));
        }
    writeModel(path, [&](const std::string& name) { rig.save(name); });
}
