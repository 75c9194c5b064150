// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "perf_precomp.hpp"

#include <opencv2/imgproc.hpp>
#include "imaging/sampler.hpp"
#include "scene.hpp"
#include "thread_count.hpp"

namespace opencv_test { namespace {

const Size FRAME(800, 600);

/// A level of noise, and a position for each of its pixels but those at the border.
struct Reading
{
    gcpw::PyramidLevel level;
    Mat positions; ///< CV_32FC2

    Reading() : positions(FRAME, CV_32FC2)
    {
        level.pixels.create(FRAME, CV_32FC4);
        RNG rng = seeded(1);
        rng.fill(level.pixels, RNG::UNIFORM, 0, 1);
        insertChannel(Mat(FRAME, CV_32FC1, Scalar(1)), level.pixels, 3);
        const Matx33d warp = slightHomography(0);
        for (int y = 0; y < FRAME.height; ++y)
            for (int x = 0; x < FRAME.width; ++x)
            {
                const Vec3d p = warp * Vec3d(x, y, 1);
                positions.at<Vec2f>(y, x) = Vec2f(Vec2d(std::min(std::max(p[0], 1.0), FRAME.width - 3.0),
                                                        std::min(std::max(p[1], 1.0), FRAME.height - 3.0)));
            }
    }
};

PERF_TEST(Gcpw_Sampler, value_and_gradient)
{
    const Reading reading;
    gcpw::PixelSample sample{};
    double sum = 0;
    int inside = 0;
    TEST_CYCLE()
    {
        inside = 0;
        for (int y = 0; y < FRAME.height; ++y)
            for (int x = 0; x < FRAME.width; ++x)
            {
                const Vec2f& p = reading.positions.at<Vec2f>(y, x);
                inside += gcpw::samplePixel(reading.level, Point2d(p[0], p[1]), sample) ? 1 : 0;
                sum += sample.value[0] + sample.dx[1] + sample.dy[2];
            }
    }
    CV_Assert(inside == FRAME.area() && std::isfinite(sum));
    SANITY_CHECK_NOTHING();
}

PERF_TEST(Gcpw_Sampler, value_and_gradient_by_remap)
{
    const ThreadCount threads(1);
    const Reading reading;
    Mat value;
    cvtColor(reading.level.pixels, value, COLOR_BGRA2BGR);
    const Mat dx = 0.5 * value;
    const Mat dy = -0.5 * value;
    Mat read[3];
    TEST_CYCLE()
    {
        remap(value, read[0], reading.positions, noArray(), INTER_LINEAR);
        remap(dx, read[1], reading.positions, noArray(), INTER_LINEAR);
        remap(dy, read[2], reading.positions, noArray(), INTER_LINEAR);
    }
    CV_Assert(read[2].size() == FRAME);
    SANITY_CHECK_NOTHING();
}

}} // namespace
