// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
//
// What a piece of code in a document may use without saying where it comes from.
#include <iostream>
#include <opencv2/gcpw.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/stitching.hpp>

extern const cv::Mat source, target;                     // two photographs
extern const cv::Mat photo, K;                           // one photograph and its camera's K
extern std::vector<cv::Mat> photographs, images;         // more of them
extern std::vector<cv::detail::CameraParams> cameras;    // of images
extern std::vector<cv::Point> corners;                   // of warped
extern std::vector<cv::UMat> warped, masks;              // images as a warper left them
extern cv::Ptr<cv::Stitcher> stitcher;
extern const cv::gcpw::Rig rig;
extern cv::Mat panorama, picture;
extern float scale;
void show(const cv::gcpw::Alignment& alignment);
void show(const cv::Mat& picture);
bool nextFrames(std::vector<cv::Mat>& frames);
