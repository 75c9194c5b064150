// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "rendering/feather.hpp"

#include <opencv2/imgproc.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const int NOBODY = 65535; ///< label of pixels that no picture has

/// Which picture each pixel of the canvas goes to, CV_16UC1.
Mat labels(const std::vector<CutPicture>& pictures, Rect canvas)
{
    Mat label(canvas.size(), CV_16UC1, Scalar(NOBODY));
    Mat most(canvas.size(), CV_8UC1, Scalar(0));
    for (size_t k = 0; k < pictures.size(); ++k)
    {
        const CutPicture& picture = pictures[k];
        const Rect rect = Rect(picture.corner, picture.valid.size()) - canvas.tl();
        Mat kept;
        resize(picture.kept, kept, picture.valid.size(), 0, 0, INTER_LINEAR);
        Mat best = most(rect);
        Mat owner = label(rect);
        // Also pixels of which no cut leaves anything to anybody, so that no gap is left.
        const Mat taken = (picture.valid != 0) & ((kept > best) | (owner == NOBODY));
        owner.setTo(Scalar(static_cast<double>(k)), taken);
        kept.copyTo(best, taken);
    }
    return label;
}

} // namespace

std::vector<Mat> featherWeights(const std::vector<CutPicture>& pictures, Rect canvas, int radius)
{
    CV_CheckLT(pictures.size(), static_cast<size_t>(NOBODY), "gcpw: that many pictures have no weights");
    const Mat label = labels(pictures, canvas);
    const Size window(2 * radius + 1, 2 * radius + 1);
    std::vector<Mat> weights;
    Mat sum(canvas.size(), CV_16UC1, Scalar(0));
    for (size_t k = 0; k < pictures.size(); ++k)
    {
        const Mat& valid = pictures[k].valid;
        const Rect rect = Rect(pictures[k].corner, valid.size()) - canvas.tl();
        Mat soft = label == static_cast<double>(k); // of the whole canvas: the border of the picture is no cut
        for (int pass = 0; pass < 2; ++pass)
            blur(soft, soft, window, Point(-1, -1), BORDER_REPLICATE);
        Mat weight = Mat(soft(rect)).clone();
        weight.setTo(0, valid == 0);
        // The owner's own is never lost in the rounding.
        weight.setTo(1, (weight == 0) & (label(rect) == static_cast<double>(k)));
        Mat wide;
        weight.convertTo(wide, CV_16U);
        sum(rect) += wide;
        weights.push_back(weight);
    }
    // What is left of 255 is shared out in turn, so that nothing is lost in the rounding.
    Mat left(canvas.size(), CV_16UC1, Scalar(255));
    for (size_t k = 0; k < pictures.size(); ++k)
    {
        Mat& weight = weights[k];
        const Point corner = pictures[k].corner - canvas.tl();
        parallel_for_(Range(0, weight.rows),
                      [&](const Range& rows)
                      {
            for (int y = rows.start; y < rows.end; ++y)
            {
                uchar* own = weight.ptr<uchar>(y);
                ushort* of_all = sum.ptr<ushort>(y + corner.y) + corner.x;
                ushort* rest = left.ptr<ushort>(y + corner.y) + corner.x;
                for (int x = 0; x < weight.cols; ++x)
                {
                    if (own[x] == 0)
                        continue;
                    const int share = (2 * rest[x] * own[x] + of_all[x]) / (2 * of_all[x]);
                    of_all[x] = static_cast<ushort>(of_all[x] - own[x]);
                    rest[x] = static_cast<ushort>(rest[x] - share);
                    own[x] = static_cast<uchar>(share);
                }
            }
        });
    }
    return weights;
}

} // namespace gcpw
} // namespace cv
