// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/seam_finder.hpp"

#include "rendering/seam_cut.hpp"
#include "stitching/shared_state.hpp"

namespace cv
{
namespace gcpw
{

GcpwSeamFinder::GcpwSeamFinder() = default;

GcpwSeamFinder::GcpwSeamFinder(const std::shared_ptr<SharedState>& shared_state,
                               const Ptr<cv::detail::SeamFinder>& fallback)
    : shared_state_(shared_state), fallback_(fallback)
{
}

void GcpwSeamFinder::find(const std::vector<UMat>& src, const std::vector<Point>& corners, std::vector<UMat>& masks)
{
    // Without a rig the panorama is the plain one, to the bit.
    if (fallback_ && !(shared_state_ && shared_state_->model))
    {
        fallback_->find(src, corners, masks);
        return;
    }
    CV_CheckEQ(src.size(), corners.size(), "gcpw: find() takes one corner for each image");
    CV_CheckEQ(src.size(), masks.size(), "gcpw: find() takes one mask for each image");
    for (size_t i = 0; i < src.size(); ++i)
    {
        CV_CheckType(src[i].type(), src[i].type() == CV_32FC3 || src[i].type() == CV_8UC3,
                     "gcpw: find() takes images of type CV_32FC3 or CV_8UC3");
        CV_CheckTypeEQ(masks[i].type(), CV_8UC1, "gcpw: find() takes masks of type CV_8UC1");
        if (src[i].size() != masks[i].size())
            CV_Error(Error::StsUnmatchedSizes,
                     format("gcpw: image %zu given to find() is %d x %d px and its mask %d x %d px", i, src[i].cols,
                            src[i].rows, masks[i].cols, masks[i].rows));
    }
    PairwiseSeamFinder::find(src, corners, masks);
}

void GcpwSeamFinder::findInPair(size_t first, size_t second, Rect)
{
    const auto placed = [&](size_t i)
    {
        PlacedPicture picture{Mat(), masks_[i].getMat(ACCESS_RW), corners_[i]};
        picture.image = images_[i].getMat(ACCESS_READ);
        if (picture.image.depth() != CV_32F)
            picture.image.convertTo(picture.image, CV_32F);
        return picture;
    };
    PlacedPicture a = placed(first);
    PlacedPicture b = placed(second);
    cutBetween(a, b, findGhosts(a, b));
}

} // namespace gcpw
} // namespace cv
