// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_COMPOSE_HPP
#define GCPW_APPS_STITCH_COMPOSE_HPP

#include <functional>
#include <vector>
#include "common/progress_line.hpp"
#include "stitch/layout.hpp"

/// A picture and where it has pixels.
struct Composition
{
    cv::Mat picture; ///< CV_8UC3 or CV_16UC3
    cv::Mat shown;   ///< CV_8UC1, not 0 where a photograph shows
    int turns = 0;   ///< to the right, by 90 degrees, that made it stand
    cv::Rect crop;   ///< the part of it that is written; empty for all of it
};

/// Warped photographs at the picture's resolution, one after the other.
class Warping
{
public:
    /// A photograph on the canvas.
    struct Warped
    {
        cv::Mat image; ///< BGR of 8 or 16 bits, colours untouched
        cv::Mat mask;  ///< CV_8UC1, 255 where it is to be shown
        cv::Point corner;
    };

    Warping(const StitchJob& job, const std::vector<Photograph>& photographs, const Layout& layout, bool deep);

    /// The k-th photograph of the layout. In their order, each once.
    Warped warp(size_t k);

    const std::vector<cv::Point>& corners() const { return corners_; }
    const std::vector<cv::Size>& sizes() const { return sizes_; }

private:
    const std::vector<Photograph>& photographs_;
    const Layout& layout_;
    bool deep_;
    double scale_ = 1; ///< pixels of the picture per pixel of the photographs
    std::vector<cv::detail::CameraParams> cameras_;
    cv::Ptr<cv::detail::RotationWarper> warper_;
    std::vector<cv::Point> corners_;
    std::vector<cv::Size> sizes_;
};

/// Pixels of the picture per pixel of the photographs.
double composeScale(const StitchJob& job, const std::vector<Photograph>& photographs, const Layout& layout);

/** @brief Makes the picture as cv::Stitcher::composePanorama() does, with transparent pixels left out and 16 bits kept.
@param deep 16 bits
@param on_warped called with each warped photograph before its colours change; may be empty */
Composition compose(const StitchJob& job, const std::vector<Photograph>& photographs, const Layout& layout, bool deep,
                    ProgressLine& progress,
                    const std::function<void(size_t, const Warping&, const Warping::Warped&)>& on_warped);

#endif
