// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_LINKED_IMAGES_HPP
#define OPENCV_GCPW_LINKED_IMAGES_HPP

#include <vector>
#include <opencv2/stitching/detail/matchers.hpp>

namespace cv
{
namespace gcpw
{

/// Photographs and the keypoints that each two of them have in common.
struct LinkedImages
{
    std::vector<cv::detail::ImageFeatures> features; ///< img_idx is the number of the user's image
    std::vector<cv::detail::MatchesInfo> matches;    ///< of every ordered pair: a * count() + b
    /// Focal lengths that files note, px of the features' images, 0 where one notes none; empty if none of them does.
    std::vector<double> focals;

    int count() const { return static_cast<int>(features.size()); }
    const cv::detail::MatchesInfo& between(int a, int b) const
    {
        return matches[static_cast<size_t>(a) * features.size() + b];
    }
    cv::detail::MatchesInfo& between(int a, int b) { return matches[static_cast<size_t>(a) * features.size() + b]; }
};

/// Matches of two images a < b that agree with one homography.
struct Link
{
    int a = -1;
    int b = -1;
    double confidence = 0;
    std::vector<Point2f> points_a; ///< pixels of a
    std::vector<Point2f> points_b; ///< pixels of b
};

/// The matches of a pair that agree with its homography.
Link linkOf(const LinkedImages& images, int a, int b);

/// All links of at least this confidence, in ascending order.
std::vector<Link> linksOf(const LinkedImages& images, double confidence);

/// The homography of a pair's matches in pixels, b from a. False if there is none.
bool homographyOf(const LinkedImages& images, int a, int b, Matx33d& b_from_a);

/// The group that every image belongs to: images are in one group if links of at least this confidence lead from one to the other.
/// Groups are numbered in the order of their first image.
std::vector<int> groupsOf(const LinkedImages& images, double confidence);

/// The images of the largest group, ascending; of equals the first.
std::vector<int> largestGroup(const std::vector<int>& groups);

/// Whether the files of some images note a focal length.
bool notesFocal(const LinkedImages& images);

/// A part of the images with the matches among them; `chosen` ascending.
LinkedImages subset(const LinkedImages& images, const std::vector<int>& chosen);

} // namespace gcpw
} // namespace cv

#endif
