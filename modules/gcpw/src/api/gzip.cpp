// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "api/gzip.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

[[noreturn]] void damaged(const char* what)
{
    CV_Error(Error::StsParseError, format("the compressed data are damaged: %s", what));
}

/// The bytes of a stream, also bit by bit: the lowest bit of a byte comes first.
class BitReader
{
public:
    explicit BitReader(std::istream& stream) : stream_(stream) {}

    int byte()
    {
        const int value = stream_.get();
        if (!stream_)
            CV_Error(Error::StsParseError, "the compressed data are cut short");
        return value;
    }
    unsigned bit()
    {
        if (left_ == 0)
        {
            rest_ = static_cast<unsigned>(byte());
            left_ = 8;
        }
        const unsigned value = rest_ & 1U;
        rest_ >>= 1;
        --left_;
        return value;
    }
    /// A number whose lowest bit comes first.
    unsigned bits(int count)
    {
        unsigned value = 0;
        for (int i = 0; i < count; ++i)
            value |= bit() << i;
        return value;
    }
    /// A number of whole bytes, the lowest first; what is left of the byte before is passed over.
    uint32_t number(int bytes)
    {
        left_ = 0;
        uint32_t value = 0;
        for (int i = 0; i < bytes; ++i)
            value |= static_cast<uint32_t>(byte()) << (8 * i);
        return value;
    }
    bool atEnd() { return stream_.peek() == std::istream::traits_type::eof(); }

private:
    std::istream& stream_;
    unsigned rest_ = 0;
    int left_ = 0;
};

const int LONGEST_CODE = 15; ///< bits of a Huffman code (RFC 1951, 3.2.7)

/// A canonical Huffman code: of two symbols the one with fewer bits, then the smaller one, has the smaller code.
class HuffmanCode
{
public:
    /// @param lengths bits of each symbol's code; 0 for a symbol that does not occur  @param single a lone code of 1 bit is allowed
    HuffmanCode(const std::vector<int>& lengths, bool single)
    {
        for (const int length : lengths)
            ++count_[static_cast<size_t>(length)];
        const int used = static_cast<int>(lengths.size()) - count_[0];
        int free = 1; // codes of the length that are not yet taken
        for (size_t length = 1; length <= LONGEST_CODE; ++length)
            free = 2 * free - count_[length];
        const bool lone = single && (used == 0 || (used == 1 && count_[1] == 1));
        if (free != 0 && !lone)
            damaged("a code is incomplete or ambiguous");
        for (int length = 1; length <= LONGEST_CODE; ++length)
            for (size_t symbol = 0; symbol < lengths.size(); ++symbol)
                if (lengths[symbol] == length)
                    symbols_.push_back(static_cast<int>(symbol));
    }

    int read(BitReader& reader) const
    {
        int code = 0;
        int first = 0; // code of this length
        int index = 0; // of its symbol
        for (size_t length = 1; length <= LONGEST_CODE; ++length)
        {
            code |= static_cast<int>(reader.bit());
            if (code - first < count_[length])
                return symbols_[static_cast<size_t>(index + code - first)];
            index += count_[length];
            first = 2 * (first + count_[length]);
            code *= 2;
        }
        damaged("there is a code without a symbol");
    }

private:
    std::array<int, LONGEST_CODE + 1> count_{}; ///< codes of each length
    std::vector<int> symbols_;                  ///< in the order of their codes
};

/// The text as it grows.
class Text
{
public:
    explicit Text(size_t most) : most_(most) {}

    void add(int byte)
    {
        if (text_.size() >= most_)
            CV_Error(Error::StsParseError, format("it unpacks to more than %zu bytes", most_));
        text_.push_back(static_cast<char>(byte));
    }
    /// Repeats what stands `distance` bytes before the end.
    void repeat(int length, size_t distance)
    {
        if (distance > text_.size())
            damaged("a distance leads before the beginning");
        for (int i = 0; i < length; ++i)
            add(text_[text_.size() - distance]);
    }
    std::string take() { return std::move(text_); }
    const std::string& text() const { return text_; }

private:
    std::string text_;
    size_t most_;
};

const int END_OF_BLOCK = 256;
const int FIRST_LENGTH = 257;

