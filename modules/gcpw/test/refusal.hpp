// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_REFUSAL_HPP
#define OPENCV_GCPW_TEST_REFUSAL_HPP

#include "test_precomp.hpp"

#include <functional>
#include <string>

namespace opencv_test
{

/// What a call says when it throws cv::Exception; empty if it does not.
inline std::string refusalOf(const std::function<void()>& call)
{
    try
    {
        call();
    }
    catch (const cv::Exception& error)
    {
        return error.err.empty() ? std::string("without a message") : error.err;
    }
    return std::string();
}

/// Expects a cv::Exception whose message contains `part`.
inline void expectRefused(const std::function<void()>& call, const std::string& part)
{
    const std::string refusal = refusalOf(call);
    EXPECT_NE(refusal.find(part), std::string::npos) << "'" << refusal << "' does not mention '" << part << "'";
}

inline void expectTaken(const std::function<void()>& call)
{
    EXPECT_EQ(refusalOf(call), "");
}

} // namespace opencv_test

#endif
