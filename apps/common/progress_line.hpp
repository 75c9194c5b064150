// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_PROGRESS_LINE_HPP
#define GCPW_APPS_PROGRESS_LINE_HPP

#include <chrono>
#include <mutex>
#include <string>
#include <vector>
#include <opencv2/gcpw/alignment.hpp>

/** @brief One line on the terminal with the stage, the share of the whole work that is done, and the time left.

The whole is all stages, each with the share of the time that it usually takes. Silent where standard error is no terminal. */
class ProgressLine
{
public:
    struct Stage
    {
        std::string name;
        double share; ///< of the whole time; any unit
    };

    /// @param shown false for a line that is never shown
    ProgressLine(const std::vector<Stage>& stages, bool shown);
    ~ProgressLine() { erase(); }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// The stage of this name begins; what lies before it is done.
    void begin(const std::string& stage);

    /// @param fraction of the present stage, 0 to 1; from any thread
    void show(double fraction);

    /** @brief show() for the module's functions, which name stages of their own: together these are the present stage of the line.
    @param parts the module's stages in their order, each with its share of the time; others are not shown
    @return empty if the line is never shown */
    cv::gcpw::Progress callback(const std::vector<Stage>& parts);

    /// Wipes the line, before something else is written.
    static void erase();

    /// What is done of all stages when one of them has come to a fraction of itself, 0 to 1. @param present its index
    static double doneOf(const std::vector<Stage>& stages, size_t present, double fraction);

    /// "1:05 left", or nothing where that cannot be told yet. @param done share of the whole @param seconds since the beginning
    static std::string timeLeft(double done, double seconds);

private:
    std::vector<Stage> stages_;
    bool shown_;
    size_t present_ = 0;
    double fraction_ = 0; ///< of the present stage
    std::chrono::steady_clock::time_point start_;
    std::mutex mutex_;
};

#endif
