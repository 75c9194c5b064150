// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_TEST_STORED_PICTURE_HPP
#define GCPW_TEST_STORED_PICTURE_HPP

#include <string>
#include <vector>
#include <opencv2/imgcodecs.hpp>

/// Files with an orientation, made byte by byte: nothing of what reads them has a hand in it.
namespace stored
{

inline void add(std::string& bytes, unsigned value, int count, bool big_end_first = false)
{
    for (int i = 0; i < count; ++i)
        bytes += static_cast<char>(value >> 8 * (big_end_first ? count - 1 - i : i) & 255);
}

/// An entry of a TIFF directory with one value that fits into it. Kind 3 is 16 bits, 4 is 32.
inline void addEntry(std::string& bytes, unsigned tag, unsigned kind, unsigned value, unsigned count = 1)
{
    add(bytes, tag, 2);
    add(bytes, kind, 2);
    add(bytes, count, 4);
    add(bytes, value, 4);
}

/// EXIF with nothing but the orientation.
inline std::string exif(int orientation)
{
    std::string bytes("II*\0\10\0\0\0\1\0", 10);
    addEntry(bytes, 0x112, 3, static_cast<unsigned>(orientation));
    return bytes + std::string(4, '\0');
}

inline std::string encoded(const std::string& ending, const cv::Mat& image, const std::vector<int>& settings = {})
{
    std::vector<uchar> data;
    cv::imencode(ending, image, data, settings);
    return std::string(data.begin(), data.end());
}

inline std::string jpeg(const cv::Mat& image, int orientation)
{
    const std::string whole = encoded(".jpg", image, {cv::IMWRITE_JPEG_QUALITY, 100});
    const std::string content = std::string("Exif\0\0", 6) + exif(orientation);
    std::string segment("\xff\xe1", 2);
    add(segment, static_cast<unsigned>(content.size()) + 2, 2, true);
    return whole.substr(0, 2) + segment + content + whole.substr(2);
}

inline unsigned crc(const std::string& bytes)
{
    unsigned value = ~0U;
    for (const char byte : bytes)
    {
        value ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit)
            value = (value & 1) != 0 ? 0xedb88320U ^ value >> 1 : value >> 1;
    }
    return ~value;
}

inline std::string png(const cv::Mat& image, int orientation)
{
    const size_t header = 33; // the signature and IHDR
    const std::string whole = encoded(".png", image);
    const std::string content = "eXIf" + exif(orientation);
    std::string chunk;
    add(chunk, static_cast<unsigned>(content.size()) - 4, 4, true);
    chunk += content;
    add(chunk, crc(content), 4, true);
    return whole.substr(0, header) + chunk + whole.substr(header);
}

inline std::string webp(const cv::Mat& image, int orientation)
{
    const std::string whole = encoded(".webp", image, {cv::IMWRITE_WEBP_QUALITY, 101}); // beyond 100: without loss
    std::string body = "WEBPVP8X";
    add(body, 10, 4);
    add(body, 8, 4); // there is EXIF
    add(body, static_cast<unsigned>(image.cols) - 1, 3);
    add(body, static_cast<unsigned>(image.rows) - 1, 3);
    body += whole.substr(12);
    const std::string content = exif(orientation);
    body += "EXIF";
    add(body, static_cast<unsigned>(content.size()), 4);
    body += content;
    std::string file = "RIFF";
    add(file, static_cast<unsigned>(body.size()), 4);
    return file + body;
}

/// BGR of 8 or 16 bits, uncompressed, in one strip, with a profile if it is not empty.
inline std::string tiff(const cv::Mat& image, int orientation, const std::string& profile = std::string())
{
    const unsigned depth = image.depth() == CV_16U ? 16 : 8;
    const unsigned entries = profile.empty() ? 11 : 12;
    const unsigned bits_at = 8 + 2 + 12 * entries + 4;
    const unsigned pixels_at = bits_at + 6;
    const unsigned bytes = static_cast<unsigned>(image.total() * image.elemSize());
    std::string file("II*\0\10\0\0\0", 8);
    add(file, entries, 2);
    addEntry(file, 256, 4, static_cast<unsigned>(image.cols));
    addEntry(file, 257, 4, static_cast<unsigned>(image.rows));
    addEntry(file, 258, 3, bits_at, 3);
    addEntry(file, 259, 3, 1); // not compressed
    addEntry(file, 262, 3, 2); // RGB
    addEntry(file, 273, 4, pixels_at);
    addEntry(file, 274, 3, static_cast<unsigned>(orientation));
    addEntry(file, 277, 3, 3);
    addEntry(file, 278, 4, static_cast<unsigned>(image.rows));
    addEntry(file, 279, 4, bytes);
    addEntry(file, 284, 3, 1); // channels beside each other
    if (!profile.empty())
        addEntry(file, 34675, 7, pixels_at + bytes, static_cast<unsigned>(profile.size()));
    add(file, 0, 4);
    for (int i = 0; i < 3; ++i)
        add(file, depth, 2);
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
            for (int c = 2; c >= 0; --c)
                if (depth == 16)
                    add(file, image.at<cv::Vec3w>(y, x)[c], 2);
                else
                    add(file, image.at<cv::Vec3b>(y, x)[c], 1);
    return file + profile;
}

} // namespace stored

#endif
