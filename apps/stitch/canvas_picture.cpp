// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/canvas_picture.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/stitching/detail/blenders.hpp>
#include "common/crop.hpp"
#include "common/exit_code.hpp"
#include "common/tiled_blender.hpp"
#include "stitch/compose.hpp"
#include "stitch/stand_up.hpp"

namespace
{

const int STRIP = 256; ///< rows that are looked through at once

/// Down or up to a multiple of the grid's step from its origin.
int onGrid(int at, int origin, int step, bool up)
{
    const int from = at - origin;
    const int steps = up ? (from + step - 1) / step : from / step;
    return origin + steps * step;
}

} // namespace

CanvasPicture::CanvasPicture(const WarpedStore& store, cv::Rect canvas, const Blending& blending, bool deep, int turns)
    : store_(store), canvas_(canvas), blending_(blending), deep_(deep), turns_(turns)
{
    if (blending.kind == Blending::BANDS && blending.bands > TiledBlender::MOST_BANDS_OF_TILES)
        throw WrongUse(
            cv::format("--blend_strength asks for %d bands in a picture of this size, and tiles take %d; lower it, or "
                       "leave it out for %d",
                       blending.bands, TiledBlender::MOST_BANDS_OF_TILES, TiledBlender::USUAL_BANDS));
}

int CanvasPicture::marginOf(const Blending& blending)
{
    if (blending.kind == Blending::BANDS)
        return TiledBlender::marginOf(blending.bands);
    // A feather reaches from a border until its weight is 1.
    return blending.kind == Blending::FEATHER ? static_cast<int>(std::ceil(1 / blending.sharpness)) + 2 : 0;
}

cv::Size CanvasPicture::size() const
{
    return turns_ % 2 == 1 ? cv::Size(canvas_.height, canvas_.width) : canvas_.size();
}

cv::Rect CanvasPicture::onCanvas(cv::Rect rect) const
{
    cv::Rect part = rect;
    if (turns_ == 1)
        part = cv::Rect(rect.y, canvas_.height - rect.br().x, rect.height, rect.width);
    if (turns_ == 2)
        part = cv::Rect(canvas_.width - rect.br().x, canvas_.height - rect.br().y, rect.width, rect.height);
    return part + canvas_.tl();
}

cv::Rect CanvasPicture::reach(cv::Rect rect) const
{
    const cv::Rect tile = onCanvas(rect);
    const int step = blending_.kind == Blending::BANDS ? 1 << blending_.bands : 1;
    const int margin = marginOf(blending_);
    const cv::Point from(onGrid(std::max(tile.x - margin, canvas_.x), canvas_.x, step, false),
                         onGrid(std::max(tile.y - margin, canvas_.y), canvas_.y, step, false));
    const cv::Point to(onGrid(tile.br().x + margin, canvas_.x, step, true),
                       onGrid(tile.br().y + margin, canvas_.y, step, true));
    return cv::Rect(from, to) & canvas_;
}

cv::Mat CanvasPicture::pixels(cv::Rect rect) const
{
    const cv::Rect tile = onCanvas(rect);
    const cv::Rect outer = reach(rect);
    const cv::Ptr<cv::detail::Blender> blender = blenderOf(blending_);
    blender->prepare(outer);
    for (const WarpedStore::Part& part : store_.read(outer))
    {
        cv::Mat fed;
        part.image.convertTo(fed, CV_16S);
        blender->feed(fed, part.mask, part.corner);
    }
    cv::Mat blended;
    cv::Mat mask;
    blender->blend(blended, mask);
    return stood(finished(blended(tile - outer.tl()), deep_));
}

cv::Mat CanvasPicture::shown(cv::Rect rect) const
{
    return stood(store_.shown(onCanvas(rect)));
}

cv::Mat CanvasPicture::stood(const cv::Mat& part) const
{
    return turned(part, turns_);
}

cv::Rect CanvasPicture::largestRectangle() const
{
    RectangleSearch search(size().width);
    for (int y = 0; y < size().height; y += STRIP)
        search.add(shown(cv::Rect(0, y, size().width, std::min(STRIP, size().height - y))));
    return search.best();
}
