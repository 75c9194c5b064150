// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "imaging/photograph.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace cv
{
namespace gcpw
{

Photograph toPhotograph(InputArray input, const char* name)
{
    Mat image = input.getMat();
    const std::string what = std::string("gcpw: the ") + name + " image ";
    if (image.empty() || image.dims > 2)
        CV_Error(Error::StsBadArg, what + "is empty; pass a two-dimensional image");
    if (image.depth() == CV_16U)
    {
        Mat bytes;
        image.convertTo(bytes, CV_8U, 1.0 / 257.0);
        image = bytes;
    }
    const int channels = image.channels();
    if (image.depth() != CV_8U || (channels != 1 && channels != 3 && channels != 4))
        CV_Error(Error::StsUnsupportedFormat, what + "has type " + typeToString(image.type()) +
                                                  "; pass 8- or 16-bit gray, BGR or BGRA");
    Photograph photograph;
    if (channels == 1)
        cvtColor(image, photograph.image, COLOR_GRAY2BGR);
    else if (channels == 3)
        photograph.image = image;
    else
    {
        Mat alpha;
        extractChannel(image, alpha, 3);
        cvtColor(image, photograph.image, COLOR_BGRA2BGR);
        const Mat valid = alpha > 127;
        if (countNonZero(valid) < static_cast<int>(valid.total()))
        {
            photograph.mask = valid;
            // Filters look over the border of the mask: what is hidden there must not show through.
            photograph.image.setTo(Scalar::all(128), valid == 0);
        }
    }
    return photograph;
}

Size cappedSize(Size full, double megapix)
{
    const double scale = std::min(1.0, std::sqrt(megapix * 1e6 / full.area()));
    return {std::max(cvRound(full.width * scale), 1), std::max(cvRound(full.height * scale), 1)};
}

Photograph resized(const Photograph& photograph, Size size)
{
    if (photograph.image.size() == size)
        return photograph;
    const bool shrinks = size.area() < photograph.image.size().area();
    Photograph result;
    resize(photograph.image, result.image, size, 0, 0, shrinks ? INTER_AREA : INTER_LINEAR);
    if (!photograph.mask.empty())
    {
        resize(photograph.mask, result.mask, size, 0, 0, INTER_AREA);
        result.mask = result.mask > 254;
    }
    return result;
}

} // namespace gcpw
} // namespace cv
