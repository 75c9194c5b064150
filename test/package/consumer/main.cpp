// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
//
// A user's program: GCPW in a cv::Stitcher. Arguments: two photographs and the panorama.
#include <opencv2/gcpw.hpp>
#include <opencv2/imgcodecs.hpp>

int main(int argc, char** argv)
{
    if (argc != 4)
        return 2;
    const std::vector<cv::Mat> images = {cv::imread(argv[1]), cv::imread(argv[2])};
    cv::Mat panorama;
    const cv::Ptr<cv::Stitcher> stitcher = cv::Stitcher::create(cv::Stitcher::PANORAMA);
    stitcher->setFeaturesFinder(cv::SIFT::create(4000, 3, 0.007));
    cv::gcpw::attach(stitcher);
    if (stitcher->stitch(images, panorama) != cv::Stitcher::OK && !cv::gcpw::stitchPair(images[0], images[1], panorama))
        return 1;
    return cv::imwrite(argv[3], panorama) ? 0 : 3;
}
