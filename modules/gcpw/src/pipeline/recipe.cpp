// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/recipe.hpp"

namespace cv
{
namespace gcpw
{

Recipe recipeOf(Method method)
{
    const int rank = static_cast<int>(method);
    Recipe recipe;
    recipe.points = rank >= static_cast<int>(Method::CPW);
    recipe.lines = rank >= static_cast<int>(Method::DFW);
    recipe.pixels = rank >= static_cast<int>(Method::MFW);
    recipe.colors = rank >= static_cast<int>(Method::GCPW);
    return recipe;
}

} // namespace gcpw
} // namespace cv
