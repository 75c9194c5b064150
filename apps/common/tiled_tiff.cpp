// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/tiled_tiff.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <tiffio.h>
#include "common/exit_code.hpp"
#include "common/paths.hpp"

namespace
{

const double MOST_OF_CLASSIC = 4e9; ///< bytes: offsets of TIFF have 32 bits, and headers need some

int compressionOf(const PictureFormat& format)
{
    if (format.compression == "none")
        return COMPRESSION_NONE;
    return format.compression == "lzw" ? COMPRESSION_LZW : COMPRESSION_ADOBE_DEFLATE;
}

[[noreturn]] void fail(const std::string& path)
{
    throw FileTrouble("cannot write " + shortened(path) +
                      ": the disk is full or the file is too large; make room or choose another place");
}

} // namespace

struct TiledTiff::File
{
    TIFF* tiff = nullptr;
    ~File()
    {
        if (tiff)
            TIFFClose(tiff);
    }
};

TiledTiff::TiledTiff(const std::string& path, cv::Size size, int type, const PictureFormat& format,
                     const std::vector<uchar>& profile, const std::string& description)
    : path_(path), size_(size), partial_(path), file_(new File)
{
    TIFFSetErrorHandler(nullptr); // it is told in words of our own
    TIFFSetWarningHandler(nullptr);
    const int bytes = CV_ELEM_SIZE1(type);
    const double raw = 3.0 * bytes * size.width * size.height;
    file_->tiff = TIFFOpen(partial_.name().c_str(), raw > MOST_OF_CLASSIC ? "w8" : "w");
    if (!file_->tiff)
        fail(path);
    TIFF* const tiff = file_->tiff;
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<uint32_t>(size.width));
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<uint32_t>(size.height));
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, static_cast<uint32_t>(TILE));
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, static_cast<uint32_t>(TILE));
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8 * bytes);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 3);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    const int compression = compressionOf(format);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, compression);
    if (compression != COMPRESSION_NONE)
        TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
    if (!description.empty())
        TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, description.c_str());
    if (!profile.empty())
        TIFFSetField(tiff, TIFFTAG_ICCPROFILE, static_cast<uint32_t>(profile.size()), profile.data());
    waiting_ = cv::Mat(TILE, (size.width + TILE - 1) / TILE * TILE, type, cv::Scalar::all(0));
}

TiledTiff::~TiledTiff() = default;

void TiledTiff::add(const cv::Mat& rows)
{
    CV_Assert(rows.type() == waiting_.type() && rows.cols == size_.width);
    for (int y = 0; y < rows.rows;)
    {
        const int count = std::min(rows.rows - y, TILE - filled_);
        cv::Mat place = waiting_(cv::Rect(0, filled_, size_.width, count));
        cv::cvtColor(rows.rowRange(y, y + count), place, cv::COLOR_BGR2RGB);
        y += count;
        filled_ += count;
        if (filled_ == TILE)
            writeRowOfTiles();
    }
}

void TiledTiff::writeRowOfTiles()
{
    waiting_.rowRange(filled_, TILE).setTo(cv::Scalar::all(0));
    cv::Mat tile(TILE, TILE, waiting_.type());
    for (int x = 0; x < waiting_.cols; x += TILE, ++written_)
    {
        waiting_.colRange(x, x + TILE).copyTo(tile);
        const auto size = static_cast<tmsize_t>(tile.total() * tile.elemSize());
        if (TIFFWriteEncodedTile(file_->tiff, static_cast<uint32_t>(written_), tile.data, size) != size)
            fail(path_);
    }
    filled_ = 0;
}

void TiledTiff::addTile(const std::vector<uchar>& encoded)
{
    std::vector<uchar> data = encoded; // libtiff may swap its bytes
    const auto size = static_cast<tmsize_t>(data.size());
    if (TIFFWriteRawTile(file_->tiff, static_cast<uint32_t>(written_), data.data(), size) != size)
        fail(path_);
    ++written_;
}

void TiledTiff::finish()
{
    if (filled_ > 0)
        writeRowOfTiles();
    CV_Assert(written_ == (size_.height + TILE - 1) / TILE * (waiting_.cols / TILE));
    const bool whole = TIFFFlush(file_->tiff) == 1;
    file_.reset();
    const std::string reason = whole ? partial_.commit() : "the disk is full; make room or choose another place";
    if (!reason.empty())
        throw FileTrouble("cannot write " + shortened(path_) + ": " + reason);
}
