// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <opencv2/imgcodecs.hpp>
#include <pybind11/pybind11.h>
#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"

namespace py = pybind11;

namespace
{

py::object readPicture(const std::string& path)
{
    cv::Mat picture;
    {
        py::gil_scoped_release unlocked;
        picture = cv::imread(path, cv::IMREAD_COLOR);
    }
    if (picture.empty())
        return py::none();
    return arrayOf(picture);
}

bool writePicture(const std::string& path, const Pixels& picture)
{
    py::gil_scoped_release unlocked;
    return cv::imwrite(path, picture.mat);
}

} // namespace

PYBIND11_MODULE(_gcpw, module)
{
    module.doc() = "The compiled part of gcpw; use the package.";
    module.attr("__version__") = GCPW_VERSION;
    bindErrors(module);
    bindParams(module);
    bindAlignment(module);
    bindPair(module);
    bindRig(module);
    bindWarper(module);
    bindStitch(module);
    module.def("read_picture", &readPicture, py::arg("path"));
    module.def("can_write", [](const std::string& path) { return cv::haveImageWriter(path); }, py::arg("path"));
    module.def("write_picture", &writePicture, py::arg("path"), py::arg("picture"));
}
