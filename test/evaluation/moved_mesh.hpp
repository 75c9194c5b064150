// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_TEST_EVALUATION_MOVED_MESH_HPP
#define GCPW_TEST_EVALUATION_MOVED_MESH_HPP

#include <opencv2/gcpw/alignment.hpp>

/// An image whose rough alignment is itself, and whose mesh is where a law takes its vertices.
template <typename Law>
cv::gcpw::AlignedImage movedMesh(cv::Size size, Law law, int quads = 64)
{
    cv::gcpw::AlignedImage image;
    image.full_size = image.work_size = size;
    image.rough.create(quads + 1, quads + 1, CV_64FC2);
    image.mesh.create(quads + 1, quads + 1, CV_64FC2);
    image.color = cv::Mat(quads, quads, CV_32FC(6), cv::Scalar::all(0));
    for (int row = 0; row <= quads; ++row)
        for (int col = 0; col <= quads; ++col)
        {
            const cv::Vec2d p(static_cast<double>(col) / quads * size.width - 0.5, static_cast<double>(row) / quads * size.height - 0.5);
            image.rough.at<cv::Vec2d>(row, col) = p;
            image.mesh.at<cv::Vec2d>(row, col) = law(p);
        }
    return image;
}

#endif
