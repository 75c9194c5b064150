// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/tiled_blender.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include "common/grown.hpp"

namespace
{

const int TILE = 1024; ///< px; a multiple of the coarsest band's pixel, so that its grid is the same in all tiles

} // namespace

void TiledBlender::prepare(cv::Rect roi)
{
    roi_ = roi;
    parts_.clear();
}

void TiledBlender::feed(cv::InputArray image, cv::InputArray mask, cv::Point corner)
{
    const cv::Rect shown = cv::boundingRect(mask);
    if (shown.empty())
        return;
    const cv::Rect kept = grown(shown, marginOf(bands_)) & cv::Rect(cv::Point(), image.size());
    Part part;
    image.getMat()(kept).convertTo(part.image, deep_ ? CV_16S : CV_8U);
    part.mask = mask.getMat()(kept).clone();
    part.corner = corner + kept.tl();
    parts_.push_back(part);
}

void TiledBlender::blendTile(cv::Rect outer, cv::Mat& picture, cv::Mat& mask) const
{
    cv::detail::MultiBandBlender blender(0, bands_);
    blender.prepare(outer);
    for (const Part& part : parts_)
    {
        const cv::Rect inside = cv::Rect(part.corner, part.image.size()) & outer;
        if (inside.empty())
            continue;
        const cv::Rect local = inside - part.corner;
        if (cv::countNonZero(part.mask(local)) == 0)
            continue;
        cv::Mat deep;
        part.image(local).convertTo(deep, CV_16S);
        blender.feed(deep, part.mask(local), inside.tl());
    }
    blender.blend(picture, mask);
}

void TiledBlender::blend(cv::InputOutputArray picture, cv::InputOutputArray mask)
{
    // Whoever blends 8 bits makes such of whatever it is given.
    picture.create(roi_.size(), deep_ ? CV_16SC3 : CV_8UC3);
    mask.create(roi_.size(), CV_8UC1);
    cv::Mat whole = picture.getMat();
    cv::Mat whole_mask = mask.getMat();
    const int side = bands_ <= MOST_BANDS_OF_TILES ? TILE : std::max(roi_.width, roi_.height);
    for (int y = roi_.y; y < roi_.br().y; y += side)
        for (int x = roi_.x; x < roi_.br().x; x += side)
        {
            const cv::Rect tile = cv::Rect(x, y, side, side) & roi_;
            const cv::Rect outer = grown(tile, marginOf(bands_)) & roi_;
            cv::Mat blended;
            cv::Mat blended_mask;
            blendTile(outer, blended, blended_mask);
            cv::Mat place = whole(tile - roi_.tl());
            blended(tile - outer.tl()).convertTo(place, whole.depth());
            blended_mask(tile - outer.tl()).copyTo(whole_mask(tile - roi_.tl()));
        }
    parts_.clear();
}
