// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_TILED_BLENDER_HPP
#define GCPW_APPS_TILED_BLENDER_HPP

#include <vector>
#include <opencv2/stitching/detail/blenders.hpp>

/** @brief cv::detail::MultiBandBlender tile by tile, with a fraction of its memory.

OpenCV keeps pyramids of the whole panorama and builds those of a whole image, together some 40 bytes a pixel. Here an image is kept as it
was fed, 8-bit and only where it shows, and each tile of the panorama is blended by itself, with a margin as wide as the coarsest
band reaches. The picture differs by rounding at most. */
class TiledBlender : public cv::detail::Blender
{
public:
    static const int USUAL_BANDS = 5; ///< OpenCV's own
    static const int MOST_BANDS_OF_TILES = 7; ///< with more, tiles would be mostly margin: the picture is one

    /// px: a pixel of the coarsest band comes of 4 of its own to each side, and its weight too.
    static int marginOf(int bands) { return 8 << bands; }

    /// @param deep images have values up to 8191 instead of 255, and so has the picture: CV_16SC3
    explicit TiledBlender(int bands = USUAL_BANDS, bool deep = false) : bands_(bands), deep_(deep) {}

    void prepare(cv::Rect roi) override;
    void feed(cv::InputArray image, cv::InputArray mask, cv::Point corner) override;
    void blend(cv::InputOutputArray picture, cv::InputOutputArray mask) override;

private:
    struct Part
    {
        cv::Mat image; ///< CV_8UC3, CV_16SC3 if deep
        cv::Mat mask;
        cv::Point corner;
    };

    /// Blends all parts inside `outer`. @param picture, mask of that size
    void blendTile(cv::Rect outer, cv::Mat& picture, cv::Mat& mask) const;

    int bands_;
    bool deep_;
    cv::Rect roi_;
    std::vector<Part> parts_;
};

#endif
