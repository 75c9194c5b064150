// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/heif.hpp"

#include <cstring>
#include <fstream>
#include <memory>
#include <opencv2/imgproc.hpp>
#include "common/exit_code.hpp"
#ifdef GCPW_HAS_HEIF
#include <libheif/heif.h>
#endif

bool isHeif(const std::string& path)
{
    // ISO/IEC 14496-12: the length of the first box, its name, and the brand of the file.
    char head[12] = {};
    std::ifstream(path, std::ios::binary).read(head, sizeof(head));
    if (std::memcmp(head + 4, "ftyp", 4) != 0)
        return false;
    for (const char* brand : {"heic", "heix", "hevc", "heim", "heis", "mif1", "msf1", "avif"})
        if (std::memcmp(head + 8, brand, 4) == 0)
            return true;
    return false;
}

#ifdef GCPW_HAS_HEIF

cv::Mat readHeif(const std::string& path)
{
    const auto check = [&path](const heif_error& error)
    {
        if (error.code != heif_error_Ok)
            throw FileTrouble("cannot read " + path + ": " + error.message);
    };
    const std::unique_ptr<heif_context, void (*)(heif_context*)> context(heif_context_alloc(), heif_context_free);
    check(heif_context_read_from_file(context.get(), path.c_str(), nullptr));
    heif_image_handle* raw_handle = nullptr;
    check(heif_context_get_primary_image_handle(context.get(), &raw_handle));
    const std::unique_ptr<const heif_image_handle, void (*)(const heif_image_handle*)> handle(
        raw_handle, heif_image_handle_release);
    const bool alpha = heif_image_handle_has_alpha_channel(handle.get()) != 0;
    heif_image* raw_image = nullptr;
    check(heif_decode_image(handle.get(), &raw_image, heif_colorspace_RGB,
                            alpha ? heif_chroma_interleaved_RGBA : heif_chroma_interleaved_RGB, nullptr));
    const std::unique_ptr<const heif_image, void (*)(const heif_image*)> image(raw_image, heif_image_release);
    int stride = 0;
    const uint8_t* const pixels = heif_image_get_plane_readonly(image.get(), heif_channel_interleaved, &stride);
    if (!pixels)
        throw FileTrouble("cannot read " + path + ": it has no picture");
    const cv::Size size(heif_image_get_width(image.get(), heif_channel_interleaved),
                        heif_image_get_height(image.get(), heif_channel_interleaved));
    const cv::Mat rgb(size, alpha ? CV_8UC4 : CV_8UC3, const_cast<uint8_t*>(pixels), static_cast<size_t>(stride));
    cv::Mat bgr;
    cv::cvtColor(rgb, bgr, alpha ? cv::COLOR_RGBA2BGRA : cv::COLOR_RGB2BGR);
    return bgr;
}

#else

cv::Mat readHeif(const std::string& path)
{
    throw FileTrouble("cannot read " + path +
                      ": it is HEIF, and this program was built without libheif; save it as JPEG, PNG or TIFF");
}

#endif
