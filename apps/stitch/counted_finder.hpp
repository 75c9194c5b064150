// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_COUNTED_FINDER_HPP
#define GCPW_APPS_COUNTED_FINDER_HPP

#include <functional>
#include <opencv2/features2d.hpp>

/// Another features finder that tells how many photographs are done: cv::Stitcher does not.
class CountedFinder : public cv::Feature2D
{
public:
    /** @param images how many photographs there are. cv::Stitcher detects in all of them, then describes what it found in all
    @param show called with the share that is done */
    CountedFinder(const cv::Ptr<cv::Feature2D>& finder, size_t images, const std::function<void(double)>& show)
        : finder_(finder), calls_(2 * images), show_(show)
    {
    }

    void detectAndCompute(cv::InputArray image, cv::InputArray mask, std::vector<cv::KeyPoint>& keypoints,
                          cv::OutputArray descriptors, bool use_provided) override
    {
        finder_->detectAndCompute(image, mask, keypoints, descriptors, use_provided);
        show_(std::min(1.0, static_cast<double>(++done_) / static_cast<double>(calls_)));
    }
    int descriptorSize() const override { return finder_->descriptorSize(); }
    int descriptorType() const override { return finder_->descriptorType(); }
    int defaultNorm() const override { return finder_->defaultNorm(); }
    bool empty() const override { return finder_->empty(); }
    cv::String getDefaultName() const override { return finder_->getDefaultName(); }

private:
    cv::Ptr<cv::Feature2D> finder_;
    size_t calls_;
    size_t done_ = 0;
    std::function<void(double)> show_;
};

#endif
