// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "cameras/picture_shape.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

const int GRID = 8;           ///< places a side of an image whose enlargement is looked at
const double STEP_PX = 4;     ///< for the derivative of the warp
const double MAX_STRETCH = 4; ///< of a photograph that a person still takes for one
const double MAX_AREA =
    1.5; ///< of the picture over its photographs: these overlap, so a picture is smaller but for its empty corners
const double MAX_FOCALS = 2; ///< largest over smallest: zooming during a panorama is not meant
const double MIN_FOCAL =
    0.25; ///< over the longer side: beyond it a lens shows more than 127 degrees, which no rectilinear lens does
const double MAX_FOCAL = 30; ///< over the longer side: 2 degrees

void view(const cv::detail::CameraParams& camera, Mat& K, Mat& R)
{
    camera.K().convertTo(K, CV_32F);
    camera.R.convertTo(R, CV_32F);
}

std::string cameraFault(const std::vector<cv::detail::CameraParams>& cameras, const std::vector<Size>& sizes)
{
    double smallest = 0;
    double largest = 0;
    for (size_t i = 0; i < cameras.size(); ++i)
    {
        if (!checkRange(cameras[i].R) || cameras[i].R.total() != 9 || !std::isfinite(cameras[i].focal))
            return "a camera is not finite";
        const double side = std::max(sizes[i].width, sizes[i].height);
        const bool affine = cameras[i].focal == 1 && cameras[i].ppx == 0;
        if (!affine && !(cameras[i].focal >= MIN_FOCAL * side && cameras[i].focal <= MAX_FOCAL * side))
            return format("a focal length is %.3g times an image's longer side", cameras[i].focal / side);
        smallest = i == 0 ? cameras[i].focal : std::min(smallest, cameras[i].focal);
        largest = std::max(largest, cameras[i].focal);
    }
    return largest <= MAX_FOCALS * smallest ? std::string()
                                            : format("focal lengths differ by %.2g", largest / smallest);
}

/// Singular values of the warp's derivative at a point of the image, rising; false where it has none (behind the camera).
bool enlargement(cv::detail::RotationWarper& warper, const Mat& K, const Mat& R, Point2f p, double period,
                 Vec2d& values)
{
    const Point2d at = warper.warpPoint(p, K, R);
    const auto step = [&](double x, double y)
    {
        Point2d moved = Point2d(warper.warpPoint(p + Point2f(Point2d(x, y)), K, R)) - at;
        if (period > 0)
            moved.x -= period * std::round(moved.x / period);
        return moved;
    };
    const Point2d right = step(STEP_PX, 0);
    const Point2d below = step(0, STEP_PX);
    const Matx22d derivative(right.x / STEP_PX, below.x / STEP_PX, right.y / STEP_PX, below.y / STEP_PX);
    const double square = 0.5 * norm(derivative, NORM_L2SQR);
    const double det = std::abs(determinant(derivative));
    const double root = std::sqrt(std::max(0.0, square * square - det * det));
    values = Vec2d(std::sqrt(std::max(0.0, square - root)), std::sqrt(square + root));
    return std::isfinite(values[0]) && std::isfinite(values[1]);
}

double medianOf(std::vector<double>& values)
{
    if (values.empty())
        return 0;
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

} // namespace

float medianFocal(const std::vector<cv::detail::CameraParams>& cameras)
{
    CV_CheckGT(cameras.size(), size_t(0), "gcpw: medianFocal() takes one camera or more");
    std::vector<double> focals;
    for (const cv::detail::CameraParams& camera : cameras)
        focals.push_back(camera.focal);
    std::sort(focals.begin(), focals.end());
    const size_t half = focals.size() / 2;
    // As cv::Stitcher has it, rounding included.
    return focals.size() % 2 == 1 ? static_cast<float>(focals[half])
                                  : static_cast<float>(focals[half - 1] + focals[half]) * 0.5F;
}

PictureShape shapeOfPicture(const std::vector<cv::detail::CameraParams>& cameras, const std::vector<Size>& sizes,
                            cv::detail::RotationWarper& warper, double period)
{
    PictureShape shape;
    shape.fault = cameraFault(cameras, sizes);
    if (!shape.fault.empty())
        return shape;
    double pixels = 0;
    Point2d low(1e18, 1e18);
    Point2d high = -low;
    shape.shrink = 1e18;
    for (size_t i = 0; i < cameras.size(); ++i)
    {
        Mat K;
        Mat R;
        view(cameras[i], K, R);
        pixels += sizes[i].area();
        for (int row = 0; row <= GRID; ++row)
            for (int col = 0; col <= GRID; ++col)
            {
                const Point2f p(static_cast<float>(col * (sizes[i].width - STEP_PX) / GRID),
                                static_cast<float>(row * (sizes[i].height - STEP_PX) / GRID));
                Vec2d values;
                if (!enlargement(warper, K, R, p, period, values))
                {
                    shape.fault = format("image %zu has no place in the picture", i);
                    return shape;
                }
                const Point2d at = warper.warpPoint(p, K, R);
                low = Point2d(std::min(low.x, at.x), std::min(low.y, at.y));
                high = Point2d(std::max(high.x, at.x), std::max(high.y, at.y));
                shape.stretch = std::max(shape.stretch, values[1]);
                shape.shrink = std::min(shape.shrink, values[0]);
            }
    }
    const double width = high.x - low.x;
    const double height = high.y - low.y;
    shape.area = width * height / pixels;
    if (!(shape.stretch <= MAX_STRETCH))
        shape.fault = format("a photograph is enlarged %.3g times at one of its ends", shape.stretch);
    else if (!(shape.shrink >= 1 / MAX_STRETCH))
        shape.fault = format("a photograph is made %.3g times smaller", 1 / std::max(shape.shrink, 1e-9));
    else if (!(shape.area <= MAX_AREA))
        shape.fault = format("the picture is %.3g times as large as its photographs", shape.area);
    else
        shape.size = Size(cvCeil(width), cvCeil(height));
    return shape;
}

std::vector<double> missesOf(const std::vector<cv::detail::CameraParams>& cameras, const std::vector<Link>& links,
                             cv::detail::RotationWarper& warper, double period)
{
    std::vector<double> misses;
    for (const Link& link : links)
    {
        Mat K[2];
        Mat R[2];
        view(cameras[link.a], K[0], R[0]);
        view(cameras[link.b], K[1], R[1]);
        std::vector<double> distances;
        for (size_t k = 0; k < link.points_a.size(); ++k)
        {
            Point2d miss = Point2d(warper.warpPoint(link.points_a[k], K[0], R[0])) -
                           Point2d(warper.warpPoint(link.points_b[k], K[1], R[1]));
            if (period > 0)
                miss.x -= period * std::round(miss.x / period);
            distances.push_back(norm(miss));
        }
        misses.push_back(medianOf(distances));
    }
    return misses;
}

} // namespace gcpw
} // namespace cv
