// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "rendering/inverse_map.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

const double FARTHEST = 1e9;  ///< px: rectangles of twice this size still fit an int
const int BORDER_SAMPLES = 8; ///< of the border of a quad: what a sphere's picture leaves their chords by is nothing

struct Box
{
    int left, top, right, bottom; ///< inclusive pixels
};

/// Pixel centres inside the bounding box of a quad with a margin, clipped to the stripe.
Box boxOf(const std::array<Point2d, 4>& quad, double margin, Rect clip)
{
    Point2d low = quad[0];
    Point2d high = quad[0];
    for (const Point2d& p : quad)
    {
        low = Point2d(std::min(low.x, p.x), std::min(low.y, p.y));
        high = Point2d(std::max(high.x, p.x), std::max(high.y, p.y));
    }
    const auto bounded = [](double value) { return static_cast<int>(std::min(std::max(value, -FARTHEST), FARTHEST)); };
    margin += BORDER_FRACTION;
    return {std::max(bounded(std::ceil(low.x - margin)), clip.x), std::max(bounded(std::ceil(low.y - margin)), clip.y),
            std::min(bounded(std::floor(high.x + margin)), clip.x + clip.width - 1),
            std::min(bounded(std::floor(high.y + margin)), clip.y + clip.height - 1)};
}

/// The pixels whose centres lie between two corners.
Rect2d pixelsBetween(Point2d low, Point2d high)
{
    const Point2d first(std::ceil(low.x - BORDER_FRACTION), std::ceil(low.y - BORDER_FRACTION));
    const Point2d last(std::floor(high.x + BORDER_FRACTION), std::floor(high.y + BORDER_FRACTION));
    return {first, last + Point2d(1, 1)};
}

} // namespace

Rect2d coveredBounds(const MeshGrid& mesh, const FrameScale& canvas)
{
    const Rect2d bounds = mesh.bounds();
    return pixelsBetween(canvas.toFull(bounds.tl()), canvas.toFull(bounds.br()));
}

Rect coveredRect(const MeshGrid& mesh, const FrameScale& canvas)
{
    const Rect2d bounds = coveredBounds(mesh, canvas);
    for (const double value : {bounds.x, bounds.y, bounds.x + bounds.width, bounds.y + bounds.height})
        if (!(std::abs(value) <= FARTHEST))
            CV_Error(Error::StsOutOfRange, format("gcpw: a mesh of %g x %g px at (%g, %g) lies beyond any canvas", bounds.width,
                                                  bounds.height, bounds.x, bounds.y));
    return bounds;
}

MeshGrid viewed(const MeshGrid& mesh, const FrameScale& canvas, const CanvasView& view)
{
    MeshGrid result = mesh;
    for (Point2d& vertex : result.vertices())
        vertex = view.show(canvas.toFull(vertex));
    return result;
}

Rect2d viewedBounds(const MeshGrid& mesh, const FrameScale& canvas, const CanvasView& view)
{
    const Rect2d bounds = viewed(mesh, canvas, view).bounds();
    Point2d low = bounds.tl();
    Point2d high = bounds.br();
    const Lattice& lattice = mesh.lattice();
    const auto include = [&](int cell, double u, double v)
    {
        CellPoint point;
        point.cell = cell;
        point.weight = bilinearWeights(u, v);
        const Point2d p = view.show(canvas.toFull(mesh.warp(point)));
        low = Point2d(std::min(low.x, p.x), std::min(low.y, p.y));
        high = Point2d(std::max(high.x, p.x), std::max(high.y, p.y));
    };
    // The borders bulge between the vertices.
    for (int k = 1; k < BORDER_SAMPLES; ++k)
    {
        const double t = static_cast<double>(k) / BORDER_SAMPLES;
        for (int col = 0; !view.isFlat() && col < lattice.cols(); ++col)
        {
            include(col, t, 0);
            include((lattice.rows() - 1) * lattice.cols() + col, t, 1);
        }
        for (int row = 0; !view.isFlat() && row < lattice.rows(); ++row)
        {
            include(row * lattice.cols(), 0, t);
            include((row + 1) * lattice.cols() - 1, 1, t);
        }
    }
    return pixelsBetween(low, high);
}

void buildInverseMap(const MeshGrid& mesh, const FrameScale& canvas, const FrameScale& source, Rect roi, Mat& map,
                     Mat& mask, const CanvasView& view)
{
    map.create(roi.size(), CV_32FC2);
    map.setTo(Scalar::all(-1));
    mask.create(roi.size(), CV_8UC1);
    mask.setTo(Scalar(0));
    const Lattice& lattice = mesh.lattice();
    // Stripes of rows: every pixel is written by one thread, in the order of the cells.
    const int stripe_height = 64;
    const int stripes = (roi.height + stripe_height - 1) / stripe_height;
    parallel_for_(Range(0, stripes), [&](const Range& range)
    {
        for (int stripe = range.start; stripe < range.end; ++stripe)
        {
            const int top = stripe * stripe_height;
            const Rect clip(roi.x, roi.y + top, roi.width, std::min(stripe_height, roi.height - top));
            for (int cell = 0; cell < lattice.cellCount(); ++cell)
            {
                std::array<Point2d, 4> quad;
                std::array<Point2d, 4> shown;
                for (int k = 0; k < 4; ++k)
                {
                    quad[k] = canvas.toFull(mesh.vertex(cell, k));
                    shown[k] = view.show(quad[k]);
                }
                const double diagonal = std::max(norm(shown[3] - shown[0]), norm(shown[2] - shown[1]));
                const Box box = boxOf(shown, view.bulge(diagonal), clip);
                for (int y = box.top; y <= box.bottom; ++y)
                    for (int x = box.left; x <= box.right; ++x)
                    {
                        double u = 0;
                        double v = 0;
                        // Inverted on the canvas, where the quad is bilinear: the alignment stays exact in any view.
                        if (!invertBilinear(quad, view.canvasAt(Point2d(x, y)), u, v) || !isInQuad(u, v))
                            continue;
                        CellPoint point;
                        point.cell = cell;
                        point.weight = bilinearWeights(u, v);
                        const Point2d from = source.toFull(lattice.referencePoint(point));
                        map.at<Vec2f>(y - roi.y, x - roi.x) = Vec2f(static_cast<float>(from.x), static_cast<float>(from.y));
                        mask.at<uchar>(y - roi.y, x - roi.x) = 255;
                    }
            }
        }
    });
}

} // namespace gcpw
} // namespace cv
