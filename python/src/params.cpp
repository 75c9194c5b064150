// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <cmath>
#include <opencv2/gcpw/params.hpp>
#include <pybind11/stl.h>
#include <string>
#include <utility>
#include "bindings.hpp"
#include "calls.hpp"

namespace py = pybind11;
using cv::gcpw::Method;
using cv::gcpw::Params;

namespace
{

const std::pair<const char*, Method> METHODS[] = {
    {"global", Method::GLOBAL}, {"cpw", Method::CPW}, {"dfw", Method::DFW}, {"mfw", Method::MFW}, {"gcpw", Method::GCPW}};

std::string methodOf(const Params& params)
{
    for (const auto& method : METHODS)
        if (method.second == params.method)
            return method.first;
    return "unknown";
}

/// Whether a member is an int: it refuses a fraction.
bool isWhole(const std::string& name)
{
    Params params;
    try
    {
        params.set(name, std::floor(params.get(name)) + 0.5);
    }
    catch (const cv::Exception&)
    {
        return true;
    }
    return false;
}

void setMember(Params& params, const std::string& name, const py::handle& value)
{
    if (name == "method")
        params.method = choose("method", value.cast<std::string>(), METHODS);
    else
        params.set(name, value.cast<double>());
}

std::string describe(const Params& params)
{
    const Params defaults;
    std::string text;
    if (params.method != defaults.method)
        text += "method='" + methodOf(params) + "'";
    for (const std::string& name : Params::names())
        if (params.get(name) != defaults.get(name))
            text += (text.empty() ? "" : ", ") + name + "=" + std::string(py::str(py::float_(params.get(name))));
    return "gcpw.Params(" + text + ")";
}

} // namespace

void bindParams(py::module_& module)
{
    py::class_<Params> params(module, "Params", "The parameters of the method, by the names that opencv2/gcpw/params.hpp explains.");
    params
        .def(py::init([](const py::kwargs& values)
             {
                 Params made;
                 for (const auto& item : values)
                     setMember(made, item.first.cast<std::string>(), item.second);
                 made.check();
                 return made;
             }),
             "The defaults, but for what is given by name: Params(meshCols=48, similarityWeight=0.1).")
        .def_static("paper", &Params::paper, "The constants of the paper.")
        .def_static("alignment_only", &Params::alignmentOnly, "The closest alignment of the overlap, whatever it does to lines and shapes.")
        .def("check", &Params::check, "Raises ValueError that names the first value out of its range.")
        .def("set", &Params::set, py::arg("name"), py::arg("value"), "Sets a number by its name.")
        .def("get", &Params::get, py::arg("name"), "A number by its name.")
        .def_static("names", &Params::names, "The names of all members but method.")
        .def_property("method", &methodOf, [](Params& self, const std::string& name) { self.method = choose("method", name, METHODS); },
                      "'global', 'cpw', 'dfw', 'mfw' or 'gcpw'.")
        .def("__repr__", &describe);
    for (const std::string& name : Params::names())
    {
        const auto set = [name](Params& self, double value) { self.set(name, value); };
        if (isWhole(name))
            params.def_property(name.c_str(), py::cpp_function([name](const Params& self) { return static_cast<int>(self.get(name)); }),
                                py::cpp_function(set));
        else
            params.def_property(name.c_str(), py::cpp_function([name](const Params& self) { return self.get(name); }),
                                py::cpp_function(set));
    }
}
