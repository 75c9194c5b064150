// This file is part of OpenCV project, under the license terms in its LICENSE file.
//
// An ordinary cv::Stitcher program, with the one line that puts GCPW into it.
#include <iostream>
#include <opencv2/gcpw/stitcher.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/stitching.hpp>

namespace
{

int fail(const std::string& why, int code)
{
    std::cerr << why << '\n';
    return code;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 4)
        return fail("plugin IMAGE IMAGE.. PANORAMA", 2);
    std::vector<cv::Mat> images;
    for (int i = 1; i + 1 < argc; ++i)
    {
        images.push_back(cv::imread(argv[i]));
        if (images.back().empty())
            return fail(std::string("cannot read ") + argv[i], 2);
    }

    cv::Ptr<cv::Stitcher> stitcher = cv::Stitcher::create(cv::Stitcher::PANORAMA);
    const cv::Ptr<cv::gcpw::StitcherBinding> gcpw = cv::gcpw::attach(stitcher); // this line

    cv::Mat panorama;
    const cv::Stitcher::Status status = stitcher->stitch(images, panorama);
    if (status != cv::Stitcher::OK)
        return fail("the images could not be stitched, status " + std::to_string(static_cast<int>(status)), 1);
    if (!gcpw->rig().alignment.ok())
        std::cout << gcpw->rig().alignment.report().message << '\n';

    if (!cv::imwrite(argv[argc - 1], panorama))
        return fail(std::string("cannot write ") + argv[argc - 1], 2);
    return 0;
}
