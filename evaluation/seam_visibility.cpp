// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/seam_visibility.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include "evaluation/likeness.hpp"
#include "evaluation/spread.hpp"

namespace evaluation
{

namespace
{

const int WINDOW = LIKENESS_WINDOW;
const size_t MIN_CUT = 20;        ///< px; less says nothing
const size_t STRETCHES = 20;      ///< the worst place is one of so many parts of a cut
const size_t MIN_STRETCH = 10;    ///< px
const double NOISE = 4;           ///< gray levels a pixel: gradients below it are not seen

/// What two images say about each pixel that they share.
struct Fields : Likeness
{
    cv::Mat gradient;  ///< CV_64FC1
    cv::Mat color;     ///< CV_64FC3
};

cv::Mat gradientField(const cv::Mat& a, const cv::Mat& b)
{
    const double SOBEL = 0.125; // makes it gray levels a pixel
    cv::Mat ax, ay, bx, by;
    cv::Sobel(a, ax, CV_64F, 1, 0, 3, SOBEL);
    cv::Sobel(a, ay, CV_64F, 0, 1, 3, SOBEL);
    cv::Sobel(b, bx, CV_64F, 1, 0, 3, SOBEL);
    cv::Sobel(b, by, CV_64F, 0, 1, 3, SOBEL);
    cv::Mat size_a, size_b, step;
    cv::magnitude(ax, ay, size_a);
    cv::magnitude(bx, by, size_b);
    cv::magnitude(ax - bx, ay - by, step);
    return step / (size_a + size_b + NOISE);
}

Fields fieldsOf(const cv::Mat& a, const cv::Mat& b)
{
    const cv::Mat gray_a = grayOf(a);
    const cv::Mat gray_b = grayOf(b);
    Fields fields;
    static_cast<Likeness&>(fields) = likenessOf(gray_a, gray_b);
    fields.gradient = gradientField(gray_a, gray_b);
    cv::Mat colors_a, colors_b;
    a.convertTo(colors_a, CV_64F);
    b.convertTo(colors_b, CV_64F);
    cv::absdiff(windowMean(colors_a), windowMean(colors_b), fields.color);
    return fields;
}

/// All cuts of a picture.
struct Cuts
{
    std::vector<double> structure;
    std::vector<double> gradient;
    std::vector<double> color;
    double worst = 0;
    cv::Point worst_place;
    double strongest = 0;
    cv::Point strongest_place;
};

/// The stretch of one cut, walked along its longer side, with the largest mean of a field, if it is larger than `largest`.
void findWorst(std::vector<cv::Point> pixels, const cv::Mat& field, cv::Point origin, double& largest, cv::Point& place)
{
    const cv::Rect extent = cv::boundingRect(pixels);
    std::stable_sort(pixels.begin(), pixels.end(), [&](cv::Point a, cv::Point b)
                     { return extent.height > extent.width ? a.y < b.y : a.x < b.x; });
    const size_t run = std::max(MIN_STRETCH, pixels.size() / STRETCHES);
    double sum = 0;
    for (size_t k = 0; k < pixels.size(); ++k)
    {
        sum += field.at<double>(pixels[k]) - (k >= run ? field.at<double>(pixels[k - run]) : 0);
        const double mean = sum / static_cast<double>(run);
        if (k + 1 >= run && mean > largest)
        {
            largest = mean;
            place = pixels[k - run / 2] + origin;
        }
    }
}

void look(const Shared& shared, const std::vector<cv::Point>& pixels, Cuts& cuts)
{
    // Only what the windows along the cut reach: the overlap may be many megapixels.
    const cv::Rect extent = cv::boundingRect(pixels);
    const cv::Rect reach = cv::Rect(extent.x - WINDOW, extent.y - WINDOW, extent.width + 2 * WINDOW, extent.height + 2 * WINDOW) &
                           cv::Rect(cv::Point(), shared.a.size());
    const Fields fields = fieldsOf(shared.a(reach), shared.b(reach));
    std::vector<cv::Point> textured;
    for (const cv::Point& pixel : pixels)
    {
        const cv::Point p = pixel - reach.tl();
        cuts.gradient.push_back(fields.gradient.at<double>(p));
        const cv::Vec3d& color = fields.color.at<cv::Vec3d>(p);
        cuts.color.push_back(std::max(color[0], std::max(color[1], color[2])));
        if (fields.structure.at<double>(p) < 0)
            continue;
        cuts.structure.push_back(fields.structure.at<double>(p));
        textured.push_back(p);
    }
    if (textured.size() < MIN_CUT)
        return;
    const cv::Point origin = shared.box.tl() + reach.tl();
    findWorst(textured, fields.structure, origin, cuts.worst, cuts.worst_place);
    findWorst(textured, fields.structure.mul(fields.contrast), origin, cuts.strongest, cuts.strongest_place);
}

} // namespace

SeamVisibility seamVisibility(const std::vector<WarpedImage>& images)
{
    return images.size() > 1 ? seamVisibility(images, graphCut(images)) : seamVisibility({}, Labels());
}

SeamVisibility seamVisibility(const std::vector<WarpedImage>& images, const Labels& labels)
{
    Cuts cuts;
    for (size_t i = 0; i < images.size(); ++i)
        for (size_t j = i + 1; j < images.size(); ++j)
        {
            const Shared shared = sharedPart(images[i], images[j]);
            if (shared.both.empty())
                continue;
            const cv::Mat part = labels.of(shared.box - labels.origin);
            const std::vector<cv::Point> pixels =
                cutPixels(part, shared.both, static_cast<int>(i), static_cast<int>(j));
            if (pixels.size() >= MIN_CUT)
                look(shared, pixels, cuts);
        }
    SeamVisibility result;
    result.pixels = static_cast<int>(cuts.gradient.size());
    const double none = std::numeric_limits<double>::quiet_NaN();
    const bool seen = result.pixels > 0;
    result.structure_p95 = seen ? percentile(cuts.structure, 95) : none;
    result.worst = seen ? cuts.worst : none;
    result.gradient_p95 = seen ? percentile(cuts.gradient, 95) : none;
    result.color_p95 = seen ? percentile(cuts.color, 95) : none;
    result.worst_place = cuts.worst_place;
    result.strongest_place = cuts.strongest_place;
    return result;
}

} // namespace evaluation
