// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <algorithm>
#include "rig_scene.hpp"

namespace opencv_test { namespace {

const int VIEWS = 12;
const double CIRCLE = 2 * CV_PI * RIG_FOCAL; ///< px of the canvas at the cameras' focal length
const double PARALLAX = 3;                   ///< px, largest displacement of a view in x and in y

double wrapped(double distance)
{
    return distance - CIRCLE * std::round(distance / CIRCLE);
}

/** @brief A textured circle seen by 12 cameras, each with a smooth displacement of its own, as parallax makes it.

View i has at canvas point s the scene point s + displacement_i(s); texture and displacements repeat after the circle. */
class Ring
{
public:
    Ring()
    {
        for (int i = 0; i < VIEWS; ++i)
        {
            cameras_.push_back(cameraAt(2 * CV_PI * i / VIEWS + 0.1, i % 2 == 0 ? 0.02 : -0.02));
        }
        images_.resize(VIEWS);
        parallel_for_(Range(0, VIEWS), [&](const Range& views)
        {
            for (int i = views.start; i < views.end; ++i)
                images_[i] = view(i);
        });
    }

    const std::vector<cv::detail::CameraParams>& cameras() const { return cameras_; }
    const std::vector<Mat>& images() const { return images_; }

    /// Where view i has a scene point, px of the image.
    Point2f imagePoint(int i, Point2d scene) const
    {
        Point2d canvas = scene;
        for (int k = 0; k < 40; ++k) // the displacement is smooth and small, so that this contracts
            canvas = scene - displacement(i, canvas);
        return cv::detail::SphericalWarper(static_cast<float>(RIG_FOCAL)).warpPointBackward(canvas, intrinsics(cameras_[i]), cameras_[i].R);
    }

    /// Mean and largest distance of where two views have a scene point on the canvas, over what both show.
    Vec2d gap(int a, int b, cv::detail::RotationWarper& warper) const
    {
        const Rect2f inside(4, 4, RIG_IMAGE.width - 9, RIG_IMAGE.height - 9);
        double sum = 0;
        double most = 0;
        int count = 0;
        // Between the two views, with room for what the displacements do.
        for (double x = -150; x <= 150; x += 6)
            for (double y = -140; y <= 140; y += 8)
            {
                const Point2d scene((2 * CV_PI * (a + 0.5) / VIEWS + 0.1) * RIG_FOCAL + x, CV_PI / 2 * RIG_FOCAL + y);
                const Point2f at_a = imagePoint(a, scene);
                const Point2f at_b = imagePoint(b, scene);
                if (!inside.contains(at_a) || !inside.contains(at_b))
                    continue;
                const Point2d gap = warper.warpPoint(at_a, intrinsics(cameras_[a]), cameras_[a].R) -
                                    warper.warpPoint(at_b, intrinsics(cameras_[b]), cameras_[b].R);
                const double distance = std::hypot(wrapped(gap.x), gap.y);
                sum += distance;
                most = std::max(most, distance);
                ++count;
            }
        EXPECT_GT(count, 300);
        return {sum / count, most};
    }

private:
    static Point2d displacement(int i, Point2d canvas)
    {
        return {PARALLAX * std::sin(2 * CV_PI * 5 * canvas.x / CIRCLE + 1.7 * i), PARALLAX * std::cos(canvas.y / 80 + 1.3 * i)};
    }

    /// Repeats after the circle: near the end the texture fades into its own beginning.
    Vec3d colorAt(Point2d scene) const
    {
        const double fade = 120;
        const double x = scene.x - CIRCLE * std::floor(scene.x / CIRCLE);
        const Vec3d color = texture_.at(Point2d(x, scene.y));
        const double share = (x - CIRCLE + fade) / fade;
        return share <= 0 ? color : color * (1 - share) + texture_.at(Point2d(x - CIRCLE, scene.y)) * share;
    }

    Mat view(int i) const
    {
        cv::detail::SphericalWarper sphere(static_cast<float>(RIG_FOCAL));
        const Mat K = intrinsics(cameras_[i]);
        Mat picture(RIG_IMAGE, CV_8UC3);
        for (int y = 0; y < picture.rows; ++y)
            for (int x = 0; x < picture.cols; ++x)
            {
                const Point2f pixel(static_cast<float>(x), static_cast<float>(y));
                const Point2d canvas = sphere.warpPoint(pixel, K, cameras_[i].R);
                picture.at<Vec3b>(y, x) = Vec3b(colorAt(canvas + displacement(i, canvas)) * 255.0);
            }
        return picture;
    }

    Texture texture_{5};
    std::vector<cv::detail::CameraParams> cameras_;
    std::vector<Mat> images_;
};

TEST(Gcpw_Ring, a_circle_of_twelve_views_closes_to_a_third_of_a_pixel)
{
    const Ring ring;
    const Ptr<WarperCreator> base = makePtr<cv::SphericalWarper>();
    gcpw::Params params;
    params.meshCols = params.meshRows = 16; // 25 px a quad, finer than any displacement
    const gcpw::Rig rig = gcpw::alignRig(ring.images(), ring.cameras(), base, params);
    ASSERT_TRUE(rig.usable()) << rig.alignment.report().message;
    EXPECT_EQ(rig.alignment.report().folds, 0);
    EXPECT_EQ(rig.alignment.report().pairs.size(), static_cast<size_t>(VIEWS));
    const auto rotatedAboutAxis = std::count_if(rig.turns.begin(), rig.turns.end(), [](double seam_rotation_rad) { return seam_rotation_rad != 0; });
    EXPECT_EQ(rotatedAboutAxis, 2) << "views across the seam of the canvas";
    const Ptr<cv::detail::RotationWarper> plain = base->create(rig.scale);
    const Ptr<cv::detail::RotationWarper> refined = gcpw::GcpwWarper(base, rig).create(rig.scale);
    for (int a = 0; a < VIEWS; ++a)
    {
        const int b = (a + 1) % VIEWS;
        const Vec2d before = ring.gap(a, b, *plain);
        const Vec2d after = ring.gap(a, b, *refined);
        EXPECT_GT(before[0], 1) << "nothing to do between " << a << " and " << b;
        EXPECT_LE(after[0], 0.3) << a << " and " << b;
        EXPECT_LE(after[1], 2) << a << " and " << b;
    }
}

}} // namespace
