// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "terms/photometric_term.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const float INSIDE = 0.98F;            ///< least mask value of a source pixel that is sampled
const int CONTRAST_WINDOW = 5;         ///< px, that of the scores
const double TYPICAL_VARIANCE = 0.01;  ///< of Y at an edge: there w_q is about one, so lambda_1 keeps its meaning
const int MIN_WINDOW_SAMPLES = 6;      ///< in a quarter of a quad, to correlate

/// 0.01 / (local variance of Y + floor^2) for every pixel of a level.
Mat importanceOf(const PyramidLevel& level, double floor)
{
    Mat luma;
    extractChannel(level.pixels, luma, 0);
    Mat mean;
    Mat squares;
    const Size window(CONTRAST_WINDOW, CONTRAST_WINDOW);
    blur(luma, mean, window);
    blur(luma.mul(luma), squares, window);
    const Mat variance = max(squares - mean.mul(mean), 0.0);
    return TYPICAL_VARIANCE / (variance + floor * floor);
}

} // namespace

PhotometricTerm::PhotometricTerm(int source_image, int target_image, const PyramidLevel& source,
                                 const PyramidLevel& target, const Lattice& lattice, const Options& options,
                                 Point2d target_shift)
    : source_image_(source_image), target_image_(target_image), target_(target), lattice_(lattice), options_(options),
      target_shift_(target_shift), first_(lattice.cellCount() + 1, 0), frozen_(lattice.cellCount(), false)
{
    CV_CheckGT(options.step, 0, "Photometric samples need a positive step");
    CV_Assert(source.scale == target.scale);
    struct Found
    {
        CellPoint point;
        Point pixel;
    };
    std::vector<Found> found;
    for (int y = options.step / 2; y < source.pixels.rows; y += options.step)
        for (int x = options.step / 2; x < source.pixels.cols; x += options.step)
        {
            const Point2d rest(x * source.scale, y * source.scale);
            if (source.at(x, y)[3] >= INSIDE && lattice.contains(rest))
                found.push_back({lattice.locate(rest), Point(x, y)});
        }
    // Counting sort by cell: the samples of a quad lie together and keep their order.
    for (const Found& f : found)
        ++first_[f.point.cell + 1];
    for (int cell = 0; cell < lattice.cellCount(); ++cell)
        first_[cell + 1] += first_[cell];
    const Mat importance = options.contrast_floor > 0 ? importanceOf(source, options.contrast_floor) : Mat();
    std::vector<int> next(first_.begin(), first_.end() - 1);
    samples_.resize(found.size());
    for (const Found& f : found)
    {
        Sample& sample = samples_[next[f.point.cell]++];
        const float* pixel = source.at(f.pixel.x, f.pixel.y);
        for (int k = 0; k < 4; ++k)
            sample.weight[k] = static_cast<float>(f.point.weight[k]);
        std::copy(pixel, pixel + 3, sample.value);
        sample.importance = importance.empty() ? 1.0F : importance.at<float>(f.pixel);
    }
}

template <typename Visit>
void PhotometricTerm::forEachInside(const std::vector<ImageState>& images, int cell, TargetLookup& target, Visit visit) const
{
    const MeshGrid& mesh = images[source_image_].mesh;
    const ColorGrid::Quad& mine = images[source_image_].color.quad(cell);
    const Point2d corner[4] = {mesh.vertex(cell, 0), mesh.vertex(cell, 1), mesh.vertex(cell, 2), mesh.vertex(cell, 3)};
    if (!target.near(corner))
        return;
    PixelSample pixel;
    double residual[3];
    for (int i = first_[cell]; i < first_[cell + 1]; ++i)
    {
        const Sample& sample = samples_[i];
        Point2d canvas;
        for (int k = 0; k < 4; ++k)
        {
            canvas.x += sample.weight[k] * corner[k].x;
            canvas.y += sample.weight[k] * corner[k].y;
        }
        if (!target.find(canvas) || !samplePixel(target_, target.rest(), pixel))
            continue;
        const ColorGrid::Quad& other = target.color();
        double squared = 0;
        for (int c = 0; c < 3; ++c)
        {
            residual[c] = mine[c].gain * sample.value[c] + mine[c].bias - other[c].gain * pixel.value[c] - other[c].bias;
            squared += residual[c] * residual[c];
        }
        visit(sample, pixel, residual, squared * sample.importance);
    }
}

namespace
{

/// Squared residual of a sample as other colours would have it.
double squaredResidual(const float* value, const PixelSample& pixel, const ColorGrid::Quad& mine, const ColorGrid::Quad& other)
{
    double squared = 0;
    for (int c = 0; c < CHANNELS; ++c)
    {
        const double residual = mine[c].gain * value[c] + mine[c].bias - other[c].gain * pixel.value[c] - other[c].bias;
        squared += residual * residual;
    }
    return squared;
}

} // namespace

