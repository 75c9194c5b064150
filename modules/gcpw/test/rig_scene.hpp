// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_RIG_SCENE_HPP
#define OPENCV_GCPW_TEST_RIG_SCENE_HPP

#include "test_precomp.hpp"

#include <cmath>
#include <vector>
#include "scene.hpp"

namespace opencv_test
{

const double RIG_FOCAL = 420;
const Size RIG_IMAGE(400, 300);

inline Mat rotationOf(double yaw, double pitch, double roll)
{
    const Matx33d y(std::cos(yaw), 0, std::sin(yaw), 0, 1, 0, -std::sin(yaw), 0, std::cos(yaw));
    const Matx33d x(1, 0, 0, 0, std::cos(pitch), -std::sin(pitch), 0, std::sin(pitch), std::cos(pitch));
    const Matx33d z(std::cos(roll), -std::sin(roll), 0, std::sin(roll), std::cos(roll), 0, 0, 0, 1);
    return Mat(Matx33f(y * x * z));
}

inline cv::detail::CameraParams cameraAt(double yaw, double pitch = 0, double roll = 0)
{
    cv::detail::CameraParams camera;
    camera.focal = RIG_FOCAL;
    camera.ppx = 0.5 * RIG_IMAGE.width;
    camera.ppy = 0.5 * RIG_IMAGE.height;
    camera.R = rotationOf(yaw, pitch, roll);
    return camera;
}

inline Mat intrinsics(const cv::detail::CameraParams& camera, double scale = 1)
{
    Mat K;
    camera.K().convertTo(K, CV_32F);
    for (const Point p : {Point(0, 0), Point(2, 0), Point(1, 1), Point(2, 1)})
        K.at<float>(p) *= static_cast<float>(scale);
    return K;
}

/// What a camera sees of a textured sphere; `bend_px` is parallax, different for every `bend_phase`.
inline Mat photographOf(const cv::detail::CameraParams& camera, double bend_px, double bend_phase, uint64_t seed = 7,
                        Size size = RIG_IMAGE)
{
    const Texture texture(seed);
    cv::detail::SphericalWarper sphere(static_cast<float>(RIG_FOCAL));
    const Mat K = intrinsics(camera);
    const Matx33d ray_from_pixel = Matx33d(Matx33f(camera.R.ptr<float>())) * Matx33d(Matx33f(K.ptr<float>())).inv();
    Mat picture(size, CV_8UC3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
        {
            const Vec3d ray = ray_from_pixel * Vec3d(x, y, 1);
            const Point2d on_sphere(RIG_FOCAL * std::atan2(ray[0], ray[2]), RIG_FOCAL * std::atan2(ray[1], std::hypot(ray[0], ray[2])));
            const Point2d bend(bend_px * std::sin(on_sphere.x / 90 + bend_phase), bend_px * std::cos(on_sphere.y / 80 + bend_phase));
            picture.at<Vec3b>(y, x) = Vec3b(texture.at(on_sphere + bend) * 255.0);
        }
    return picture;
}

/// A rig whose meshes are bent smoothly by up to `bend_px`: nothing was estimated.
inline gcpw::Rig bentRig(const Ptr<WarperCreator>& base, const std::vector<cv::detail::CameraParams>& cameras, double bend_px,
                         const std::vector<double>& turns = std::vector<double>())
{
    gcpw::Rig rig;
    rig.cameras = cameras;
    rig.scale = static_cast<float>(cameras[0].focal);
    rig.turns = turns;
    const Ptr<cv::detail::RotationWarper> warper = base->create(rig.scale);
    std::vector<gcpw::Alignment::Image> images;
    for (size_t i = 0; i < cameras.size(); ++i)
    {
        const double seam_rotation_rad = turns.empty() ? 0 : turns[i];
        const Matx33f world = Matx33f(rotationOf(-seam_rotation_rad, 0, 0).ptr<float>()) * Matx33f(cameras[i].R.ptr<float>());
        const Rect roi = warper->warpRoi(RIG_IMAGE, intrinsics(cameras[i]), Mat(seam_rotation_rad == 0 ? Matx33f(cameras[i].R.ptr<float>()) : world));
        gcpw::Alignment::Image image;
        image.full_size = image.work_size = roi.size();
        image.color = Mat(6, 8, CV_32FC(6));
        image.rough.create(7, 9, CV_64FC2);
        image.mesh.create(7, 9, CV_64FC2);
        for (int row = 0; row < 7; ++row)
            for (int col = 0; col < 9; ++col)
            {
                const Vec2d reference(roi.x + seam_rotation_rad * rig.scale + col * roi.width / 8.0 - 0.5, roi.y + row * roi.height / 6.0 - 0.5);
                const double phase = static_cast<double>(i);
                image.rough.at<Vec2d>(row, col) = reference;
                image.mesh.at<Vec2d>(row, col) = reference + bend_px * Vec2d(std::sin(0.7 * col + 0.4 * row + phase), std::cos(0.5 * col - 0.8 * row + phase));
                if (row < 6 && col < 8)
                    image.color.at<Vec<float, 6>>(row, col) =
                        Vec<float, 6>(0.8F + 0.05F * static_cast<float>(col), 1, 1, 0.01F * static_cast<float>(row), 0, 0.01F);
            }
        images.push_back(image);
    }
    rig.alignment = gcpw::Alignment(images, Size2d(1, 1), gcpw::Report());
    return rig;
}

} // namespace opencv_test

#endif
