// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/model_check.hpp"

#include <cmath>
#include <numeric>
#include "common/program.hpp"

std::vector<int> checkModel(const cv::gcpw::Rig& rig, const std::vector<cv::Mat>& images, const std::string& name)
{
    std::vector<int> component = rig.component;
    if (component.empty() && rig.cameras.size() == images.size())
    {
        component.resize(images.size());
        std::iota(component.begin(), component.end(), 0);
    }
    if (component.empty() || component.size() != rig.cameras.size())
        throw WrongUse(name + " is of " + std::to_string(rig.cameras.size()) + " other images");
    for (size_t i = 0; i < component.size(); ++i)
    {
        if (component[i] < 0 || component[i] >= static_cast<int>(images.size()))
            throw WrongUse(name + " is of image " + std::to_string(component[i] + 1) + ", which is not given");
        if (rig.image_sizes.size() != component.size())
            continue;
        const cv::Size size = images[component[i]].size();
        const cv::Size made = rig.image_sizes[i];
        // The model has the size at its work scale, rounded.
        if (std::abs(size.width * rig.work_scale - made.width) > 1 || std::abs(size.height * rig.work_scale - made.height) > 1)
            throw WrongUse(cv::format("%s is of photographs of another size: image %d is %d x %d px, that of the model about %.0f x %.0f px",
                                      name.c_str(), component[i] + 1, size.width, size.height, made.width / rig.work_scale,
                                      made.height / rig.work_scale));
    }
    return component;
}

void checkWorkScale(const cv::gcpw::Rig& rig, const cv::Stitcher& stitcher, const std::string& name)
{
    const double slack = 1e-6; // of numbers that went through a file
    if (!(std::abs(stitcher.workScale() - rig.work_scale) <= slack * rig.work_scale))
        throw WrongUse(name + " was made with another --work_megapix");
}
