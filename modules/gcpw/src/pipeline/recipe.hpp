// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_RECIPE_HPP
#define OPENCV_GCPW_RECIPE_HPP

#include "opencv2/gcpw/params.hpp"

namespace cv
{
namespace gcpw
{

/// Which terms a method is made of.
struct Recipe
{
    bool points = false;
    bool lines = false;
    bool pixels = false;
    bool colors = false;

    bool movesMesh() const { return points; }
};

Recipe recipeOf(Method method);

} // namespace gcpw
} // namespace cv

#endif
