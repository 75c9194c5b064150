// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <memory>
#include <opencv2/gcpw/compensator.hpp>
#include <opencv2/gcpw/rotation_warper.hpp>
#include <pybind11/stl.h>
#include <utility>
#include "arrays.hpp"
#include "bindings.hpp"

namespace py = pybind11;
using cv::gcpw::GcpwCompensator;
using cv::gcpw::Params;
using cv::gcpw::PyGcpwWarper;
using cv::gcpw::Rig;

namespace
{

typedef std::pair<float, float> PointPair;
typedef std::pair<int, int> SizePair;

py::tuple rectOf(const cv::Rect& rect)
{
    return py::make_tuple(rect.x, rect.y, rect.width, rect.height);
}

py::tuple warp(PyGcpwWarper& self, const Pixels& src, const Pixels& K, const Pixels& R, int interp_mode, int border_mode)
{
    cv::Mat picture;
    cv::Point corner;
    {
        py::gil_scoped_release unlocked;
        corner = self.warp(src.mat, K.mat, R.mat, interp_mode, border_mode, picture);
    }
    return py::make_tuple(std::make_pair(corner.x, corner.y), arrayOf(picture));
}

py::array warpBackward(PyGcpwWarper& self, const Pixels& src, const Pixels& K, const Pixels& R, int interp_mode, int border_mode,
                       SizePair dst_size)
{
    cv::Mat picture;
    {
        py::gil_scoped_release unlocked;
        self.warpBackward(src.mat, K.mat, R.mat, interp_mode, border_mode, cv::Size(dst_size.first, dst_size.second), picture);
    }
    return arrayOf(picture);
}

py::tuple buildMaps(PyGcpwWarper& self, SizePair src_size, const Pixels& K, const Pixels& R)
{
    cv::Mat xmap;
    cv::Mat ymap;
    cv::Rect rect;
    {
        py::gil_scoped_release unlocked;
        rect = self.buildMaps(cv::Size(src_size.first, src_size.second), K.mat, R.mat, xmap, ymap);
    }
    return py::make_tuple(rectOf(rect), arrayOf(xmap), arrayOf(ymap));
}

PointPair warpPoint(PyGcpwWarper& self, PointPair pt, const Pixels& K, const Pixels& R)
{
    const cv::Point2f at = self.warpPoint({pt.first, pt.second}, K.mat, R.mat);
    return {at.x, at.y};
}

PointPair warpPointBackward(PyGcpwWarper& self, PointPair pt, const Pixels& K, const Pixels& R)
{
    const cv::Point2f at = self.warpPointBackward({pt.first, pt.second}, K.mat, R.mat);
    return {at.x, at.y};
}

std::vector<cv::UMat> copiesOf(const std::vector<Pixels>& pixels)
{
    std::vector<cv::UMat> copies(pixels.size());
    for (size_t i = 0; i < pixels.size(); ++i)
        pixels[i].mat.copyTo(copies[i]);
    return copies;
}

void feed(GcpwCompensator& self, const std::vector<SizePair>& corners, const std::vector<Pixels>& images, const std::vector<Pixels>& masks)
{
    py::gil_scoped_release unlocked;
    std::vector<cv::Point> places;
    for (const SizePair& corner : corners)
        places.emplace_back(corner.first, corner.second);
    self.feed(places, copiesOf(images), copiesOf(masks));
}

py::object apply(GcpwCompensator& self, int index, SizePair corner, const Pixels& image, const Pixels& mask)
{
    cv::Mat picture = image.shared ? image.mat : image.mat.clone();
    {
        py::gil_scoped_release unlocked;
        self.apply(index, {corner.first, corner.second}, picture, mask.mat);
    }
    return image.shared ? py::object(image.owner) : py::object(arrayOf(picture));
}

} // namespace

void bindWarper(py::module_& module)
{
    py::class_<GcpwCompensator, std::shared_ptr<GcpwCompensator>>(
        module, "Compensator", "Makes colours agree by a local affine map of each image; used as those of cv2.detail.")
        .def(py::init<const Params&>(), py::arg("params") = Params())
        .def("feed", &feed, py::arg("corners"), py::arg("images"), py::arg("masks"),
             "Estimates colours from images warped onto one canvas, unless a rig has them.")
        .def("apply", &apply, py::arg("index"), py::arg("corner"), py::arg("image"), py::arg("mask"),
             "Corrects an image in place where it is a writable, contiguous array; returns it, or else a corrected copy.")
        .def("getMatGains",
             [](GcpwCompensator& self)
             {
                 std::vector<cv::Mat> gains;
                 self.getMatGains(gains);
                 std::vector<py::array> arrays;
                 for (const cv::Mat& gain : gains)
                     arrays.push_back(arrayOf(gain));
                 return arrays;
             },
             "The colours in use: one array of rows x cols x 6 an image.")
        .def("setMatGains",
             [](GcpwCompensator& self, const std::vector<Pixels>& arrays)
             {
                 std::vector<cv::Mat> gains = matsOf(arrays);
                 self.setMatGains(gains);
             },
             py::arg("gains"), "Sets the colours to use.");
    py::class_<PyGcpwWarper>(module, "Warper", "The meshes of a rig behind a warper of OpenCV; used as cv2.PyRotationWarper.")
        .def(py::init([](const std::string& projection, float scale, const Rig* rig)
                      { return std::unique_ptr<PyGcpwWarper>(new PyGcpwWarper(projection, scale, rig ? *rig : Rig())); }),
             py::arg("projection"), py::arg("scale"), py::arg("rig").none(true) = py::none())
        .def("warp", &warp, py::arg("src"), py::arg("K"), py::arg("R"), py::arg("interp_mode"), py::arg("border_mode"),
             "Canvas position (x, y) of the top-left pixel, and the warped picture.")
        .def("warpBackward", &warpBackward, py::arg("src"), py::arg("K"), py::arg("R"), py::arg("interp_mode"), py::arg("border_mode"),
             py::arg("dst_size"), "Undoes warp().")
        .def("warpRoi",
             [](PyGcpwWarper& self, SizePair size, const Pixels& K, const Pixels& R)
             { return rectOf(self.warpRoi(cv::Size(size.first, size.second), K.mat, R.mat)); },
             py::arg("src_size"), py::arg("K"), py::arg("R"), "x, y, width and height of what an image covers.")
        .def("buildMaps", &buildMaps, py::arg("src_size"), py::arg("K"), py::arg("R"), "The rectangle, and maps for cv2.remap().")
        .def("warpPoint", &warpPoint, py::arg("pt"), py::arg("K"), py::arg("R"), "Canvas position of a point of an image.")
        .def("warpPointBackward", &warpPointBackward, py::arg("pt"), py::arg("K"), py::arg("R"), "Point of an image at a canvas position.")
        .def("compensator", [](const PyGcpwWarper& self, const Params& params) { return std::shared_ptr<GcpwCompensator>(self.compensator(params)); },
             py::arg("params") = Params(), "A compensator with the colours of the rig.")
        .def("getScale", &PyGcpwWarper::getScale, "Canvas pixels per radian.")
        .def("setScale", &PyGcpwWarper::setScale, py::arg("scale"));
}
