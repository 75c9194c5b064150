// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "cameras/rotation_fit.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

const double LOSS_PX = 4;     ///< of the robust loss: parallax of a hand-held camera at half a million pixels
const int MOST_MATCHES = 100; ///< of a link: more change nothing but the time
const int MAX_STEPS = 60;
const double ENOUGH = 1e-5;    ///< relative decrease of the cost below which a fit is done
const double BEHIND = 1e4;     ///< px^2: cost of a point that falls behind a camera
const double MIN_DEPTH = 0.05; ///< of a ray of length about 1; nearer to the image plane's horizon positions explode
const double STARTS[] = {0.6, 0.9, 1.3, 2,
                         3.5}; ///< focal lengths over the longer side: from very wide lenses to short telephotos

Matx33d cross(const Vec3d& v)
{
    return {0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0};
}

/// The rotation by a vector (Rodrigues).
Matx33d rotationBy(const Vec3d& w)
{
    const double angle = norm(w);
    const Matx33d x = cross(w);
    const double first = angle > 1e-8 ? std::sin(angle) / angle : 1;
    const double second = angle > 1e-8 ? (1 - std::cos(angle)) / (angle * angle) : 0.5;
    return Matx33d::eye() + first * x + second * (x * x);
}

/// The rotation that turns unit vectors `from` best onto `to` (Kabsch), with robust weights.
Matx33d rotationBetween(const std::vector<Vec3d>& from, const std::vector<Vec3d>& to, double loss_rad)
{
    Matx33d rotation = Matx33d::eye();
    for (int round = 0; round < 10; ++round)
    {
        Matx33d moment = Matx33d::zeros();
        for (size_t k = 0; k < from.size(); ++k)
        {
            // All weights are equal at first: the matches agree with a homography already.
            const Vec3d miss = to[k] - rotation * from[k];
            const double weight = round == 0 ? 1 : 1 / (1 + miss.dot(miss) / (loss_rad * loss_rad));
            moment += weight * (to[k] * from[k].t());
        }
        Mat values;
        Mat u;
        Mat vt;
        SVD::compute(Mat(moment), values, u, vt);
        const double sign = determinant(u) * determinant(vt) < 0 ? -1 : 1;
        const Mat flip = Mat::diag(Mat(Vec3d(1, 1, sign)));
        rotation = Matx33d(Mat(u * flip * vt).ptr<double>());
    }
    return rotation;
}

/// One match: offsets from the middles of its two images.
struct Sight
{
    int a;
    int b;
    Vec2d in_a;
    Vec2d in_b;
    double weight;
};

class Fit
{
public:
    Fit(const std::vector<Size>& sizes, const std::vector<Link>& links)
        : count_(static_cast<int>(sizes.size())), links_(links)
    {
        for (const Link& link : links)
        {
            const size_t most = std::min<size_t>(link.points_a.size(), MOST_MATCHES);
            for (size_t k = 0; k < most; ++k)
            {
                const size_t i = k * link.points_a.size() / most;
                sights_.push_back({link.a, link.b, offset(link.points_a[i], sizes[link.a]),
                                   offset(link.points_b[i], sizes[link.b]),
                                   static_cast<double>(link.points_a.size()) / static_cast<double>(most)});
            }
        }
        for (const Sight& sight : sights_)
            weight_ += 2 * sight.weight;
    }

    /// Rotations along the tree of the strongest links. False if it does not reach all images.
    bool start(double focal, TurningCameras& cameras) const
    {
        cameras.focal = focal;
        cameras.rotations.assign(count_, Matx33d::eye());
        std::vector<bool> placed(count_, false);
        const auto strongest =
            std::max_element(links_.begin(), links_.end(),
                             [](const Link& p, const Link& q) { return p.points_a.size() < q.points_a.size(); });
        if (strongest == links_.end())
            return false;
        placed[strongest->a] = true;
        for (int reached = 1; reached < count_; ++reached)
        {
            const Link* best = nullptr;
            for (const Link& link : links_)
                if (placed[link.a] != placed[link.b] && (!best || link.points_a.size() > best->points_a.size()))
                    best = &link;
            if (!best)
                return false;
            const Matx33d b_from_a = relative(*best, focal);
            if (placed[best->a])
                cameras.rotations[best->b] = cameras.rotations[best->a] * b_from_a.t();
            else
                cameras.rotations[best->a] = cameras.rotations[best->b] * b_from_a;
            placed[best->a] = placed[best->b] = true;
        }
        cameras.cost = cost(cameras);
        return true;
    }

    /// Levenberg-Marquardt with iteratively reweighted squares.
    void refine(TurningCameras& cameras) const
    {
        double damping = 1e-3;
        for (int step = 0; step < MAX_STEPS; ++step)
        {
            Mat normal;
            Mat gradient;
            linearize(cameras, normal, gradient);
            bool lower = false;
            double gain = 0;
            for (int attempt = 0; attempt < 8 && !lower; ++attempt)
            {
                Mat damped = normal.clone();
                for (int k = 0; k < damped.rows; ++k)
                    damped.at<double>(k, k) *= 1 + damping;
                Mat delta;
                if (solve(damped, -gradient, delta, DECOMP_CHOLESKY))
                {
                    TurningCameras moved = moveBy(cameras, delta);
                    moved.cost = cost(moved);
                    lower = moved.cost < cameras.cost;
                    if (lower)
                    {
                        gain = cameras.cost - moved.cost;
                        cameras = moved;
                    }
                }
                damping = lower ? std::max(damping * 0.2, 1e-9) : damping * 6;
            }
            if (!lower || gain <= ENOUGH * cameras.cost)
                return;
        }
    }

private:
    static Vec2d offset(Point2f p, Size size) { return {p.x - 0.5 * size.width, p.y - 0.5 * size.height}; }

