// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include <opencv2/gcpw.hpp>

#include <iostream>

int main()
{
    const cv::gcpw::Params params = cv::gcpw::Params::paper();
    params.check();
    std::cout << "The paper's parameters pass their own check." << std::endl;
    return 0;
}
