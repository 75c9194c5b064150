// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "api/match_check.hpp"

#include <algorithm>
#include <cmath>

namespace cv
{
namespace gcpw
{

namespace
{

const double MAX_ZOOM = 1000;    ///< local change of scale: no two photographs differ as much
const double FARTHEST = 1 << 20; ///< px: cv::imread takes no larger image
const double HEAVIEST = 1e9;     ///< weight of a line, as Params has it

void checkSize(Size size, Size matched, const char* name)
{
    if (size != matched)
        CV_Error(Error::StsUnmatchedSizes, format("gcpw: the %s image is %d x %d px but was matched at %d x %d px",
                                                  name, size.width, size.height, matched.width, matched.height));
}

void checkStatus(Status status)
{
    if (status != Status::OK && status != Status::NO_ALIGNMENT && status != Status::CANCELLED)
        CV_Error(Error::StsOutOfRange,
                 format("gcpw: PairMatches::status is %d; it must be OK, NO_ALIGNMENT or CANCELLED",
                        static_cast<int>(status)));
}

/// The whole source must stay upright on the target's side of the horizon.
void checkHomography(const Matx33d& given, Size source)
{
    const char* const name = "gcpw: PairMatches::target_from_source ";
    if (!checkRange(Mat(given)))
        CV_Error(Error::StsOutOfRange, std::string(name) + "holds values that are not finite");
    const double right = source.width - 0.5;
    const double bottom = source.height - 0.5;
    const double largest = norm(given, NORM_INF);
    double sign = 0; // H and any multiple of it are one map
    for (const Point2d& p : {Point2d(-0.5, -0.5), Point2d(right, -0.5), Point2d(-0.5, bottom), Point2d(right, bottom)})
    {
        const Matx33d h = largest > 0 ? given * (1 / largest) : given;
        const double z = h(2, 0) * p.x + h(2, 1) * p.y + h(2, 2);
        sign = sign == 0 ? z : sign;
        if (!(z * sign > 0))
            CV_Error(Error::StsOutOfRange,
                     std::string(name) + "has its horizon inside the source, or is zero; no image is seen like that");
        // det of the Jacobian of a homography is det(H) / z^3
        const double area = determinant(h) / (z * z * z);
        if (!(area >= 1 / (MAX_ZOOM * MAX_ZOOM)) || !(area <= MAX_ZOOM * MAX_ZOOM))
            CV_Error(Error::StsOutOfRange, format("%schanges areas by a factor of %g at corner (%g, %g) of the source; "
                                                  "it must be above 0 (not mirrored or "
                                                  "singular) and within 1e-6 to 1e6",
                                                  name, area, p.x, p.y));
    }
}

bool isNear(double value)
{
    return std::abs(value) <= FARTHEST; // not for NaN
}

void checkPoints(const std::vector<Point2d>& points, const char* name)
{
    for (size_t i = 0; i < points.size(); ++i)
        if (!isNear(points[i].x) || !isNear(points[i].y))
            CV_Error(Error::StsOutOfRange,
                     format("gcpw: PairMatches::%s[%zu] is (%g, %g); coordinates must be finite and at most %g px",
                            name, i, points[i].x, points[i].y, FARTHEST));
}

void checkLines(const std::vector<Vec4d>& lines, const char* name)
{
    for (size_t i = 0; i < lines.size(); ++i)
    {
        const Vec4d& line = lines[i];
        if (!std::all_of(line.val, line.val + 4, isNear))
            CV_Error(
                Error::StsOutOfRange,
                format("gcpw: PairMatches::%s[%zu] is (%g, %g, %g, %g); coordinates must be finite and at most %g px",
                       name, i, line[0], line[1], line[2], line[3], FARTHEST));
        if (line[0] == line[2] && line[1] == line[3])
            CV_Error(Error::StsBadArg, format("gcpw: PairMatches::%s[%zu] has no length; leave it out", name, i));
    }
}

} // namespace

void checkMatches(const PairMatches& matches, Size source, Size target)
{
    checkStatus(matches.status);
    checkSize(source, matches.source_size, "source");
    checkSize(target, matches.target_size, "target");
    CV_CheckEQ(matches.source_points.size(), matches.target_points.size(), "gcpw: matches come in pairs of points");
    CV_CheckEQ(matches.source_lines.size(), matches.target_lines.size(), "gcpw: matches come in pairs of lines");
    CV_CheckEQ(matches.source_lines.size(), matches.line_weights.size(), "gcpw: every matched line has a weight");
    checkHomography(matches.target_from_source, source);
    checkPoints(matches.source_points, "source_points");
    checkPoints(matches.target_points, "target_points");
    checkLines(matches.source_lines, "source_lines");
    checkLines(matches.target_lines, "target_lines");
    for (size_t i = 0; i < matches.line_weights.size(); ++i)
        if (!(matches.line_weights[i] > 0) || !(matches.line_weights[i] <= HEAVIEST))
            CV_Error(Error::StsOutOfRange,
                     format("gcpw: PairMatches::line_weights[%zu] is %g; it must be greater than 0 and at most %g", i,
                            matches.line_weights[i], HEAVIEST));
}

} // namespace gcpw
} // namespace cv
