// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_TEST_SHIM_TS_HPP
#define GCPW_TEST_SHIM_TS_HPP

/** @file
The part of OpenCV's test module (ts) that the tests of this module use, over GoogleTest, for builds where ts is not at
hand. What is missing here does not compile; add it only with the meaning it has in ts. */

#include <gtest/gtest.h>

#include <string>

#include <opencv2/core.hpp>

// ts carries an older GoogleTest; both names work in both worlds.
#undef INSTANTIATE_TEST_CASE_P
#define INSTANTIATE_TEST_CASE_P INSTANTIATE_TEST_SUITE_P

// The GoogleTest of ts cannot skip.
#undef GTEST_SKIP

// The GoogleTest of ts looks at the first argument in sizeof(), where no lambda may stand before C++20.
namespace cvtest
{

template <size_t>
struct ShimEqHelper : testing::internal::EqHelper
{
};
char shimUnevaluated(...);

} // namespace cvtest
#define GCPW_SHIM_EQ(first) ::cvtest::ShimEqHelper<sizeof(::cvtest::shimUnevaluated(first))>::Compare
#undef EXPECT_EQ
#define EXPECT_EQ(first, second) EXPECT_PRED_FORMAT2(GCPW_SHIM_EQ(first), first, second)
#undef ASSERT_EQ
#define ASSERT_EQ(first, second) ASSERT_PRED_FORMAT2(GCPW_SHIM_EQ(first), first, second)

// Like ts, asks that tests live in namespace opencv_test.
#undef TEST
#define TEST(suite, name)                                                                                              \
    static_assert(required_opencv_test_namespace, "tests live in namespace opencv_test");                              \
    GTEST_TEST(suite, name)

namespace cvtest
{

inline double norm(const cv::Mat& src, int norm_type, const cv::Mat& mask = cv::Mat())
{
    return cv::norm(src, norm_type, mask);
}

inline double norm(const cv::Mat& src1, const cv::Mat& src2, int norm_type, const cv::Mat& mask = cv::Mat())
{
    return cv::norm(src1, src2, norm_type, mask);
}

} // namespace cvtest

namespace opencv_test
{

using namespace cvtest;
using namespace cv;

constexpr bool required_opencv_test_namespace = true;

// As in ts, where cvtest has an own version of each: a test says whether it means cv::norm() or cvtest::norm().
#define GCPW_SHIM_GUARD(name)                                                                                          \
    class required_namespace_specificatin_here_for_symbol_##name                                                       \
    {                                                                                                                  \
    };                                                                                                                 \
    using name = required_namespace_specificatin_here_for_symbol_##name;
GCPW_SHIM_GUARD(norm)
GCPW_SHIM_GUARD(add)
GCPW_SHIM_GUARD(multiply)
GCPW_SHIM_GUARD(divide)
GCPW_SHIM_GUARD(transpose)
GCPW_SHIM_GUARD(copyMakeBorder)
GCPW_SHIM_GUARD(filter2D)
GCPW_SHIM_GUARD(compare)
GCPW_SHIM_GUARD(minMaxIdx)
GCPW_SHIM_GUARD(threshold)

} // namespace opencv_test

#define CV_TEST_MAIN(resource_sub_directory)                                                                           \
    int main(int argc, char** argv)                                                                                    \
    {                                                                                                                  \
        ::testing::InitGoogleTest(&argc, argv);                                                                        \
        return RUN_ALL_TESTS();                                                                                        \
    }

#ifdef GCPW_TEST_SHIM_PERF
#include "opencv2/ts/ts_perf.hpp"
#endif

#endif
