// This file is part of OpenCV project, under the license terms in its LICENSE file.
//
// Two photographs, one call. The second keeps its place, the first is warped onto it.
#include <iostream>
#include <opencv2/gcpw/pair.hpp>
#include <opencv2/imgcodecs.hpp>

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
    if (argc != 4)
        return fail("pair SOURCE TARGET PANORAMA", 2);
    const cv::Mat source = cv::imread(argv[1]);
    const cv::Mat target = cv::imread(argv[2]);
    if (source.empty() || target.empty())
        return fail(std::string("cannot read ") + argv[source.empty() ? 1 : 2], 2);

    cv::Mat panorama;
    if (!cv::gcpw::stitchPair(source, target, panorama)) // this line
        return fail("the photographs do not match", 1);

    if (!cv::imwrite(argv[3], panorama))
        return fail(std::string("cannot write ") + argv[3], 2);
    return 0;
}
