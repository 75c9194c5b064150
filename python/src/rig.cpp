// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <filesystem>
#include <opencv2/gcpw/cameras.hpp>
#include <opencv2/gcpw/rig.hpp>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <utility>
#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "camera.hpp"
#include "panorama.hpp"

namespace py = pybind11;
using cv::detail::CameraParams;
using cv::gcpw::Params;
using cv::gcpw::Rig;

namespace
{

/// A copy of a 3 x 3 or 3 x 1 member of a camera.
cv::Mat matrixOf(const Pixels& pixels, const std::string& name, int cols)
{
    if (pixels.mat.rows != 3 || pixels.mat.cols != cols || pixels.mat.channels() != 1)
        CV_Error(cv::Error::StsUnmatchedSizes, cv::format("%s of a camera is 3 x %d numbers", name.c_str(), cols));
    cv::Mat matrix;
    pixels.mat.convertTo(matrix, CV_32F);
    return matrix.clone();
}

CameraParams makeCamera(double focal, double aspect, double ppx, double ppy, const py::object& R)
{
    CameraParams camera;
    camera.focal = focal;
    camera.aspect = aspect;
    camera.ppx = ppx;
    camera.ppy = ppy;
    camera.R = R.is_none() ? cv::Mat(cv::Mat::eye(3, 3, CV_32F)) : matrixOf(R.cast<Pixels>(), "R", 3);
    camera.t = cv::Mat::zeros(3, 1, CV_32F);
    return camera;
}

CameraParams cameraOf(const py::handle& camera, size_t number)
{
    if (py::isinstance<CameraParams>(camera))
        return camera.cast<CameraParams>();
    for (const char* const name : {"focal", "aspect", "ppx", "ppy", "R"})
        if (!py::hasattr(camera, name))
            throw py::type_error("gcpw: camera " + std::to_string(number) + " has no attribute " + name +
                                 "; gcpw.Camera or cv2.detail.CameraParams is wanted");
    return makeCamera(camera.attr("focal").cast<double>(), camera.attr("aspect").cast<double>(), camera.attr("ppx").cast<double>(),
                      camera.attr("ppy").cast<double>(), camera.attr("R"));
}

void bindCamera(py::module_& module)
{
    py::class_<CameraParams>(module, "Camera", "A pinhole camera that turns: focal length, principal point and rotation.")
        .def(py::init(&makeCamera), py::arg("focal") = 1, py::arg("aspect") = 1, py::arg("ppx") = 0, py::arg("ppy") = 0,
             py::arg("R") = py::none(), "R is 3 x 3, None for no turn; for the affine projection the affine map.")
        .def_readwrite("focal", &CameraParams::focal, "Pixels.")
        .def_readwrite("aspect", &CameraParams::aspect, "Vertical focal length / horizontal one.")
        .def_readwrite("ppx", &CameraParams::ppx, "Principal point, pixels from the left.")
        .def_readwrite("ppy", &CameraParams::ppy, "Principal point, pixels from the top.")
        .def_property("R", [](const CameraParams& self) { return arrayOf(self.R.clone()); },
                      [](CameraParams& self, const Pixels& R) { self.R = matrixOf(R, "R", 3); }, "Rotation, 3 x 3.")
        .def("K", [](const CameraParams& self) { return arrayOf(self.K()); }, "Camera matrix, 3 x 3.")
        .def("__repr__", [](const CameraParams& self)
             { return cv::format("<gcpw.Camera focal %.1f, centre %.1f, %.1f>", self.focal, self.ppx, self.ppy); });
}

Rig alignRigOf(const std::vector<Pixels>& images, const py::sequence& cameras, const std::string& projection, const Params& params,
               const py::object& progress)
{
    Watch watch(progress);
    const std::vector<CameraParams> known = camerasOf(cameras);
    const std::vector<cv::Mat> pictures = matsOf(images);
    return watch.run([&]
    {
        cv::gcpw::CameraEstimate named; // knows the warpers by their names
        named.projection = projection;
        Rig rig = cv::gcpw::alignRig(pictures, known, named.warper(), params, watch.progress());
        rig.projection = projection;
        return rig;
    });
}

py::tuple warpOf(const Rig& rig, int index, const Pixels& photograph)
{
    Warped warped;
    {
        py::gil_scoped_release unlocked;
        warped = warpByRig(rig, index, photograph.mat);
    }
    return py::make_tuple(std::make_pair(warped.corner.x, warped.corner.y), arrayOf(warped.picture), arrayOf(warped.mask));
}

Panorama stitchOf(const Rig& rig, const std::vector<Pixels>& photographs, double megapix, const py::object& progress)
{
    Watch watch(progress);
    const std::vector<cv::Mat> images = matsOf(photographs);
    return watch.run([&] { return stitchByRig(rig, images, megapix, watch); });
}

} // namespace

