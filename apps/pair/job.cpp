// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "pair/job.hpp"

#include "common/input_list.hpp"
#include "common/output_plan.hpp"
#include "common/paths.hpp"
#include "common/program.hpp"
#include "report/report.hpp"

using cv::gcpw::Blend;
using cv::gcpw::Params;
using cv::gcpw::View;

namespace
{

const double PREVIEW_MEGAPIX = 0.15; ///< of --preview, for a look within a second or two

const CommandLine::Texts TEXTS = {
    "gcpw_pair",
    "Stitches two overlapping photographs with Generalized Content-Preserving Warps.\n"
    "Exit code: 0 stitched, 1 no answer (they do not match), 2 wrong use, 3 could not read or write a file.",
    "gcpw_pair SOURCE TARGET [options]\n"
    "  SOURCE is warped, TARGET is what it is aligned to. Transparent pixels are not used.",
    {"gcpw_pair left.jpg right.jpg --output pano.jpg", "both seen from between them",
     "gcpw_pair left.jpg right.jpg --view=target -o pano.tif", "the target keeps its frame and pixels",
     "gcpw_pair left.jpg right.jpg --method global --report report.json", "another method, and its scores",
     "gcpw_pair --synthetic photos", "two photographs of a painted scene, to try it"}};

std::vector<std::string> methodNames()
{
    std::vector<std::string> names;
    for (const evaluation::PairMethod& method : evaluation::pairMethods())
        names.emplace_back(method.name);
    return names;
}

} // namespace

PairOptions::PairOptions() : line_(TEXTS), work_megapix_(Params().workMegapix)
{
    line_.arguments(arguments_);
    line_.group("Alignment");
    line_.choice("-m,--method", method_, methodNames(),
                 "gcpw, its special cases global, cpw, dfw, mfw, or a rival: apap, lsh_mfw, ros_mfw");
    line_.number("--work_megapix", work_megapix_, {LEAST_MEGAPIX, MOST_MEGAPIX, "million pixels"},
                 "resolution of the estimation, million pixels");
    line_.flag("--paper", paper_, "the paper's constants instead of the defaults");
    line_.text("--set", settings_, "NAME=VALUE,..", "further parameters; see gcpw::Params");
    line_.group("Picture");
    line_.choice("--view", view_, {"natural", "target"},
                 "natural: seen from between both, little stretched; target: the target keeps its frame and pixels. "
                 "Default natural, with "
                 "--paper target");
    line_.choice("--blend", blend_, {"multiband", "average"},
                 "multiband: seam and multi-band blender; average: the paper's plain mean");
    line_.choice("--crop", job_.crop, {"none", "auto"}, "auto: the largest rectangle without empty corners");
    line_.flag("-p,--preview", preview_, "a small picture in a short time");
    line_.text("--render_source", job_.render_source, "FILE",
               "estimate on SOURCE but show this file, which must have its size");
    line_.group("Outputs");
    line_.text("-o,--output", job_.output, "FILE",
               "the panorama: .jpg, .png, .tif, .webp, ..; - is standard output, as PNG. Profile and EXIF of the "
               "target go with it");
    declareFormat(line_, job_.format);
    line_.text("--report", job_.report, "FOLDER",
               "for a page that shows the result, index.html, and report.json; a name ending in .json is a file, for "
               "that alone");
    line_.text("--dump", job_.dump, "FOLDER",
               "for source.png, source_mask.png, target.png, target_mask.png, source_corrected.png, mesh.png and the "
               "alignment, model.yml.gz");
    line_.text("--synthetic", job_.synthetic, "FOLDER",
               "write source.png and target.png of a synthetic scene into it and stop");
}

void PairOptions::planOutputs(Console& console) const
{
    OutputPlan plan;
    if (!job_.synthetic.empty())
    {
        plan.writesFolder("--synthetic", job_.synthetic);
        plan.check(line_.force);
        return;
    }
    for (const std::string* input : {&job_.source, &job_.target, &job_.render_source})
        if (!input->empty())
            plan.reads(*input);
    plan.writesPicture("--output", job_.output);
    report::addTo(plan, job_.report);
    plan.writesFolder("--dump", job_.dump);
    plan.check(line_.force);
    if (plan.usesStandardOutput())
        console.keepOutputFree();
}

PairJob PairOptions::job(Console& console)
{
    if (!job_.synthetic.empty())
    {
        planOutputs(console);
        return job_;
    }
    const std::vector<std::string> photographs = arguments_.size() == 1 ? listPhotographs(arguments_) : arguments_;
    if (photographs.size() < 2)
        throw WrongUse("two photographs are needed: gcpw_pair SOURCE TARGET; --help lists the options");
    if (photographs.size() > 2)
        throw WrongUse("two photographs are stitched: gcpw_pair SOURCE TARGET; gcpw_stitch takes more");
    job_.source = photographs[0];
    job_.target = photographs[1];
    job_.blend = blend_ == "average" ? Blend::AVERAGE : Blend::MULTIBAND;
    job_.view = view_ == "target" || (view_.empty() && paper_) ? View::TARGET : View::NATURAL;
    if (paper_)
        job_.params = Params::paper();
    job_.method = evaluation::findPairMethod(method_);
    if (preview_)
        job_.params.workMegapix = job_.params.featureMegapix = PREVIEW_MEGAPIX;
    if (line_.given("--work_megapix"))
        job_.params.workMegapix = work_megapix_;
    applySettings(settings_, job_.params);
    planOutputs(console);
    return job_;
}
