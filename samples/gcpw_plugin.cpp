// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
//
// An ordinary cv::Stitcher program, with the one line that puts GCPW into it.
#include <iostream>
#include <opencv2/gcpw/stitcher.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/stitching.hpp>

int main(int argc, char** argv)
{
    std::vector<cv::Mat> images;
    for (int i = 1; i + 1 < argc; ++i)
        images.push_back(cv::imread(argv[i]));
    if (images.size() < 2)
    {
        std::cerr << "gcpw_plugin IMAGE IMAGE.. PANORAMA\n";
        return 2;
    }
    for (size_t i = 0; i < images.size(); ++i)
        if (images[i].empty())
        {
            std::cerr << "gcpw_plugin: cannot read " << argv[i + 1] << '\n';
            return 2;
        }

    cv::Ptr<cv::Stitcher> stitcher = cv::Stitcher::create(cv::Stitcher::PANORAMA);
    const cv::Ptr<cv::gcpw::StitcherBinding> gcpw = cv::gcpw::attach(stitcher); // this line

    cv::Mat panorama;
    const cv::Stitcher::Status status = stitcher->stitch(images, panorama);
    if (status != cv::Stitcher::OK)
    {
        std::cerr << "gcpw_plugin: the images could not be stitched, status " << status << '\n';
        return 1;
    }
    if (!gcpw->rig().alignment.ok())
        std::cout << gcpw->rig().alignment.report().message << '\n';
    if (!cv::imwrite(argv[argc - 1], panorama))
    {
        std::cerr << "gcpw_plugin: cannot write " << argv[argc - 1] << '\n';
        return 2;
    }
    return 0;
}
