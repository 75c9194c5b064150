// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "pipeline/alignment_io.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const char* const KIND = "gcpw_alignment";
const int FORMAT = 1; ///< raised when a reader of the older kind would misread the file

bool opened(FileStorage& file, const std::string& path, int mode, std::string& reason)
{
    try
    {
        return file.open(path, mode);
    }
    catch (const cv::Exception& e)
    {
        reason = ": " + e.err;
        return false;
    }
}

void require(const Mat& mat, Size size, int type, const char* name)
{
    if (mat.size() != size || mat.type() != type)
        CV_Error(Error::StsParseError, format("%s is missing or has a wrong size", name));
    if (!checkRange(mat))
        CV_Error(Error::StsParseError, format("%s holds values that are not finite", name));
}

Alignment::Image readImage(const FileNode& node)
{
    Alignment::Image image;
    node["full_size"] >> image.full_size;
    node["work_size"] >> image.work_size;
    node["mesh"] >> image.mesh;
    node["rough"] >> image.rough;
    node["color"] >> image.color;
    if (image.full_size.empty() || image.work_size.empty() || image.color.empty())
        CV_Error(Error::StsParseError, "an image without size or colour");
    require(image.color, image.color.size(), CV_32FC(6), "color");
    const Size vertices = image.color.size() + Size(1, 1);
    require(image.mesh, vertices, CV_64FC2, "mesh");
    require(image.rough, vertices, CV_64FC2, "rough");
    return image;
}

} // namespace

FileStorage openForWriting(const std::string& path)
{
    FileStorage file;
    std::string reason;
    if (!opened(file, path, FileStorage::WRITE, reason))
        CV_Error(Error::StsError, "gcpw: cannot write " + path + reason);
    file << "format" << FORMAT;
    return file;
}

FileStorage openForReading(const std::string& path, const std::string& kind)
{
    FileStorage file;
    std::string reason;
    if (!opened(file, path, FileStorage::READ, reason))
        CV_Error(reason.empty() ? Error::StsError : Error::StsParseError, "gcpw: cannot read " + path + reason);
    std::string found;
    int format = 0;
    file["kind"] >> found;
    file["format"] >> format;
    if (found != kind || format != FORMAT)
        CV_Error(Error::StsParseError, "gcpw: " + path + " is not a file of kind " + kind + ", format " + std::to_string(FORMAT));
    return file;
}

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
    if (scale.size() != 2 || !(scale[0] > 0) || !(scale[1] > 0))
        CV_Error(Error::StsParseError, "canvas_scale is missing or wrong");
    std::vector<Alignment::Image> images;
    for (const FileNode& image : node["images"])
        images.push_back(readImage(image));
    return {images, Size2d(scale[0], scale[1]), report};
}

void Alignment::save(const std::string& path) const
{
    FileStorage file = openForWriting(path);
    file << "kind" << KIND;
    writeAlignment(file, *this);
}

Alignment Alignment::load(const std::string& path)
{
    return readFile(path, KIND, [](const FileNode& root) { return readAlignment(root); });
}

} // namespace gcpw
} // namespace cv
