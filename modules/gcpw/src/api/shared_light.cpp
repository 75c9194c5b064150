// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "api/shared_light.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include "api/estimate_colors.hpp"
#include "imaging/photograph.hpp"
#include "rendering/color_field.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double MAX_AREA = 3e5; ///< px of a picture whose colours are found: light varies slowly

/// The part of a canvas that one photograph covers, made smaller.
struct Reduced
{
    Mat image;
    Mat mask;
    Point corner;
};

Reduced reduced(const Mat& image, const Mat& mask, Rect part, double scale)
{
    const Size size(std::max(cvRound(part.width * scale), 1), std::max(cvRound(part.height * scale), 1));
    Reduced result{Mat(), Mat(), Point(cvRound(part.x * scale), cvRound(part.y * scale))};
    resize(image(part), result.image, size, 0, 0, INTER_AREA);
    resize(mask(part), result.mask, size, 0, 0, INTER_AREA);
    result.image = toDepth(result.image, CV_8U);
    result.mask = result.mask == 255; // the others are mixed with black
    return result;
}

Mat corrected(const Mat& image, const Mat& mask, Rect part, const Mat& color)
{
    const float x_scale = static_cast<float>(color.cols) / static_cast<float>(part.width);
    const float y_scale = static_cast<float>(color.rows) / static_cast<float>(part.height);
    Mat result = image.clone();
    ColorField(color).apply(result, mask, [&](Point pixel)
    {
        return Point2f((static_cast<float>(pixel.x - part.x) + 0.5F) * x_scale,
                       (static_cast<float>(pixel.y - part.y) + 0.5F) * y_scale);
    });
    return result;
}

} // namespace

void shareLight(PairCanvas& canvas)
{
    const Mat* const images[] = {&canvas.source, &canvas.target};
    const Mat* const masks[] = {&canvas.source_mask, &canvas.target_mask};
    Mat* const results[] = {&canvas.source_corrected, &canvas.target_corrected};
    const Rect parts[] = {boundingRect(canvas.source_mask), boundingRect(canvas.target_mask)};
    const double scale = std::min(1.0, std::sqrt(MAX_AREA / std::max({parts[0].area(), parts[1].area(), 1})));
    std::vector<Point> corners;
    std::vector<Mat> small_images;
    std::vector<Mat> small_masks;
    for (int i = 0; i < 2; ++i)
    {
        const Reduced small = reduced(*images[i], *masks[i], parts[i], scale);
        corners.push_back(small.corner);
        small_images.push_back(small.image);
        small_masks.push_back(small.mask);
    }
    const std::vector<Mat> colors = estimateColors(corners, small_images, small_masks, Params());
    for (int i = 0; i < 2; ++i)
        *results[i] = corrected(*images[i], *masks[i], parts[i], colors[static_cast<size_t>(i)]);
}

} // namespace gcpw
} // namespace cv
