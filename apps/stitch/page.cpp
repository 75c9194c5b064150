// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/page.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/gcpw/pair.hpp>
#include "report/pair_page.hpp"
#include "report/panorama_page.hpp"

namespace
{

using cv::gcpw::GcpwWarper;

const char* const PROGRAM = "gcpw_stitch";

std::vector<report::Timing> timingsOf(const Layout& layout, const Stages& stages)
{
    const double align = layout.rig.alignment.report().timings_ms.align; // 0 without a rig, and of one that was loaded
    return {{"Reading", stages.read},
            {"Keypoints, matches, cameras", std::max(stages.cameras - align, 0.0)},
            {"Alignment", align},
            {"Seams and blending", stages.compose}};
}

std::vector<std::string> messagesOf(const std::vector<Photograph>& photographs, const Layout& layout)
{
    std::vector<std::string> messages = layout.decisions;
    const auto kept = [&](size_t k)
    { return std::count(layout.component.begin(), layout.component.end(), static_cast<int>(k)) > 0; };
    for (size_t k = 0; layout.ok() && k < photographs.size(); ++k)
        if (!kept(k))
            messages.push_back(photographs[k].path +
                               " is not in the picture: it matches none of the others well enough");
    if (!layout.rig.alignment.report().message.empty())
        messages.push_back(layout.rig.alignment.report().message);
    return messages;
}

/// A picture as it was before it was made to stand.
cv::Mat lying(const Composition& composition)
{
    cv::Mat picture = composition.picture;
    if (composition.turns > 0)
        cv::rotate(composition.picture, picture = cv::Mat(),
                   composition.turns == 2   ? cv::ROTATE_180
                   : composition.turns == 1 ? cv::ROTATE_90_COUNTERCLOCKWISE
                                            : cv::ROTATE_90_CLOCKWISE);
    return picture;
}

/// What OpenCV alone makes of the same cameras.
report::Composed plainOf(const StitchJob& job, const std::vector<Photograph>& photographs, const Layout& layout)
{
    StitchJob plain_job = job;
    plain_job.gcpw = false;
    plain_job.plain_colors = true;
    Layout plain = layout;
    const auto bent = layout.warper.dynamicCast<GcpwWarper>();
    plain.warper = bent ? bent->base() : layout.warper;
    plain.compensator = compensatorOf(job.setup);
    plain_job.setup.seam = plainSeam(job.setup.seam);
    plain.seam_finder = seamFinderOf(plain_job.setup, {});
    const cv::Ptr<report::RecordedSeams> seams = recordSeams(plain);
    ProgressLine silent({}, false);
    const cv::Mat picture = compose(plain_job, photographs, plain, false, silent, {}).picture;
    return {picture, plain.warper, plain.compensator, seams};
}

report::Page pairPage(const StitchJob& job, const std::vector<Photograph>& photographs, const Composition& composition)
{
    report::PairRun run;
    run.program = PROGRAM;
    run.method = "GCPW";
    run.paths = {photographs[0].path, photographs[1].path};
    run.source = toBytes(photographs[0].image);
    run.target = toBytes(photographs[1].image);
    run.alignment = cv::gcpw::alignPair(run.source, run.target, job.params);
    run.canvas = cv::gcpw::renderPair(run.alignment, run.source, run.target, run.view);
    run.panorama = composition.picture;
    run.crop = composition.crop;
    const auto score = [&](const cv::gcpw::Alignment& alignment)
    { return cv::gcpw::scorePair(cv::gcpw::renderPair(alignment, run.source, run.target)).zncc; };
    run.zncc = {score(run.alignment.rough()), score(run.alignment)};
    return pageOf(run);
}

} // namespace

cv::Ptr<report::RecordedSeams> recordSeams(Layout& layout)
{
    const cv::Ptr<report::RecordedSeams> seams = cv::makePtr<report::RecordedSeams>(layout.seam_finder);
    layout.seam_finder = seams;
    return seams;
}

report::Page pageOf(const StitchJob& job, const std::vector<Photograph>& photographs, const Layout& layout,
                    const Composition& composition, const cv::Ptr<report::RecordedSeams>& seams, const Stages& stages)
{
    report::PanoramaRun run;
    run.program = PROGRAM;
    run.method = job.gcpw ? "GCPW" : "cv::Stitcher";
    run.status = layout.ok() ? "Stitched" : layout.trouble;
    for (const Photograph& photograph : photographs)
    {
        run.paths.push_back(photograph.path);
        run.cameras.photographs.push_back(toBytes(photograph.image));
    }
    run.timings = timingsOf(layout, stages);
    run.messages = messagesOf(photographs, layout);
    if (!layout.ok())
        return pageOf(run);
    if (!seams)
    {
        report::Page page = pairPage(job, photographs, composition);
        page.messages.insert(page.messages.begin(), run.messages.begin(), run.messages.end());
        page.timings = run.timings;
        return page;
    }
    run.cameras.component = layout.component;
    run.cameras.cameras = layout.cameras;
    run.cameras.focal = cv::gcpw::medianFocal(layout.cameras);
    run.cameras.work_scale = layout.work_scale;
    run.compose_scale = composeScale(job, photographs, layout);
    run.shown = {lying(composition), layout.warper, layout.compensator, seams};
    if (job.gcpw)
        run.plain = plainOf(job, photographs, layout);
    run.rig = job.gcpw ? &layout.rig : nullptr;
    run.turns = composition.turns;
    run.crop = composition.crop;
    return pageOf(run);
}
