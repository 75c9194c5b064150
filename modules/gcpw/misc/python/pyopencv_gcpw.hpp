// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
// The binding generator's names of types that our headers have to write in full, and converters that it does not have.
#include <memory>
#include <vector>
#include <opencv2/gcpw.hpp>

typedef std::vector<cv::detail::CameraParams> vector_detail_CameraParams;
typedef std::vector<cv::Point2d> vector_Point2d;
typedef std::vector<cv::Vec4d> vector_Vec4d;
typedef std::vector<cv::gcpw::TermEnergy> vector_TermEnergy;
typedef std::vector<cv::gcpw::LevelReport> vector_LevelReport;
typedef std::vector<cv::gcpw::PairReport> vector_PairReport;

/// Lists of our own classes.
template <typename Value>
struct GcpwVecConverter
{
    static bool to(PyObject* object, std::vector<Value>& values, const ArgInfo& info)
    {
        return pyopencv_to_generic_vec(object, values, info);
    }

    static PyObject* from(const std::vector<Value>& values)
    {
        return pyopencv_from_generic_vec(values);
    }
};

template <>
struct pyopencvVecConverter<cv::gcpw::TermEnergy> : GcpwVecConverter<cv::gcpw::TermEnergy>
{
};

template <>
struct pyopencvVecConverter<cv::gcpw::LevelReport> : GcpwVecConverter<cv::gcpw::LevelReport>
{
};

template <>
struct pyopencvVecConverter<cv::gcpw::PairReport> : GcpwVecConverter<cv::gcpw::PairReport>
{
};

/// A Python function as cv::gcpw::Progress. It is called, and let go of, with the interpreter's lock.
template <>
bool pyopencv_to(PyObject* object, cv::gcpw::Progress& progress, const ArgInfo& info)
{
    if (!object || object == Py_None)
        return true;
    if (!PyCallable_Check(object))
    {
        failmsg("'%s' is no function of stage and fraction", info.name);
        return false;
    }
    Py_INCREF(object);
    const std::shared_ptr<PyObject> function(object, [](PyObject* kept)
    {
        PyEnsureGIL locked;
        Py_DECREF(kept);
    });
    progress = [function](const std::string& stage, double fraction)
    {
        PyEnsureGIL locked;
        PyObject* const answer = PyErr_CheckSignals() == 0 ? PyObject_CallFunction(function.get(), "sd", stage.c_str(), fraction) : NULL;
        if (!answer)
            PyErr_WriteUnraisable(function.get());
        const bool go_on = answer && answer != Py_False;
        Py_XDECREF(answer);
        return go_on;
    };
    return true;
}
