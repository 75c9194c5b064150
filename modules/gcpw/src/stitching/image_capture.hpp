// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_IMAGE_CAPTURE_HPP
#define OPENCV_GCPW_IMAGE_CAPTURE_HPP

#include <functional>
#include <memory>
#include <vector>
#include "registration/features_header.hpp"
#include "opencv2/gcpw/aligner.hpp"

namespace cv
{
namespace gcpw
{

/// Whether keypoints found by others are enough for a mesh: from fewer it is poorly informed, and more are looked for.
inline bool areEnough(const KnownKeypoints& keypoints)
{
    const size_t enough = 1000;
    return keypoints.points.size() >= enough;
}

/// The images that a features finder was called with, and what it found.
struct CapturedImages
{
    std::vector<Mat> images;
    std::vector<KnownKeypoints> keypoints; ///< empty if they are not SIFT's
    bool fresh = false;                    ///< not used yet

    void clear() { *this = CapturedImages(); }
};

/// Forwards everything to another features finder and keeps a copy: cv::Stitcher's images at work scale.
class ImageCapture : public Feature2D
{
public:
    /// @param finder may be empty: then detecting says so  @param on_show called when images arrive; may be empty
    ImageCapture(const Ptr<Feature2D>& finder, const std::shared_ptr<CapturedImages>& captured,
                 const std::function<void()>& on_show = std::function<void()>())
        : finder_(finder), captured_(captured), on_show_(on_show)
    {
    }

    Ptr<Feature2D> finder() const { return finder_; }

    void detect(InputArray image, std::vector<KeyPoint>& keypoints, InputArray mask) override
    {
        real().detect(image, keypoints, mask);
    }
    void detect(InputArrayOfArrays images, std::vector<std::vector<KeyPoint>>& keypoints, InputArrayOfArrays masks) override
    {
        keep(images);
        real().detect(images, keypoints, masks);
    }
    void compute(InputArray image, std::vector<KeyPoint>& keypoints, OutputArray descriptors) override
    {
        real().compute(image, keypoints, descriptors);
    }
    void compute(InputArrayOfArrays images, std::vector<std::vector<KeyPoint>>& keypoints,
                 OutputArrayOfArrays descriptors) override
    {
        real().compute(images, keypoints, descriptors);
        keep(keypoints, descriptors);
    }
    void detectAndCompute(InputArray image, InputArray mask, std::vector<KeyPoint>& keypoints, OutputArray descriptors,
                          bool use_provided) override
    {
        real().detectAndCompute(image, mask, keypoints, descriptors, use_provided);
    }
    int descriptorSize() const override { return real().descriptorSize(); }
    int descriptorType() const override { return real().descriptorType(); }
    int defaultNorm() const override { return real().defaultNorm(); }
    bool empty() const override { return !finder_ || finder_->empty(); }
    void write(FileStorage& file) const override { real().write(file); }
    void read(const FileNode& node) override { real().read(node); }
    String getDefaultName() const override { return real().getDefaultName(); }

private:
    Feature2D& real() const
    {
        if (!finder_)
            CV_Error(Error::StsNullPtr, "gcpw: the stitcher had no features finder when attach() was called: call setFeaturesFinder(), "
                                        "then attach() once more");
        return *finder_;
    }

    void keep(InputArrayOfArrays images)
    {
        if (on_show_)
            on_show_();
        std::vector<UMat> shown;
        images.getUMatVector(shown);
        captured_->clear();
        captured_->images.resize(shown.size());
        // Copies: a stitcher may work on the caller's own pixels.
        for (size_t i = 0; i < shown.size(); ++i)
            shown[i].copyTo(captured_->images[i]);
        captured_->fresh = true;
    }

    void keep(const std::vector<std::vector<KeyPoint>>& keypoints, InputArrayOfArrays descriptor_array)
    {
        std::vector<UMat> descriptors;
        descriptor_array.getUMatVector(descriptors);
        captured_->keypoints.clear();
        if (!finder_.dynamicCast<SIFT>() || descriptors.size() != keypoints.size())
            return;
        captured_->keypoints.resize(keypoints.size());
        for (size_t i = 0; i < keypoints.size(); ++i)
        {
            KeyPoint::convert(keypoints[i], captured_->keypoints[i].points);
            descriptors[i].copyTo(captured_->keypoints[i].descriptors);
        }
    }

    Ptr<Feature2D> finder_;
    std::shared_ptr<CapturedImages> captured_;
    std::function<void()> on_show_;
};

} // namespace gcpw
} // namespace cv

#endif
