// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "cameras/linked_images.hpp"

#include <algorithm>

namespace cv
{
namespace gcpw
{

namespace
{

/// Matches store their homography between centred pixels.
Matx33d centred(Size size, double sign)
{
    return {1, 0, sign * 0.5 * size.width, 0, 1, sign * 0.5 * size.height, 0, 0, 1};
}

} // namespace

Link linkOf(const LinkedImages& images, int a, int b)
{
    const cv::detail::MatchesInfo& info = images.between(a, b);
    Link link;
    link.a = a;
    link.b = b;
    link.confidence = info.confidence;
    for (size_t k = 0; k < info.inliers_mask.size(); ++k)
    {
        if (!info.inliers_mask[k])
            continue;
        link.points_a.push_back(images.features[a].keypoints[info.matches[k].queryIdx].pt);
        link.points_b.push_back(images.features[b].keypoints[info.matches[k].trainIdx].pt);
    }
    return link;
}

std::vector<Link> linksOf(const LinkedImages& images, double confidence)
{
    std::vector<Link> links;
    for (int a = 0; a < images.count(); ++a)
        for (int b = a + 1; b < images.count(); ++b)
            if (!images.between(a, b).H.empty() && images.between(a, b).confidence >= confidence)
                links.push_back(linkOf(images, a, b));
    return links;
}

bool homographyOf(const LinkedImages& images, int a, int b, Matx33d& b_from_a)
{
    const Mat& stored = images.between(a, b).H;
    if (stored.empty())
        return false;
    Matx33d h;
    stored.convertTo(Mat(3, 3, CV_64F, h.val), CV_64F);
    b_from_a = centred(images.features[b].img_size, 1) * h * centred(images.features[a].img_size, -1);
    return true;
}

std::vector<int> groupsOf(const LinkedImages& images, double confidence)
{
    std::vector<int> groups(images.features.size(), -1);
    int made = 0;
    for (int first = 0; first < images.count(); ++first)
    {
        if (groups[first] >= 0)
            continue;
        std::vector<int> open(1, first);
        groups[first] = made;
        while (!open.empty())
        {
            const int a = open.back();
            open.pop_back();
            for (int b = 0; b < images.count(); ++b)
                if (groups[b] < 0 && images.between(std::min(a, b), std::max(a, b)).confidence >= confidence)
                {
                    groups[b] = made;
                    open.push_back(b);
                }
        }
        ++made;
    }
    return groups;
}

std::vector<int> largestGroup(const std::vector<int>& groups)
{
    std::vector<int> largest;
    for (int group = 0; group < static_cast<int>(groups.size()); ++group)
    {
        std::vector<int> members;
        for (int i = 0; i < static_cast<int>(groups.size()); ++i)
            if (groups[i] == group)
                members.push_back(i);
        if (members.size() > largest.size())
            largest = members;
    }
    return largest;
}

bool notesFocal(const LinkedImages& images)
{
    return std::any_of(images.focals.begin(), images.focals.end(), [](double focal) { return focal > 0; });
}

LinkedImages subset(const LinkedImages& images, const std::vector<int>& chosen)
{
    LinkedImages part;
    for (const int a : chosen)
        part.features.push_back(images.features[a]);
    for (size_t i = 0; !images.focals.empty() && i < chosen.size(); ++i)
        part.focals.push_back(images.focals[chosen[i]]);
    for (size_t i = 0; i < chosen.size(); ++i)
        for (size_t j = 0; j < chosen.size(); ++j)
        {
            part.matches.push_back(images.between(chosen[i], chosen[j]));
            part.matches.back().src_img_idx = static_cast<int>(i);
            part.matches.back().dst_img_idx = static_cast<int>(j);
        }
    return part;
}

} // namespace gcpw
} // namespace cv
