// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <opencv2/gcpw/cameras.hpp>
#include <pybind11/stl.h>
#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "panorama.hpp"

namespace py = pybind11;
using namespace cv::gcpw;

namespace
{

Panorama stitchOf(const std::vector<Pixels>& photographs, const Params& params, const std::string& projection, double megapix,
                  const py::object& progress)
{
    Watch watch(progress);
    const std::vector<cv::Mat> images = matsOf(photographs);
    return watch.run([&] { return stitchPhotographs(images, params, projection, megapix, watch); });
}

CameraEstimate estimateOf(const std::vector<Pixels>& photographs, const std::string& projection, double megapix,
                          const std::vector<double>& focal, const py::object& progress)
{
    Watch watch(progress);
    const std::vector<cv::Mat> images = matsOf(photographs);
    CameraOptions options;
    options.projection = projection;
    options.workMegapix = megapix;
    options.focal = focal;
    return watch.run([&] { return estimateCameras(images, options, watch.progress()); });
}

Rig alignEstimate(const CameraEstimate& estimate, const Params& params, const py::object& progress)
{
    Watch watch(progress);
    return watch.run([&] { return alignRig(estimate, params, watch.progress()); });
}

} // namespace

void bindStitch(py::module_& module)
{
    py::class_<Panorama>(module, "_Panorama")
        .def_property_readonly("picture", [](const Panorama& self) { return arrayOf(self.picture); })
        .def_property_readonly("mask", [](const Panorama& self) { return arrayOf(self.mask); })
        .def_readonly("rig", &Panorama::rig)
        .def_readonly("used", &Panorama::used)
        .def_readonly("decisions", &Panorama::decisions);
    py::class_<CameraEstimate>(module, "CameraEstimate", "Cameras and a projection for a set of photographs, and why these.")
        .def_property_readonly("ok", &CameraEstimate::ok, "Whether there are cameras.")
        .def_readonly("component", &CameraEstimate::component, "Which of the photographs have a camera, from 0.")
        .def_readonly("cameras", &CameraEstimate::cameras, "Of these, at the resolution of the estimation.")
        .def_readonly("work_scale", &CameraEstimate::work_scale, "Pixels of the estimation per pixel of the photographs.")
        .def_readonly("projection", &CameraEstimate::projection, "Name of the warper that the cameras are for.")
        .def_readonly("turned", &CameraEstimate::turned, "The picture comes out turned to the left by 90 degrees.")
        .def_readonly("decisions", &CameraEstimate::decisions, "One sentence for each choice that was made.");
    module.def("stitch", &stitchOf, py::arg("photographs"), py::arg("params"), py::arg("projection"), py::arg("megapix"),
               py::arg("progress"));
    module.def("estimate_cameras", &estimateOf, py::arg("photographs"), py::arg("projection"), py::arg("megapix"),
               py::arg("focal"), py::arg("progress"));
    module.def("align_estimate", &alignEstimate, py::arg("estimate"), py::arg("params"), py::arg("progress"));
}
