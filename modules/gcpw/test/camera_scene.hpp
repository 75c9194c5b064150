// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_CAMERA_SCENE_HPP
#define OPENCV_GCPW_TEST_CAMERA_SCENE_HPP

#include "test_precomp.hpp"

#include <cmath>
#include <vector>
#include <opencv2/stitching/detail/camera.hpp>
#include "cameras/linked_images.hpp"
#include "geometry/homography.hpp"

namespace opencv_test
{

/// Photographs of which only the size, and the true positions of matches, are known.
const Size SHOT(640, 480);

inline std::vector<Size> sizesOf(size_t count)
{
    return std::vector<Size>(count, SHOT);
}

/// World from camera: yaw to the right, then pitch upwards, then roll to the right; rad.
inline Matx33d turnOf(double yaw, double pitch = 0, double roll = 0)
{
    const Matx33d y(std::cos(yaw), 0, std::sin(yaw), 0, 1, 0, -std::sin(yaw), 0, std::cos(yaw));
    const Matx33d x(1, 0, 0, 0, std::cos(pitch), -std::sin(pitch), 0, std::sin(pitch), std::cos(pitch));
    const Matx33d z(std::cos(roll), -std::sin(roll), 0, std::sin(roll), std::cos(roll), 0, 0, 0, 1);
    return y * x * z;
}

inline std::vector<cv::detail::CameraParams> camerasOf(const std::vector<Matx33d>& rotations, double focal)
{
    std::vector<cv::detail::CameraParams> cameras(rotations.size());
    for (size_t i = 0; i < rotations.size(); ++i)
    {
        cameras[i].focal = focal;
        cameras[i].ppx = 0.5 * SHOT.width;
        cameras[i].ppy = 0.5 * SHOT.height;
        cameras[i].R = Mat(Matx33f(rotations[i]));
    }
    return cameras;
}

/// A grid of matches between each two images of which one shows what the other does. @param map homography, b from a, pixels
template <typename Map>
std::vector<gcpw::Link> linksBy(size_t count, const Map& map)
{
    std::vector<gcpw::Link> links;
    for (int a = 0; a < static_cast<int>(count); ++a)
        for (int b = a + 1; b < static_cast<int>(count); ++b)
        {
            gcpw::Link link;
            link.a = a;
            link.b = b;
            link.confidence = 2;
            const Matx33d h = map(a, b);
            for (int y = 10; y < SHOT.height; y += 20)
                for (int x = 10; x < SHOT.width; x += 20)
                {
                    const Vec3d q = h * Vec3d(x, y, 1);
                    const Point2d p(q[0] / q[2], q[1] / q[2]);
                    if (q[2] > 0 && p.x >= 0 && p.y >= 0 && p.x < SHOT.width && p.y < SHOT.height)
                    {
                        link.points_a.emplace_back(static_cast<float>(x), static_cast<float>(y));
                        link.points_b.emplace_back(p);
                    }
                }
            if (link.points_a.size() >= 20)
                links.push_back(link);
        }
    return links;
}

inline std::vector<gcpw::Link> linksOfTurning(const std::vector<Matx33d>& rotations, double focal)
{
    const Matx33d K(focal, 0, 0.5 * SHOT.width, 0, focal, 0.5 * SHOT.height, 0, 0, 1);
    return linksBy(rotations.size(), [&](int a, int b) { return K * rotations[b].t() * rotations[a] * K.inv(); });
}

/// The links as a features matcher gives them: every match a keypoint of its own in both images.
inline gcpw::LinkedImages linkedBy(size_t count, const std::vector<gcpw::Link>& links)
{
    gcpw::LinkedImages images;
    images.features.resize(count);
    images.matches.resize(count * count);
    for (size_t i = 0; i < count; ++i)
    {
        images.features[i].img_idx = static_cast<int>(i);
        images.features[i].img_size = SHOT;
    }
    const auto addMatches =
        [&](const gcpw::Link& link, int a, int b, const std::vector<Point2f>& in_a, const std::vector<Point2f>& in_b)
    {
        cv::detail::MatchesInfo& info = images.between(a, b);
        info.src_img_idx = a;
        info.dst_img_idx = b;
        info.confidence = link.confidence;
        info.num_inliers = static_cast<int>(in_a.size());
        info.inliers_mask.assign(in_a.size(), 1);
        std::vector<gcpw::PointMatch> centred;
        const Point2d middle(0.5 * SHOT.width, 0.5 * SHOT.height);
        for (size_t k = 0; k < in_a.size(); ++k)
        {
            info.matches.emplace_back(static_cast<int>(images.features[a].keypoints.size() + k),
                                      static_cast<int>(images.features[b].keypoints.size() + k), 0.F);
            gcpw::PointMatch match;
            match.a = Point2d(in_a[k]) - middle;
            match.b = Point2d(in_b[k]) - middle;
            centred.push_back(match);
        }
        for (size_t k = 0; k < in_a.size(); ++k)
        {
            images.features[a].keypoints.emplace_back(in_a[k], 1.F);
            images.features[b].keypoints.emplace_back(in_b[k], 1.F);
        }
        Matx33d h;
        gcpw::fitHomography(centred, std::vector<gcpw::LineMatch>(), h);
        info.H = Mat(h).clone();
    };
    for (const gcpw::Link& link : links)
    {
        addMatches(link, link.a, link.b, link.points_a, link.points_b);
        addMatches(link, link.b, link.a, link.points_b, link.points_a);
    }
    return images;
}

} // namespace opencv_test

#endif
