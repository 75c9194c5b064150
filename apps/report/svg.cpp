// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "report/svg.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace report
{

namespace
{

const double TOLERANCE = 0.2; ///< px: less cannot be seen
const double TENTHS = 10;     ///< coordinates are written in tenths of a pixel

/// Tenths of a pixel, as short as it can be written.
std::string tenths(int value)
{
    if (value % 10 == 0)
        return std::to_string(value / 10);
    return (value < 0 ? "-" : "") + std::to_string(std::abs(value) / 10) + "." + std::to_string(std::abs(value) % 10);
}

std::string pair(const char* command, cv::Point tenths_px)
{
    return command + tenths(tenths_px.x) + (tenths_px.y < 0 ? "" : " ") + tenths(tenths_px.y);
}

/// Straight strokes of a path, of pixel edges.
class Strokes
{
public:
    void add(const char* direction, cv::Point start, int length)
    {
        data_ += pair("M", 10 * start) + direction + std::to_string(length);
    }
    const std::string& data() const { return data_; }

private:
    std::string data_;
};

bool parted(short a, short b)
{
    return a != b && a >= 0 && b >= 0;
}

} // namespace

std::string pathData(const std::vector<Path>& paths, const cv::Rect& frame)
{
    std::string data;
    for (const Path& path : paths)
    {
        std::vector<cv::Point2f> points;
        cv::Rect2d bounds;
        for (const cv::Point2d& p : path)
        {
            if (!std::isfinite(p.x) || !std::isfinite(p.y))
                continue;
            // A pixel is the square around its position.
            points.emplace_back(cv::Point2d(p.x + 0.5 - frame.x, p.y + 0.5 - frame.y));
            bounds = points.size() == 1 ? cv::Rect2d(p, cv::Size2d(1, 1)) : bounds | cv::Rect2d(p, cv::Size2d(1, 1));
        }
        if (points.size() < 2 || (bounds & cv::Rect2d(frame)).area() <= 0)
            continue;
        std::vector<cv::Point2f> few;
        cv::approxPolyDP(points, few, TOLERANCE, false);
        cv::Point last;
        for (size_t k = 0; k < few.size(); ++k)
        {
            const cv::Point here(cvRound(TENTHS * few[k].x), cvRound(TENTHS * few[k].y));
            data += pair(k == 0 ? "M" : "l", k == 0 ? here : here - last);
            last = here;
        }
    }
    return data;
}

std::string cutData(const evaluation::Labels& labels, const cv::Rect& frame)
{
    Strokes strokes;
    const cv::Mat& of = labels.of;
    const cv::Point shift = labels.origin - frame.tl();
    for (int y = 0; y < of.rows; ++y) // edges between a row and the next, each run of them one stroke
        for (int x = 0; y + 1 < of.rows && x < of.cols; ++x)
        {
            int end = x;
            while (end < of.cols && parted(of.at<short>(y, end), of.at<short>(y + 1, end)))
                ++end;
            if (end > x)
                strokes.add("h", cv::Point(x, y + 1) + shift, end - x);
            x = end;
        }
    for (int x = 0; x + 1 < of.cols; ++x)
        for (int y = 0; y < of.rows; ++y)
        {
            int end = y;
            while (end < of.rows && parted(of.at<short>(end, x), of.at<short>(end, x + 1)))
                ++end;
            if (end > y)
                strokes.add("v", cv::Point(x + 1, y) + shift, end - y);
            y = end;
        }
    return strokes.data();
}

std::vector<cv::Point> middles(const evaluation::Labels& labels, size_t count, const cv::Rect& frame)
{
    std::vector<cv::Point> result(count, cv::Point(-1, -1));
    for (size_t k = 0; k < count && !labels.of.empty(); ++k)
    {
        cv::Mat part = labels.of == static_cast<double>(k);
        cv::copyMakeBorder(part, part, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
        cv::Mat depth;
        cv::distanceTransform(part, depth, cv::DIST_L2, 3);
        double deepest = 0;
        cv::Point at;
        cv::minMaxLoc(depth, nullptr, &deepest, nullptr, &at);
        if (deepest > 0)
            result[k] = at - cv::Point(1, 1) + labels.origin - frame.tl();
    }
    return result;
}

} // namespace report
