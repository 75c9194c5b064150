// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitching/warp_maps.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include "stitching/seam_rotation.hpp"
#include "rendering/inverse_map.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int BAND = 256;          ///< rows looked up at once, for the sake of memory
const int BORDER_STEPS = 64;   ///< pieces of an image's side whose bend inside a piece is below a pixel
const int FORWARD_STEP = 8;    ///< px between exact forward positions; both maps bend far more slowly
const float TORN = 1000;       ///< px between neighbours of a base map: behind the camera, not in the picture
const float BEYOND = 64;       ///< px that a base map is extended by; the mesh may reach a pixel of its own scale farther

/// A part of a base warper's maps, read as if it were the whole.
class MapWindow
{
public:
    /// @param low, high canvas points between which it is going to be read
    MapWindow(const BaseMaps& base, Point2d low, Point2d high) : whole_(base.whole())
    {
        const Point first = cellAt(low);
        const Point last = cellAt(high);
        window_ = Rect(first, last + Point(2, 2));
        base.build(window_ + whole_.tl(), x_map_, y_map_);
    }

    /// Bilinear in both maps, extended linearly a little; (-1, -1) where they are torn or end.
    Vec2f at(Point2d canvas) const
    {
        const Point cell = cellAt(canvas);
        const Point2d p = canvas - Point2d(whole_.tl());
        const float u = static_cast<float>(p.x - cell.x);
        const float v = static_cast<float>(p.y - cell.y);
        if (!(std::abs(u) < BEYOND && std::abs(v) < BEYOND))
            return {-1, -1};
        Vec2f result;
        for (int k = 0; k < 2; ++k)
        {
            const Mat& map = k == 0 ? x_map_ : y_map_;
            const float* top = map.ptr<float>(cell.y - window_.y) + cell.x - window_.x;
            const float* bottom = map.ptr<float>(cell.y - window_.y + 1) + cell.x - window_.x;
            if (!(std::abs(top[0] - bottom[1]) < TORN && std::abs(top[1] - bottom[0]) < TORN))
                return {-1, -1};
            result[k] = (top[0] * (1 - u) + top[1] * u) * (1 - v) + (bottom[0] * (1 - u) + bottom[1] * u) * v;
        }
        return result;
    }

private:
    /// The pixel of the whole from which a point is read to the right and below.
    Point cellAt(Point2d canvas) const
    {
        const auto clamped = [](double value, int most)
        { return static_cast<int>(std::min(std::max(std::floor(value), 0.0), most - 2.0)); };
        return {clamped(canvas.x - whole_.x, whole_.width), clamped(canvas.y - whole_.y, whole_.height)};
    }

    Rect whole_;
    Rect window_; ///< in the whole
    Mat x_map_;
    Mat y_map_;
};

/// The least and the greatest point of a map, where the mask has any. False if it has none.
bool boundsOf(const Mat& map, const Mat& mask, Point2d& low, Point2d& high)
{
    low = Point2d(1e9, 1e9);
    high = -low;
    for (int y = 0; y < map.rows; ++y)
        for (int x = 0; x < map.cols; ++x)
            if (mask.at<uchar>(y, x))
            {
                const Vec2f& p = map.at<Vec2f>(y, x);
                low = Point2d(std::min<double>(low.x, p[0]), std::min<double>(low.y, p[1]));
                high = Point2d(std::max<double>(high.x, p[0]), std::max<double>(high.y, p[1]));
            }
    return low.x <= high.x;
}

/// The pixels of a rectangle that touch the box from `low` to `high`, however far that reaches.
Rect clipped(Rect rect, Point2d low, Point2d high)
{
    const double left = std::max<double>(rect.x, std::floor(low.x));
    const double top = std::max<double>(rect.y, std::floor(low.y));
    const double right = std::min<double>(rect.br().x, std::ceil(high.x) + 1);
    const double bottom = std::min<double>(rect.br().y, std::ceil(high.y) + 1);
    return right > left && bottom > top ? Rect(Point(cvRound(left), cvRound(top)), Point(cvRound(right), cvRound(bottom))) : Rect();
}

} // namespace

