// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "cameras/projection_choice.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const char* const PLANE = "plane";
const char* const SPHERE = "spherical";
const char* const STEREOGRAPHIC = "stereographic";

const double PLANE_STRETCH = 1.9; ///< a view of about 80 degrees, as a lens of 24 mm shows it
const double SPHERE_STRETCH =
    4; ///< up to 75 degrees from the horizon: nearer to a pole pictures are smeared; before, walls stay upright

/// A quarter turn of the picture: what lies on its side in a column's frame stands again.
const Matx33d STANDING(0, -1, 0, 1, 0, 0, 0, 0, 1);

struct Trial
{
    const char* projection;
    Matx33d world;
    bool turned;
    double limit; ///< of the stretch
};

std::vector<Matx33d> rotationsOf(const std::vector<cv::detail::CameraParams>& cameras)
{
    std::vector<Matx33d> rotations;
    for (const cv::detail::CameraParams& camera : cameras)
    {
        Matx33d R;
        camera.R.convertTo(Mat(3, 3, CV_64F, R.val), CV_64F);
        rotations.push_back(R);
    }
    return rotations;
}

} // namespace

std::vector<cv::detail::CameraParams> inWorld(const Matx33d& world,
                                              const std::vector<cv::detail::CameraParams>& cameras)
{
    std::vector<cv::detail::CameraParams> moved = cameras;
    const std::vector<Matx33d> rotations = rotationsOf(cameras);
    for (size_t i = 0; i < cameras.size(); ++i)
        moved[i].R = Mat(Matx33f(world * rotations[i]));
    return moved;
}

ProjectionChoice chooseProjection(const std::vector<cv::detail::CameraParams>& cameras, const std::vector<Size>& sizes,
                                  const WarperMaker& make, const std::string& forced)
{
    const std::vector<Matx33d> rotations = rotationsOf(cameras);
    const SetShape set_shape = shapeOf(rotations);
    const bool column = set_shape == SetShape::COLUMN;
    const Matx33d straight = straightening(rotations, set_shape);
    const Matx33d centre = centring(rotations);
    std::vector<Trial> trials;
    if (forced.empty())
        trials = {{PLANE, column ? STANDING * straight : straight, false, PLANE_STRETCH},
                  {SPHERE, straight, column, SPHERE_STRETCH},
                  {SPHERE, centre, false, SPHERE_STRETCH},
                  {STEREOGRAPHIC, centre, false, SPHERE_STRETCH}};
    else
        trials = {{forced.c_str(), forced == PLANE && column ? STANDING * straight : straight,
                   forced != PLANE && column, SPHERE_STRETCH},
                  {forced.c_str(), centre, false, SPHERE_STRETCH}};
    const float scale = medianFocal(cameras);
    ProjectionChoice best;
    for (const Trial& trial : trials)
    {
        ProjectionChoice choice;
        choice.name = trial.projection;
        choice.world = trial.world;
        choice.turned = trial.turned;
        choice.straight = norm(trial.world - centre) > 1e-9 || set_shape == SetShape::SPOT;
        choice.set_shape = set_shape;
        // Projections without a seam have no two neighbours that far apart.
        choice.picture = shapeOfPicture(inWorld(trial.world, cameras), sizes, *make(trial.projection, scale),
                                        choice.name == PLANE ? 0 : 2 * CV_PI * scale);
        const bool sound = choice.picture.fault.empty();
        if (sound && choice.picture.stretch <= trial.limit)
            return choice;
        const bool better = sound && (!best.picture.fault.empty() || choice.picture.stretch < best.picture.stretch);
        if (best.name.empty() || better)
            best = choice;
    }
    return best;
}

} // namespace gcpw
} // namespace cv
