// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/mesh_folds.hpp"

namespace evaluation
{

int countFoldedQuads(const cv::Mat& mesh)
{
    CV_CheckTypeEQ(mesh.type(), CV_64FC2, "a mesh holds x and y of its vertices as doubles");
    int folds = 0;
    for (int row = 0; row + 1 < mesh.rows; ++row)
        for (int col = 0; col + 1 < mesh.cols; ++col)
        {
            // The corners clockwise on the screen; each turn must keep its hand.
            const cv::Vec2d corners[] = {mesh.at<cv::Vec2d>(row, col), mesh.at<cv::Vec2d>(row, col + 1),
                                         mesh.at<cv::Vec2d>(row + 1, col + 1), mesh.at<cv::Vec2d>(row + 1, col)};
            bool sound = true;
            for (int k = 0; k < 4; ++k)
            {
                const cv::Vec2d in = corners[k] - corners[(k + 3) % 4];
                const cv::Vec2d out = corners[(k + 1) % 4] - corners[k];
                sound = sound && in[0] * out[1] - in[1] * out[0] > 0; // false for NaN too
            }
            folds += sound ? 0 : 1;
        }
    return folds;
}

} // namespace evaluation