    Matx33d relative(const Link& link, double focal) const
    {
        std::vector<Vec3d> from;
        std::vector<Vec3d> to;
        for (const Sight& sight : sights_)
            if (sight.a == link.a && sight.b == link.b)
            {
                from.push_back(normalize(Vec3d(sight.in_a[0], sight.in_a[1], focal)));
                to.push_back(normalize(Vec3d(sight.in_b[0], sight.in_b[1], focal)));
            }
        return rotationBetween(from, to, LOSS_PX / focal);
    }

    static double loss(const Vec2d& miss)
    {
        return LOSS_PX * LOSS_PX * std::log1p(miss.dot(miss) / (LOSS_PX * LOSS_PX));
    }

    double cost(const TurningCameras& cameras) const
    {
        double sum = 0;
        for (const Sight& sight : sights_)
            for (const bool back : {false, true})
            {
                const Vec2d& p = back ? sight.in_b : sight.in_a;
                const Vec2d& q = back ? sight.in_a : sight.in_b;
                const Vec3d x(p[0] / cameras.focal, p[1] / cameras.focal, 1);
                const Vec3d y =
                    cameras.rotations[back ? sight.a : sight.b].t() * (cameras.rotations[back ? sight.b : sight.a] * x);
                const bool ahead = y[2] > MIN_DEPTH;
                sum += sight.weight * (ahead ? loss(Vec2d(y[0], y[1]) * (cameras.focal / y[2]) - q) : BEHIND);
            }
        return sum / weight_;
    }

    /// Unknowns: the logarithm of the focal length, then a turn of each camera about its own axes.
    void linearize(const TurningCameras& cameras, Mat& normal, Mat& gradient) const
    {
        const int unknowns = 1 + 3 * count_;
        normal = Mat::zeros(unknowns, unknowns, CV_64F);
        gradient = Mat::zeros(unknowns, 1, CV_64F);
        const double f = cameras.focal;
        for (const Sight& sight : sights_)
            for (const bool back : {false, true})
            {
                const int from = back ? sight.b : sight.a;
                const int to = back ? sight.a : sight.b;
                const Vec2d& p = back ? sight.in_b : sight.in_a;
                const Vec2d& q = back ? sight.in_a : sight.in_b;
                const Vec3d x(p[0] / f, p[1] / f, 1);
                const Matx33d turn = cameras.rotations[to].t() * cameras.rotations[from];
                const Vec3d y = turn * x;
                if (y[2] <= MIN_DEPTH)
                    continue;
                const Vec2d miss = Vec2d(y[0], y[1]) * (f / y[2]) - q;
                const double weight = sight.weight / (1 + miss.dot(miss) / (LOSS_PX * LOSS_PX));
                const Matx23d project(f / y[2], 0, -f * y[0] / (y[2] * y[2]), 0, f / y[2], -f * y[1] / (y[2] * y[2]));
                const Vec2d by_focal = Vec2d(y[0], y[1]) * (f / y[2]) + project * (turn * Vec3d(-x[0], -x[1], 0));
                const Matx23d by_from = project * turn * (-1.0 * cross(x));
                const Matx23d by_to = project * cross(y);
                Matx<double, 2, 7> row;
                for (int r = 0; r < 2; ++r)
                {
                    row(r, 0) = by_focal[r];
                    for (int c = 0; c < 3; ++c)
                    {
                        row(r, 1 + c) = by_from(r, c);
                        row(r, 4 + c) = by_to(r, c);
                    }
                }
                int place[7] = {0};
                for (int c = 0; c < 3; ++c)
                {
                    place[1 + c] = 1 + 3 * from + c;
                    place[4 + c] = 1 + 3 * to + c;
                }
                const Matx<double, 7, 7> square = row.t() * row;
                const Matx<double, 7, 1> slope = row.t() * miss;
                for (int r = 0; r < 7; ++r)
                {
                    gradient.at<double>(place[r]) += weight * slope(r);
                    for (int c = 0; c < 7; ++c)
                        normal.at<double>(place[r], place[c]) += weight * square(r, c);
                }
            }
        // The world may turn as a whole: the first camera is held, and so is whatever no match sees.
        for (int c = 0; c < 3; ++c)
            normal.at<double>(1 + c, 1 + c) += 1e12;
        for (int k = 0; k < unknowns; ++k)
            normal.at<double>(k, k) += 1e-6;
    }

    TurningCameras moveBy(const TurningCameras& cameras, const Mat& delta) const
    {
        TurningCameras moved = cameras;
        // No single step changes the focal length by more than half.
        moved.focal *= std::exp(std::min(std::max(delta.at<double>(0), -0.5), 0.5));
        for (int i = 0; i < count_; ++i)
            moved.rotations[i] =
                cameras.rotations[i] * rotationBy(Vec3d(delta.at<double>(1 + 3 * i), delta.at<double>(2 + 3 * i),
                                                        delta.at<double>(3 + 3 * i)));
        return moved;
    }

    int count_;
    const std::vector<Link>& links_;
    std::vector<Sight> sights_;
    double weight_ = 0;
};

} // namespace

bool fitTurningCameras(const std::vector<Size>& sizes, const std::vector<Link>& links, TurningCameras& cameras)
{
    CV_DbgAssert(sizes.size() >= 2);
    const Fit fit(sizes, links);
    const double side = std::max(sizes[0].width, sizes[0].height);
    bool found = false;
    for (const double start : STARTS)
    {
        TurningCameras tried;
        if (!fit.start(start * side, tried))
            return false;
        fit.refine(tried);
        if (std::isfinite(tried.cost) && (!found || tried.cost < cameras.cost))
        {
            cameras = tried;
            found = true;
        }
    }
    return found;
}

} // namespace gcpw
} // namespace cv
