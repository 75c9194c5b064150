// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "terms/photometric_term.hpp"

#include <opencv2/imgproc.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const float INSIDE = 0.98F; ///< least mask value of a source pixel that is sampled

/// Sums over the samples of one quad, folded out into a ColoredBlock at the end.
struct QuadSums
{
    double corner[10][3] = {};    ///< for each pair of corners k <= m: sum w_k w_m (xx, xy, yy)
    double slope[4][2] = {};      ///< sum w_k g r
    double color[4][3][4] = {};   ///< per corner and channel: sum w_k (gx I, gx, gy I, gy)
    double moments[3][3] = {};    ///< per channel: I I, I, 1
    double residual[3][2] = {};   ///< per channel: I r, r
    double energy = 0;
    int samples = 0;
};

void unfold(const QuadSums& sums, double weight, ColoredBlock& block)
{
    int pair = 0;
    for (int k = 0; k < 4; ++k)
    {
        for (int m = k; m < 4; ++m, ++pair)
        {
            const double* s = sums.corner[pair];
            block.mesh_mesh[2 * k][2 * m] = weight * s[0];
            block.mesh_mesh[2 * k][2 * m + 1] = weight * s[1];
            if (m > k)
                block.mesh_mesh[2 * k + 1][2 * m] = weight * s[1];
            block.mesh_mesh[2 * k + 1][2 * m + 1] = weight * s[2];
        }
        for (int axis = 0; axis < 2; ++axis)
        {
            block.mesh_gradient[2 * k + axis] = -weight * sums.slope[k][axis];
            for (int c = 0; c < 3; ++c)
                for (int j = 0; j < 2; ++j)
                    block.mesh_color[2 * k + axis][2 * c + j] = -weight * sums.color[k][c][2 * axis + j];
        }
    }
    for (int c = 0; c < 3; ++c)
    {
        for (int j = 0; j < 3; ++j)
            block.color_color[c][j] = weight * sums.moments[c][j];
        for (int j = 0; j < 2; ++j)
            block.color_gradient[c][j] = weight * sums.residual[c][j];
    }
    block.energy = sums.energy;
    block.samples = sums.samples;
}

} // namespace

PhotometricTerm::PhotometricTerm(int source_image, int target_image, const PyramidLevel& source,
                                 const PyramidLevel& target, const Lattice& lattice, const Options& options)
    : source_image_(source_image), target_image_(target_image), source_(source), target_(target), lattice_(lattice),
      options_(options)
{
    CV_CheckGT(options.step, 0, "Photometric samples need a positive step");
    CV_Assert(source.scale == target.scale);
    // Counting sort by cell: first how many samples each cell has, then where they go.
    first_.assign(lattice.cellCount() + 1, 0);
    std::vector<CellPoint> found;
    std::vector<Point> where;
    for (int y = options.step / 2; y < source.pixels.rows; y += options.step)
        for (int x = options.step / 2; x < source.pixels.cols; x += options.step)
        {
            const Point2d rest(x * source.scale, y * source.scale);
            if (source.at(x, y)[3] < INSIDE || !lattice.contains(rest))
                continue;
            found.push_back(lattice.locate(rest));
            where.emplace_back(x, y);
            ++first_[found.back().cell + 1];
        }
    for (int cell = 0; cell < lattice.cellCount(); ++cell)
        first_[cell + 1] += first_[cell];
    std::vector<int> next(first_.begin(), first_.end() - 1);
    samples_.resize(found.size());
    pixels_.resize(found.size());
    for (size_t i = 0; i < found.size(); ++i)
    {
        const int slot = next[found[i].cell]++;
        const float* pixel = source.at(where[i].x, where[i].y);
        Sample& sample = samples_[slot];
        for (int k = 0; k < 4; ++k)
            sample.weight[k] = static_cast<float>(found[i].weight[k]);
        for (int c = 0; c < 3; ++c)
            sample.value[c] = pixel[c];
        sample.importance = 1;
        pixels_[slot] = where[i];
    }
    if (options.contrast_floor > 0)
        setImportance(options.contrast_floor);
}

void PhotometricTerm::setImportance(double contrast_floor)
{
    Mat luma;
    extractChannel(source_.pixels, luma, 0);
    Mat mean;
    Mat squares;
    blur(luma, mean, Size(5, 5));
    blur(luma.mul(luma), squares, Size(5, 5));
    double sum = 0;
    for (size_t i = 0; i < samples_.size(); ++i)
    {
        const float m = mean.at<float>(pixels_[i]);
        const double variance = std::max(squares.at<float>(pixels_[i]) - m * m, 0.0F) + contrast_floor * contrast_floor;
        samples_[i].importance = static_cast<float>(1 / variance);
        sum += 1 / variance;
    }
    // Scaled so that a sample at a typical edge (deviation 0.1) weighs one.
    (void)sum;
    for (Sample& sample : samples_)
        sample.importance *= 0.01F;
}

