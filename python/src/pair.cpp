// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <opencv2/gcpw/pair.hpp>
#include <pybind11/stl.h>
#include <utility>
#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"

namespace py = pybind11;
using namespace cv::gcpw;

namespace
{

const std::pair<const char*, View> VIEWS[] = {{"target", View::TARGET}, {"natural", View::NATURAL}};
const std::pair<const char*, Blend> BLENDS[] = {{"average", Blend::AVERAGE}, {"multiband", Blend::MULTIBAND}};

PairMatches findPair(const Pixels& source, const Pixels& target, const Params& params, const py::object& progress)
{
    Watch watch(progress);
    return watch.run([&] { return findPairMatches(source.mat, target.mat, params, watch.progress()); });
}

Alignment alignPairOf(const Pixels& source, const Pixels& target, const Params& params, const PairMatches* matches,
                      const py::object& progress)
{
    Watch watch(progress);
    return watch.run([&]
    {
        return matches ? alignPair(source.mat, target.mat, *matches, params, watch.progress())
                       : alignPair(source.mat, target.mat, params, watch.progress());
    });
}

PairCanvas renderPairOf(const Alignment& alignment, const Pixels& source, const Pixels& target, const std::string& view)
{
    const View from = choose("view", view, VIEWS);
    py::gil_scoped_release unlocked;
    return renderPair(alignment, source.mat, target.mat, from);
}

py::array blendPairOf(const PairCanvas& canvas, const std::string& blend)
{
    const Blend how = choose("blend", blend, BLENDS);
    cv::Mat picture;
    {
        py::gil_scoped_release unlocked;
        picture = blendPair(canvas, how);
    }
    return arrayOf(picture);
}

/// An array that shows a member of PairCanvas.
template <cv::Mat PairCanvas::*MEMBER>
py::array member(const PairCanvas& canvas)
{
    return arrayOf(canvas.*MEMBER);
}

void bindMatches(py::module_& module)
{
    py::class_<PairMatches>(module, "PairMatches", "What two photographs have in common, found once or given by another matcher.")
        .def(py::init<>())
        .def_property_readonly("status", [](const PairMatches& self) { return toString(self.status); })
        .def_readonly("message", &PairMatches::message)
        .def_property("source_size", [](const PairMatches& self) { return std::make_pair(self.source_size.width, self.source_size.height); },
                      [](PairMatches& self, std::pair<int, int> size) { self.source_size = cv::Size(size.first, size.second); })
        .def_property("target_size", [](const PairMatches& self) { return std::make_pair(self.target_size.width, self.target_size.height); },
                      [](PairMatches& self, std::pair<int, int> size) { self.target_size = cv::Size(size.first, size.second); })
        .def_property("target_from_source", [](const PairMatches& self) { return arrayOf(cv::Mat(self.target_from_source)); },
                      [](PairMatches& self, const Pixels& homography)
                      {
                          if (homography.mat.rows != 3 || homography.mat.cols != 3 || homography.mat.channels() != 1)
                              CV_Error(cv::Error::StsUnmatchedSizes, "target_from_source is a homography, 3 x 3 numbers");
                          homography.mat.convertTo(self.target_from_source, CV_64F);
                      })
        .def_property("source_points", [](const PairMatches& self) { return arrayOf(self.source_points); },
                      [](PairMatches& self, const Pixels& points) { self.source_points = pointsOf<cv::Point2d>(points, "source_points"); })
        .def_property("target_points", [](const PairMatches& self) { return arrayOf(self.target_points); },
                      [](PairMatches& self, const Pixels& points) { self.target_points = pointsOf<cv::Point2d>(points, "target_points"); })
        .def_property("source_lines", [](const PairMatches& self) { return arrayOf(self.source_lines); },
                      [](PairMatches& self, const Pixels& lines) { self.source_lines = pointsOf<cv::Vec4d>(lines, "source_lines"); })
        .def_property("target_lines", [](const PairMatches& self) { return arrayOf(self.target_lines); },
                      [](PairMatches& self, const Pixels& lines) { self.target_lines = pointsOf<cv::Vec4d>(lines, "target_lines"); })
        .def_readwrite("line_weights", &PairMatches::line_weights)
        .def("__repr__", [](const PairMatches& self)
             { return cv::format("<gcpw.PairMatches: %zu points, %zu lines>", self.source_points.size(), self.source_lines.size()); });
}

} // namespace

void bindPair(py::module_& module)
{
    bindMatches(module);
    py::class_<PairCanvas>(module, "PairCanvas", "Both photographs on one canvas; all images and masks have one size.")
        .def_property_readonly("source", &member<&PairCanvas::source>, "The warped source, colours unchanged.")
        .def_property_readonly("source_mask", &member<&PairCanvas::source_mask>, "255 where the source has pixels.")
        .def_property_readonly("source_corrected", &member<&PairCanvas::source_corrected>, "The warped source in the target's light.")
        .def_property_readonly("target", &member<&PairCanvas::target>, "The target as its view has it.")
        .def_property_readonly("target_corrected", &member<&PairCanvas::target_corrected>, "The target in the light of both, where its view says so.")
        .def_property_readonly("target_mask", &member<&PairCanvas::target_mask>, "255 where the target has pixels.")
        .def_property_readonly("mesh", &member<&PairCanvas::mesh>, "The mesh drawn over the mean of both.")
        .def_property_readonly("target_origin", [](const PairCanvas& self) { return std::make_pair(self.target_origin.x, self.target_origin.y); },
                               "Canvas pixel of the target's top-left pixel.")
        .def_property_readonly("canvas_from_target", &member<&PairCanvas::canvas_from_target>, "Homography from pixels of the target, 3 x 3.");
    py::class_<Score>(module, "Score", "How well two images line up; 0 is perfect, NaN where nothing could be compared.")
        .def_readonly("ncc", &Score::ncc)
        .def_readonly("zncc", &Score::zncc)
        .def("__repr__", [](const Score& self) { return cv::format("<gcpw.Score ncc %.2f, zncc %.2f>", self.ncc, self.zncc); });
    module.def("find_pair_matches", &findPair, py::arg("source"), py::arg("target"), py::arg("params"), py::arg("progress"));
    module.def("align_pair", &alignPairOf, py::arg("source"), py::arg("target"), py::arg("params"), py::arg("matches").none(true),
               py::arg("progress"));
    module.def("render_pair", &renderPairOf, py::arg("alignment"), py::arg("source"), py::arg("target"), py::arg("view"));
    module.def("blend_pair", &blendPairOf, py::arg("canvas"), py::arg("blend"));
    module.def("score_pair", &scorePair, py::arg("canvas"), py::call_guard<py::gil_scoped_release>());
}
