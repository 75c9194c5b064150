// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "opencv2/gcpw/rig.hpp"

#include <cstring>
#include "pipeline/alignment_io.hpp"

namespace cv
{
namespace gcpw
{

namespace
{

const char* const KIND = "gcpw_rig";

bool sameCamera(const cv::detail::CameraParams& a, const cv::detail::CameraParams& b)
{
    Mat R_a;
    Mat R_b;
    a.R.convertTo(R_a, CV_32F);
    b.R.convertTo(R_b, CV_32F);
    // The bits, so that a rotation that is not finite equals itself.
    return a.focal == b.focal && a.aspect == b.aspect && a.ppx == b.ppx && a.ppy == b.ppy && R_a.total() == 9 &&
           R_b.total() == 9 && std::memcmp(R_a.data, R_b.data, 9 * sizeof(float)) == 0;
}

} // namespace

bool Rig::usable() const
{
    return alignment.ok() && alignment.imageCount() > 0 &&
           static_cast<size_t>(alignment.imageCount()) == cameras.size() && scale > 0;
}

bool Rig::fits(const std::vector<cv::detail::CameraParams>& others) const
{
    if (cameras.empty() || cameras.size() != others.size())
        return false;
    for (size_t i = 0; i < cameras.size(); ++i)
        if (!sameCamera(cameras[i], others[i]))
            return false;
    return true;
}

void Rig::save(const std::string& path) const
{
    FileStorage file = openForWriting(path);
    file << "kind" << KIND << "scale" << scale << "work_scale" << work_scale << "component" << component << "turns" << turns;
    file << "cameras" << "[";
    for (size_t i = 0; i < cameras.size(); ++i)
    {
        const cv::detail::CameraParams& camera = cameras[i];
        file << "{" << "focal" << camera.focal << "aspect" << camera.aspect << "ppx" << camera.ppx << "ppy" << camera.ppy
             << "R" << camera.R << "t" << camera.t << "image_size" << (i < image_sizes.size() ? image_sizes[i] : Size())
             << "}";
    }
    file << "]" << "alignment" << "{";
    writeAlignment(file, alignment);
    file << "}";
}

Rig Rig::load(const std::string& path)
{
    return readFile(path, KIND, [](const FileNode& root)
    {
        Rig rig;
        root["scale"] >> rig.scale;
        root["work_scale"] >> rig.work_scale;
        root["component"] >> rig.component;
        root["turns"] >> rig.turns;
        for (const FileNode& node : root["cameras"])
        {
            cv::detail::CameraParams camera;
            node["focal"] >> camera.focal;
            node["aspect"] >> camera.aspect;
            node["ppx"] >> camera.ppx;
            node["ppy"] >> camera.ppy;
            node["R"] >> camera.R;
            node["t"] >> camera.t;
            Size size;
            node["image_size"] >> size;
            CV_CheckEQ(camera.R.total(), size_t(9), "a camera without rotation");
            rig.cameras.push_back(camera);
            rig.image_sizes.push_back(size);
        }
        rig.alignment = readAlignment(root["alignment"]);
        const size_t images = static_cast<size_t>(rig.alignment.imageCount());
        if (images != 0 && (images != rig.cameras.size() || (!rig.turns.empty() && images != rig.turns.size())))
            CV_Error(Error::StsParseError, "not as many cameras as images");
        return rig;
    });
}

} // namespace gcpw
} // namespace cv
