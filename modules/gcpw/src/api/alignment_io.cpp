// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "api/alignment_io.hpp"

#include "api/model_file.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const char* const KIND = "gcpw_alignment";
const int MAX_VERTICES = 257; ///< a side, of the largest mesh

Alignment::Image readImage(const FileNode& node)
{
    Alignment::Image image;
    node["full_size"] >> image.full_size;
    node["work_size"] >> image.work_size;
    image.mesh = readMatrix(node["mesh"], "mesh", MAX_VERTICES, MAX_VERTICES, {"2d"});
    image.rough = readMatrix(node["rough"], "rough", MAX_VERTICES, MAX_VERTICES, {"2d"});
    image.color = readMatrix(node["color"], "color", MAX_VERTICES, MAX_VERTICES, {"6f"});
    return image;
}

} // namespace

void writeAlignment(FileStorage& file, const Alignment& alignment)
{
    const Report& report = alignment.report();
    file << "status" << static_cast<int>(report.status) << "message" << report.message << "folds" << report.folds
         << "max_displacement_px" << report.max_displacement_px << "gain_min" << report.gain_min << "gain_max"
         << report.gain_max;
    file << "canvas_scale" << std::vector<double>{alignment.canvasScale().width, alignment.canvasScale().height};
    file << "images" << "[";
    for (int i = 0; i < alignment.imageCount(); ++i)
    {
        const Alignment::Image& image = alignment.image(i);
        file << "{" << "full_size" << image.full_size << "work_size" << image.work_size << "mesh" << image.mesh << "rough"
             << image.rough << "color" << image.color << "}";
    }
    file << "]";
}

Alignment readAlignment(const FileNode& node)
{
    if (!node.isMap())
        CV_Error(Error::StsParseError, "it holds no alignment");
    Report report;
    int status = 0;
    node["status"] >> status;
    report.status = static_cast<Status>(status);
    node["message"] >> report.message;
    node["folds"] >> report.folds;
    node["max_displacement_px"] >> report.max_displacement_px;
    node["gain_min"] >> report.gain_min;
    node["gain_max"] >> report.gain_max;
    std::vector<double> scale;
    node["canvas_scale"] >> scale;
    if (scale.size() != 2)
        CV_Error(Error::StsParseError, "canvas_scale is missing or not two numbers");
    std::vector<Alignment::Image> images;
    for (const FileNode& image : node["images"])
        images.push_back(readImage(image));
    return {images, Size2d(scale[0], scale[1]), report}; // the constructor checks them
}

void Alignment::save(const std::string& path) const
{
    writeFile(path, KIND, [this](FileStorage& file) { writeAlignment(file, *this); });
}

Alignment Alignment::load(const std::string& path)
{
    return readFile(path, KIND, [](const FileNode& root) { return readAlignment(root); });
}

} // namespace gcpw
} // namespace cv
