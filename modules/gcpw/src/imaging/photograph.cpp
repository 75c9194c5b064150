// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "imaging/photograph.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
// DIST_L2 of distanceTransform(), part of imgproc before OpenCV 5.
#if CV_VERSION_MAJOR >= 5
#include <opencv2/geometry.hpp>
#endif

namespace cv
{
namespace gcpw
{

namespace
{

void copyPixel(Mat& image, Point from, Point to)
{
    if (image.depth() == CV_16U)
        image.at<Vec3w>(to) = image.at<Vec3w>(from);
    else
        image.at<Vec3b>(to) = image.at<Vec3b>(from);
}

} // namespace

void checkPhotograph(const Mat& image, const char* name)
{
    const std::string what = std::string("gcpw: the ") + name + " image ";
    if (image.empty() || image.dims > 2)
        CV_Error(Error::StsBadArg, what + "is empty; pass a two-dimensional image");
    const int channels = image.channels();
    if ((image.depth() != CV_8U && image.depth() != CV_16U) || (channels != 1 && channels != 3 && channels != 4))
        CV_Error(Error::StsUnsupportedFormat,
                 what + "has type " + typeToString(image.type()) + "; pass 8- or 16-bit gray, BGR or BGRA");
}

Mat toDepth(const Mat& picture, int depth)
{
    CV_DbgAssert(depth == CV_8U || depth == CV_16U);
    if (picture.depth() == depth)
        return picture;
    Mat result;
    picture.convertTo(result, depth, depth == CV_16U ? 257.0 : 1 / 257.0);
    return result;
}

Photograph toPhotograph(InputArray input, const char* name, int depth)
{
    checkPhotograph(input.getMat(), name);
    const Mat image = toDepth(input.getMat(), depth);
    const int channels = image.channels();
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
        hideOutside(photograph, alpha > (depth == CV_16U ? 32767 : 127));
    }
    return photograph;
}

void hideOutside(Photograph& photograph, const Mat& valid)
{
    CV_Assert(valid.type() == CV_8UC1 && valid.size() == photograph.image.size());
    const Mat hidden = photograph.mask.empty() ? Mat(valid == 0) : Mat((valid & photograph.mask) == 0);
    if (countNonZero(hidden) == 0)
        return;
    photograph.mask = hidden == 0;
    Mat image = photograph.image.clone();
    photograph.image = image;
    if (countNonZero(photograph.mask) == 0)
    {
        image.setTo(Scalar::all(0));
        return;
    }
    // Every pixel is labelled with its nearest valid one; labels are found again at the valid pixels themselves.
    Mat distance;
    Mat labels;
    distanceTransform(hidden, distance, labels, DIST_L2, 5, DIST_LABEL_PIXEL);
    std::vector<Point> home(photograph.image.total() + 1);
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
            if (!hidden.at<uchar>(y, x))
                home[labels.at<int>(y, x)] = Point(x, y);
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
            if (hidden.at<uchar>(y, x))
                copyPixel(image, home[labels.at<int>(y, x)], Point(x, y));
}

Size cappedSize(Size full, double megapix)
{
    const double scale = std::min(1.0, std::sqrt(megapix * 1e6 / (static_cast<double>(full.width) * full.height)));
    return {std::max(cvRound(full.width * scale), 1), std::max(cvRound(full.height * scale), 1)};
}

Photograph resized(const Photograph& photograph, const FrameScale& scale)
{
    CV_DbgAssert(scale.x > 0 && scale.x <= 1 && scale.y > 0 && scale.y <= 1);
    if (scale.x == 1 && scale.y == 1)
        return photograph;
    Photograph result;
    resize(photograph.image, result.image, Size(), scale.x, scale.y, INTER_AREA);
    if (!photograph.mask.empty())
    {
        resize(photograph.mask, result.mask, Size(), scale.x, scale.y, INTER_AREA);
        result.mask = result.mask > 254;
    }
    return result;
}

} // namespace gcpw
} // namespace cv
