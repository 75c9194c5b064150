// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <filesystem>
#include <opencv2/gcpw/aligner.hpp>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <utility>
#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"

namespace py = pybind11;
using namespace cv::gcpw;

namespace
{

std::pair<int, int> pairOf(const cv::Size& size)
{
    return {size.width, size.height};
}

py::dict energiesOf(const std::vector<TermEnergy>& energies)
{
    py::dict values;
    for (const TermEnergy& energy : energies)
        values[py::str(energy.name)] = energy.value;
    return values;
}

void bindReport(py::module_& module)
{
    py::class_<PairReport>(module, "PairReport", "What was found between two images.")
        .def_readonly("a", &PairReport::a)
        .def_readonly("b", &PairReport::b)
        .def_readonly("points", &PairReport::points)
        .def_readonly("lines", &PairReport::lines)
        .def_readonly("miss_before", &PairReport::miss_before)
        .def_readonly("miss_after", &PairReport::miss_after)
        .def("__repr__", [](const PairReport& self)
             { return cv::format("<gcpw.PairReport %d, %d: %.1f -> %.1f>", self.a, self.b, self.miss_before, self.miss_after); });
    py::class_<LevelReport>(module, "LevelReport", "What happened on one level of the pyramid.")
        .def_readonly("scale", &LevelReport::scale)
        .def_readonly("iterations", &LevelReport::iterations)
        .def_property_readonly("start", [](const LevelReport& self) { return energiesOf(self.start); })
        .def_property_readonly("end", [](const LevelReport& self) { return energiesOf(self.end); })
        .def_property_readonly("stop", [](const LevelReport& self) { return toString(self.stop); });
    py::class_<Report>(module, "Report", "How an alignment came about.")
        .def_property_readonly("status", [](const Report& self) { return toString(self.status); })
        .def_readonly("message", &Report::message)
        .def_readonly("levels", &Report::levels)
        .def_readonly("pairs", &Report::pairs)
        .def_readonly("folds", &Report::folds)
        .def_readonly("max_displacement_px", &Report::max_displacement_px)
        .def_readonly("gain_min", &Report::gain_min)
        .def_readonly("gain_max", &Report::gain_max)
        .def_property_readonly("timings_ms",
                               [](const Report& self)
                               {
                                   py::dict times;
                                   times["features"] = self.timings_ms.features;
                                   times["homography"] = self.timings_ms.homography;
                                   times["align"] = self.timings_ms.align;
                                   times["total"] = self.timings_ms.total;
                                   return times;
                               })
        .def("__repr__", [](const Report& self) { return std::string("<gcpw.Report ") + toString(self.status) + ">"; });
}

void bindImage(py::module_& module)
{
    py::class_<AlignedImage>(module, "AlignedImage", "Where one image lies on the canvas, and how its colours change.")
        .def_property_readonly("full_size", [](const AlignedImage& self) { return pairOf(self.full_size); })
        .def_property_readonly("work_size", [](const AlignedImage& self) { return pairOf(self.work_size); })
        .def_property_readonly("mesh", [](const AlignedImage& self) { return arrayOf(self.mesh.clone()); },
                               "(rows + 1) x (cols + 1) x 2: canvas position x, y of each vertex, working pixels.")
        .def_property_readonly("rough", [](const AlignedImage& self) { return arrayOf(self.rough.clone()); },
                               "The mesh before refinement.")
        .def_property_readonly("color", [](const AlignedImage& self) { return arrayOf(self.color.clone()); },
                               "rows x cols x 6: gain of Y, Cr, Cb, then bias of Y, Cr, Cb of each quad.");
}

Alignment alignImages(const std::vector<std::pair<int, int>>& corners, const std::vector<Pixels>& images,
                      const std::vector<Pixels>& masks, const Params& params, const py::object& progress)
{
    Watch watch(progress);
    std::vector<cv::Point> places;
    for (const auto& corner : corners)
        places.emplace_back(corner.first, corner.second);
    const std::vector<cv::Mat> pictures = matsOf(images);
    const std::vector<cv::Mat> inside = matsOf(masks);
    return watch.run([&] { return Aligner::create(params)->align(places, pictures, inside, {}, watch.progress()); });
}

} // namespace

void bindAlignment(py::module_& module)
{
    bindReport(module);
    bindImage(module);
    py::class_<Alignment>(module, "Alignment", "The result of an alignment: a mesh and colours of each image, and a report.")
        .def_property_readonly("ok", &Alignment::ok, "Whether the images were refined as asked.")
        .def_property_readonly("status", [](const Alignment& self) { return toString(self.report().status); },
                               "'ok', 'rough', 'no_alignment' or 'cancelled'.")
        .def_property_readonly("message", [](const Alignment& self) { return self.report().message; },
                               "Why the status is not 'ok', or what is missing although it is; else empty.")
        .def_property_readonly("report", [](const Alignment& self) { return self.report(); }, "How it came about.")
        .def_property_readonly("canvas_scale",
                               [](const Alignment& self)
                               { return std::make_pair(self.canvasScale().width, self.canvasScale().height); },
                               "Working canvas pixels per full-resolution canvas pixel, in x and in y.")
        .def("__len__", &Alignment::imageCount)
        .def("__getitem__",
             [](const Alignment& self, int index)
             {
                 const int at = index < 0 ? index + self.imageCount() : index;
                 if (at < 0 || at >= self.imageCount())
                     throw py::index_error(cv::format("there is no image %d; the alignment has %d", index, self.imageCount()));
                 return self.image(at);
             },
             py::arg("index"))
        .def("rough", &Alignment::rough, "The alignment before refinement.")
        .def("save", [](const Alignment& self, const std::filesystem::path& path)
             { writeTo(path, [&](const std::string& name) { self.save(name); }); }, py::arg("path"),
             "Writes .yml, .xml or .json, with .gz behind it compressed.")
        .def_static("load", [](const std::filesystem::path& path) { return readFrom(path, &Alignment::load); }, py::arg("path"),
                    "Reads what save() wrote.")
        .def("__repr__", [](const Alignment& self)
             { return cv::format("<gcpw.Alignment of %d images: %s>", self.imageCount(), toString(self.report().status)); });
    module.def("align_images", &alignImages, py::arg("corners"), py::arg("images"), py::arg("masks"), py::arg("params"),
               py::arg("progress"));
}