bool PhotometricTerm::evaluate(const Sample& sample, int cell, const std::vector<ImageState>& images, int& hint,
                               CellPoint& target_point, Evaluated& out) const
{
    const MeshGrid& mesh = images[source_image_].mesh;
    Point2d canvas;
    for (int k = 0; k < 4; ++k)
        canvas += static_cast<double>(sample.weight[k]) * mesh.vertex(cell, k);
    const MeshGrid& target_mesh = images[target_image_].mesh;
    if (!target_mesh.invert(canvas, hint, target_point))
        return false;
    PixelSample pixel;
    if (!samplePixel(target_, target_mesh.lattice().restPoint(target_point), pixel))
        return false;
    const Matx22d inverse = target_mesh.jacobian(target_point).inv();
    const ColorGrid::Quad& mine = images[source_image_].color.quad(cell);
    const ColorGrid::Quad& other = images[target_image_].color.quad(target_point.cell);
    for (int c = 0; c < 3; ++c)
    {
        out.residual[c] = mine[c].gain * sample.value[c] + mine[c].bias - other[c].gain * pixel.value[c] - other[c].bias;
        const double dx = other[c].gain * pixel.dx[c];
        const double dy = other[c].gain * pixel.dy[c];
        out.gradient[c] = Point2d(dx * inverse(0, 0) + dy * inverse(1, 0), dx * inverse(0, 1) + dy * inverse(1, 1));
    }
    return true;
}

double PhotometricTerm::linearize(const std::vector<ImageState>& images, bool target_moves, const RobustLoss& loss,
                                  ResidualSink& sink) const
{
    double total = 0;
    int hint = -1;
    CellPoint target_point;
    Evaluated now;
    (void)target_moves;
    for (int cell = 0; cell < lattice_.cellCount(); ++cell)
    {
        QuadSums sums;
        for (int i = first_[cell]; i < first_[cell + 1]; ++i)
        {
            const Sample& sample = samples_[i];
            if (!evaluate(sample, cell, images, hint, target_point, now))
                continue;
            double squared = 0;
            for (int c = 0; c < 3; ++c)
                squared += now.residual[c] * now.residual[c];
            squared *= sample.importance;
            sums.energy += options_.weight * loss.value(squared);
            ++sums.samples;
            const double w = loss.weight(squared) * sample.importance;
            double xx = 0, xy = 0, yy = 0, rx = 0, ry = 0;
            for (int c = 0; c < 3; ++c)
            {
                const Point2d g = now.gradient[c];
                const double value = sample.value[c];
                xx += g.x * g.x;
                xy += g.x * g.y;
                yy += g.y * g.y;
                rx += g.x * now.residual[c];
                ry += g.y * now.residual[c];
                sums.moments[c][0] += w * value * value;
                sums.moments[c][1] += w * value;
                sums.moments[c][2] += w;
                sums.residual[c][0] += w * value * now.residual[c];
                sums.residual[c][1] += w * now.residual[c];
                for (int k = 0; k < 4; ++k)
                {
                    const double wk = w * sample.weight[k];
                    sums.color[k][c][0] += wk * g.x * value;
                    sums.color[k][c][1] += wk * g.x;
                    sums.color[k][c][2] += wk * g.y * value;
                    sums.color[k][c][3] += wk * g.y;
                }
            }
            int pair = 0;
            for (int k = 0; k < 4; ++k)
            {
                const double wk = w * sample.weight[k];
                for (int m = k; m < 4; ++m, ++pair)
                {
                    const double wkm = wk * sample.weight[m];
                    sums.corner[pair][0] += wkm * xx;
                    sums.corner[pair][1] += wkm * xy;
                    sums.corner[pair][2] += wkm * yy;
                }
                sums.slope[k][0] += wk * rx;
                sums.slope[k][1] += wk * ry;
            }
        }
        if (sums.samples == 0)
            continue;
        ColoredBlock block;
        unfold(sums, options_.weight, block);
        sink.addColored({source_image_, cell}, block);
        total += sums.energy;
    }
    return total;
}

std::vector<float> PhotometricTerm::squaredResiduals(const std::vector<ImageState>& images) const
{
    std::vector<float> squared;
    squared.reserve(samples_.size());
    int hint = -1;
    CellPoint target_point;
    Evaluated now;
    for (int cell = 0; cell < lattice_.cellCount(); ++cell)
        for (int i = first_[cell]; i < first_[cell + 1]; ++i)
            if (evaluate(samples_[i], cell, images, hint, target_point, now))
            {
                double sum = 0;
                for (int c = 0; c < 3; ++c)
                    sum += now.residual[c] * now.residual[c];
                squared.push_back(static_cast<float>(sum * samples_[i].importance));
            }
    return squared;
}

std::vector<int> PhotometricTerm::countInside(const std::vector<ImageState>& images) const
{
    std::vector<int> count(lattice_.cellCount(), 0);
    int hint = -1;
    CellPoint target_point;
    Evaluated now;
    for (int cell = 0; cell < lattice_.cellCount(); ++cell)
        for (int i = first_[cell]; i < first_[cell + 1]; ++i)
            count[cell] += evaluate(samples_[i], cell, images, hint, target_point, now) ? 1 : 0;
    return count;
}

} // namespace gcpw
} // namespace cv
