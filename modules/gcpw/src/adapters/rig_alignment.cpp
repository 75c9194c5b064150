// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include <algorithm>
#include <cmath>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include "adapters/affine_warper.hpp"
#include "adapters/seam_turn.hpp"
#include "opencv2/gcpw/aligner.hpp"
#include "opencv2/gcpw/rig.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const int MAX_SIDE = 32766;       ///< px: cv::remap takes no more
const double MAX_GROWTH = 16;     ///< of an image's area by the base warper: beyond it the camera is wrong
const double MAX_MOVE = 0.5;      ///< of the larger side of an image: a mesh that moves farther is no refinement
const double WORK_SLACK = 2;      ///< the canvas may have this many times workMegapix before it is scaled down once more
const double WHOLE_CIRCLE = 0.95; ///< share of the period from which on the canvas may close

/// The reason why a rig has no answer; becomes its report's message.
struct NoAnswer
{
    std::string reason;
};

float medianFocal(const std::vector<cv::detail::CameraParams>& cameras)
{
    std::vector<double> focals;
    for (const cv::detail::CameraParams& camera : cameras)
        focals.push_back(camera.focal);
    std::sort(focals.begin(), focals.end());
    const size_t half = focals.size() / 2;
    // As cv::Stitcher has it, rounding included.
    return focals.size() % 2 == 1 ? static_cast<float>(focals[half])
                                  : static_cast<float>(focals[half - 1] + focals[half]) * 0.5F;
}

/// The photographs on the base warper's canvas.
struct Canvas
{
    std::vector<Point> corners;
    std::vector<Mat> images;
    std::vector<Mat> masks;
    std::vector<KnownKeypoints> keypoints;
    double period = 0;
};

void checkCamera(const Mat& K, const Mat& R, size_t index)
{
    if (K.total() != 9 || R.total() != 9 || !checkRange(K) || !checkRange(R) || !(std::abs(determinant(K)) > 0) ||
        !(std::abs(determinant(R)) > 0))
        throw NoAnswer{format("camera %zu is not a camera", index)};
}

void checkRoi(Rect roi, Size image, size_t index)
{
    if (roi.width <= 0 || roi.height <= 0 || roi.width > MAX_SIDE || roi.height > MAX_SIDE ||
        static_cast<double>(roi.width) * roi.height > MAX_GROWTH * image.area() + 1e4)
        throw NoAnswer{format("camera %zu would make a picture of %d x %d px of an image of %d x %d px", index, roi.width,
                              roi.height, image.width, image.height)};
}

Canvas warpAll(const std::vector<Mat>& images, const std::vector<KnownKeypoints>& keypoints, cv::detail::RotationWarper& warper,
               Rig& rig)
{
    Canvas canvas;
    canvas.keypoints = keypoints;
    canvas.images.resize(images.size());
    canvas.masks.resize(images.size());
    bool straddles = false;
    int left = MAX_SIDE;
    int right = -MAX_SIDE;
    for (size_t i = 0; i < images.size(); ++i)
    {
        Mat K;
        Mat R;
        rig.cameras[i].K().convertTo(K, CV_32F);
        rig.cameras[i].R.convertTo(R, CV_32F);
        checkCamera(K, R, i);
        const Matx33f rotation(R.ptr<float>());
        const Size size = images[i].size();
        const double period = periodOf(warper, size, K, rotation);
        canvas.period = i == 0 || period == canvas.period ? period : 0;
        const double turn = turnOffSeam(warper, size, K, rotation, period);
        const Mat off_seam(turned(rotation, -turn));
        checkRoi(warper.warpRoi(size, K, off_seam), size, i);
        Point corner = warper.warp(images[i], K, off_seam, INTER_LINEAR, BORDER_REFLECT, canvas.images[i]);
        warper.warp(Mat(size, CV_8UC1, Scalar(255)), K, off_seam, INTER_NEAREST, BORDER_CONSTANT, canvas.masks[i]);
        for (size_t k = 0; !keypoints.empty() && k < keypoints[i].points.size(); ++k)
        {
            // What the projection has no place for goes far outside, where it is left out.
            const Point2f p = warper.warpPoint(keypoints[i].points[k], K, off_seam) - Point2f(corner);
            canvas.keypoints[i].points[k] = std::isfinite(p.x) && std::isfinite(p.y) ? p : Point2f(-MAX_SIDE, -MAX_SIDE);
        }
        corner.x += cvRound(turn * warper.getScale());
        canvas.corners.push_back(corner);
        rig.turns.push_back(turn);
        rig.image_sizes.push_back(size);
        straddles = straddles || turn != 0;
        left = std::min(left, corner.x);
        right = std::max(right, corner.x + canvas.images[i].cols);
    }
    if (!straddles && right - left < WHOLE_CIRCLE * canvas.period)
        canvas.period = 0;
    return canvas;
}

/// Meshes that run away are worse than none.
void checkMeshes(const Alignment& alignment)
{
    for (int i = 0; i < alignment.imageCount(); ++i)
    {
        const Alignment::Image& image = alignment.image(i);
        const double limit = MAX_MOVE * std::max(image.work_size.width, image.work_size.height);
        if (!checkRange(image.mesh) || !checkRange(image.color) || !(norm(image.mesh, image.rough, NORM_INF) <= limit))
            throw NoAnswer{format("the mesh of image %d ran away", i)};
    }
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

Alignment failed(Status status, const std::string& message)
{
    Report report;
    report.status = status;
    report.message = message;
    return {std::vector<Alignment::Image>(), Size2d(1, 1), report};
}

} // namespace

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

    Rig rig;
    rig.cameras = cameras;
    rig.scale = medianFocal(cameras);
    try
    {
        if (!(rig.scale > 0) || !std::isfinite(rig.scale))
            throw NoAnswer{"the cameras have no focal length"};
        const Ptr<cv::detail::RotationWarper> warper = trueWarper(base->create(rig.scale));
        const Canvas canvas = warpAll(mats, keypoints, *warper, rig);
        const Params used = tuned(params, canvas);
        rig.alignment = Aligner::create(used)->align(canvas.corners, canvas.images, canvas.masks,
                                                     std::vector<Correspondences>(), progress, canvas.keypoints);
        checkMeshes(rig.alignment);
        rig.check();
    }
    catch (const NoAnswer& e)
    {
        rig.alignment = failed(Status::ROUGH, e.reason + "; the plain warper was used");
    }
    catch (const cv::Exception& e)
    {
        rig.alignment = failed(Status::ROUGH, (e.err.empty() ? std::string(e.what()) : e.err) + "; the plain warper was used");
    }
    catch (const std::bad_alloc&)
    {
        rig.alignment = failed(Status::ROUGH, "not enough memory; the plain warper was used");
    }
    if (!rig.alignment.ok())
        CV_LOG_WARNING(nullptr, "gcpw: " << rig.alignment.report().message);
    return rig;
}

} // namespace gcpw
} // namespace cv
