// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/shape.hpp"

#include <algorithm>
#include <cmath>
#include <vector>
#include "evaluation/bend.hpp"

namespace evaluation
{

namespace
{

/// Derivative of a mesh at the middle of a quad, by columns and rows of quads.
cv::Matx22d derivative(const cv::Mat& mesh, int row, int col)
{
    const cv::Vec2d a = mesh.at<cv::Vec2d>(row, col);
    const cv::Vec2d b = mesh.at<cv::Vec2d>(row, col + 1);
    const cv::Vec2d c = mesh.at<cv::Vec2d>(row + 1, col);
    const cv::Vec2d d = mesh.at<cv::Vec2d>(row + 1, col + 1);
    const cv::Vec2d across = 0.5 * (b + d - a - c);
    const cv::Vec2d down = 0.5 * (c + d - a - b);
    return {across[0], down[0], across[1], down[1]};
}

/// ln(s1 / s2) and ln(s1 s2) of the singular values of a map.
cv::Vec2d logarithms(const cv::Matx22d& map)
{
    const double LEAST = 1e-9; // of a quad without area
    const double squares = map.dot(map);
    const double area = std::abs(cv::determinant(map));
    const double sum = std::sqrt(squares + 2 * area);
    const double difference = std::sqrt(std::max(squares - 2 * area, 0.0));
    const double s1 = std::max(0.5 * (sum + difference), LEAST);
    const double s2 = std::max(0.5 * (sum - difference), LEAST);
    return {std::log(s1 / s2), std::log(s1 * s2)};
}

} // namespace

Shape shapeOf(const cv::gcpw::Alignment& alignment)
{
    Shape shape;
    double quads = 0;
    double largest = 0;
    for (int k = 0; k < alignment.imageCount(); ++k)
    {
        const cv::gcpw::AlignedImage& image = alignment.image(k);
        if (!moves(image))
            continue;
        double sum = 0;
        double squares = 0;
        for (int row = 0; row + 1 < image.mesh.rows; ++row)
            for (int col = 0; col + 1 < image.mesh.cols; ++col)
            {
                const cv::Vec2d logs = logarithms(derivative(image.mesh, row, col) * derivative(image.rough, row, col).inv());
                shape.stretch += logs[0] * logs[0];
                largest = std::max(largest, logs[0]);
                sum += logs[1];
                squares += logs[1] * logs[1];
            }
        const double count = static_cast<double>(image.mesh.rows - 1) * (image.mesh.cols - 1);
        shape.area += std::max(squares - sum * sum / count, 0.0);
        quads += count;
    }
    if (quads > 0)
        shape = {std::sqrt(shape.stretch / quads), std::sqrt(shape.area / quads), std::exp(largest)};
    return shape;
}

} // namespace evaluation
