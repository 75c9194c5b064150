// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/seam_visibility.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <opencv2/stitching/detail/seam_finders.hpp>
#include "evaluation/spread.hpp"

namespace evaluation
{

namespace
{

const int WINDOW = 15;            ///< px
const double FLAT = 2;            ///< gray levels: a window with less deviation has no structure
const double CUT_PIXELS = 0.3e6;  ///< of the largest image, while the cut is found
const size_t MIN_CUT = 20;        ///< px; less says nothing
const size_t STRETCHES = 20;      ///< the worst place is one of so many parts of a cut
const size_t MIN_STRETCH = 10;    ///< px
const double NOISE = 4;           ///< gray levels a pixel: gradients below it are not seen

/// Which image each canvas pixel shows.
struct Labels
{
    cv::Point origin; ///< canvas pixel of the top-left label
    cv::Mat of;       ///< CV_16SC1, -1 where there is none
};

Labels emptyLabels(const std::vector<WarpedImage>& images)
{
    cv::Rect canvas = images[0].place;
    for (const WarpedImage& image : images)
        canvas |= image.place;
    return {canvas.tl(), cv::Mat(canvas.size(), CV_16SC1, cv::Scalar(-1))};
}

Labels cut(const std::vector<WarpedImage>& images)
{
    double largest = 0;
    for (const WarpedImage& image : images)
        largest = std::max(largest, static_cast<double>(image.place.area()));
    const double scale = std::min(1.0, std::sqrt(CUT_PIXELS / largest));
    std::vector<cv::UMat> small;
    std::vector<cv::UMat> parts;
    std::vector<cv::Point> corners;
    for (const WarpedImage& image : images)
    {
        cv::Mat picture;
        cv::Mat mask;
        cv::resize(image.corrected, picture, cv::Size(), scale, scale, cv::INTER_AREA);
        cv::resize(image.mask, mask, picture.size(), 0, 0, cv::INTER_AREA);
        picture.convertTo(picture, CV_32F);
        mask = mask == 255;
        small.emplace_back();
        parts.emplace_back();
        picture.copyTo(small.back());
        mask.copyTo(parts.back());
        corners.emplace_back(cvRound(image.place.x * scale), cvRound(image.place.y * scale));
    }
    cv::detail::GraphCutSeamFinder(cv::detail::GraphCutSeamFinderBase::COST_COLOR_GRAD).find(small, corners, parts);
    Labels labels = emptyLabels(images);
    for (size_t k = 0; k < images.size(); ++k)
    {
        cv::Mat part;
        cv::resize(parts[k], part, images[k].place.size(), 0, 0, cv::INTER_LINEAR);
        part = (part > 127) & images[k].mask;
        labels.of(images[k].place - labels.origin).setTo(cv::Scalar(static_cast<double>(k)), part);
    }
    return labels;
}

/// Two images where they share a rectangle of the canvas.
struct Shared
{
    cv::Rect box; ///< canvas
    cv::Mat a;
    cv::Mat b;
    cv::Mat both; ///< 255 where both have whole windows
};

Shared share(const WarpedImage& a, const WarpedImage& b)
{
    Shared result;
    result.box = a.place & b.place;
    if (result.box.width < 2 * WINDOW || result.box.height < 2 * WINDOW)
        return result;
    const cv::Rect in_a = result.box - a.place.tl();
    const cv::Rect in_b = result.box - b.place.tl();
    result.a = a.corrected(in_a);
    result.b = b.corrected(in_b);
    cv::erode(a.mask(in_a) & b.mask(in_b), result.both, cv::Mat::ones(WINDOW, WINDOW, CV_8U), cv::Point(-1, -1), 1,
              cv::BORDER_CONSTANT, cv::Scalar(0));
    return result;
}

/// Pixels whose right or lower neighbour shows the other one of two images.
std::vector<cv::Point> cutPixels(const cv::Mat& labels, const cv::Mat& both, int i, int j)
{
    std::vector<cv::Point> pixels;
    const auto parted = [&](short p, short q) { return (p == i && q == j) || (p == j && q == i); };
    for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
        {
            const short own = labels.at<short>(y, x);
            const bool right = x + 1 < labels.cols && parted(own, labels.at<short>(y, x + 1));
            const bool below = y + 1 < labels.rows && parted(own, labels.at<short>(y + 1, x));
            if ((right || below) && both.at<uchar>(y, x))
                pixels.emplace_back(x, y);
        }
    return pixels;
}

cv::Mat windowMean(const cv::Mat& image)
{
    cv::Mat mean;
    cv::blur(image, mean, cv::Size(WINDOW, WINDOW));
    return mean;
}

cv::Mat grayOf(const cv::Mat& bgr)
{
    cv::Mat gray;
    cv::cvtColor(bgr, gray, cv::COLOR_BGR2GRAY);
    gray.convertTo(gray, CV_64F);
    return gray;
}

/// What two images say about each pixel that they share.
struct Fields
{
    cv::Mat structure; ///< CV_64FC1, (1 - zncc) / 2; -1 where a window is flat
    cv::Mat contrast;  ///< CV_64FC1, geometric mean of both windows' deviations, gray levels; 0 where one is flat
    cv::Mat gradient;  ///< CV_64FC1
    cv::Mat color;     ///< CV_64FC3
};

void compareStructure(const cv::Mat& a, const cv::Mat& b, Fields& fields)
{
    const cv::Mat mean_a = windowMean(a);
    const cv::Mat mean_b = windowMean(b);
    const cv::Mat var_a = windowMean(a.mul(a)) - mean_a.mul(mean_a);
    const cv::Mat var_b = windowMean(b.mul(b)) - mean_b.mul(mean_b);
    const cv::Mat covariance = windowMean(a.mul(b)) - mean_a.mul(mean_b);
    fields.structure = cv::Mat(a.size(), CV_64FC1, cv::Scalar(-1));
    fields.contrast = cv::Mat(a.size(), CV_64FC1, cv::Scalar(0));
    for (int y = 0; y < a.rows; ++y)
        for (int x = 0; x < a.cols; ++x)
        {
            const double va = var_a.at<double>(y, x);
            const double vb = var_b.at<double>(y, x);
            if (!(va > FLAT * FLAT && vb > FLAT * FLAT))
                continue;
            const double zncc = covariance.at<double>(y, x) / std::sqrt(va * vb);
            fields.structure.at<double>(y, x) = 0.5 * (1 - std::min(std::max(zncc, -1.0), 1.0));
            fields.contrast.at<double>(y, x) = std::sqrt(std::sqrt(va * vb));
        }
}

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
    Fields fields;
    const cv::Mat gray_a = grayOf(a);
    const cv::Mat gray_b = grayOf(b);
    compareStructure(gray_a, gray_b, fields);
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
    Cuts cuts;
    if (images.size() > 1)
    {
        const Labels labels = cut(images);
        for (size_t i = 0; i < images.size(); ++i)
            for (size_t j = i + 1; j < images.size(); ++j)
            {
                const Shared shared = share(images[i], images[j]);
                if (shared.both.empty())
                    continue;
                const cv::Mat part = labels.of(shared.box - labels.origin);
                const std::vector<cv::Point> pixels = cutPixels(part, shared.both, static_cast<int>(i), static_cast<int>(j));
                if (pixels.size() >= MIN_CUT)
                    look(shared, pixels, cuts);
            }
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
