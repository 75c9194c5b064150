// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
//
// Draws panoramas of cv::Stitcher alone and with GCPW side by side, with bent lines in red; see scripts/pictures.
#include "evaluation/before_after.hpp"
#include <opencv2/imgcodecs.hpp>
#include "common/program.hpp"
#include "common/write_file.hpp"

namespace
{

const CommandLine::Texts TEXTS = {"before_after",
                                  "Draws panoramas of cv::Stitcher alone and with GCPW side by side.",
                                  "before_after PHOTOGRAPH.. --plain=FOLDER --gcpw=FOLDER",
                                  {}};

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
    CommandLine line(TEXTS);
    std::vector<std::string> photographs;
    std::string plain;
    std::string gcpw;
    std::string output = "before_after.jpg";
    int width = 1280;
    int kilobytes = 300;
    line.arguments(photographs);
    line.group("Pictures");
    line.text("--plain", plain, "FOLDER", "of gcpw_stitch --method=none: panorama.png or .jpg, and its --dump");
    line.text("--gcpw", gcpw, "FOLDER",
              "of gcpw_stitch: panorama.png or .jpg, its --dump, and --save_model=model.yml.gz");
    line.text("-o,--output", output, "FILE", "the picture");
    line.integer("--width", width, {64, 32766, "px"}, "of the picture, px");
    line.integer("--kilobytes", kilobytes, {1, 1e6}, "a JPEG file is compressed until it is no larger");
    return runProgram(line, argc, argv,
                      [&](const Console& console)
                      {
        if (photographs.size() < 2 || plain.empty() || gcpw.empty())
            throw WrongUse("photographs, --plain and --gcpw are needed; --help lists the options");
        writeSmall(output, evaluation::beforeAfter(plain, gcpw, photographs, width), kilobytes);
        console.tell(output + " written");
        return static_cast<int>(EXIT_STITCHED);
    });
}
