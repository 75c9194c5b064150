// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/reduced_photographs.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include "common/read_all.hpp"

ReducedPhotographs readReduced(const StitchJob& job, const Console& console, ProgressLine& progress)
{
    ReducedPhotographs reduced;
    double work_scale = 1;
    const auto reduce = [&](Photograph& photograph)
    {
        const cv::Mat whole = photograph.image;
        if (reduced.seam_copies.empty()) // as estimateCameras() has it: the first gives one scale for all
        {
            work_scale = std::min(1.0, std::sqrt(job.setup.work_megapix * 1e6 / static_cast<double>(whole.total())));
            reduced.seam_scale = seamScale(job, photograph);
        }
        reduced.deep = reduced.deep || whole.depth() == CV_16U;
        reduced.seam_copies.push_back(seamCopy(whole, reduced.seam_scale));
        photograph.file_size = whole.size();
        photograph.scale = work_scale;
        if (work_scale < 1)
            cv::resize(toBytes(whole), photograph.image, cv::Size(), work_scale, work_scale, cv::INTER_LINEAR_EXACT);
    };
    reduced.photographs = readAll(job.paths, job.skip_bad, console, progress, reduce);
    return reduced;
}
