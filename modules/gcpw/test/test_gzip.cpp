// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "test_precomp.hpp"

#include <cstdio>
#include <fstream>
#include <sstream>
#include "api/gzip.hpp"
#include "refusal.hpp"

namespace opencv_test
{
namespace
{

const size_t PLENTY = 1 << 24;
const size_t HEADER = 10; // bytes, of which time, effort and system say nothing

std::string gunzipOf(const std::string& packed, size_t most = PLENTY)
{
    std::istringstream stream(packed);
    return gcpw::gunzip(stream, most);
}

std::string contentOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
}

std::string littleEndian(uint32_t value, int bytes)
{
    std::string result;
    for (int i = 0; i < bytes; ++i)
        result.push_back(static_cast<char>(value >> (8 * i)));
    return result;
}

uint32_t checksumOf(const std::string& text)
{
    uint32_t crc = 0xffffffff;
    for (const char c : text)
    {
        crc ^= static_cast<unsigned char>(c);
        for (int k = 0; k < 8; ++k)
            crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320 : 0);
    }
    return ~crc;
}

/// A gzip file of the text in blocks that are stored as they are.
std::string stored(const std::string& text)
{
    const size_t longest = 65535;
    std::string packed("\x1f\x8b\x08\0\0\0\0\0\0\x03", HEADER);
    size_t begin = 0;
    do
    {
        const std::string block = text.substr(begin, longest);
        begin += block.size();
        packed += begin == text.size() ? '\1' : '\0';
        packed += littleEndian(static_cast<uint32_t>(block.size()), 2) +
                  littleEndian(~static_cast<uint32_t>(block.size()), 2) + block;
    } while (begin < text.size());
    return packed + littleEndian(checksumOf(text), 4) + littleEndian(static_cast<uint32_t>(text.size()), 4);
}

/// "mesh mesh mesh mesh: 1, 2, 3\n" in the code that RFC 1951 fixes.
std::string fixedCode()
{
    const unsigned char bytes[] = {0x1f, 0x8b, 0x08, 0x00, 0x00, 0x00, 0x00, 0x00, 0x02, 0x03, 0xcb, 0x4d, 0x2d,
                                   0xce, 0x50, 0xc8, 0x45, 0x21, 0xac, 0x14, 0x0c, 0x75, 0x14, 0x8c, 0x74, 0x14,
                                   0x8c, 0xb9, 0x00, 0x9a, 0x4d, 0xfa, 0x5d, 0x1d, 0x00, 0x00, 0x00};
    return std::string(bytes, bytes + sizeof(bytes));
}

/// A model, as cv::FileStorage writes it under a name that ends like this.
std::string modelFile(const char* ending)
{
    const std::string path = cv::tempfile(ending);
    std::vector<gcpw::Alignment::Image> images(2);
    RNG rng(7);
    for (gcpw::Alignment::Image& image : images)
    {
        image.full_size = image.work_size = Size(320, 240);
        image.mesh.create(4, 4, CV_64FC2);
        rng.fill(image.mesh, RNG::UNIFORM, 0, 300);
        image.rough = image.mesh;
        image.color.create(3, 3, CV_32FC(6));
        Mat channels = image.color.reshape(1);
        rng.fill(channels, RNG::UNIFORM, 0, 1);
    }
    gcpw::Alignment(images, Size2d(1, 1), gcpw::Report()).save(path);
    const std::string content = contentOf(path);
    std::remove(path.c_str());
    return content;
}

void expectModelRefused(const char* ending, const std::string& content, const std::string& part)
{
    const std::string path = cv::tempfile(ending);
    std::ofstream(path, std::ios::binary) << content;
    expectRefused([&] { gcpw::Alignment::load(path); }, part);
    expectRefused([&] { gcpw::Alignment::load(path); }, path);
    std::remove(path.c_str());
}