PhotometricTerm::Energy PhotometricTerm::linearize(const std::vector<ImageState>& images, bool target_moves,
                                                   const RobustLoss& loss, Range cells, ResidualSink& sink,
                                                   const Fixed* before, std::vector<ColorTrust>& weights) const
{
    Energy total;
    TargetLookup target(images[target_image_], target_shift_, target_moves);
    std::vector<std::pair<int, PartnerSums>> partners; // target cell, sums; a handful at most
    for (int cell = cells.start; cell < cells.end; ++cell)
    {
        SampleSums sums;
        partners.clear();
        double energy = 0;
        double former_energy = 0; // with the colours of the linearisation before
        const ColorGrid::Quad* former = before ? &before->images[source_image_].color.quad(cell) : nullptr;
        const double former_share = before ? 1 - before->weights[cell].trust : 0;
        forEachInside(images, cell, target,
                      [&](const Sample& sample, const PixelSample& pixel, const double* residual, double squared)
        {
            LinearSample linear;
            for (int c = 0; c < 3; ++c)
            {
                linear.residual[c] = residual[c];
                linear.mine[c] = sample.value[c];
                linear.theirs[c] = pixel.value[c];
            }
            target.gradient(pixel, linear.gx, linear.gy);
            linear.weight = loss.weight(squared) * sample.importance;
            energy += loss.value(squared);
            if (former_share > 0)
                former_energy += loss.value(sample.importance * squaredResidual(sample.value, pixel, *former,
                                            before->images[target_image_].color.quad(target.point().cell)));
            sums.add(sample.weight, linear);
            if (!target_moves)
                return;
            const int other = target.point().cell;
            auto partner = std::find_if(partners.begin(), partners.end(),
                                        [other](const std::pair<int, PartnerSums>& p) { return p.first == other; });
            if (partner == partners.end())
                partner = partners.insert(partner, {other, PartnerSums()});
            partner->second.add(sample.weight, target.point().weight.data(), linear);
        });
        total.samples += options_.weight * energy;
        if (before)
            total.fixed += options_.weight * ((1 - former_share) * energy + former_share * former_energy) +
                           before->weights[cell].extras(images[source_image_].color.quad(cell), images[target_image_].color);
        weights[cell].clear();
        if (sums.samples() == 0)
            continue;
        ColoredBlock block = sums.block(options_.weight);
        block.energy = options_.weight * energy;
        const ColorGrid::Quad& now = images[source_image_].color.quad(cell);
        const bool judged = options_.gain_support > 0;
        ColorTrust& fixed = weights[cell];
        if (judged)
            sums.judgeColors(now, options_.weight, target_moves ? 0 : options_.gain_support, block, fixed);
        for (const std::pair<int, PartnerSums>& partner : partners)
        {
            PartnerBlock other = partner.second.block(options_.weight);
            if (judged)
                fixed.partners.push_back({partner.first, partner.second.judgeColors(now, images[target_image_].color.quad(partner.first),
                                                                                   options_.weight, fixed.trust, block, other)});
            if (frozen_[cell])
            {
                other.cross = other.mesh_mesh = QuadBlock{};
                other.mesh_gradient = QuadRow{};
            }
            sink.addPartner({source_image_, cell}, {target_image_, partner.first}, other);
        }
        total.here += block.energy;
        if (frozen_[cell])
        {
            block.mesh_mesh = QuadBlock{};
            block.mesh_gradient = QuadRow{};
            block.mesh_color = {};
        }
        sink.addColored({source_image_, cell}, block);
    }
    return total;
}

std::vector<PhotometricTerm::QuadMiss> PhotometricTerm::correlate(const std::vector<ImageState>& images) const
{
    std::vector<QuadMiss> misses(lattice_.cellCount());
    TargetLookup target(images[target_image_], target_shift_, false);
    for (int cell = 0; cell < lattice_.cellCount(); ++cell)
    {
        PairSums quarters[4];
        forEachInside(images, cell, target, [&](const Sample& sample, const PixelSample& pixel, const double*, double)
        {
            const bool right = sample.weight[1] + sample.weight[3] > 0.5F;
            const bool bottom = sample.weight[2] + sample.weight[3] > 0.5F;
            quarters[(right ? 1 : 0) + (bottom ? 2 : 0)].add(sample.value[0], pixel.value[0]);
        });
        for (const PairSums& m : quarters)
        {
            if (m.n < MIN_WINDOW_SAMPLES)
                continue;
            const double va = m.aa - m.a * m.a / m.n;
            const double vb = m.bb - m.b * m.b / m.n;
            if (va < TEXTURE_VARIANCE * m.n || vb < TEXTURE_VARIANCE * m.n)
                continue;
            const double miss = 1 - (m.ab - m.a * m.b / m.n) / std::sqrt(va * vb);
            misses[cell].sum += m.n * miss * miss;
            misses[cell].samples += static_cast<int>(m.n);
        }
    }
    return misses;
}

std::vector<PhotometricTerm::QuadColors> PhotometricTerm::compareColors(const std::vector<ImageState>& images) const
{
    std::vector<QuadColors> result;
    TargetLookup target(images[target_image_], target_shift_, true);
    for (int cell = 0; cell < lattice_.cellCount(); ++cell)
    {
        const size_t first = result.size();
        forEachInside(images, cell, target, [&](const Sample& sample, const PixelSample& pixel, const double*, double)
        {
            const int other = target.point().cell;
            auto found = std::find_if(result.begin() + first, result.end(),
                                      [other](const QuadColors& item) { return item.target_cell == other; });
            if (found == result.end())
                found = result.insert(found, {cell, other, ColorMoments()});
            found->moments.add(sample.value, pixel.value);
        });
    }
    return result;
}

void PhotometricTerm::freeze(const std::vector<int>& cells)
{
    for (int cell : cells)
        frozen_[cell] = true;
}

} // namespace gcpw
} // namespace cv
