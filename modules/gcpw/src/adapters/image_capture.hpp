// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_IMAGE_CAPTURE_HPP
#define OPENCV_GCPW_IMAGE_CAPTURE_HPP

#include <memory>
#include <vector>
#include <opencv2/features2d.hpp>

namespace cv
{
namespace gcpw
{

/// Hands everything on to another features finder and keeps the images it was shown: cv::Stitcher's, at work scale.
class ImageCapture : public Feature2D
{
public:
    ImageCapture(const Ptr<Feature2D>& finder, const std::shared_ptr<std::vector<Mat>>& images)
        : finder_(finder), images_(images)
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
        images_->assign(shown.size(), Mat());
        // Copies: a stitcher may work on the caller's own pixels.
        for (size_t i = 0; i < shown.size(); ++i)
            shown[i].copyTo((*images_)[i]);
    }

    Ptr<Feature2D> finder_;
    std::shared_ptr<std::vector<Mat>> images_;
};

} // namespace gcpw
} // namespace cv

#endif
