// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/read_all.hpp"

#include <algorithm>
#include "common/exit_code.hpp"

namespace
{

Photograph readOne(const std::string& path)
{
    Photograph photograph = readPhotograph(path);
    const cv::Size size = photograph.image.size();
    if (std::min(size.width, size.height) < MIN_SIDE)
        throw FileTrouble(path +
                          cv::format(" is %d x %d px; %d px a side are needed", size.width, size.height, MIN_SIDE));
    return photograph;
}

} // namespace

std::vector<Photograph> readAll(const std::vector<std::string>& paths, bool skip_bad, const Console& console,
                                ProgressLine& progress)
{
    return readAll(paths, skip_bad, console, progress, [](Photograph&) {});
}

std::vector<Photograph> readAll(const std::vector<std::string>& paths, bool skip_bad, const Console& console,
                                ProgressLine& progress, const std::function<void(Photograph&)>& on_read)
{
    std::vector<Photograph> photographs;
    for (size_t i = 0; i < paths.size(); ++i)
    {
        try
        {
            photographs.push_back(readOne(paths[i]));
            const cv::Mat& image = photographs.back().image;
            console.detail(cv::format("read %s: %d x %d px, %s", paths[i].c_str(), image.cols, image.rows,
                                      cv::typeToString(image.type()).c_str()));
            on_read(photographs.back());
        }
        catch (const FileTrouble& trouble)
        {
            if (!skip_bad)
                throw FileTrouble(std::string(trouble.what()) +
                                  (paths.size() > 2 ? " (--skip-bad leaves it out)" : ""));
            console.warn(std::string(trouble.what()) + "; it is left out");
        }
        progress.show(static_cast<double>(i + 1) / static_cast<double>(paths.size()));
    }
    if (photographs.size() < 2)
        throw FileTrouble("fewer than two of the photographs can be read: nothing is left to stitch");
    return photographs;
}

Metadata sharedMetadata(const std::vector<Photograph>& photographs, const std::vector<int>& kept,
                        const Console& console)
{
    const Photograph& first = photographs[static_cast<size_t>(kept.at(0))];
    for (const int index : kept)
    {
        const Photograph& other = photographs[static_cast<size_t>(index)];
        if (other.metadata.profile() != first.metadata.profile())
        {
            console.warn("the colour profiles of " + first.path + " and " + other.path +
                         " differ: the picture has that of the first; convert them to one profile for true colours");
            break;
        }
    }
    return first.metadata;
}
