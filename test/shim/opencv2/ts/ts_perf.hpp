// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_TEST_SHIM_TS_PERF_HPP
#define GCPW_TEST_SHIM_TS_PERF_HPP

/** @file
PERF_TEST and PERF_TEST_P of OpenCV's ts over Google Benchmark. One TEST_CYCLE a test. No sanity data is kept: the
tests in test/ say what is right, this says how fast. */

#include <benchmark/benchmark.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include <opencv2/core.hpp>

namespace perf
{

class TestBase
{
public:
    virtual ~TestBase() = default;
    void run(benchmark::State& state)
    {
        state_ = &state;
        SetUp();
        PerfTestBody();
        TearDown();
    }

protected:
    /// Takes hints such as declare.in(a).time(10), which Google Benchmark does not need.
    struct Declare
    {
        Declare& in(cv::InputOutputArray, cv::InputOutputArray = cv::noArray()) { return *this; }
        Declare& out(cv::InputOutputArray, cv::InputOutputArray = cv::noArray()) { return *this; }
        Declare& time(double) { return *this; }
        Declare& iterations(unsigned) { return *this; }
    };

    virtual void SetUp() {}
    virtual void TearDown() {}
    virtual void PerfTestBody() = 0;
    bool keepRunning() { return state_->KeepRunning(); }

    Declare declare;

private:
    benchmark::State* state_ = nullptr;
};

template <typename T>
class TestBaseWithParam : public TestBase
{
public:
    using ParamType = T;
    const T& GetParam() const { return param_; }
    void setParam(const T& param) { param_ = param; }

private:
    T param_{};
};

/// Registers one benchmark; returns a value so that a static initialiser can call it.
template <typename Test>
bool registerTest(const std::string& name)
{
    benchmark::RegisterBenchmark(name.c_str(), [](benchmark::State& state) { Test().run(state); });
    return true;
}

/// Registers one benchmark for each parameter of a GoogleTest generator such as testing::Values or testing::Combine.
template <typename Test>
bool registerTests(const std::string& name, const testing::internal::ParamGenerator<typename Test::ParamType>& params)
{
    for (const typename Test::ParamType& param : params)
    {
        const auto body = [param](benchmark::State& state)
        {
            Test test;
            test.setParam(param);
            test.run(state);
        };
        benchmark::RegisterBenchmark((name + "/" + testing::PrintToString(param)).c_str(), body);
    }
    return true;
}

} // namespace perf

namespace opencv_test
{

using namespace perf;

} // namespace opencv_test

#define GCPW_SHIM_PERF_CLASS(name, parent)                                                                             \
    class name : public parent                                                                                         \
    {                                                                                                                  \
    protected:                                                                                                         \
        void PerfTestBody() override;                                                                                  \
    };

#define PERF_TEST(suite, name)                                                                                         \
    GCPW_SHIM_PERF_CLASS(suite##_##name##_Perf, ::perf::TestBase)                                                      \
    const bool suite##_##name##_registered = ::perf::registerTest<suite##_##name##_Perf>(#suite "." #name);            \
    void suite##_##name##_Perf::PerfTestBody()

#define PERF_TEST_P(fixture, name, params)                                                                             \
    GCPW_SHIM_PERF_CLASS(fixture##_##name##_Perf, fixture)                                                             \
    const bool fixture##_##name##_registered =                                                                         \
        ::perf::registerTests<fixture##_##name##_Perf>(#fixture "." #name, params);                                    \
    void fixture##_##name##_Perf::PerfTestBody()

#define TEST_CYCLE() while (this->keepRunning())
#define SANITY_CHECK_NOTHING() (void)0

#define CV_PERF_TEST_MAIN(module)                                                                                      \
    int main(int argc, char** argv)                                                                                    \
    {                                                                                                                  \
        benchmark::Initialize(&argc, argv);                                                                            \
        if (benchmark::ReportUnrecognizedArguments(argc, argv))                                                        \
            return 2;                                                                                                  \
        benchmark::RunSpecifiedBenchmarks();                                                                           \
        return 0;                                                                                                      \
    }

#endif
