// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
//
// Draws panoramas of cv::Stitcher alone and with GCPW side by side, with bent lines in red; see scripts/pictures.
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include "common/program.hpp"
#include "evaluation/before_after.hpp"

namespace
{

const char* const KEYS =
    "{help h usage ? |               | this text }"
    "{plain          |               | folder of gcpw_stitch --method=none: panorama.png or .jpg, and its --dump }"
    "{gcpw           |               | folder of gcpw_stitch: panorama.png or .jpg, its --dump, and --save_model=model.yml.gz }"
    "{output         | before_after.jpg | the picture }"
    "{width          | 1280          | of the picture, px }"
    "{kilobytes      | 300           | a JPEG file is compressed until it is no larger }";

/// The best quality that fits.
void writeSmall(const std::string& path, const cv::Mat& picture, int kilobytes)
{
    const bool jpeg = path.size() > 4 && path.substr(path.size() - 4) == ".jpg";
    for (int quality = 92; jpeg && quality > 40; quality -= 4)
    {
        std::vector<uchar> bytes;
        cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
        if (bytes.size() > 1000 * static_cast<size_t>(kilobytes))
            continue;
        writeText(path, std::string(bytes.begin(), bytes.end()));
        return;
    }
    writeImage(path, picture);
}

} // namespace

int main(int argc, char** argv)
{
    const std::string about = "Draws panoramas of cv::Stitcher alone and with GCPW side by side.\n"
                              "before_after PHOTOGRAPH.. --plain=FOLDER --gcpw=FOLDER";
    return runProgram("before_after", argc, argv, KEYS, about, [&](const cv::CommandLineParser& parser)
    {
        std::vector<std::string> photographs;
        for (int i = 1; i < argc; ++i)
            if (argv[i][0] != '-')
                photographs.emplace_back(argv[i]);
        const std::string plain = parser.get<std::string>("plain");
        const std::string gcpw = parser.get<std::string>("gcpw");
        const std::string output = parser.get<std::string>("output");
        if (photographs.size() < 2 || plain.empty() || gcpw.empty())
            throw WrongUse("photographs, --plain and --gcpw are needed; --help lists the options");
        writeSmall(output, evaluation::beforeAfter(plain, gcpw, photographs, parser.get<int>("width")), parser.get<int>("kilobytes"));
        std::cout << output << " written\n";
        return static_cast<int>(EXIT_STITCHED);
    });
}
