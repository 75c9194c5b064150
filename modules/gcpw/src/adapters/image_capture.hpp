// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_IMAGE_CAPTURE_HPP
#define OPENCV_GCPW_IMAGE_CAPTURE_HPP

#include <memory>
#include <vector>
#include "matching/features_header.hpp"
#include "opencv2/gcpw/aligner.hpp"

namespace cv
{
namespace gcpw
{

/// What a features finder was shown and what it found.
struct Captured
{
    std::vector<Mat> images;
    std::vector<KnownKeypoints> keypoints; ///< empty if they are not SIFT's

    void clear() { *this = Captured(); }
};

/// Hands everything on to another features finder and keeps what passes by: cv::Stitcher's images at work scale.
class ImageCapture : public Feature2D
{
public:
    ImageCapture(const Ptr<Feature2D>& finder, const std::shared_ptr<Captured>& captured)
        : finder_(finder), captured_(captured)
    {
    }

    Ptr<Feature2D> finder() const { return finder_; }

    void detect(InputArray image, std::vector<KeyPoint>& keypoints, InputArray mask) override
    {
        finder_->detect(image, keypoints, mask);
    }
    void detect(InputArrayOfArrays images, std::vector<std::vector<KeyPoint>>& keypoints, InputArrayOfArrays masks) override
    {
        keep(images);
        finder_->detect(images, keypoints, masks);
    }
    void compute(InputArray image, std::vector<KeyPoint>& keypoints, OutputArray descriptors) override
    {
        finder_->compute(image, keypoints, descriptors);
    }
    void compute(InputArrayOfArrays images, std::vector<std::vector<KeyPoint>>& keypoints,
                 OutputArrayOfArrays descriptors) override
    {
        finder_->compute(images, keypoints, descriptors);
        keep(keypoints, descriptors);
    }
    void detectAndCompute(InputArray image, InputArray mask, std::vector<KeyPoint>& keypoints, OutputArray descriptors,
                          bool use_provided) override
    {
        finder_->detectAndCompute(image, mask, keypoints, descriptors, use_provided);
    }
    int descriptorSize() const override { return finder_->descriptorSize(); }
    int descriptorType() const override { return finder_->descriptorType(); }
    int defaultNorm() const override { return finder_->defaultNorm(); }
    bool empty() const override { return finder_->empty(); }
    void write(FileStorage& file) const override { finder_->write(file); }
    void read(const FileNode& node) override { finder_->read(node); }
    String getDefaultName() const override { return finder_->getDefaultName(); }

private:
    void keep(InputArrayOfArrays images)
    {
        std::vector<UMat> shown;
        images.getUMatVector(shown);
        captured_->clear();
        captured_->images.resize(shown.size());
        // Copies: a stitcher may work on the caller's own pixels.
        for (size_t i = 0; i < shown.size(); ++i)
            shown[i].copyTo(captured_->images[i]);
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
    std::shared_ptr<Captured> captured_;
};

} // namespace gcpw
} // namespace cv

#endif
