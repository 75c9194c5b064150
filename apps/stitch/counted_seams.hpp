// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_COUNTED_SEAMS_HPP
#define GCPW_APPS_COUNTED_SEAMS_HPP

#include <functional>
#include <opencv2/gcpw/seam_finder.hpp>

/// cv::gcpw::GcpwSeamFinder that tells how many pairs of photographs are cut.
class CountedSeams : public cv::gcpw::GcpwSeamFinder
{
public:
    /// @param show called with the share that is done
    explicit CountedSeams(const std::function<void(double)>& show) : show_(show) {}

    void find(const std::vector<cv::UMat>& src, const std::vector<cv::Point>& corners,
              std::vector<cv::UMat>& masks) override;

protected:
    void findInPair(size_t first, size_t second, cv::Rect roi) override;

private:
    std::function<void(double)> show_;
    size_t pairs_ = 0; ///< that overlap
    size_t done_ = 0;
};

#endif