WarpMaps::WarpMaps(cv::detail::RotationWarper& base, const PlacedMesh& placed, const Mat& K, const Matx33f& R, double seam_rotation_rad)
    : base_(base), placed_(placed), K_(K), R_(rotatedAboutAxis(R, -seam_rotation_rad)), plain_R_(R), turn_px_(seam_rotation_rad * base.getScale()),
      period_px_(seam_rotation_rad == 0 ? 0 : 2 * CV_PI * base.getScale())
{
}

Point2d WarpMaps::referenceCanvasAt(Point2f image_px) const
{
    return Point2d(base_.warpPoint(image_px, K_, R_)) + Point2d(turn_px_, 0);
}

Point2f WarpMaps::canvasAt(Point2f image_px) const
{
    Point2d p = placed_.canvasAt(referenceCanvasAt(image_px));
    if (period_px_ > 0)
        p.x -= period_px_ * std::round(p.x / period_px_);
    return p;
}

Point2f WarpMaps::imageAt(Point2f canvas_px) const
{
    Point2d p = canvas_px;
    if (period_px_ > 0)
    {
        const Rect2d bounds = placed_.mesh().bounds();
        p.x -= period_px_ * std::round((p.x - bounds.x - 0.5 * bounds.width) / period_px_);
    }
    int hint = -1;
    return base_.warpPointBackward(placed_.referenceAt(p, hint) - Point2d(turn_px_, 0), K_, R_);
}

Rect WarpMaps::roi(Size image) const
{
    // The lattice covers the base warper's whole rectangle; the picture inside it is smaller.
    Point2d reference_low(1e9, 1e9);
    Point2d reference_high(-1e9, -1e9);
    Point2d low = reference_low;
    Point2d high = reference_high;
    const auto take = [&](double x, double y)
    {
        const Point2d reference = referenceCanvasAt(Point2d(x, y));
        const Point2d moved = placed_.canvasAt(reference);
        reference_low = Point2d(std::min(reference_low.x, reference.x), std::min(reference_low.y, reference.y));
        reference_high = Point2d(std::max(reference_high.x, reference.x), std::max(reference_high.y, reference.y));
        low = Point2d(std::min(low.x, moved.x), std::min(low.y, moved.y));
        high = Point2d(std::max(high.x, moved.x), std::max(high.y, moved.y));
    };
    for (int i = 0; i <= BORDER_STEPS; ++i)
    {
        const double x = static_cast<double>(i) * (image.width - 1) / BORDER_STEPS;
        const double y = static_cast<double>(i) * (image.height - 1) / BORDER_STEPS;
        take(x, 0);
        take(x, image.height - 1);
        take(0, y);
        take(image.width - 1, y);
    }
    const Rect base = base_.warpRoi(image, K_, R_);
    const Rect covered = coveredRect(placed_.mesh(), FrameScale());
    // A picture that is wider than its border contains a pole: only the mesh itself knows its bounds.
    const double slack = 4;
    const bool by_border = base.width <= reference_high.x - reference_low.x + slack && base.height <= reference_high.y - reference_low.y + slack;
    Rect roi = covered;
    if (by_border)
        roi = clipped(covered, low, high);
    if (period_px_ > 0)
    {
        const Rect plain = base_.warpRoi(image, K_, plain_R_);
        roi.x = plain.x;
        roi.width = plain.width;
    }
    return roi;
}

