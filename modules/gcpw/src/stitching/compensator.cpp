// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/compensator.hpp"

#include "rendering/color_field.hpp"
#include "stitching/picture_scale.hpp"
#include "stitching/rig_colors.hpp"
#include "stitching/shared_state.hpp"
#include "model/color_grid.hpp"
#include "api/estimate_colors.hpp"

namespace cv
{
namespace gcpw
{

GcpwCompensator::GcpwCompensator(const Params& params) : params_(params), given_(false)
{
    params_.check();
}

GcpwCompensator::GcpwCompensator(const Params& params, const std::shared_ptr<SharedState>& shared_state)
    : params_(params), shared_state_(shared_state), given_(false)
{
    params_.check();
}

bool GcpwCompensator::hasRig() const
{
    return shared_state_ && shared_state_->model;
}

GcpwCompensator::Source GcpwCompensator::source() const
{
    if (hasRig())
        return given_ ? Source::OWN : Source::RIG;
    return fallback_ && colors_.empty() ? Source::FALLBACK : Source::OWN;
}

void GcpwCompensator::feed(const std::vector<Point>& corners, const std::vector<UMat>& images,
                           const std::vector<std::pair<UMat, uchar> >& masks)
{
    if (shared_state_ && shared_state_->before_feed)
        shared_state_->before_feed();
    if (hasRig() || (!getUpdateGain() && !colors_.empty() && colors_.size() == images.size()))
        return;
    if (fallback_)
    {
        fallback_->setUpdateGain(getUpdateGain());
        fallback_->feed(corners, images, masks);
        colors_.clear();
        given_ = false;
        return;
    }
    CV_CheckEQ(corners.size(), images.size(), "gcpw: feed() takes one corner for each image");
    CV_CheckEQ(masks.size(), images.size(), "gcpw: feed() takes one mask for each image");
    std::vector<Mat> pictures;
    std::vector<Mat> inside;
    for (size_t i = 0; i < images.size(); ++i)
    {
        CV_CheckType(images[i].type(), images[i].type() == CV_8UC3 || images[i].type() == CV_8UC1,
                     "gcpw: feed() takes 8-bit BGR or gray images, as apply() does");
        CV_CheckTypeEQ(masks[i].first.type(), CV_8UC1, "gcpw: feed() takes masks of type CV_8UC1");
        const Size size = images[i].size();
        const Size mask = masks[i].first.size();
        if (size.empty() || mask != size)
            CV_Error(Error::StsUnmatchedSizes, format("gcpw: image %zu given to feed() is %d x %d px and its mask %d x %d px; they need one size",
                                                      i, size.width, size.height, mask.width, mask.height));
        pictures.push_back(images[i].getMat(ACCESS_READ));
        inside.push_back(masks[i].first.getMat(ACCESS_READ) == masks[i].second);
    }
    colors_ = estimateColors(corners, pictures, inside, params_);
    given_ = false;
}

void GcpwCompensator::apply(int index, Point corner, InputOutputArray image, InputArray mask)
{
    const Source from = source();
    if (from == Source::FALLBACK)
    {
        fallback_->apply(index, corner, image, mask);
        return;
    }
    const bool joint = from == Source::RIG;
    const size_t count = joint ? shared_state_->model->items().size() : colors_.size();
    if (index < 0 || static_cast<size_t>(index) >= count)
        return;
    Mat picture = image.getMat();
    // Colours of more images than the rig has are not for its meshes.
    if (!hasRig() || static_cast<size_t>(index) >= shared_state_->model->items().size())
    {
        const Mat& color = colors_[index];
        const double x_scale = static_cast<double>(color.cols) / picture.cols;
        const double y_scale = static_cast<double>(color.rows) / picture.rows;
        ColorField(color).apply(picture, Mat(), [&](Point p) { return Point2f(Point2d((p.x + 0.5) * x_scale, (p.y + 0.5) * y_scale)); });
        return;
    }
    const RigModel::Item& item = shared_state_->model->items()[index];
    const Mat& color = joint ? item.image.color : colors_[index];
    const double scale = pictureScale(*shared_state_->model, index, Rect(corner, picture.size()), shared_state_->scales);
    const GridPosition position = positionOnColors(*shared_state_->model, index, scale, Rect(corner, picture.size()), color.size());
    ColorField(color).apply(picture, Mat(), position);
}

void GcpwCompensator::getMatGains(std::vector<Mat>& gains)
{
    const Source from = source();
    if (from == Source::FALLBACK)
    {
        fallback_->getMatGains(gains);
        return;
    }
    gains.clear();
    if (from == Source::RIG)
    {
        for (const RigModel::Item& item : shared_state_->model->items())
            gains.push_back(item.image.color.clone());
        return;
    }
    for (const Mat& color : colors_)
        gains.push_back(color.clone());
}

void GcpwCompensator::setMatGains(std::vector<Mat>& gains)
{
    const bool grids = !gains.empty() && gains[0].type() == CV_32FC(6);
    if (fallback_ && !hasRig() && !grids)
    {
        fallback_->setMatGains(gains);
        colors_.clear();
        given_ = false;
        return;
    }
    for (size_t i = 0; i < gains.size(); ++i)
        checkColorGrid(gains[i], format("colour grid %zu", i));
    colors_.clear();
    for (const Mat& gain : gains)
        colors_.push_back(gain.clone());
    given_ = !colors_.empty();
}

} // namespace gcpw
} // namespace cv
