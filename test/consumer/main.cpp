// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include <opencv2/gcpw.hpp>

#include <iostream>

int main()
{
    const cv::gcpw::Params params = cv::gcpw::Params::paper();
    params.check();
    std::cout << "The paper's parameters pass their own check." << std::endl;
    return 0;
}
