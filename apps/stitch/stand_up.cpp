// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/stand_up.hpp"

int turnsToStand(const Photograph& photograph, std::vector<std::string>& decisions)
{
    const int orientation = photograph.metadata.orientation();
    const int turned_right = orientation == 6 ? 1 : orientation == 8 ? 3 : 0;
    const int noted = photograph.size().width > photograph.size().height ? turned_right : 0;
    if (noted != 0)
        decisions.push_back(
            "the picture does without the turn that is noted in the photographs: it lays on their side what was "
            "stored upright, and they stand in a column");
    // Turned to the right once, and to the left as often as the note did to the right.
    return (1 - noted + 4) % 4;
}

cv::Mat turned(const cv::Mat& picture, int turns)
{
    cv::Mat result = picture;
    if (turns == 1)
        cv::rotate(picture, result, cv::ROTATE_90_CLOCKWISE);
    if (turns == 2)
        cv::rotate(picture, result, cv::ROTATE_180);
    return result;
}
