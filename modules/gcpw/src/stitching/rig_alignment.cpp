// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitching/rig_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include "opencv2/gcpw/aligner.hpp"
#include "opencv2/gcpw/cameras.hpp"
#include "opencv2/gcpw/rig.hpp"
#include "rendering/remap_tiled.hpp"
#include "stitching/affine_warper.hpp"
#include "stitching/seam_rotation.hpp"
#include "stitching/warped_lines.hpp"
#include "stitching/warper_names.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const double MAX_GROWTH = 16;     ///< of an image's area by the base warper: beyond it the camera is wrong
const double MAX_MOVE = 0.5;      ///< of the larger side of an image: a mesh that moves farther is no refinement
const double MAX_PLACE = 1e9;     ///< px from the canvas's origin: corners are int
const double WORK_SLACK = 2;      ///< the canvas may have this many times workMegapix before it is scaled down once more
const double WHOLE_CIRCLE = 0.95; ///< fraction of the period from which on the canvas may close

/// The photographs on the base warper's canvas.
struct Canvas
{
    std::vector<Point> corners;
    std::vector<Mat> images;
    std::vector<Mat> masks;
    std::vector<KnownKeypoints> keypoints;
    std::vector<KnownLines> lines;
    double period = 0;
};

/// What is wrong with a camera; empty for nothing. So with the other functions that return a reason.
std::string cameraFault(const Mat& K, const Mat& R, size_t index)
{
    if (K.total() == 9 && R.total() == 9 && checkRange(K) && checkRange(R) && std::abs(determinant(K)) > 0 &&
        std::abs(determinant(R)) > 0)
        return {};
    return format("K or R of camera %zu is not a finite, invertible 3 x 3 matrix", index);
}

std::string roiFault(Rect roi, Size image, size_t index)
{
    if (std::abs(static_cast<double>(roi.x)) > MAX_PLACE || std::abs(static_cast<double>(roi.y)) > MAX_PLACE)
        return format("camera %zu would put its picture at (%d, %d)", index, roi.x, roi.y);
    if (roi.width > 0 && roi.height > 0 && roi.width <= MAX_REMAP_SIDE && roi.height <= MAX_REMAP_SIDE &&
        static_cast<double>(roi.width) * roi.height <= MAX_GROWTH * image.area() + 1e4)
        return {};
    return format("camera %zu would make a picture of %d x %d px of an image of %d x %d px", index, roi.width, roi.height,
                  image.width, image.height);
}

/// Fills canvas, and the rig's sizes and turns. Lines are looked for at straightness_megapix, if that is not 0.
std::string warpAll(const std::vector<Mat>& images, const std::vector<KnownKeypoints>& keypoints, double straightness_megapix,
                    cv::detail::RotationWarper& warper, Rig& rig, Canvas& canvas)
{
    canvas.keypoints = keypoints;
    canvas.images.resize(images.size());
    canvas.masks.resize(images.size());
    bool straddles = false;
    double left = MAX_REMAP_SIDE;
    double right = -MAX_REMAP_SIDE;
    for (size_t i = 0; i < images.size(); ++i)
    {
        Mat K;
        Mat R;
        rig.cameras[i].K().convertTo(K, CV_32F);
        rig.cameras[i].R.convertTo(R, CV_32F);
        std::string fault = cameraFault(K, R, i);
        if (!fault.empty())
            return fault;
        const Matx33f rotation(R.ptr<float>());
        const Size size = images[i].size();
        const double period = periodOf(warper, size, K, rotation);
        canvas.period = i == 0 || period == canvas.period ? period : 0;
        const double seam_rotation_rad = rotateOffSeam(warper, size, K, rotation, period);
        const Mat off_seam(rotatedAboutAxis(rotation, -seam_rotation_rad));
        fault = roiFault(warper.warpRoi(size, K, off_seam), size, i);
        if (!fault.empty())
            return fault;
        Point corner = warper.warp(images[i], K, off_seam, INTER_LINEAR, BORDER_REFLECT, canvas.images[i]);
        warper.warp(Mat(size, CV_8UC1, Scalar(255)), K, off_seam, INTER_NEAREST, BORDER_CONSTANT, canvas.masks[i]);
        for (size_t k = 0; !keypoints.empty() && k < keypoints[i].points.size(); ++k)
        {
            // Points that the projection cannot map are put far outside, where they are ignored.
            const Point2f p = warper.warpPoint(keypoints[i].points[k], K, off_seam) - Point2f(corner);
            canvas.keypoints[i].points[k] = std::isfinite(p.x) && std::isfinite(p.y) ? p : Point2f(-MAX_REMAP_SIDE, -MAX_REMAP_SIDE);
        }
        if (straightness_megapix > 0)
            canvas.lines.push_back(warpedLines(images[i], warper, K, off_seam, corner, straightness_megapix));
        corner.x += cvRound(seam_rotation_rad * warper.getScale());
        canvas.corners.push_back(corner);
        rig.turns.push_back(seam_rotation_rad);
        rig.image_sizes.push_back(size);
        straddles = straddles || seam_rotation_rad != 0;
        left = std::min<double>(left, corner.x);
        right = std::max<double>(right, static_cast<double>(corner.x) + canvas.images[i].cols);
    }
    if (!straddles && right - left < WHOLE_CIRCLE * canvas.period)
        canvas.period = 0;
    return {};
}

