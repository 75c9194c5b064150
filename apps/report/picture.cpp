// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "report/picture.hpp"

#include <algorithm>
#include <cmath>

namespace report
{

namespace
{

using evaluation::WarpedImage;

const double MOST_PIXELS = 1.25e6; ///< of a picture of a page: 1600 x 780
const double LONGEST_SIDE = 4000;  ///< px: of a whole turn

// A pixel is the square around its position, so that rows and columns turn about the corner of pixel 0, 0.
cv::Point2d turned(const cv::Point2d& p)
{
    return {-p.y - 1, p.x};
}

cv::Rect turned(const cv::Rect& place)
{
    return {-(place.y + place.height), place.x, place.height, place.width};
}

void turn(cv::Mat& image)
{
    cv::Mat result;
    if (!image.empty())
        cv::rotate(image, result, cv::ROTATE_90_CLOCKWISE);
    image = result;
}

void turn(Path& path)
{
    for (cv::Point2d& p : path)
        p = turned(p);
}

} // namespace

double pageScale(cv::Size picture)
{
    const double by_area = std::sqrt(MOST_PIXELS / (static_cast<double>(picture.width) * picture.height));
    return std::min({1.0, by_area, LONGEST_SIDE / std::max(picture.width, picture.height)});
}

std::vector<Path> gridLines(const cv::Mat& grid)
{
    std::vector<Path> lines;
    for (const cv::Mat& vertices : {grid, cv::Mat(grid.t())})
        for (int row = 0; row < vertices.rows; ++row)
        {
            lines.emplace_back();
            for (int col = 0; col < vertices.cols; ++col)
                lines.back().emplace_back(vertices.at<cv::Vec2d>(row, col));
        }
    return lines;
}

void turnRight(Picture& picture, int times)
{
    for (int k = 0; k < times; ++k)
    {
        picture.origin = turned(picture.place()).tl();
        turn(picture.image);
        turn(picture.whole);
        for (WarpedImage& image : picture.images)
        {
            image.place = turned(image.place);
            for (cv::Mat* part : {&image.image, &image.corrected, &image.mask})
                turn(*part);
        }
        picture.labels.origin = turned(cv::Rect(picture.labels.origin, picture.labels.of.size())).tl();
        turn(picture.labels.of);
        for (std::vector<Path>& mesh : picture.meshes)
            for (Path& path : mesh)
                turn(path);
        for (Line& line : picture.lines)
            turn(line.path);
    }
}

cv::Mat framed(const cv::Mat& image, cv::Point origin, const cv::Rect& frame)
{
    cv::Mat result(frame.size(), CV_8UC3, BACKDROP);
    const cv::Rect common = cv::Rect(origin, image.size()) & frame;
    if (!common.empty())
        image(common - origin).copyTo(result(common - frame.tl()));
    return result;
}

cv::Mat covered(const std::vector<WarpedImage>& images, const cv::Rect& frame)
{
    cv::Mat result(frame.size(), CV_8UC1, cv::Scalar(0));
    for (const WarpedImage& image : images)
    {
        const cv::Rect common = image.place & frame;
        if (!common.empty())
            result(common - frame.tl()).setTo(255, image.mask(common - image.place.tl()));
    }
    return result;
}

void clearBeside(const std::vector<WarpedImage>& images, const cv::Rect& frame, cv::Mat& picture)
{
    picture.setTo(BACKDROP, covered(images, frame) == 0);
}

cv::Mat meanOf(const std::vector<WarpedImage>& images, const cv::Rect& frame)
{
    cv::Mat sum(frame.size(), CV_32FC3, cv::Scalar::all(0));
    cv::Mat count(frame.size(), CV_32FC3, cv::Scalar::all(0));
    for (const WarpedImage& image : images)
    {
        const cv::Rect common = image.place & frame;
        if (common.empty())
            continue;
        const cv::Rect in_image = common - image.place.tl();
        cv::Mat part = sum(common - frame.tl());
        cv::Mat counted = count(common - frame.tl());
        cv::add(part, image.corrected(in_image), part, image.mask(in_image), CV_32F);
        cv::add(counted, cv::Scalar::all(1), counted, image.mask(in_image));
    }
    cv::Mat mean;
    cv::divide(sum, count, mean);
    mean.convertTo(mean, CV_8U);
    clearBeside(images, frame, mean);
    return mean;
}

} // namespace report
