// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "evaluation/external.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include "evaluation/input_jitter.hpp"
#include "evaluation/mesh_folds.hpp"

namespace fs = std::filesystem;

namespace evaluation
{

namespace
{

using cv::gcpw::AlignedImage;
using cv::gcpw::Alignment;

const size_t MOST_LINES = 257; ///< of a grid: meshes have 2 to 256 quads a side
const int QUADS = 64;          ///< of the mesh that a grid becomes, a side: finer than those of the methods here

[[noreturn]] void refuse(const std::string& why)
{
    CV_Error(cv::Error::StsParseError, why);
}

/// A map that is bilinear between the points of a grid and goes on beyond it.
class GridMap
{
public:
    explicit GridMap(const std::vector<cv::Vec4d>& rows)
    {
        for (const cv::Vec4d& row : rows)
        {
            if (!cv::checkRange(cv::Mat(row)))
                refuse("a grid holds a number that is not finite");
            x_.push_back(row[0]);
            y_.push_back(row[1]);
        }
        sortOnce(x_);
        sortOnce(y_);
        if (x_.size() < 2 || y_.size() < 2 || x_.size() > MOST_LINES || y_.size() > MOST_LINES ||
            x_.size() * y_.size() != rows.size())
            refuse(cv::format("%zu points with %zu values of x and %zu of y are no grid", rows.size(), x_.size(),
                              y_.size()));
        there_ =
            cv::Mat(static_cast<int>(y_.size()), static_cast<int>(x_.size()), CV_64FC2, cv::Scalar::all(std::nan("")));
        for (const cv::Vec4d& row : rows)
            there_.at<cv::Vec2d>(lineOf(y_, row[1]), lineOf(x_, row[0])) = {row[2], row[3]};
        if (!cv::checkRange(there_))
            refuse("a grid holds a point twice");
    }

    cv::Vec2d at(double x, double y) const
    {
        const int col = cellOf(x_, x);
        const int row = cellOf(y_, y);
        const double a = share(x_, col, x);
        const double b = share(y_, row, y);
        return (1 - b) * ((1 - a) * there_.at<cv::Vec2d>(row, col) + a * there_.at<cv::Vec2d>(row, col + 1)) +
               b * ((1 - a) * there_.at<cv::Vec2d>(row + 1, col) + a * there_.at<cv::Vec2d>(row + 1, col + 1));
    }

private:
    static void sortOnce(std::vector<double>& values)
    {
        std::sort(values.begin(), values.end());
        values.erase(std::unique(values.begin(), values.end()), values.end());
    }
    static int lineOf(const std::vector<double>& values, double value)
    {
        return static_cast<int>(std::lower_bound(values.begin(), values.end(), value) - values.begin());
    }
    static int cellOf(const std::vector<double>& values, double value)
    {
        return std::min(std::max(lineOf(values, value) - 1, 0), static_cast<int>(values.size()) - 2);
    }
    static double share(const std::vector<double>& values, int cell, double value)
    {
        const double start = values[static_cast<size_t>(cell)];
        return (value - start) / (values[static_cast<size_t>(cell) + 1] - start);
    }

