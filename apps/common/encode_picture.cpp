// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/encode_picture.hpp"

#include <opencv2/imgcodecs.hpp>
#include "common/command_line.hpp"
#include "common/exit_code.hpp"
#include "common/paths.hpp"
#include "common/read_photograph.hpp"
#include "common/write_file.hpp"

namespace
{

const char* const PIPED = ".png"; ///< what goes to a name without an ending: loses nothing, read by everybody

// Values of libtiff.
const int TIFF_NONE = 1;
const int TIFF_LZW = 5;
const int TIFF_DEFLATE = 8;

std::string formatOf(const std::string& path)
{
    const std::string ending = endingOf(path);
    return ending.empty() || isStandardOutput(path) ? PIPED : ending;
}

std::vector<int> settingsOf(const PictureFormat& format)
{
    const int compression = format.compression == "none"  ? TIFF_NONE
                            : format.compression == "lzw" ? TIFF_LZW
                                                          : TIFF_DEFLATE;
    // Each encoder takes its own and passes over the others.
    return {cv::IMWRITE_JPEG_QUALITY,     format.quality, cv::IMWRITE_WEBP_QUALITY, format.quality,
            cv::IMWRITE_TIFF_COMPRESSION, compression};
}

} // namespace

void declareFormat(CommandLine& line, PictureFormat& format)
{
    line.integer("--quality", format.quality, {1, 100}, "of JPEG and WebP, 1 to 100");
    line.choice("--compression", format.compression, {"none", "lzw", "deflate"}, "of TIFF: none, lzw or deflate");
}

bool keepsDeepPixels(const std::string& path)
{
    const std::string format = formatOf(path);
    return format == ".png" || format == ".tif" || format == ".tiff";
}

void writePicture(const std::string& path, const cv::Mat& picture, const PictureFormat& format,
                  const Metadata& metadata)
{
    const std::string ending = formatOf(path);
    std::vector<uchar> data;
    const cv::Mat pixels = keepsDeepPixels(path) ? picture : toBytes(picture);
    bool encoded = false;
    std::string reason;
    try
    {
        encoded = cv::imencode(ending, pixels, data, settingsOf(format));
    }
    catch (const cv::Exception& error)
    {
        reason = ": " + error.err;
    }
    if (!encoded || data.empty())
        throw FileTrouble("cannot write " + shortened(path) +
                          cv::format(": a picture of %d x %d px cannot be made a file of kind %s; try .png or .tif",
                                     pixels.cols, pixels.rows, ending.c_str()) +
                          reason);
    data = metadata.addTo(data, pixels.size());
    writeBytes(path, data.data(), data.size());
}
