// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/aligner.hpp"

#include "api/aligner_check.hpp"
#include "api/problem_builder.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

std::vector<Mat> toMats(InputArrayOfArrays arrays)
{
    std::vector<Mat> mats;
    if (arrays.empty())
        return mats;
    if (arrays.isUMatVector())
    {
        std::vector<UMat> umats;
        arrays.getUMatVector(umats);
        for (const UMat& u : umats)
            mats.push_back(u.getMat(ACCESS_READ));
    }
    else
        arrays.getMatVector(mats);
    return mats;
}

class AlignerImpl : public Aligner
{
public:
    using Aligner::align;

    explicit AlignerImpl(const Params& params) : params_(params) { params_.check(); }

    const Params& params() const override { return params_; }

    Alignment align(const std::vector<Point>& corners, InputArrayOfArrays image_array, InputArrayOfArrays mask_array,
                    const std::vector<Correspondences>& correspondences, const Progress& progress,
                    const std::vector<KnownKeypoints>& keypoints) override
    {
        const std::vector<Mat> images = toMats(image_array);
        const std::vector<Mat> masks = toMats(mask_array);
        checkAlignerInput(corners, images, masks, correspondences, keypoints, params_);
        const MatchKinds kinds = matchesUsedBy(params_.method);
        ProblemBuilder builder(images, masks, ScaleRule::COMMON, params_, progress);
        builder.startFrom(startOnCanvas(builder.images(), corners, params_));
        if (correspondences.empty() && kinds.points)
            builder.findFeatures(keypoints);
        builder.findMatches(kinds, correspondences);
        return builder.align();
    }

private:
    Params params_;
};

} // namespace

Aligner::~Aligner() = default;

Alignment Aligner::align(const std::vector<Point>& corners, InputArrayOfArrays images, InputArrayOfArrays masks)
{
    return align(corners, images, masks, std::vector<Correspondences>());
}

Ptr<Aligner> Aligner::create(const Params& params)
{
    return makePtr<AlignerImpl>(params);
}

} // namespace gcpw
} // namespace cv
