// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/read_photograph.hpp"

#include <filesystem>
#include <fstream>
#include <fcntl.h>
#include <opencv2/core/check.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <unistd.h>
#include "common/exit_code.hpp"
#include "common/heif.hpp"
#include "common/jpeg_end.hpp"
#include "common/paths.hpp"

namespace fs = std::filesystem;

namespace
{

/// Keeps standard error silent while it lives: decoders print what they think of broken files there, and it is told in words of our own.
class SilentErrors
{
public:
    SilentErrors() : before_(dup(STDERR_FILENO))
    {
        const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (before_ >= 0 && nothing >= 0)
            dup2(nothing, STDERR_FILENO);
        if (nothing >= 0)
            close(nothing);
    }
    ~SilentErrors()
    {
        if (before_ < 0)
            return;
        dup2(before_, STDERR_FILENO);
        close(before_);
    }
    SilentErrors(const SilentErrors&) = delete;
    SilentErrors& operator=(const SilentErrors&) = delete;

private:
    int before_;
};

/// Throws FileTrouble unless there is a file that can be read.
void checkReadable(const std::string& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found)
        throw FileTrouble("there is no file " + shortened(path));
    if (status.type() == fs::file_type::none)
        throw FileTrouble("cannot read " + shortened(path) + ": " + error.message());
    if (fs::is_directory(status))
        throw FileTrouble("cannot read " + shortened(path) + ": it is a folder");
    const std::ifstream file(path, std::ios::binary);
    if (!file)
        throw FileTrouble("cannot read " + shortened(path) + ": it may not be opened; change its permissions");
    if (fs::is_regular_file(status) && fs::file_size(path, error) == 0)
        throw FileTrouble("cannot read " + shortened(path) + ": it is empty; copy it anew");
}

cv::Mat decode(const std::string& path)
{
    const SilentErrors silent;
    try
    {
        // Only this mode keeps alpha and all bits. It leaves the picture as it is stored, but for TIFF.
        return cv::imread(path, cv::IMREAD_UNCHANGED);
    }
    catch (const cv::Exception& error)
    {
        throw FileTrouble("cannot read " + shortened(path) + ": " + error.err);
    }
}

/// OpenCV's decoder of TIFF turns pictures itself.
bool isTurnedByOpenCv(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    char head[2] = {};
    file.read(head, sizeof(head));
    return (head[0] == 'I' && head[1] == 'I') || (head[0] == 'M' && head[1] == 'M');
}

/// BGR or BGRA of whatever number of channels a file has.
cv::Mat inColor(const cv::Mat& image)
{
    cv::Mat color = image;
    if (image.channels() == 1)
        cv::cvtColor(image, color, cv::COLOR_GRAY2BGR);
    if (image.channels() == 2) // gray with alpha
    {
        cv::Mat channels[2];
        cv::split(image, channels);
        cv::merge(std::vector<cv::Mat>{channels[0], channels[0], channels[0], channels[1]}, color);
    }
    if (color.channels() == 4 && cv::countNonZero(shownPixels(color)) == static_cast<int>(color.total()))
        color = withoutAlpha(color);
    return color;
}

} // namespace

Photograph readPhotograph(const std::string& path)
{
    checkReadable(path);
    Photograph photograph;
    photograph.path = path;
    const bool heif = isHeif(path);
    cv::Mat stored = heif ? readHeif(path) : decode(path);
    if (stored.empty())
        throw FileTrouble(
            shortened(path) +
            " is no picture that can be read: its format is unknown, or it is damaged or cut short; copy it "
            "anew, or save it as JPEG, PNG or TIFF");
    if (stored.depth() != CV_8U && stored.depth() != CV_16U)
        throw FileTrouble(shortened(path) + " has pixels of kind " + cv::typeToString(stored.type()) +
                          "; save it with 8 or 16 bits a channel");
    if (lacksJpegEnd(path))
        throw FileTrouble(shortened(path) +
                          " is cut short: its end is missing, and with it a part of the picture; copy it anew");
    photograph.metadata = Metadata::read(path);
    const bool is_upright = heif || isTurnedByOpenCv(path);
    photograph.image = inColor(is_upright ? stored : upright(stored, photograph.metadata.orientation()));
    if (photograph.image.channels() == 4 && cv::countNonZero(shownPixels(photograph.image)) == 0)
        throw FileTrouble(shortened(path) + " shows nothing: all of its pixels are transparent");
    return photograph;
}

cv::Mat readImage(const std::string& path)
{
    return readPhotograph(path).image;
}

cv::Mat toBytes(const cv::Mat& image)
{
    if (image.depth() != CV_16U)
        return image;
    cv::Mat bytes;
    image.convertTo(bytes, CV_8U, 1.0 / 257);
    return bytes;
}

cv::Mat shownPixels(const cv::Mat& image)
{
    if (image.channels() != 4)
        return {};
    cv::Mat alpha;
    cv::extractChannel(image, alpha, 3);
    return alpha > (image.depth() == CV_16U ? 32767 : 127); // as the module has it
}

cv::Mat withoutAlpha(const cv::Mat& image)
{
    if (image.channels() != 4)
        return image;
    cv::Mat color;
    cv::cvtColor(image, color, cv::COLOR_BGRA2BGR);
    return color;
}
