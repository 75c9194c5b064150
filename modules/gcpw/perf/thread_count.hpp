// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
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
