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

    /// @param large warps with less memory, and pictures of any side; for a layout of GCPW's
    Warping(const StitchJob& job, const std::vector<Photograph>& photographs, const Layout& layout, bool deep,
            bool large = false);

    /// The k-th photograph of the layout. In their order, each once.
    Warped warp(size_t k);

    /// The same of which only a reduced copy is among the photographs. @param photograph its image as the file has it
    Warped warp(size_t k, const cv::Mat& photograph);

    const std::vector<cv::Point>& corners() const { return corners_; }
    const std::vector<cv::Size>& sizes() const { return sizes_; }

private:
    const std::vector<Photograph>& photographs_;
    const Layout& layout_;
    bool deep_;
    double scale_ = 1; ///< pixels of the picture per pixel of the photographs
    std::vector<cv::detail::CameraParams> cameras_;
    cv::Ptr<cv::detail::RotationWarper> warper_;
    cv::Ptr<cv::gcpw::GcpwRotationWarper> large_; ///< the same; null if it need not be large
    std::vector<cv::Point> corners_;
    std::vector<cv::Size> sizes_;
};

/// A photograph and the pixels to be shown of it at the low resolution of the cuts.
struct SeamCopy
{
    cv::Mat image; ///< CV_8UC3
    cv::Mat mask;  ///< CV_8UC1, 255 where it is to be shown
};

/// Pixels of such a copy per pixel of a photograph. @param first of all photographs
double seamScale(const StitchJob& job, const Photograph& first);

SeamCopy seamCopy(const cv::Mat& photograph, double scale);

/** @brief Which part of each photograph is shown, at the low resolution of the cuts. Estimates exposures on the way.
@param copy_of the copy of a photograph by its number */
std::vector<cv::UMat> findSeams(const Layout& layout, double seam_scale,
                                const std::function<SeamCopy(size_t)>& copy_of, ProgressLine& progress);

/// A warped photograph as blenders take it, CV_16SC3. @param deep 16 bits
cv::Mat fedImage(const cv::Mat& image, bool deep);

/// What is shown of a warped photograph. @param seam of findSeams()  @param shown its mask at the picture's resolution
cv::Mat cutMask(const cv::UMat& seam, const cv::Mat& shown);

/// What a blender has made, in the depth of the photographs.
cv::Mat finished(const cv::Mat& blended, bool deep);

/// Pixels of the picture per pixel of the photographs.
double composeScale(const StitchJob& job, const std::vector<Photograph>& photographs, const Layout& layout);

/** @brief Makes the picture as cv::Stitcher::composePanorama() does, with transparent pixels left out and 16 bits kept.
@param deep 16 bits
@param on_warped called with each warped photograph before its colours change; may be empty */
Composition compose(const StitchJob& job, const std::vector<Photograph>& photographs, const Layout& layout, bool deep,
                    ProgressLine& progress,
                    const std::function<void(size_t, const Warping&, const Warping::Warped&)>& on_warped);

#endif
