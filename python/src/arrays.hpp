// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_PYTHON_ARRAYS_HPP
#define GCPW_PYTHON_ARRAYS_HPP

#include <opencv2/core.hpp>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <string>
#include <vector>

/** @brief An argument that Python gave as a NumPy array, seen as a cv::Mat without a copy where its rows are contiguous.

The array is kept alive as long as this; C++ reads it while other Python threads run. */
struct Pixels
{
    pybind11::array owner;
    cv::Mat mat;
    bool shared = false; ///< mat shows the caller's own pixels, and they may be written
};

/// The Mats of several arguments; valid as long as these.
std::vector<cv::Mat> matsOf(const std::vector<Pixels>& pixels);

/// A NumPy array that shows a Mat without a copy and keeps its pixels alive.
pybind11::array arrayOf(const cv::Mat& mat);

/// The same of points, as N x 2 (or 4) CV_64F.
template <typename Point>
pybind11::array arrayOf(const std::vector<Point>& points)
{
    const int columns = static_cast<int>(sizeof(Point) / sizeof(double));
    return arrayOf(points.empty() ? cv::Mat(0, columns, CV_64F) : cv::Mat(points).reshape(1).clone());
}

/// Points of an N x 2 (or 4) array. Throws cv::Exception that names it if it has another shape.
template <typename Point>
std::vector<Point> pointsOf(const Pixels& pixels, const std::string& name)
{
    const int columns = static_cast<int>(sizeof(Point) / sizeof(double));
    if (pixels.mat.total() == 0)
        return {};
    if (pixels.mat.channels() != 1 || pixels.mat.cols != columns)
        CV_Error(cv::Error::StsUnmatchedSizes, cv::format("%s is an array of N x %d numbers; its shape is %d x %d", name.c_str(), columns,
                                                          pixels.mat.rows, pixels.mat.cols * pixels.mat.channels()));
    cv::Mat rows;
    pixels.mat.convertTo(rows, CV_64F);
    return std::vector<Point>(rows.ptr<Point>(), rows.ptr<Point>() + rows.rows);
}

/// A photograph as cv::Stitcher takes it: 8-bit BGR, from 8- or 16-bit BGR, BGRA or gray. Throws cv::Exception for any other.
cv::Mat bgrOf(const cv::Mat& photograph, size_t number);

namespace pybind11
{
namespace detail
{

template <>
struct type_caster<Pixels>
{
    PYBIND11_TYPE_CASTER(Pixels, const_name("numpy.ndarray"));

    bool load(handle source, bool convert);
};

} // namespace detail
} // namespace pybind11

#endif