std::vector<CameraParams> camerasOf(const py::sequence& cameras)
{
    std::vector<CameraParams> known;
    for (const py::handle camera : cameras)
        known.push_back(cameraOf(camera, known.size()));
    return known;
}

void bindRig(py::module_& module)
{
    bindCamera(module);
    py::class_<Rig>(module, "Rig", "An alignment with the cameras it was estimated for: one estimate, many frames.")
        .def_property_readonly("usable", &Rig::usable, "Whether there is a refinement to render.")
        .def_readonly("alignment", &Rig::alignment, "Image k belongs to camera k.")
        .def_readonly("cameras", &Rig::cameras, "At the resolution of the estimation.")
        .def_property_readonly("image_sizes",
                               [](const Rig& self)
                               {
                                   std::vector<std::pair<int, int>> sizes;
                                   for (const cv::Size& size : self.image_sizes)
                                       sizes.emplace_back(size.width, size.height);
                                   return sizes;
                               },
                               "Width and height of each camera's image at that resolution.")
        .def_readonly("component", &Rig::component, "Which of the photographs they are, from 0; may be empty: all.")
        .def_readonly("turns", &Rig::turns)
        .def_readonly("scale", &Rig::scale, "Canvas pixels per radian of the base warper.")
        .def_readonly("work_scale", &Rig::work_scale, "Pixels of the estimation per pixel of the photographs.")
        .def_readonly("projection", &Rig::projection, "Name of the base warper.")
        .def_readonly("turned", &Rig::turned, "The picture comes out turned to the left by 90 degrees.")
        .def("fits", [](const Rig& self, const py::sequence& cameras) { return self.fits(camerasOf(cameras)); }, py::arg("cameras"),
             "Whether these are the cameras of the rig.")
        .def("check", &Rig::check, "Raises ValueError that names what cannot be rendered.")
        .def("warp", &warpOf, py::arg("index"), py::arg("photograph"),
             "Position on the canvas (x, y), warped picture and mask of the photograph of camera `index`.")
        .def("save", [](const Rig& self, const std::filesystem::path& path)
             { writeTo(path, [&](const std::string& name) { self.save(name); }); }, py::arg("path"),
             "Writes .yml, .xml or .json, with .gz behind it compressed.")
        .def_static("load", [](const std::filesystem::path& path) { return readFrom(path, &Rig::load); }, py::arg("path"),
                    "Reads what save() wrote.")
        .def("__repr__", [](const Rig& self)
             { return cv::format("<gcpw.Rig of %zu cameras, %s%s>", self.cameras.size(), self.projection.c_str(), self.usable() ? "" : ", not usable"); });
    module.def("stitch_by_rig", &stitchOf, py::arg("rig"), py::arg("photographs"), py::arg("megapix"), py::arg("progress"));
    module.def("align_rig", &alignRigOf, py::arg("images"), py::arg("cameras"), py::arg("projection"), py::arg("params"),
               py::arg("progress"));
}