TEST(Gcpw_Gzip, unpacks_blocks_of_every_kind)
{
    EXPECT_EQ(gunzipOf(fixedCode()), "mesh mesh mesh mesh: 1, 2, 3\n");
    const std::string plain = modelFile(".yml");
    const std::string packed = modelFile(".yml.gz");
    ASSERT_LT(2 * packed.size(), plain.size()) << "nothing is compressed";
    EXPECT_EQ(gunzipOf(packed), plain);
    const std::string long_text = plain + std::string(200000, 'x');
    EXPECT_EQ(gunzipOf(stored(long_text)), long_text);
    EXPECT_EQ(gunzipOf(stored("")), "");
}

TEST(Gcpw_Gzip, passes_over_a_name_and_a_comment)
{
    std::string packed = stored("text");
    packed[3] = 4 + 8 + 16;
    EXPECT_EQ(gunzipOf(packed.substr(0, HEADER) + std::string("\3\0abcname\0comment\0", 18) + packed.substr(HEADER)),
              "text");
}

TEST(Gcpw_Gzip, refuses_a_file_that_is_cut_anywhere)
{
    for (const std::string& whole : {fixedCode(), modelFile(".json.gz"), stored("text")})
        for (size_t length = 0; length < whole.size(); ++length)
            expectRefused([&] { gunzipOf(whole.substr(0, length)); }, "cut short");
}

TEST(Gcpw_Gzip, a_changed_byte_is_refused_or_changes_nothing)
{
    for (const std::string& whole : {fixedCode(), modelFile(".yml.gz"), stored("text")})
    {
        const std::string text = gunzipOf(whole);
        for (size_t at = HEADER; at < whole.size(); ++at)
        {
            std::string changed = whole;
            changed[at] = static_cast<char>(changed[at] ^ (1 << (at % 8)));
            std::string other;
            // Of a repetition that stands twice before, either may be taken.
            const bool taken = refusalOf([&] { other = gunzipOf(changed); }).empty();
            EXPECT_TRUE(!taken || other == text) << at;
        }
    }
    EXPECT_NE(refusalOf([&] { gunzipOf(stored("text") + "x"); }), "") << "something follows";
}

TEST(Gcpw_Gzip, unpacks_no_more_than_is_allowed)
{
    const std::string text(1000, 'x');
    EXPECT_EQ(gunzipOf(stored(text), 1000), text);
    expectRefused([&] { gunzipOf(stored(text), 999); }, "more than 999 bytes");
    expectRefused([&] { gunzipOf(fixedCode(), 20); }, "more than 20 bytes");
}

TEST(Gcpw_Gzip, a_compressed_model_is_looked_at_before_it_is_parsed)
{
    const std::string brackets(300000, '[');
    std::string tags;
    for (int i = 0; i < 300000; ++i)
        tags += "<a>";
    expectModelRefused(".yml.gz", stored("%YAML:1.0\n---\nx: " + brackets), "deeper");
    expectModelRefused(".json.gz", stored("{ \"x\": " + brackets), "deeper");
    expectModelRefused(".xml.gz", stored("<?xml version=\"1.0\"?>\n<opencv_storage>\n" + tags), "deeper");
    expectModelRefused(".xml.gz", stored("<?xml version=\"1.0\"?>\n<opencv_storage>\n<images"), "inside a tag");
}

TEST(Gcpw_Gzip, a_compressed_model_that_is_cut_anywhere_is_refused)
{
    const std::string whole = modelFile(".xml.gz");
    for (size_t length = 2; length < whole.size(); length += 17) // two bytes tell that it is compressed
        expectModelRefused(".xml.gz", whole.substr(0, length), "cut short");
    const std::string path = cv::tempfile(".xml.gz");
    std::ofstream(path, std::ios::binary) << whole;
    EXPECT_EQ(gcpw::Alignment::load(path).imageCount(), 2);
    std::remove(path.c_str());
}

} // namespace
} // namespace opencv_test
