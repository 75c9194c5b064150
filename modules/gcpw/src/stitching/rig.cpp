// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/rig.hpp"

#include <cstring>
#include "api/alignment_io.hpp"
#include "api/model_file.hpp"
#include "stitching/rig_fault.hpp"

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
    return alignment.ok() && alignment.imageCount() > 0 && findFault(*this).message.empty();
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

void Rig::check() const
{
    const RigFault fault = findFault(*this);
    if (!fault.message.empty())
        CV_Error(fault.code, fault.message);
}

void Rig::save(const std::string& path) const
{
    writeFile(path, KIND, [this](FileStorage& file)
    {
        file << "scale" << scale << "work_scale" << work_scale << "component" << component << "turns" << turns;
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
    });
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
        bool sizes_known = false;
        for (const FileNode& node : root["cameras"])
        {
            cv::detail::CameraParams camera;
            node["focal"] >> camera.focal;
            node["aspect"] >> camera.aspect;
            node["ppx"] >> camera.ppx;
            node["ppy"] >> camera.ppy;
            camera.R = readMatrix(node["R"], "R of a camera", 3, 3, {"f", "d"});
            if (!node["t"].empty())
                camera.t = readMatrix(node["t"], "t of a camera", 3, 3, {"f", "d"});
            Size size;
            node["image_size"] >> size;
            rig.cameras.push_back(camera);
            rig.image_sizes.push_back(size);
            sizes_known = sizes_known || size != Size();
        }
        if (!sizes_known)
            rig.image_sizes.clear(); // save() had none to write
        rig.alignment = readAlignment(root["alignment"]);
        rig.check();
        return rig;
    });
}

} // namespace gcpw
} // namespace cv
