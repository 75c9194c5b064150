// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/apap.hpp"

#include <array>
#include <cmath>
#include <vector>
#include "evaluation/mesh_folds.hpp"

namespace evaluation
{

namespace
{

using cv::gcpw::Alignment;

const size_t MIN_POINTS = 4;
const int UNKNOWNS = 9;

typedef cv::Matx<double, UNKNOWNS, UNKNOWNS> Normal9;

/// Takes points to zero mean and mean distance sqrt(2) from it.
cv::Matx33d normaliser(const std::vector<cv::Point2d>& points)
{
    cv::Point2d mean;
    for (const cv::Point2d& p : points)
        mean += p;
    mean /= static_cast<double>(points.size());
    double distance = 0;
    for (const cv::Point2d& p : points)
        distance += cv::norm(p - mean);
    const double scale = distance > 0 ? std::sqrt(2.0) * static_cast<double>(points.size()) / distance : 1;
    return {scale, 0, -scale * mean.x, 0, scale, -scale * mean.y, 0, 0, 1};
}

cv::Point2d apply(const cv::Matx33d& h, cv::Point2d p)
{
    const cv::Vec3d q = h * cv::Vec3d(p.x, p.y, 1);
    return {q[0] / q[2], q[1] / q[2]};
}

/// a a^T summed over the two rows that say b x H a = 0.
Normal9 normalOf(cv::Point2d a, cv::Point2d b)
{
    const cv::Vec<double, UNKNOWNS> rows[] = {{0, 0, 0, -a.x, -a.y, -1, b.y * a.x, b.y * a.y, b.y},
                                              {a.x, a.y, 1, 0, 0, 0, -b.x * a.x, -b.x * a.y, -b.x}};
    return Normal9(rows[0] * rows[0].t()) + Normal9(rows[1] * rows[1].t());
}

/// The matches of a pair, ready for the homography of any vertex.
class MovingDlt
{
public:
    MovingDlt(const std::vector<cv::Point2d>& from, const std::vector<cv::Point2d>& to, double sigma_px, double gamma)
        : from_(from), from_norm_(normaliser(from)), to_norm_(normaliser(to)), sigma_px_(sigma_px), gamma_(gamma)
    {
        for (size_t i = 0; i < from.size(); ++i)
            normals_.push_back(normalOf(apply(from_norm_, from[i]), apply(to_norm_, to[i])));
    }

    cv::Matx33d homographyAt(cv::Point2d vertex) const
    {
        Normal9 sum = Normal9::zeros();
        for (size_t i = 0; i < from_.size(); ++i)
        {
            const cv::Point2d d = vertex - from_[i];
            const double weight = std::max(std::exp(-d.dot(d) / (sigma_px_ * sigma_px_)), gamma_);
            sum += weight * weight * normals_[i];
        }
        cv::Mat values;
        cv::Mat vectors;
        cv::eigen(cv::Mat(sum), values, vectors); // largest eigenvalue first
        const cv::Matx33d h(vectors.ptr<double>(UNKNOWNS - 1));
        return to_norm_.inv() * h * from_norm_;
    }

private:
    std::vector<cv::Point2d> from_;
    cv::Matx33d from_norm_;
    cv::Matx33d to_norm_;
    double sigma_px_;
    double gamma_;
    std::vector<Normal9> normals_;
};

/// Pixels of a photograph to those of its working copy.
cv::Point2d toWork(cv::Point2d full, cv::Size2d scale)
{
    return {(full.x + 0.5) * scale.width - 0.5, (full.y + 0.5) * scale.height - 0.5};
}

cv::Mat warpedVertices(const Alignment::Image& image, const MovingDlt& dlt)
{
    cv::Mat mesh(image.mesh.size(), CV_64FC2);
    cv::parallel_for_(cv::Range(0, mesh.rows), [&](const cv::Range& range)
    {
        for (int row = range.start; row < range.end; ++row)
            for (int col = 0; col < mesh.cols; ++col)
            {
                // The lattice covers the pixels' squares.
                const cv::Point2d vertex(col * static_cast<double>(image.work_size.width) / (mesh.cols - 1) - 0.5,
                                         row * static_cast<double>(image.work_size.height) / (mesh.rows - 1) - 0.5);
                const cv::Point2d there = apply(dlt.homographyAt(vertex), vertex);
                mesh.at<cv::Vec2d>(row, col) = cv::Vec2d(there.x, there.y);
            }
    });
    return mesh;
}

} // namespace

Alignment alignApap(cv::InputArray source, cv::InputArray target, const cv::gcpw::PairMatches& matches,
                    const cv::gcpw::Params& params, const ApapOptions& options)
{
    CV_CheckGT(options.sigma, 0.0, "ApapOptions::sigma is a share of the diagonal above 0");
    CV_Check(options.gamma, options.gamma >= 0 && options.gamma <= 1, "ApapOptions::gamma lies in 0..1");
    cv::gcpw::Params rough_params = params;
    rough_params.method = cv::gcpw::Method::GLOBAL;
    const Alignment rough = cv::gcpw::alignPair(source, target, matches, rough_params);
    if (!rough.ok())
        return rough;
    cv::gcpw::Report report = rough.report();
    if (matches.source_points.size() < MIN_POINTS)
    {
        report.status = cv::gcpw::Status::ROUGH;
        report.message = cv::format("%zu point matches, %zu are needed; the rough alignment was kept",
                                    matches.source_points.size(), MIN_POINTS);
        return Alignment({rough.image(0), rough.image(1)}, rough.canvasScale(), report);
    }
    cv::TickMeter clock;
    clock.start();
    Alignment::Image image = rough.image(0);
    const cv::Size2d scale(static_cast<double>(image.work_size.width) / image.full_size.width,
                           static_cast<double>(image.work_size.height) / image.full_size.height);
    std::vector<cv::Point2d> from;
    std::vector<cv::Point2d> to;
    for (size_t i = 0; i < matches.source_points.size(); ++i)
    {
        from.push_back(toWork(matches.source_points[i], scale));
        to.push_back(toWork(matches.target_points[i], rough.canvasScale()));
    }
    const double sigma_px = options.sigma * std::hypot(image.work_size.width, image.work_size.height);
    image.mesh = warpedVertices(image, MovingDlt(from, to, sigma_px, options.gamma));
    clock.stop();
    report.folds = countFoldedQuads(image.mesh);
    cv::Mat moves[2];
    cv::split(image.mesh - image.rough, moves);
    cv::Mat distance;
    cv::magnitude(moves[0], moves[1], distance);
    cv::minMaxLoc(distance, nullptr, &report.max_displacement_px);
    report.pairs[0].points = static_cast<int>(from.size());
    report.timings_ms.align += clock.getTimeMilli();
    report.timings_ms.total += clock.getTimeMilli();
    return Alignment({image, rough.image(1)}, rough.canvasScale(), report);
}

} // namespace evaluation
