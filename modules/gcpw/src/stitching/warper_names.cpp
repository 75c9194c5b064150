// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitching/warper_names.hpp"

#include <string>

namespace cv
{
namespace gcpw
{

namespace
{

typedef Ptr<WarperCreator> (*Maker)();

template <typename Warper>
Ptr<WarperCreator> plain()
{
    return makePtr<Warper>();
}

/// Warpers with two ratios, A and B; A in tenths. B is 1.
template <typename Warper, int TENTHS>
Ptr<WarperCreator> stretched()
{
    return makePtr<Warper>(TENTHS / 10.F, 1.F);
}

struct NamedWarper
{
    const char* name;
    Maker make;
};

const NamedWarper WARPERS[] = {
    {"plane", plain<PlaneWarper>},
    {"affine", plain<AffineWarper>},
    {"cylindrical", plain<CylindricalWarper>},
    {"spherical", plain<SphericalWarper>},
    {"fisheye", plain<FisheyeWarper>},
    {"stereographic", plain<StereographicWarper>},
    {"compressedPlaneA2B1", stretched<CompressedRectilinearWarper, 20>},
    {"compressedPlaneA1.5B1", stretched<CompressedRectilinearWarper, 15>},
    {"compressedPlanePortraitA2B1", stretched<CompressedRectilinearPortraitWarper, 20>},
    {"compressedPlanePortraitA1.5B1", stretched<CompressedRectilinearPortraitWarper, 15>},
    {"paniniA2B1", stretched<PaniniWarper, 20>},
    {"paniniA1.5B1", stretched<PaniniWarper, 15>},
    {"paniniPortraitA2B1", stretched<PaniniPortraitWarper, 20>},
    {"paniniPortraitA1.5B1", stretched<PaniniPortraitWarper, 15>},
    {"mercator", plain<MercatorWarper>},
    {"transverseMercator", plain<TransverseMercatorWarper>},
};

} // namespace

Ptr<WarperCreator> warperOfName(const String& name)
{
    std::string known;
    for (const NamedWarper& warper : WARPERS)
    {
        if (name == warper.name)
            return warper.make();
        known += known.empty() ? warper.name : std::string(", ") + warper.name;
    }
    CV_Error(Error::StsBadArg, "gcpw: there is no warper \"" + name + "\"; there are " + known);
}

} // namespace gcpw
} // namespace cv
