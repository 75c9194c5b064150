// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/embed.hpp"

#include <algorithm>
#include <cstring>

namespace
{

typedef std::vector<uchar> Bytes;

const size_t PNG_HEAD = 33; ///< the signature and the chunk IHDR, which comes first
const size_t RIFF_HEAD = 12;

void add(Bytes& bytes, const char* text, size_t size)
{
    bytes.insert(bytes.end(), text, text + size);
}

void addLittle(Bytes& bytes, uint64 value, int count)
{
    for (int i = 0; i < count; ++i)
        bytes.push_back(static_cast<uchar>(value >> 8 * i));
}

void addBig(Bytes& bytes, uint64 value, int count)
{
    for (int i = count - 1; i >= 0; --i)
        bytes.push_back(static_cast<uchar>(value >> 8 * i));
}

/// The check sum of PNG (RFC 2083, chapter 15).
unsigned crc(const uchar* data, size_t size)
{
    unsigned value = ~0U;
    for (size_t i = 0; i < size; ++i)
    {
        value ^= data[i];
        for (int bit = 0; bit < 8; ++bit)
            value = (value & 1) != 0 ? 0xedb88320U ^ (value >> 1) : value >> 1;
    }
    return ~value;
}

void addPngChunk(Bytes& bytes, const char* name, const Bytes& content)
{
    addBig(bytes, content.size(), 4);
    const size_t start = bytes.size();
    add(bytes, name, 4);
    bytes.insert(bytes.end(), content.begin(), content.end());
    addBig(bytes, crc(bytes.data() + start, bytes.size() - start), 4);
}

/// zlib's form (RFC 1950 and 1951) without compression: profiles are small.
Bytes stored(const Bytes& content)
{
    const size_t most = 65535; // of one block
    Bytes bytes = {0x78, 0x01};
    for (size_t at = 0; at == 0 || at < content.size(); at += most)
    {
        const size_t size = std::min(most, content.size() - at);
        bytes.push_back(at + size == content.size() ? 1 : 0); // the last block
        addLittle(bytes, size, 2);
        addLittle(bytes, ~size, 2);
        bytes.insert(bytes.end(), content.begin() + static_cast<long>(at),
                     content.begin() + static_cast<long>(at + size));
    }
    const unsigned base = 65521;
    unsigned sum = 1;
    unsigned sums = 0;
    for (const uchar byte : content)
    {
        sum = (sum + byte) % base;
        sums = (sums + sum) % base;
    }
    addBig(bytes, sums, 2);
    addBig(bytes, sum, 2);
    return bytes;
}

void addRiffChunk(Bytes& bytes, const char* name, const Bytes& content)
{
    add(bytes, name, 4);
    addLittle(bytes, content.size(), 4);
    bytes.insert(bytes.end(), content.begin(), content.end());
    if (content.size() % 2 == 1)
        bytes.push_back(0);
}

} // namespace

bool isPng(const Bytes& file)
{
    return file.size() > PNG_HEAD && std::memcmp(file.data(), "\x89PNG\r\n\x1a\n", 8) == 0;
}

bool isWebp(const Bytes& file)
{
    return file.size() > RIFF_HEAD && std::memcmp(file.data(), "RIFF", 4) == 0 &&
           std::memcmp(file.data() + 8, "WEBP", 4) == 0;
}

Bytes embedInPng(const Bytes& file, const Bytes& exif, const Bytes& profile)
{
    const auto head_end = file.begin() + static_cast<long>(PNG_HEAD);
    Bytes result(file.begin(), head_end);
    if (!profile.empty())
    {
        Bytes content;
        add(content, "ICC profile", 12); // its name with a zero behind it,
        content.push_back(0);            // and how it is compressed
        const Bytes packed = stored(profile);
        content.insert(content.end(), packed.begin(), packed.end());
        addPngChunk(result, "iCCP", content);
    }
    if (!exif.empty())
        addPngChunk(result, "eXIf", exif);
    result.insert(result.end(), head_end, file.end());
    return result;
}

Bytes embedInWebp(const Bytes& file, const Bytes& exif, const Bytes& profile, cv::Size size)
{
    const bool extended = file.size() > RIFF_HEAD + 4 && std::memcmp(file.data() + RIFF_HEAD, "VP8X", 4) == 0;
    if (extended || (exif.empty() && profile.empty())) // OpenCV writes simple files
        return file;
    const int has_profile = 0x20;
    const int has_exif = 0x08;
    Bytes head = {static_cast<uchar>((profile.empty() ? 0 : has_profile) | (exif.empty() ? 0 : has_exif)), 0, 0, 0};
    addLittle(head, static_cast<uint64>(size.width) - 1, 3);
    addLittle(head, static_cast<uint64>(size.height) - 1, 3);
    Bytes body;
    add(body, "WEBP", 4);
    addRiffChunk(body, "VP8X", head);
    if (!profile.empty())
        addRiffChunk(body, "ICCP", profile);
    body.insert(body.end(), file.begin() + static_cast<long>(RIFF_HEAD), file.end());
    if (!exif.empty())
        addRiffChunk(body, "EXIF", exif);
    Bytes result;
    add(result, "RIFF", 4);
    addLittle(result, body.size(), 4);
    result.insert(result.end(), body.begin(), body.end());
    return result;
}
