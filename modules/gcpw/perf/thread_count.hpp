// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PERF_THREAD_COUNT_HPP
#define OPENCV_GCPW_PERF_THREAD_COUNT_HPP

#include "perf_precomp.hpp"

namespace opencv_test
{

/// OpenCV's number of threads within a scope. Whatever does not compare threads is measured on one.
class ThreadCount
{
public:
    explicit ThreadCount(int threads) : before_(cv::getNumThreads()) { cv::setNumThreads(threads); }
    ~ThreadCount() { cv::setNumThreads(before_); }
    ThreadCount(const ThreadCount&) = delete;
    ThreadCount& operator=(const ThreadCount&) = delete;

private:
    int before_;
};

} // namespace opencv_test

#endif
