// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_PART_FACTORY_HPP
#define OPENCV_GCPW_PART_FACTORY_HPP

#include <memory>
#include "opencv2/gcpw/compensator.hpp"
#include "opencv2/gcpw/seam_finder.hpp"
#include "opencv2/gcpw/warper.hpp"

namespace cv
{
namespace gcpw
{

/// Makes the public classes from private types: a friend of each, so that no exported constructor names such a type.
struct PartFactory
{
    /// @param model may be empty: then this is the base warper
    static Ptr<GcpwRotationWarper> rotationWarper(const Ptr<cv::detail::RotationWarper>& base, const std::shared_ptr<const RigModel>& model)
    {
        return Ptr<GcpwRotationWarper>(new GcpwRotationWarper(base, model));
    }

    static Ptr<GcpwWarper> warper(const std::shared_ptr<SharedState>& shared_state)
    {
        return Ptr<GcpwWarper>(new GcpwWarper(shared_state));
    }

    static Ptr<GcpwCompensator> compensator(const Params& params, const std::shared_ptr<SharedState>& shared_state)
    {
        return Ptr<GcpwCompensator>(new GcpwCompensator(params, shared_state));
    }

    static Ptr<GcpwSeamFinder> seamFinder(const std::shared_ptr<SharedState>& shared_state,
                                          const Ptr<cv::detail::SeamFinder>& fallback)
    {
        return Ptr<GcpwSeamFinder>(new GcpwSeamFinder(shared_state, fallback));
    }
};

} // namespace gcpw
} // namespace cv

#endif
