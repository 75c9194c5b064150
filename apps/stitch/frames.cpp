// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/frames.hpp"

#include "common/deep_exposure.hpp"
#include "common/write_file.hpp"

void dumpWarped(const StitchJob& job, const std::vector<Photograph>& photographs, const Layout& layout)
{
    makeFolder(job.dump);
    Warping warping(job, photographs, layout, false);
    std::string corners;
    for (size_t k = 0; k < layout.cameras.size(); ++k)
    {
        Warping::Warped warped = warping.warp(k);
        const std::string number = cv::format("%03d", layout.component[k]);
        writeImage(job.dump + "/" + number + "_image.png", warped.image);
        writeImage(job.dump + "/" + number + "_mask.png", warped.mask);
        correctExposure(*layout.compensator, static_cast<int>(k), warped.corner, warped.image, warped.mask);
        writeImage(job.dump + "/" + number + "_corrected.png", warped.image);
        corners += cv::format("%s,%d,%d\n", number.c_str(), warped.corner.x, warped.corner.y);
    }
    writeText(job.dump + "/corners.csv", corners);
}

void TimeLapse::write(size_t k, const Warping& warping, const Warping::Warped& warped)
{
    if (!timelapser_)
    {
        typedef cv::detail::Timelapser T;
        timelapser_ = T::createDefault(job_.timelapse == "crop" ? T::CROP : T::AS_IS);
        timelapser_->initialize(warping.corners(), warping.sizes());
    }
    cv::Mat image;
    toBytes(warped.image).convertTo(image, CV_16S);
    timelapser_->process(image, warped.mask, warped.corner);
    cv::Mat frame;
    timelapser_->getDst().getMat(cv::ACCESS_READ).convertTo(frame, CV_8U);
    writeImage(job_.frameOf(job_.paths[static_cast<size_t>(layout_.component[k])]), frame);
}