/// Meshes that move too far are worse than none.
std::string meshFault(const Alignment& alignment)
{
    for (int i = 0; i < alignment.imageCount(); ++i)
    {
        const Alignment::Image& image = alignment.image(i);
        const double limit = MAX_MOVE * std::max(image.work_size.width, image.work_size.height);
        if (!checkRange(image.mesh) || !checkRange(image.color) || !(norm(image.mesh, image.rough, NORM_INF) <= limit))
            return format("the mesh of image %d moved farther than half its side, or is not finite", i);
    }
    return {};
}

Params tuned(const Params& params, const Canvas& canvas)
{
    Params result = params;
    double largest = 0;
    for (const Mat& image : canvas.images)
        largest = std::max(largest, 1e-6 * static_cast<double>(image.total()));
    // The warp has resampled the photographs already: a second time for little would only blur them.
    if (largest <= WORK_SLACK * params.workMegapix)
        result.workMegapix = std::max(params.workMegapix, 1.001 * largest);
    result.canvasPeriod = canvas.period;
    return result;
}

/// Fills the rig of cameras; returns why it has no meshes.
std::string alignInto(Rig& rig, const std::vector<Mat>& images, const Ptr<WarperCreator>& base, const Params& params,
                      const Progress& progress, const std::vector<KnownKeypoints>& keypoints)
{
    if (images.size() < 2)
        return "a single image has no other to be aligned with";
    if (!(rig.scale > 0) || !std::isfinite(rig.scale))
        return "the cameras have no focal length";
    const Ptr<cv::detail::RotationWarper> warper = trueWarper(base->create(rig.scale));
    Canvas canvas;
    std::string fault = warpAll(images, keypoints, params.straightnessWeight > 0 ? params.workMegapix : 0, *warper, rig, canvas);
    if (!fault.empty())
        return fault;
    rig.alignment = Aligner::create(tuned(params, canvas))->align(canvas.corners, canvas.images, canvas.masks,
                                                                  std::vector<Correspondences>(), progress, canvas.keypoints,
                                                                  canvas.lines);
    fault = meshFault(rig.alignment);
    if (fault.empty())
        rig.check();
    return fault;
}

} // namespace

Rig rigWithoutAnswer(const std::vector<cv::detail::CameraParams>& cameras, const std::string& reason)
{
    Report report;
    report.status = Status::ROUGH;
    report.message = reason + "; the plain warper was used";
    Rig rig;
    rig.cameras = cameras;
    rig.alignment = Alignment(std::vector<Alignment::Image>(), Size2d(1, 1), report);
    return rig;
}

void logReason(const Rig& rig)
{
    CV_LOG_WARNING(nullptr, "gcpw: " << rig.alignment.report().message);
}

RigEstimate estimateRig(const std::vector<Mat>& images, const std::vector<cv::detail::CameraParams>& cameras,
                        const Ptr<WarperCreator>& base, const Params& params, const Progress& progress,
                        const std::vector<KnownKeypoints>& keypoints)
{
    // What the caller's callback throws goes to the caller: it is no failure of the estimation.
    bool callback_threw = false;
    Progress watched;
    if (progress)
        watched = [&](const std::string& stage, double fraction)
        {
            callback_threw = true;
            const bool go_on = progress(stage, fraction);
            callback_threw = false;
            return go_on;
        };
    RigEstimate estimate;
    Rig& rig = estimate.rig;
    std::string reason;
    try
    {
        rig.cameras = cameras;
        rig.scale = medianFocal(cameras);
        reason = alignInto(rig, images, base, params, watched, keypoints);
    }
    catch (const cv::Exception& e)
    {
        if (callback_threw)
            throw;
        estimate.lasting = e.code != Error::StsNoMem;
        reason = !estimate.lasting ? "not enough memory" : e.err.empty() ? std::string(e.what()) : e.err;
    }
    catch (const std::bad_alloc&)
    {
        if (callback_threw)
            throw;
        estimate.lasting = false;
        reason = "not enough memory";
    }
    catch (const std::exception& e)
    {
        if (callback_threw)
            throw;
        reason = e.what();
    }
    if (!reason.empty())
        rig.alignment = rigWithoutAnswer(cameras, reason).alignment;
    else
        estimate.lasting = rig.alignment.report().status != Status::CANCELLED;
    if (!rig.alignment.ok())
        logReason(rig);
    return estimate;
}

Rig alignRig(InputArrayOfArrays images, const std::vector<cv::detail::CameraParams>& cameras,
             const Ptr<WarperCreator>& base, const Params& params, const Progress& progress,
             const std::vector<KnownKeypoints>& keypoints)
{
    if (!base)
        CV_Error(Error::StsNullPtr, "gcpw: alignRig() needs a base warper");
    params.check();
    std::vector<Mat> mats;
    images.getMatVector(mats);
    CV_CheckEQ(mats.size(), cameras.size(), "gcpw: alignRig() takes one image for each camera");
    CV_CheckGE(mats.size(), size_t(2), "gcpw: alignRig() takes two images or more");
    if (!keypoints.empty())
        CV_CheckEQ(mats.size(), keypoints.size(), "gcpw: alignRig() takes keypoints for each image, or none");
    return estimateRig(mats, cameras, base, params, progress, keypoints).rig;
}

Rig alignRigByName(InputArrayOfArrays images, const std::vector<cv::detail::CameraParams>& cameras, const String& warper,
                   const Params& params, const Progress& progress)
{
    Rig rig = alignRig(images, cameras, warperOfName(warper), params, progress);
    rig.projection = warper;
    return rig;
}

} // namespace gcpw
} // namespace cv
