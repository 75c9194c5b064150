// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "arrays.hpp"

#include <opencv2/imgproc.hpp>

namespace py = pybind11;

namespace
{

/// OpenCV's depth of a NumPy type, -1 if it has none.
int depthOf(const py::dtype& type)
{
    const char kind = type.kind();
    const auto size = type.itemsize();
    if (kind == 'b' || (kind == 'u' && size == 1))
        return CV_8U;
    if (kind == 'i' && size == 1)
        return CV_8S;
    if (kind == 'u' && size == 2)
        return CV_16U;
    if (kind == 'i' && size == 2)
        return CV_16S;
    if (kind == 'i' && size == 4)
        return CV_32S;
    if (kind == 'f' && size == 4)
        return CV_32F;
    return kind == 'f' && size == 8 ? CV_64F : -1;
}

py::dtype typeOf(int depth)
{
    switch (depth)
    {
    case CV_8U:
        return py::dtype::of<uint8_t>();
    case CV_8S:
        return py::dtype::of<int8_t>();
    case CV_16U:
        return py::dtype::of<uint16_t>();
    case CV_16S:
        return py::dtype::of<int16_t>();
    case CV_32S:
        return py::dtype::of<int32_t>();
    case CV_32F:
        return py::dtype::of<float>();
    default:
        return py::dtype::of<double>();
    }
}

/// Whether a Mat can show the array as it is: pixels of a row one behind the other, rows in order.
bool isPlain(const py::array& array)
{
    const py::ssize_t item = array.itemsize();
    const py::ssize_t channels = array.ndim() == 3 ? array.shape(2) : 1;
    if (array.size() == 0)
        return false;
    if (array.ndim() == 3 && channels > 1 && array.strides(2) != item)
        return false;
    if (array.shape(1) > 1 && array.strides(1) != item * channels)
        return false;
    return array.shape(0) == 1 || array.strides(0) >= item * channels * array.shape(1);
}

} // namespace

bool py::detail::type_caster<Pixels>::load(handle source, bool)
{
    if (!py::isinstance<py::array>(source))
        return false;
    py::array array = py::reinterpret_borrow<py::array>(source);
    if (array.ndim() == 1)
        array = array.reshape({array.shape(0), py::ssize_t(1)});
    const int depth = depthOf(array.dtype());
    if (array.ndim() < 2 || array.ndim() > 3 || depth < 0 || (array.ndim() == 3 && (array.shape(2) < 1 || array.shape(2) > CV_CN_MAX)))
        throw py::type_error("gcpw: an array of " + std::to_string(array.ndim()) + " dimensions and type " +
                             std::string(py::str(array.dtype())) +
                             " is no picture: rows x columns (x channels) of uint8 are wanted; use array.astype(numpy.uint8)");
    const bool native = py::bool_(array.dtype().attr("isnative"));
    value.shared = native && isPlain(array) && array.writeable() && array.ptr() == source.ptr();
    if (!native || !isPlain(array))
        array = py::array::ensure(array.attr("astype")(typeOf(depth)), py::array::c_style);
    if (!array)
        throw py::error_already_set();
    const int rows = static_cast<int>(array.shape(0));
    const int cols = static_cast<int>(array.shape(1));
    const int type = CV_MAKETYPE(depth, array.ndim() == 3 ? static_cast<int>(array.shape(2)) : 1);
    // A Mat has no constant pixels; nothing here writes to those that are not `shared`.
    void* const data = const_cast<void*>(array.data());
    const size_t step = rows > 1 ? static_cast<size_t>(array.strides(0)) : static_cast<size_t>(cv::Mat::AUTO_STEP);
    value.mat = array.size() == 0 ? cv::Mat(rows, cols, type) : cv::Mat(rows, cols, type, data, step);
    value.owner = array;
    return true;
}

std::vector<cv::Mat> matsOf(const std::vector<Pixels>& pixels)
{
    std::vector<cv::Mat> mats;
    for (const Pixels& one : pixels)
        mats.push_back(one.mat);
    return mats;
}

py::array arrayOf(const cv::Mat& mat)
{
    const py::ssize_t channels = mat.channels();
    std::vector<py::ssize_t> shape = {mat.rows, mat.cols};
    std::vector<py::ssize_t> strides = {static_cast<py::ssize_t>(mat.step[0]), static_cast<py::ssize_t>(mat.elemSize())};
    if (channels > 1)
    {
        shape.push_back(channels);
        strides.push_back(static_cast<py::ssize_t>(mat.elemSize1()));
    }
    if (mat.empty())
        return py::array(typeOf(mat.depth()), shape);
    const py::capsule keeper(new cv::Mat(mat), [](void* kept) { delete static_cast<cv::Mat*>(kept); });
    return py::array(typeOf(mat.depth()), shape, strides, mat.data, keeper);
}

cv::Mat bgrOf(const cv::Mat& photograph, size_t number)
{
    const int depth = photograph.depth();
    const int channels = photograph.channels();
    if (photograph.empty())
        CV_Error(cv::Error::StsBadArg, cv::format("photograph %zu is empty: was its file read?", number + 1));
    if ((depth != CV_8U && depth != CV_16U) || (channels != 1 && channels != 3 && channels != 4))
        CV_Error(cv::Error::StsBadArg, cv::format("photograph %zu is of type %s; 8 or 16 bits with 1, 3 (BGR) or 4 channels (BGRA) are taken",
                                                  number + 1, cv::typeToString(photograph.type()).c_str()));
    cv::Mat bgr = photograph;
    if (depth == CV_16U)
        bgr.convertTo(bgr, CV_8U, 1.0 / 257); // 65535 becomes 255
    if (channels != 3)
        cv::cvtColor(bgr, bgr, channels == 1 ? cv::COLOR_GRAY2BGR : cv::COLOR_BGRA2BGR);
    return bgr;
}
