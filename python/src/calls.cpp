// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "calls.hpp"

#include <algorithm>
#include <cstdio>
#include <regex>

namespace py = pybind11;

namespace
{

struct Cancelled : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// What a CV_Check() wrote, which quotes itself: "> gcpw: one corner for each image (expected: ..".
bool isCheck(const cv::Exception& error)
{
    return error.code == cv::Error::StsError && error.err.compare(0, 2, "> ") == 0;
}

/// The sentence of an exception, without OpenCV's version, file, line, and marks of quotation.
std::string sentenceOf(const cv::Exception& error)
{
    std::string text = error.err.empty() ? error.msg : error.err;
    if (isCheck(error))
    {
        text = std::regex_replace(text, std::regex("(^|\\n)> *"), " ");
        text.erase(0, 1);
    }
    const std::string prefix = "gcpw: ";
    return text.compare(0, prefix.size(), prefix) == 0 ? text.substr(prefix.size()) : text;
}

/// What Python calls a fault of this code.
PyObject* kindOf(const cv::Exception& error, PyObject* fallback)
{
    switch (error.code)
    {
    case cv::Error::StsNoMem:
        return PyExc_MemoryError;
    case cv::Error::StsBadArg:
    case cv::Error::StsOutOfRange:
    case cv::Error::StsUnmatchedSizes:
    case cv::Error::StsUnmatchedFormats:
    case cv::Error::StsUnsupportedFormat:
    case cv::Error::StsBadSize:
    case cv::Error::StsAssert:
    case cv::Error::StsNullPtr:
    case cv::Error::StsParseError:
        return PyExc_ValueError;
    default:
        return isCheck(error) ? PyExc_ValueError : fallback;
    }
}

} // namespace

bool Watch::goOn(const std::string& stage, double fraction)
{
    if (stopped_)
        return false;
    py::gil_scoped_acquire locked;
    try
    {
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
        if (!function_.is_none())
        {
            const py::object answer = function_(stage, std::min(1.0, std::max(0.0, fraction)));
            stopped_ = answer.ptr() == Py_False;
        }
    }
    catch (...)
    {
        stopped_ = true;
        raised_ = std::current_exception();
    }
    return !stopped_;
}

cv::gcpw::Progress Watch::progress()
{
    return [this](const std::string& stage, double fraction) { return goOn(stage, fraction); };
}

void Watch::tell(const std::string& stage, double fraction)
{
    if (!goOn(stage, fraction))
        throw Stopped();
}

void Watch::end() const
{
    if (raised_)
        std::rethrow_exception(raised_);
    throw Cancelled("cancelled: the progress function returned False");
}

void checkReadable(const std::string& path)
{
    std::FILE* const file = std::fopen(path.c_str(), "rb");
    if (!file)
    {
        PyErr_SetFromErrnoWithFilename(PyExc_OSError, path.c_str());
        throw py::error_already_set();
    }
    std::fclose(file);
}

void raiseOsError(const cv::Exception& error)
{
    if (error.code != cv::Error::StsError || isCheck(error))
        throw error;
    PyErr_SetString(PyExc_OSError, sentenceOf(error).c_str());
    throw py::error_already_set();
}

void bindErrors(py::module_& module)
{
    // Never destroyed: the interpreter is gone when C++ destroys its statics.
    static auto& error = *new py::exception<std::runtime_error>(module, "Error");
    static auto& no_alignment = *new py::exception<NoAlignment>(module, "NoAlignmentError", error.ptr());
    static auto& cancelled = *new py::exception<Cancelled>(module, "CancelledError", error.ptr());
    for (const py::object& kind : {py::object(error), py::object(no_alignment), py::object(cancelled)})
        kind.attr("__module__") = "gcpw";
    error.attr("__doc__") = "What went wrong although the call was right. The message says what to do.";
    no_alignment.attr("__doc__") = "The photographs do not match, or too few of them.";
    cancelled.attr("__doc__") = "The progress function returned False.";
    py::register_exception_translator([](std::exception_ptr thrown)
    {
        try
        {
            std::rethrow_exception(thrown);
        }
        catch (const NoAlignment& fault)
        {
            PyErr_SetString(no_alignment.ptr(), fault.what());
        }
        catch (const Cancelled& fault)
        {
            PyErr_SetString(cancelled.ptr(), fault.what());
        }
        catch (const cv::Exception& fault)
        {
            PyErr_SetString(kindOf(fault, error.ptr()), sentenceOf(fault).c_str());
        }
    });
}