/// Lengths and distances are a base and further bits (RFC 1951, 3.2.5).
const int LENGTH_BASE[] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                           31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
const int LENGTH_BITS[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
const int DISTANCE_BASE[] = {1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
                             193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
const int DISTANCE_BITS[] = {0, 0, 0, 0, 1, 1, 2, 2,  3,  3,  4,  4,  5,  5,  6,
                             6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13};
const int LENGTHS = 29;
const int DISTANCES = 30;

void readSymbols(BitReader& reader, const HuffmanCode& literals, const HuffmanCode& distances, Text& text)
{
    for (;;)
    {
        const int symbol = literals.read(reader);
        if (symbol < END_OF_BLOCK)
            text.add(symbol);
        else if (symbol == END_OF_BLOCK)
            return;
        else
        {
            const int k = symbol - FIRST_LENGTH;
            if (k >= LENGTHS)
                damaged("there is no such length");
            const int length = LENGTH_BASE[k] + static_cast<int>(reader.bits(LENGTH_BITS[k]));
            const int d = distances.read(reader);
            if (d >= DISTANCES)
                damaged("there is no such distance");
            text.repeat(length, static_cast<size_t>(DISTANCE_BASE[d]) + reader.bits(DISTANCE_BITS[d]));
        }
    }
}

void readStored(BitReader& reader, Text& text)
{
    const uint32_t length = reader.number(2);
    if (reader.number(2) != (length ^ 0xffffU))
        damaged("a length disagrees with its complement");
    for (uint32_t i = 0; i < length; ++i)
        text.add(reader.byte());
}

void readFixed(BitReader& reader, Text& text)
{
    std::vector<int> lengths(288, 8); // RFC 1951, 3.2.6
    std::fill(lengths.begin() + 144, lengths.begin() + 256, 9);
    std::fill(lengths.begin() + 256, lengths.begin() + 280, 7);
    readSymbols(reader, HuffmanCode(lengths, false), HuffmanCode(std::vector<int>(32, 5), false), text);
}

/// The lengths of `count` codes, which are themselves coded.
std::vector<int> readLengths(BitReader& reader, const HuffmanCode& code, size_t count)
{
    const int repeat_last = 16;
    const int short_gap = 17;
    std::vector<int> lengths;
    while (lengths.size() < count)
    {
        const int symbol = code.read(reader);
        if (symbol < repeat_last)
        {
            lengths.push_back(symbol);
            continue;
        }
        if (symbol == repeat_last && lengths.empty())
            damaged("there is no length to repeat");
        const int value = symbol == repeat_last ? lengths.back() : 0;
        const unsigned times = symbol == repeat_last ? 3 + reader.bits(2)
                               : symbol == short_gap ? 3 + reader.bits(3)
                                                     : 11 + reader.bits(7);
        lengths.insert(lengths.end(), times, value);
    }
    if (lengths.size() > count)
        damaged("there are too many lengths");
    return lengths;
}

void readDynamic(BitReader& reader, Text& text)
{
    const size_t literals = 257 + reader.bits(5);
    const size_t distances = 1 + reader.bits(5);
    const size_t code_lengths = 4 + reader.bits(4);
    if (literals > FIRST_LENGTH + LENGTHS || distances > DISTANCES)
        damaged("there are too many symbols");
    const size_t order[] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15}; // RFC 1951, 3.2.7
    std::vector<int> of_lengths(19, 0);
    for (size_t i = 0; i < code_lengths; ++i)
        of_lengths[order[i]] = static_cast<int>(reader.bits(3));
    const std::vector<int> lengths = readLengths(reader, HuffmanCode(of_lengths, false), literals + distances);
    if (lengths[END_OF_BLOCK] == 0)
        damaged("a block has no end");
    const auto border = lengths.begin() + static_cast<std::ptrdiff_t>(literals);
    readSymbols(reader, HuffmanCode({lengths.begin(), border}, true), HuffmanCode({border, lengths.end()}, true), text);
}

void readHeader(BitReader& reader)
{
    enum Flag
    {
        CHECKSUM = 2,
        EXTRA = 4,
        NAME = 8,
        COMMENT = 16,
        KNOWN = 31
    };
    if (reader.byte() != 0x1f || reader.byte() != 0x8b || reader.byte() != 8)
        damaged("it is no gzip file");
    const int flags = reader.byte();
    if (flags & ~KNOWN || flags & CHECKSUM) // nothing writes a header's checksum
        damaged("its header has unknown flags");
    reader.number(4); // time, which says nothing,
    reader.number(2); // like effort and system
    if (flags & EXTRA)
        for (uint32_t left = reader.number(2); left > 0; --left)
            reader.byte();
    for (const int name : {NAME, COMMENT})
        while (flags & name && reader.byte() != 0)
            ;
}

/// The checksum of RFC 1952, 8.
uint32_t crc32(const std::string& text)
{
    const uint32_t polynomial = 0xedb88320;
    std::array<uint32_t, 256> table{};
    for (uint32_t n = 0; n < 256; ++n)
    {
        table[n] = n;
        for (int k = 0; k < 8; ++k)
            table[n] = table[n] & 1U ? polynomial ^ (table[n] >> 1) : table[n] >> 1;
    }
    uint32_t crc = 0xffffffff;
    for (const char c : text)
        crc = table[(crc ^ static_cast<unsigned char>(c)) & 0xffU] ^ (crc >> 8);
    return ~crc;
}

} // namespace

std::string gunzip(std::istream& packed, size_t most)
{
    BitReader reader(packed);
    readHeader(reader);
    Text text(most);
    bool last = false;
    while (!last)
    {
        last = reader.bit() == 1;
        switch (reader.bits(2))
        {
        case 0:
            readStored(reader, text);
            break;
        case 1:
            readFixed(reader, text);
            break;
        case 2:
            readDynamic(reader, text);
            break;
        default:
            damaged("there is no such block");
        }
    }
    const uint32_t checksum = reader.number(4);
    const uint32_t length = reader.number(4);
    if (checksum != crc32(text.text()) || length != static_cast<uint32_t>(text.text().size()))
        damaged("the checksum disagrees");
    if (!reader.atEnd())
        damaged("something stands behind their end");
    return text.take();
}

} // namespace gcpw
} // namespace cv
