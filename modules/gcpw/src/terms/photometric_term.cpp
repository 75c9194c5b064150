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
    double curvature[10][3] = {}; ///< per pair of corners k <= m: sum w_k w_m (xx, xy, yy) of g g^T
    double corner[4][14] = {};    ///< per corner: sum w_k (gx r, gy r), then per channel w_k (gx I, gx, gy I, gy)
    double color[3][5] = {};      ///< per channel: sum I I, I, 1, I r, r
    double energy = 0;
    int samples = 0;

    /// One sample: bilinear weights, channel values, residuals, gradients (x then y) and its weight.
    void add(const float* corner_weight, const float* value, const double* r, const double* gx, const double* gy, double w)
    {
        double part[14] = {};
        double xx = 0;
        double xy = 0;
        double yy = 0;
        for (int c = 0; c < 3; ++c)
        {
            const double i = value[c];
            xx += gx[c] * gx[c];
            xy += gx[c] * gy[c];
            yy += gy[c] * gy[c];
            part[0] += gx[c] * r[c];
            part[1] += gy[c] * r[c];
            double* own = part + 2 + 4 * c;
            own[0] = gx[c] * i;
            own[1] = gx[c];
            own[2] = gy[c] * i;
            own[3] = gy[c];
            color[c][0] += w * i * i;
            color[c][1] += w * i;
            color[c][2] += w;
            color[c][3] += w * i * r[c];
            color[c][4] += w * r[c];
        }
        int pair = 0;
        for (int k = 0; k < 4; ++k)
        {
            const double wk = w * corner_weight[k];
            for (int j = 0; j < 14; ++j)
                corner[k][j] += wk * part[j];
            for (int m = k; m < 4; ++m, ++pair)
            {
                const double wkm = wk * corner_weight[m];
                curvature[pair][0] += wkm * xx;
                curvature[pair][1] += wkm * xy;
                curvature[pair][2] += wkm * yy;
            }
        }
        ++samples;
    }
};

void unfold(const QuadSums& sums, double weight, ColoredBlock& block)
{
    int pair = 0;
    for (int k = 0; k < 4; ++k)
    {
        for (int m = k; m < 4; ++m, ++pair)
        {
            const double* s = sums.curvature[pair];
            block.mesh_mesh[2 * k][2 * m] = weight * s[0];
            block.mesh_mesh[2 * k][2 * m + 1] = weight * s[1];
            if (m > k)
                block.mesh_mesh[2 * k + 1][2 * m] = weight * s[1];
            block.mesh_mesh[2 * k + 1][2 * m + 1] = weight * s[2];
        }
        for (int axis = 0; axis < 2; ++axis)
        {
            block.mesh_gradient[2 * k + axis] = -weight * sums.corner[k][axis];
            for (int c = 0; c < 3; ++c)
                for (int j = 0; j < 2; ++j)
                    block.mesh_color[2 * k + axis][2 * c + j] = -weight * sums.corner[k][2 + 4 * c + 2 * axis + j];
        }
    }
    for (int c = 0; c < 3; ++c)
    {
        for (int j = 0; j < 3; ++j)
            block.color_color[c][j] = weight * sums.color[c][j];
        for (int j = 0; j < 2; ++j)
            block.color_gradient[c][j] = weight * sums.color[c][3 + j];
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

/// Where the target lies now, with a short cut for a target at rest: then no quad has to be searched.
class PhotometricTerm::Target
{
public:
    explicit Target(const ImageState& state) : state_(state), at_rest_(state.mesh.isTranslation(origin_)) {}

    /// The rest point of the target under a canvas point, and its colour; false outside the mesh.
    bool find(Point2d canvas)
    {
        if (at_rest_)
        {
            rest_ = canvas - origin_;
            if (!state_.mesh.lattice().contains(rest_))
                return false;
            if (state_.color.isIdentity())
                return true;
            point_ = state_.mesh.lattice().locate(rest_);
            return true;
        }
        if (!state_.mesh.invert(canvas, hint_, point_))
            return false;
        rest_ = state_.mesh.lattice().restPoint(point_);
        inverse_ = state_.mesh.jacobian(point_).inv();
        return true;
    }
    Point2d rest() const { return rest_; }
    /// d / d canvas of an image gradient in the rest frame.
    void toCanvas(double& dx, double& dy) const
    {
        if (at_rest_)
            return;
        const double x = dx * inverse_(0, 0) + dy * inverse_(1, 0);
        dy = dx * inverse_(0, 1) + dy * inverse_(1, 1);
        dx = x;
    }
    const ColorGrid::Quad& color() const { return state_.color.isIdentity() ? identity_ : state_.color.quad(point_.cell); }

private:
    const ImageState& state_;
    Point2d origin_;
    bool at_rest_;
    int hint_ = -1;
    Point2d rest_;
    CellPoint point_;
    Matx22d inverse_ = Matx22d::eye();
    ColorGrid::Quad identity_{};
};

template <typename Visit>
void PhotometricTerm::forEachInside(const std::vector<ImageState>& images, int cell, Target& target, Visit visit) const
{
    if (first_[cell] == first_[cell + 1])
        return;
    const MeshGrid& mesh = images[source_image_].mesh;
    const ColorGrid::Quad& mine = images[source_image_].color.quad(cell);
    const Point2d corner[4] = {mesh.vertex(cell, 0), mesh.vertex(cell, 1), mesh.vertex(cell, 2), mesh.vertex(cell, 3)};
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

double PhotometricTerm::linearize(const std::vector<ImageState>& images, bool target_moves, const RobustLoss& loss,
                                  ResidualSink& sink) const
{
    double total = 0;
    Target target(images[target_image_]);
    (void)target_moves;
    for (int cell = 0; cell < lattice_.cellCount(); ++cell)
    {
        QuadSums sums;
        forEachInside(images, cell, target,
                      [&](const Sample& sample, const PixelSample& pixel, const double* residual, double squared)
        {
            sums.energy += options_.weight * loss.value(squared);
            double gx[3];
            double gy[3];
            for (int c = 0; c < 3; ++c)
            {
                gx[c] = target.color()[c].gain * pixel.dx[c];
                gy[c] = target.color()[c].gain * pixel.dy[c];
                target.toCanvas(gx[c], gy[c]);
            }
            sums.add(sample.weight, sample.value, residual, gx, gy, loss.weight(squared) * sample.importance);
        });
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
    std::vector<float> all;
    all.reserve(samples_.size());
    Target target(images[target_image_]);
    for (int cell = 0; cell < lattice_.cellCount(); ++cell)
        forEachInside(images, cell, target, [&](const Sample&, const PixelSample&, const double*, double squared)
        { all.push_back(static_cast<float>(squared)); });
    return all;
}

std::vector<int> PhotometricTerm::countInside(const std::vector<ImageState>& images) const
{
    std::vector<int> count(lattice_.cellCount(), 0);
    Target target(images[target_image_]);
    for (int cell = 0; cell < lattice_.cellCount(); ++cell)
        forEachInside(images, cell, target,
                      [&](const Sample&, const PixelSample&, const double*, double) { ++count[cell]; });
    return count;
}

} // namespace gcpw
} // namespace cv
