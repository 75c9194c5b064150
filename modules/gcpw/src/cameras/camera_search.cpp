// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "cameras/camera_search.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

const char* const AFFINE = "affine";
const char* const SPHERE = "spherical";
const double ACCURATE =
    0.004; ///< of an image's longer side: as near as cameras held by hand come; no other model is tried then
const double NEARER = 0.75; ///< a later model must be that much nearer: then it is the truer one
const double MAX_MISS =
    0.1; ///< beyond it links contradict each other, and no mesh brings together what belongs together
const double STRICTER[] = {1, 1.5, 2, 3}; ///< times the confidence asked for, where no model is sound

/// One model, fitted and judged.
struct Attempt
{
    CameraModel model = CameraModel::TURNING;
    std::vector<cv::detail::CameraParams> cameras;
    ProjectionChoice projection;
    Misses misses;
    std::string fault; ///< why it is not sound
};

std::string nameOf(CameraModel model)
{
    switch (model)
    {
    case CameraModel::TURNING:
        return "cameras that turn, each with a focal length of its own";
    case CameraModel::TURNING_NOTED:
        return "cameras that turn, from the focal lengths that the files note";
    case CameraModel::TURNING_ONE_FOCAL:
        return "cameras that turn, with one focal length";
    case CameraModel::FLAT:
        return "photographs of a plane";
    }
    return {};
}

std::vector<Size> sizesOf(const LinkedImages& images)
{
    std::vector<Size> sizes;
    for (const cv::detail::ImageFeatures& features : images.features)
        sizes.push_back(features.img_size);
    return sizes;
}

Misses missesOver(const std::vector<cv::detail::CameraParams>& cameras, const std::vector<Link>& links,
                  const std::vector<Size>& sizes, cv::detail::RotationWarper& warper, double period)
{
    std::vector<double> misses = missesOf(cameras, links, warper, period);
    if (misses.empty())
        return {};
    std::sort(misses.begin(), misses.end());
    const double side = std::max(sizes[0].width, sizes[0].height);
    return {misses[(misses.size() - 1) / 2] / side, misses[(misses.size() - 1) * 9 / 10] / side};
}

Attempt attempt(const LinkedImages& images, double confidence, CameraModel model, const WarperMaker& make,
                const std::string& forced)
{
    Attempt result;
    result.model = model;
    if (!fitCameras(images, confidence, model, result.cameras))
    {
        result.fault = "they do not fit the matches";
        return result;
    }
    const std::vector<Size> sizes = sizesOf(images);
    const std::vector<Link> links = linksOf(images, confidence);
    const float scale = medianFocal(result.cameras);
    if (model == CameraModel::FLAT)
    {
        const Ptr<cv::detail::RotationWarper> warper = make(AFFINE, scale);
        result.projection.name = AFFINE;
        result.projection.picture = shapeOfPicture(result.cameras, sizes, *warper, 0);
        result.misses = missesOver(result.cameras, links, sizes, *warper, 0);
    }
    else
    {
        result.projection = chooseProjection(result.cameras, sizes, make, forced);
        result.cameras = inWorld(result.projection.world, result.cameras);
        // On the sphere distances are as in the photographs, whatever the projection that is shown.
        result.misses = missesOver(result.cameras, links, sizes, *make(SPHERE, scale), 2 * CV_PI * scale);
    }
    result.fault = result.projection.picture.fault;
    if (result.fault.empty() && !(result.misses.most <= MAX_MISS))
        result.fault = format("matched points lie %.0f %% of an image's side apart", 100 * result.misses.most);
    return result;
}

std::string projectionText(const ProjectionChoice& choice)
{
    const PictureShape& picture = choice.picture;
    std::string text = "the projection is " + choice.name;
    if (choice.name != AFFINE)
    {
        if (!choice.straight)
            text += ", about the middle of the view";
        else if (choice.set_shape == SetShape::COLUMN)
            text += choice.turned ? ", along the column of the photographs"
                                  : ", upright along the column of the photographs";
        else if (choice.set_shape == SetShape::STRIP)
            text += ", straightened along the strip of the photographs";
    }
    return text + format(": no photograph is enlarged more than %.2f times, and the picture has %.2f of their area",
                         picture.stretch, picture.area);
}

/// The attempt to take: see searchCameras(). -1 if none is sound.
int bestOf(const std::vector<Attempt>& attempts)
{
    int best = -1;
    for (int i = 0; i < static_cast<int>(attempts.size()); ++i)
    {
        if (!attempts[i].fault.empty())
            continue;
        if (best < 0 || isTruer(attempts[i].misses, attempts[best].misses))
            best = i;
    }
    return best;
}

void take(const Attempt& attempt, CameraChoice& choice)
{
    choice.cameras = attempt.cameras;
    choice.model = attempt.model;
    choice.projection = attempt.projection.name;
    choice.turned = attempt.projection.turned;
    choice.decisions.push_back(nameOf(attempt.model) +
                               format(" show matched points within %.2f %% of an image's side", 100 * attempt.misses.most));
    choice.decisions.push_back(projectionText(attempt.projection));
}

} // namespace

bool isTruer(const Misses& later, const Misses& earlier)
{
    return later.most < NEARER * earlier.most && later.half <= earlier.half;
}

CameraChoice searchCameras(const LinkedImages& images, double confidence, const WarperMaker& make,
                           const std::string& forced)
{
    CameraChoice choice;
    for (const double stricter : STRICTER)
    {
        choice.component = largestGroup(groupsOf(images, stricter * confidence));
        if (choice.component.size() < 2)
            break;
        const LinkedImages part = subset(images, choice.component);
        std::vector<Attempt> attempts;
        for (const CameraModel model :
             {CameraModel::TURNING, CameraModel::TURNING_NOTED, CameraModel::TURNING_ONE_FOCAL, CameraModel::FLAT})
        {
            if (model == CameraModel::TURNING_NOTED && !notesFocal(part))
                continue;
            if (forced.empty() || (forced == AFFINE) == (model == CameraModel::FLAT))
            {
                attempts.push_back(attempt(part, stricter * confidence, model, make, forced));
                // What files note shortens no search: the matches may fit another model better still.
                if (model != CameraModel::TURNING_NOTED && attempts.back().fault.empty() &&
                    attempts.back().misses.most <= ACCURATE)
                    break;
            }
        }
        const int best = bestOf(attempts);
        for (int i = 0; i < static_cast<int>(attempts.size()); ++i)
            if (!attempts[i].fault.empty())
                choice.decisions.push_back(nameOf(attempts[i].model) + " were not taken: " + attempts[i].fault);
            else if (i != best)
                choice.decisions.push_back(
                    nameOf(attempts[i].model) +
                    format(" were not taken: matched points lie %.2f %% of an image's side apart, %.2f %% in half of the links",
                           100 * attempts[i].misses.most, 100 * attempts[i].misses.half));
        if (best >= 0)
        {
            take(attempts[best], choice);
            return choice;
        }
        choice.decisions.push_back(
            format("no cameras of %zu photographs make a picture of sound proportions", choice.component.size()));
    }
    if (choice.decisions.empty())
        choice.decisions.push_back("no two of the photographs match");
    choice.component.clear();
    return choice;
}

} // namespace gcpw
} // namespace cv