void WarpMaps::look(const MeshGrid& mesh, const BaseMaps& base, Rect roi, Mat& x_map, Mat& y_map) const
{
    Mat reference;
    Mat mask;
    for (int top = 0; top < roi.height; top += BAND)
    {
        const int height = std::min(BAND, roi.height - top);
        buildInverseMap(mesh, FrameScale(), FrameScale(), Rect(roi.x, roi.y + top, roi.width, height), reference, mask);
        const auto baseCanvasAt = [this](Point2d lattice_px)
        { return placed_.referencePoint(lattice_px) - Point2d(turn_px_, 0); };
        Point2d low;
        Point2d high;
        if (!boundsOf(reference, mask, low, high))
            continue;
        const MapWindow window(base, baseCanvasAt(low), baseCanvasAt(high));
        parallel_for_(Range(0, height), [&](const Range& rows)
        {
            for (int y = rows.start; y < rows.end; ++y)
                for (int x = 0; x < roi.width; ++x)
                {
                    if (mask.at<uchar>(y, x) == 0)
                        continue;
                    const Vec2f lattice_px = reference.at<Vec2f>(y, x);
                    const Vec2f found = window.at(baseCanvasAt(Point2d(lattice_px[0], lattice_px[1])));
                    x_map.at<float>(top + y, x) = found[0];
                    y_map.at<float>(top + y, x) = found[1];
                }
        });
    }
}

void WarpMaps::build(Size image, Rect roi, Mat& x_map, Mat& y_map) const
{
    build(baseMaps(image), roi, x_map, y_map);
}

BaseMaps WarpMaps::baseMaps(Size image) const
{
    return {base_, image, K_, R_};
}

void WarpMaps::build(const BaseMaps& base, Rect roi, Mat& x_map, Mat& y_map) const
{
    x_map.create(roi.size(), CV_32FC1);
    y_map.create(roi.size(), CV_32FC1);
    x_map.setTo(Scalar(-1));
    y_map.setTo(Scalar(-1));
    if (base.whole().width < 2 || base.whole().height < 2)
        return;
    const int turns = period_px_ > 0 ? 1 : 0;
    for (int k = -turns; k <= turns; ++k)
    {
        MeshGrid mesh = placed_.mesh();
        for (Point2d& vertex : mesh.vertices())
            vertex.x += k * period_px_;
        const Rect covered = coveredRect(mesh, FrameScale()) & roi;
        if (covered.empty())
            continue;
        Mat x_part = x_map(covered - roi.tl());
        Mat y_part = y_map(covered - roi.tl());
        look(mesh, base, covered, x_part, y_part);
    }
}

void WarpMaps::buildForward(Size image, Point corner, Mat& x_map, Mat& y_map) const
{
    const int cols = image.width / FORWARD_STEP + 2;
    const int rows = image.height / FORWARD_STEP + 2;
    Mat coarse(rows, cols, CV_64FC2);
    for (int row = 0; row < rows; ++row)
        for (int col = 0; col < cols; ++col)
        {
            const Point2d p = placed_.canvasAt(referenceCanvasAt(Point(col * FORWARD_STEP, row * FORWARD_STEP)));
            coarse.at<Vec2d>(row, col) = Vec2d(p.x - corner.x, p.y - corner.y);
        }
    x_map.create(image, CV_32FC1);
    y_map.create(image, CV_32FC1);
    const double step = FORWARD_STEP;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
        {
            const int col = x / FORWARD_STEP;
            const int row = y / FORWARD_STEP;
            const auto weight = bilinearWeights((x - col * step) / step, (y - row * step) / step);
            Vec2d p = weight[0] * coarse.at<Vec2d>(row, col) + weight[1] * coarse.at<Vec2d>(row, col + 1) +
                      weight[2] * coarse.at<Vec2d>(row + 1, col) + weight[3] * coarse.at<Vec2d>(row + 1, col + 1);
            if (period_px_ > 0)
            {
                const double on_canvas = p[0] + corner.x;
                p[0] -= period_px_ * std::round(on_canvas / period_px_);
            }
            x_map.at<float>(y, x) = static_cast<float>(p[0]);
            y_map.at<float>(y, x) = static_cast<float>(p[1]);
        }
}

} // namespace gcpw
} // namespace cv
