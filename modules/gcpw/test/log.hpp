// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_LOG_HPP
#define OPENCV_GCPW_TEST_LOG_HPP

#include "test_precomp.hpp"

#include <iostream>
#include <sstream>
#include <string>
#include <opencv2/core/utils/logger.hpp>

namespace opencv_test
{

/// What goes to std::cerr while it lives, warnings of OpenCV's log among it.
class Log
{
public:
    Log() : before_(std::cerr.rdbuf(text_.rdbuf())), level_(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_WARNING)) {}
    ~Log()
    {
        std::cerr.rdbuf(before_);
        cv::utils::logging::setLogLevel(level_);
    }

    int count(const std::string& words) const
    {
        const std::string text = text_.str();
        int found = 0;
        for (size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1))
            ++found;
        return found;
    }

private:
    std::ostringstream text_;
    std::streambuf* before_;
    cv::utils::logging::LogLevel level_;
};

} // namespace opencv_test

#endif
