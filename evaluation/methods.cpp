// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/methods.hpp"

#include <opencv2/imgproc.hpp>
#include "evaluation/apap.hpp"
#include "evaluation/color_remap.hpp"
#include "evaluation/locality_sensitive_histogram.hpp"

namespace evaluation
{

namespace
{

using cv::Mat;
using cv::gcpw::Alignment;
using cv::gcpw::Method;
using cv::gcpw::PairMatches;
using cv::gcpw::Params;
using cv::gcpw::Progress;

/// The methods before GCPW as they were published: what this module adds for lines and shapes is not theirs.
void forgetShapes(Params& params)
{
    const Params alignment_only = Params::alignmentOnly();
    if (params.similarityWeight == Params().similarityWeight)
        params.similarityWeight = alignment_only.similarityWeight;
    params.straightnessWeight = alignment_only.straightnessWeight;
    params.stretchLimit = alignment_only.stretchLimit;
    params.distortionPrice = alignment_only.distortionPrice;
    params.outsideWeight = alignment_only.outsideWeight;
}

template <Method METHOD>
Alignment alignBy(const Mat& source, const Mat& target, const PairMatches& matches, const Params& params, const Progress& progress)
{
    Params own = params;
    own.method = METHOD;
    if (METHOD != Method::GCPW)
        forgetShapes(own);
    return cv::gcpw::alignPair(source, target, matches, own, progress);
}

/// An alignment of prepared images, with the time of the preparation added.
Alignment withPreparation(const Alignment& alignment, double preparation_ms)
{
    cv::gcpw::Report report = alignment.report();
    report.timings_ms.align += preparation_ms;
    report.timings_ms.total += preparation_ms;
    std::vector<Alignment::Image> images;
    for (int i = 0; i < alignment.imageCount(); ++i)
        images.push_back(alignment.image(i));
    return Alignment(images, alignment.canvasScale(), report);
}

/// The colours of a photograph, CV_8UC3, and what is left to say which of its pixels are valid.
struct Colors
{
    Mat bgr;
    Mat alpha; ///< CV_8UC1, empty if all are

    explicit Colors(const Mat& photograph)
    {
        Mat bytes = photograph;
        if (photograph.depth() == CV_16U)
            photograph.convertTo(bytes, CV_8U, 1.0 / 257);
        if (bytes.channels() == 4)
            cv::extractChannel(bytes, alpha, 3);
        if (bytes.channels() == 3)
            bgr = bytes;
        else
            cv::cvtColor(bytes, bgr, bytes.channels() == 4 ? cv::COLOR_BGRA2BGR : cv::COLOR_GRAY2BGR);
    }

    /// Other colours with the same valid pixels.
    Mat withColors(const Mat& other) const
    {
        if (alpha.empty())
            return other;
        Mat result;
        cv::merge(std::vector<Mat>{other, alpha}, result);
        return result;
    }
};

/// MF-W whose pixels are those of the images that `prepare` makes.
template <typename Prepare>
Alignment alignPrepared(Prepare prepare, const PairMatches& matches, const Params& params, const Progress& progress)
{
    cv::TickMeter clock;
    clock.start();
    Mat source;
    Mat target;
    prepare(source, target);
    clock.stop();
    return withPreparation(alignBy<Method::MFW>(source, target, matches, params, progress), clock.getTimeMilli());
}

Alignment alignLsh(const Mat& source, const Mat& target, const PairMatches& matches, const Params& params, const Progress& progress)
{
    const auto prepare = [&](Mat& source_feature, Mat& target_feature)
    {
        const Colors source_colors(source);
        const Colors target_colors(target);
        source_feature = source_colors.withColors(invariantImage(source_colors.bgr));
        target_feature = target_colors.withColors(invariantImage(target_colors.bgr));
    };
    return alignPrepared(prepare, matches, params, progress);
}

Alignment alignRemapped(const Mat& source, const Mat& target, const PairMatches& matches, const Params& params,
                        const Progress& progress)
{
    const auto prepare = [&](Mat& remapped, Mat& same)
    {
        const Colors colors(source);
        remapped = colors.withColors(applyColorCurves(colors.bgr, overlapCurves(source, target, matches, params)));
        same = target;
    };
    return alignPrepared(prepare, matches, params, progress);
}

Alignment alignMovingDlt(const Mat& source, const Mat& target, const PairMatches& matches, const Params& params, const Progress&)
{
    return alignApap(source, target, matches, params);
}

} // namespace

const std::vector<PairMethod>& pairMethods()
{
    static const std::vector<PairMethod> methods = {
        {"global", "Global", false, alignBy<Method::GLOBAL>},
        {"apap", "APAP", false, alignMovingDlt},
        {"cpw", "CPW", false, alignBy<Method::CPW>},
        {"dfw", "DF-W", false, alignBy<Method::DFW>},
        {"mfw", "MF-W", true, alignBy<Method::MFW>},
        {"lsh_mfw", "LSH+MF-W", true, alignLsh},
        {"ros_mfw", "ROS+MF-W", true, alignRemapped},
        {"gcpw", "GCPW", true, alignBy<Method::GCPW>},
    };
    return methods;
}

const PairMethod* findPairMethod(const std::string& name)
{
    for (const PairMethod& method : pairMethods())
        if (name == method.name)
            return &method;
    return nullptr;
}

std::string pairMethodNames()
{
    std::string names;
    for (const PairMethod& method : pairMethods())
        names += (names.empty() ? "" : ", ") + method.name;
    return names;
}

} // namespace evaluation
