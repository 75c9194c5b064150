// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "scene.hpp"

#include <cmath>
#include "geometry/homography.hpp"

namespace opencv_test
{

namespace
{

/// One number a lattice cell, so that the texture needs no memory and has no border.
uint64_t hashOf(uint64_t seed, int layer, int col, int row)
{
    const uint64_t place = (static_cast<uint64_t>(layer) << 56) ^ (static_cast<uint64_t>(col + 100000) << 28) ^
                           static_cast<uint64_t>(row + 100000);
    return mixBits(mixBits(seed) ^ place);
}

/// The k-th byte of a hash as a number in [0, 1).
double byteOf(uint64_t hash, int k)
{
    return static_cast<double>((hash >> (8 * k)) & 255) / 256.0;
}

/// Luminance and hue of one shape, in [-1, 1] per channel, mostly gray.
Vec3d paintOf(uint64_t hash)
{
    const double light = 2 * byteOf(hash, 2) - 1;
    Vec3d paint;
    for (int c = 0; c < 3; ++c)
        paint[c] = 0.7 * light + 0.3 * (2 * byteOf(hash, 3 + c) - 1);
    return paint;
}

/// 0 outside a ramp of 3 px, 1 inside: an edge soft enough for bilinear sampling.
double softStep(double inside_px)
{
    const double t = std::min(std::max(inside_px / 3 + 0.5, 0.0), 1.0);
    return t * t * (3 - 2 * t);
}

template <typename Shape>
Vec3d sumOfCells(uint64_t seed, int layer, double cell_px, Point2d p, Shape shape)
{
    Vec3d sum;
    const int col = cvFloor(p.x / cell_px);
    const int row = cvFloor(p.y / cell_px);
    for (int r = row - 1; r <= row + 1; ++r)
        for (int c = col - 1; c <= col + 1; ++c)
        {
            const uint64_t hash = hashOf(seed, layer, c, r);
            const Point2d centre((c + byteOf(hash, 0)) * cell_px, (r + byteOf(hash, 1)) * cell_px);
            const double cover = shape(p - centre, hash);
            if (cover > 0)
                sum += cover * paintOf(hash);
        }
    return sum;
}

const double TWO_PI = 2 * CV_PI;

} // namespace

Vec3d Texture::at(Point2d p) const
{
    Vec3d sum;
    int layer = 0;
    for (const double sigma : {2.5, 5.0, 10.0, 20.0})
    {
        const double radius = 3 * sigma;
        const auto blob = [radius](Point2d d, uint64_t)
        {
            const double t = 1 - d.dot(d) / (radius * radius);
            return t > 0 ? t * t * t : 0.0;
        };
        sum += 1.2 * sumOfCells(seed_, layer++, radius, p, blob);
    }
    const auto bar = [](Point2d d, uint64_t hash)
    {
        const double angle = CV_PI * byteOf(hash, 6);
        const Point2d along(std::cos(angle), std::sin(angle));
        const double half_width = 3 + 6 * byteOf(hash, 7);
        return softStep(30 - std::abs(d.dot(along))) * softStep(half_width - std::abs(d.cross(along)));
    };
    sum += 1.5 * sumOfCells(seed_, layer, 48, p, bar);
    Vec3d color;
    for (int c = 0; c < 3; ++c)
    {
        const double wave = 0.4 * std::sin(p.x / 17 + 2 * c) * std::cos(p.y / 23 + c);
        color[c] = 0.425 + 0.17 * std::tanh(sum[c] + wave);
    }
    return color;
}

Matx33d slightHomography(double shift_px)
{
    return {1.01, -0.015, shift_px, 0.012, 1.015, -11, 2e-6, 0, 1};
}

SceneOptions smallScene()
{
    SceneOptions options;
    options.source_size = options.target_size = Size(320, 240);
    options.rough = slightHomography(64);
    options.displacement_px = 5;
    return options;
}

Scene::Scene(const SceneOptions& options) : options_(options), texture_(options.seed)
{
    RNG rng = seeded(options.warp_seed);
    for (double& phase : phases_)
        phase = rng.uniform(0.0, TWO_PI);
    if (options.mesh_cells > 0)
    {
        gcpw::MeshGrid mesh(gcpw::Lattice(options.source_size, options.mesh_cells, options.mesh_cells));
        for (Point2d& vertex : mesh.vertices())
            vertex = smoothCanvasAt(vertex);
        mesh_ = mesh;
    }
    paint();
}

Point2d Scene::smoothCanvasAt(Point2d q) const
{
    const double x = TWO_PI * q.x / options_.source_size.width;
    const double y = TWO_PI * q.y / options_.source_size.height;
    const double amplitude = options_.displacement_px / std::sqrt(2.0);
    const Point2d d(0.5 * (std::sin(1.1 * x + phases_[0]) + std::sin(0.6 * x + 0.8 * y + phases_[1])),
                    0.5 * (std::sin(0.9 * y + phases_[2]) + std::sin(0.7 * x - 0.5 * y + phases_[3])));
    return gcpw::applyHomography(options_.rough, q) + amplitude * d;
}

Point2d Scene::canvasAt(Point2d source_px) const
{
    return options_.mesh_cells > 0 ? mesh_.warp(source_px) : smoothCanvasAt(source_px);
}

Point2d Scene::sourceAt(Point2d canvas_px) const
{
    // The warp is close to a shift, so that this contracts.
    Point2d q = canvas_px;
    for (int i = 0; i < 60; ++i)
        q += canvas_px - canvasAt(q);
    return q;
}

bool Scene::insideTarget(Point2d p, double margin) const
{
    return p.x >= margin && p.y >= margin && p.x <= options_.target_size.width - 1 - margin &&
           p.y <= options_.target_size.height - 1 - margin;
}

void Scene::colorAt(Point2d q, Vec3d& gain, Vec3d& bias) const
{
    gain = Vec3d::all(1);
    bias = Vec3d::all(0);
    if (!options_.recolored)
        return;
    const double x = TWO_PI * q.x / options_.source_size.width;
    const double y = TWO_PI * q.y / options_.source_size.height;
    for (int c = 0; c < 3; ++c)
    {
        const double* phase = &phases_[4 + (options_.tinted ? 4 * c : 0)];
        gain[c] = 1 + 0.4 * std::sin(0.6 * x + phase[0]) * std::cos(0.5 * y + phase[1]);
        bias[c] = 0.15 * std::sin(0.5 * x - 0.6 * y + phase[2]);
    }
}

void Scene::paint()
{
    source_.create(options_.source_size, CV_8UC3);
    target_.create(options_.target_size, CV_8UC3);
    for (int y = 0; y < target_.rows; ++y)
        for (int x = 0; x < target_.cols; ++x)
            target_.at<Vec3b>(y, x) = Vec3b(texture_.at(Point2d(x, y)) * 255.0);
    for (int y = 0; y < source_.rows; ++y)
        for (int x = 0; x < source_.cols; ++x)
        {
            Vec3d gain;
            Vec3d bias;
            colorAt(Point2d(x, y), gain, bias);
            source_.at<Vec3b>(y, x) = Vec3b((texture_.at(canvasAt(Point2d(x, y))).mul(gain) + bias) * 255.0);
        }
    spoil(source_, Point2d(0.45 * source_.cols, 0.55 * source_.rows), options_.seed + 1000);
    spoil(target_, Point2d(0.75 * target_.cols, 0.35 * target_.rows), options_.seed + 2000);
}

void Scene::spoil(Mat& image, Point2d disc, uint64_t seed) const
{
    const Texture other(seed);
    const double radius = image.rows / 8.0;
    for (int y = 0; options_.occluder && y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
            if (cv::norm(Point2d(x, y) - disc) < radius)
                image.at<Vec3b>(y, x) = Vec3b((other.at(Point2d(x, y)) + Vec3d(0.3, -0.2, -0.1)) * 255.0);
    if (options_.noise > 0)
    {
        Mat noise(image.size(), CV_16SC3);
        seeded(seed).fill(noise, RNG::NORMAL, 0, options_.noise);
        cv::add(image, noise, image, noArray(), CV_8U);
    }
}

std::vector<gcpw::PointMatch> Scene::pointMatches(int count, uint64_t seed, double jitter_px,
                                                  double outlier_share) const
{
    RNG rng = seeded(seed);
    std::vector<gcpw::PointMatch> matches;
    while (static_cast<int>(matches.size()) < count)
    {
        gcpw::PointMatch match;
        match.a = Point2d(rng.uniform(0.0, options_.source_size.width - 1.0),
                          rng.uniform(0.0, options_.source_size.height - 1.0));
        match.b = canvasAt(match.a);
        if (!insideTarget(match.b, 1))
            continue;
        if (rng.uniform(0.0, 1.0) < outlier_share)
            match.b += Point2d(rng.uniform(20.0, 60.0) * (rng.uniform(0, 2) ? 1 : -1), rng.uniform(-60.0, 60.0));
        match.b += Point2d(rng.gaussian(jitter_px), rng.gaussian(jitter_px));
        matches.push_back(match);
    }
    return matches;
}

std::vector<gcpw::LineMatch> Scene::lineMatches(int count, uint64_t seed, double outlier_share) const
{
    RNG rng = seeded(seed);
    std::vector<gcpw::LineMatch> matches;
    while (static_cast<int>(matches.size()) < count)
    {
        gcpw::LineMatch match;
        const double angle = rng.uniform(0.0, TWO_PI);
        match.b.start = Point2d(rng.uniform(0.0, options_.target_size.width - 1.0),
                                rng.uniform(0.0, options_.target_size.height - 1.0));
        match.b.end = match.b.start + 40 * Point2d(std::cos(angle), std::sin(angle));
        match.a = {sourceAt(match.b.start), sourceAt(match.b.end)};
        const Rect2d inside(0, 0, options_.source_size.width - 1, options_.source_size.height - 1);
        if (!insideTarget(match.b.end) || !inside.contains(match.a.start) || !inside.contains(match.a.end))
            continue;
        if (rng.uniform(0.0, 1.0) < outlier_share)
        {
            const Point2d aside = 25 * match.b.line().normal;
            match.b = {match.b.start + aside, match.b.end + aside};
        }
        matches.push_back(match);
    }
    return matches;
}

double Scene::meanError(const Mat& mesh) const
{
    gcpw::MeshGrid found(gcpw::Lattice(options_.source_size, mesh.cols - 1, mesh.rows - 1));
    for (int i = 0; i < found.lattice().vertexCount(); ++i)
    {
        const Vec2d v = mesh.at<Vec2d>(i / mesh.cols, i % mesh.cols);
        found.vertices()[i] = Point2d(v[0], v[1]);
    }
    double sum = 0;
    int count = 0;
    for (int y = 0; y < options_.source_size.height; y += 2)
        for (int x = 0; x < options_.source_size.width; x += 2)
        {
            const Point2d truth = canvasAt(Point2d(x, y));
            if (!insideTarget(truth))
                continue;
            sum += cv::norm(found.warp(Point2d(x, y)) - truth);
            ++count;
        }
    return sum / count;
}

} // namespace opencv_test
