// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_PAIR_JOB_HPP
#define GCPW_APPS_PAIR_JOB_HPP

#include <string>
#include <vector>
#include <opencv2/gcpw/pair.hpp>
#include "common/command_line.hpp"
#include "common/encode_picture.hpp"
#include "evaluation/methods.hpp"

/// Everything one run of gcpw_pair is asked to do.
struct PairJob
{
    std::string source;
    std::string target;
    std::string render_source; ///< shown in place of the source; empty for the source itself
    std::string output = "pano.png";
    std::string dump;
    std::string report;    ///< a folder for a page, or a file ending in .json
    std::string synthetic; ///< folder; then nothing is stitched
    std::string crop = "none";
    cv::gcpw::Blend blend = cv::gcpw::Blend::MULTIBAND;
    cv::gcpw::View view = cv::gcpw::View::NATURAL;
    cv::gcpw::Params params;
    const evaluation::PairMethod* method = nullptr;
    PictureFormat format;
};

/// The options of gcpw_pair. Declares them in its constructor; job() once they are parsed.
class PairOptions
{
public:
    PairOptions();

    CommandLine& line() { return line_; }

    /// Checks everything that can be checked before any work. @throws WrongUse, FileTrouble
    PairJob job(Console& console);

private:
    void planOutputs(Console& console) const;

    CommandLine line_;
    PairJob job_;
    std::vector<std::string> arguments_;
    std::string method_ = "gcpw";
    std::string blend_ = "multiband";
    std::string view_;
    std::string settings_;
    double work_megapix_;
    bool paper_ = false;
    bool preview_ = false;
};

#endif
