// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "opencv2/gcpw/rig.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include "api/alignment_io.hpp"
#include "api/model_file.hpp"

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

void checkPositive(const std::string& name, double value)
{
    if (!(value > 0) || !std::isfinite(value))
        CV_Error(Error::StsOutOfRange, format("gcpw: %s is %g; it must be finite and above 0", name.c_str(), value));
}

void checkCount(const char* name, size_t count, size_t images)
{
    if (count != 0 && count != images)
        CV_Error(Error::StsUnmatchedSizes,
                 format("gcpw: %s of a rig has %zu entries; it has one for each of the %zu images, or none", name, count, images));
}

void checkCamera(const cv::detail::CameraParams& camera, size_t index)
{
    const std::string of = format(" of camera %zu", index);
    if (camera.R.size() != Size(3, 3) || camera.R.channels() != 1 || camera.R.dims != 2)
        CV_Error(Error::StsBadArg, "gcpw: R" + of + " is not a 3 x 3 matrix");
    if (!checkRange(camera.R))
        CV_Error(Error::StsOutOfRange, "gcpw: R" + of + " holds values that are not finite");
    checkPositive("focal" + of, camera.focal);
    checkPositive("aspect" + of, camera.aspect);
    if (!std::isfinite(camera.ppx) || !std::isfinite(camera.ppy))
        CV_Error(Error::StsOutOfRange, format("gcpw: the principal point%s is (%g, %g); it must be finite", of.c_str(), camera.ppx, camera.ppy));
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

void Rig::check() const
{
    const size_t images = static_cast<size_t>(alignment.imageCount());
    if (images == 0 || !alignment.ok())
        return;
    if (cameras.size() != images)
        CV_Error(Error::StsUnmatchedSizes, format("gcpw: a rig of %zu images has %zu cameras", images, cameras.size()));
    for (size_t i = 0; i < images; ++i)
        checkCamera(cameras[i], i);
    checkCount("image_sizes", image_sizes.size(), images);
    for (size_t i = 0; i < image_sizes.size(); ++i)
        if (image_sizes[i].width < 1 || image_sizes[i].height < 1)
            CV_Error(Error::StsOutOfRange, format("gcpw: image_sizes[%zu] of a rig is %d x %d px; both must be at least 1", i,
                                                  image_sizes[i].width, image_sizes[i].height));
    checkCount("component", component.size(), images);
    for (size_t i = 0; i < component.size(); ++i)
        if (component[i] < 0 || std::find(component.begin(), component.begin() + static_cast<std::ptrdiff_t>(i), component[i]) !=
                                    component.begin() + static_cast<std::ptrdiff_t>(i))
            CV_Error(Error::StsOutOfRange,
                     format("gcpw: component[%zu] of a rig is %d; indices start at 0 and none comes twice", i, component[i]));
    checkCount("turns", turns.size(), images);
    for (size_t i = 0; i < turns.size(); ++i)
        if (!(std::abs(turns[i]) <= 2 * CV_PI))
            CV_Error(Error::StsOutOfRange, format("gcpw: turns[%zu] of a rig is %g; radians of at most one circle are taken", i, turns[i]));
    checkPositive("scale of a rig", scale);
    checkPositive("work_scale of a rig", work_scale);
}

void Rig::save(const std::string& path) const
{
    writeFile(path, KIND, [this](FileStorage& file)
    {
        file << "scale" << scale << "work_scale" << work_scale << "component" << component << "turns" << turns;
        if (!projection.empty())
            file << "projection" << projection << "turned" << turned;
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
        root["projection"] >> rig.projection;
        root["turned"] >> rig.turned;
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