    std::vector<double> x_;
    std::vector<double> y_;
    cv::Mat there_; ///< CV_64FC2
};

/// Where a pixel of an image lies on the canvas.
typedef std::function<cv::Vec2d(cv::Vec2d)> Map;

/// An image with the mesh that a map makes of it.
AlignedImage imageOf(cv::Size size, const Map& mesh, const Map& rough)
{
    AlignedImage image;
    image.full_size = image.work_size = size;
    image.mesh.create(QUADS + 1, QUADS + 1, CV_64FC2);
    image.rough.create(QUADS + 1, QUADS + 1, CV_64FC2);
    image.color = cv::Mat(QUADS, QUADS, CV_32FC(6));
    image.color.reshape(1, QUADS * QUADS).colRange(0, 3).setTo(1);
    image.color.reshape(1, QUADS * QUADS).colRange(3, 6).setTo(0);
    for (int row = 0; row <= QUADS; ++row)
        for (int col = 0; col <= QUADS; ++col)
        {
            const cv::Vec2d vertex(static_cast<double>(col) / QUADS * size.width - 0.5,
                                   static_cast<double>(row) / QUADS * size.height - 0.5);
            image.mesh.at<cv::Vec2d>(row, col) = mesh(vertex);
            image.rough.at<cv::Vec2d>(row, col) = rough(vertex);
        }
    return image;
}

std::vector<cv::Vec4d> readGrid(const fs::path& path)
{
    std::ifstream file(path);
    std::vector<cv::Vec4d> rows;
    for (std::string line; std::getline(file, line);)
    {
        cv::Vec4d row;
        if (line.empty() || line == "\r")
            continue;
        if (std::sscanf(line.c_str(), "%lf ,%lf ,%lf ,%lf", &row[0], &row[1], &row[2], &row[3]) == 4)
            rows.push_back(row);
        else if (!rows.empty() || line.find_first_of("0123456789") == 0)
            refuse("'" + line + "' is not x,y,u,v"); // other first lines are headings
    }
    return rows;
}

/// A warped image, and what it covers.
void readWarped(const fs::path& folder, const std::string& name, cv::Mat& image, cv::Mat& mask)
{
    const std::string path = (folder / (name + ".png")).string();
    image = cv::imread(path, cv::IMREAD_UNCHANGED);
    if (image.empty() || image.depth() != CV_8U || image.channels() < 3)
        refuse(path + " is no picture of 8 bits with colours");
    if (image.channels() == 4)
    {
        cv::extractChannel(image, mask, 3);
        cv::cvtColor(image, image, cv::COLOR_BGRA2BGR);
    }
    else
        mask = cv::imread((folder / (name + "_mask.png")).string(), cv::IMREAD_GRAYSCALE);
    if (mask.size() != image.size())
        refuse(path + " has neither alpha nor a " + name + "_mask.png of its size");
    mask = mask > 127;
    image.setTo(cv::Scalar::all(0), mask == 0);
}

cv::gcpw::PairCanvas readCanvas(const fs::path& folder)
{
    cv::gcpw::PairCanvas canvas;
    readWarped(folder, "source", canvas.source, canvas.source_mask);
    readWarped(folder, "target", canvas.target, canvas.target_mask);
    if (canvas.source.size() != canvas.target.size())
        refuse((folder / "target.png").string() + " has not the size of source.png: both are to lie on one canvas");
    canvas.source_corrected = canvas.source;
    canvas.target_origin = cv::boundingRect(canvas.target_mask).tl();
    return canvas;
}

} // namespace

PairMethod externalMethod(const std::string& option)
{
    const size_t colon = option.find(':');
    const std::string name = option.substr(0, colon);
    if (colon == std::string::npos || name.empty() || colon + 1 == option.size())
        CV_Error(cv::Error::StsBadArg, "--external takes NAME:FOLDER; got '" + option + "'");
    if (name.find_first_of(",|\n\r/") != std::string::npos || name == "none" || findPairMethod(name))
        CV_Error(cv::Error::StsBadArg,
                 "--external: the name '" + name + "' is taken, or cannot stand in a table; choose another one");
    const std::string folder = option.substr(colon + 1);
    std::error_code error;
    if (!fs::is_directory(folder, error))
        CV_Error(cv::Error::StsBadArg, "--external: there is no folder " + folder);
    return {name, name, false, nullptr, folder};
}

Alignment alignmentOf(const std::vector<cv::Vec4d>& rows, cv::Size source, cv::Size target,
                      const cv::Matx33d& target_from_source)
{
    const GridMap grid(rows);
    const Map warped = [&](cv::Vec2d p) { return grid.at(p[0], p[1]); };
    const Map rough = [&](cv::Vec2d p)
    {
        const cv::Vec3d q = target_from_source * cv::Vec3d(p[0], p[1], 1);
        return cv::Vec2d(q[0] / q[2], q[1] / q[2]);
    };
    const Map same = [](cv::Vec2d p) { return p; };
    const AlignedImage image = imageOf(source, warped, rough);
    cv::gcpw::Report report;
    report.pairs.resize(1);
    report.folds = countFoldedQuads(image.mesh);
    return Alignment({image, imageOf(target, same, same)}, cv::Size2d(1, 1), report);
}

ExternalResult readExternal(const PairMethod& method, const std::string& pair, int input, const cv::Mat& source,
                            const cv::Mat& target, const cv::Matx33d& target_from_source)
{
    fs::path folder = fs::path(method.results) / pair / std::to_string(input);
    std::error_code error;
    if (!fs::is_directory(folder, error) && input == INPUT_GIVEN)
        folder = folder.parent_path();
    const auto has = [&](const char* name) { return fs::is_regular_file(folder / name, error); };
    ExternalResult result;
    if (has("warp.csv"))
    {
        try
        {
            result.alignment =
                alignmentOf(readGrid(folder / "warp.csv"), source.size(), target.size(), target_from_source);
        }
        catch (const cv::Exception& fault)
        {
            refuse((folder / "warp.csv").string() + ": " + fault.err);
        }
        result.canvas = cv::gcpw::renderPair(result.alignment, source, target);
    }
    else if (has("source.png"))
        result.canvas = readCanvas(folder);
    else
    {
        const fs::path picture = folder / (has("panorama.png") ? "panorama.png" : "panorama.jpg");
        result.panorama = cv::imread(picture.string());
        if (result.panorama.empty())
            refuse(folder.string() + " holds no warp.csv, no source.png and target.png, and no panorama.png or "
                                     "panorama.jpg that can be read");
    }
    return result;
}

} // namespace evaluation
