// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/join_parts.hpp"

#include <algorithm>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <tiffio.h>
#include "common/deep_zoom.hpp"
#include "common/exit_code.hpp"
#include "common/held_signals.hpp"
#include "common/paths.hpp"
#include "common/tiled_tiff.hpp"

namespace
{

const int TILE = TiledTiff::TILE;
const char* const DESCRIPTION = "gcpw_stitch --tiles: rows %d to %d of a picture of %d x %d px";

/// A file with some rows of tiles.
class Part
{
public:
    explicit Part(const std::string& path) : path_(path), tiff_(TIFFOpen(path.c_str(), "r"), TIFFClose)
    {
        if (!tiff_)
            throw FileTrouble("cannot read " + shortened(path) + ": it is no TIFF file, or not there");
        const char* text = nullptr;
        int first = 0;
        int last = 0;
        if (TIFFGetField(tiff_.get(), TIFFTAG_IMAGEDESCRIPTION, &text) != 1 ||
            std::sscanf(text, DESCRIPTION, &first, &last, &picture.width, &picture.height) != 4)
            throw WrongUse(shortened(path) +
                           " is no part of a picture: --join takes the files that --tiles has written");
        rows = cv::Range(first - 1, last);
        uint16_t bits = 0;
        uint16_t compression_tag = 0;
        TIFFGetField(tiff_.get(), TIFFTAG_BITSPERSAMPLE, &bits);
        TIFFGetField(tiff_.get(), TIFFTAG_COMPRESSION, &compression_tag);
        type = bits == 16 ? CV_16UC3 : CV_8UC3;
        compression = compression_tag == COMPRESSION_NONE  ? "none"
                      : compression_tag == COMPRESSION_LZW ? "lzw"
                                                           : "deflate";
        uint32_t size = 0;
        const uchar* data = nullptr;
        if (TIFFGetField(tiff_.get(), TIFFTAG_ICCPROFILE, &size, &data) == 1)
            profile.assign(data, data + size);
    }

    uint32_t tiles() const { return TIFFNumberOfTiles(tiff_.get()); }

    std::vector<uchar> encoded(uint32_t index) const
    {
        const uint64_t* sizes = nullptr;
        TIFFGetField(tiff_.get(), TIFFTAG_TILEBYTECOUNTS, &sizes);
        std::vector<uchar> data(sizes ? static_cast<size_t>(sizes[index]) : 0);
        const auto size = static_cast<tmsize_t>(data.size());
        if (size == 0 || TIFFReadRawTile(tiff_.get(), index, data.data(), size) != size)
            damaged();
        return data;
    }

    /// One row of tiles. @param index of the part's own, from 0 on  @param height px of it that are in the picture
    cv::Mat rowOfTiles(int index, int height) const
    {
        const int columns = (picture.width + TILE - 1) / TILE;
        cv::Mat row(TILE, columns * TILE, type);
        cv::Mat tile(TILE, TILE, type);
        const auto size = static_cast<tmsize_t>(tile.total() * tile.elemSize());
        for (int column = 0; column < columns; ++column)
        {
            if (TIFFReadEncodedTile(tiff_.get(), static_cast<uint32_t>(index * columns + column), tile.data, size) !=
                size)
                damaged();
            cv::Mat place = row.colRange(column * TILE, (column + 1) * TILE);
            cv::cvtColor(tile, place, cv::COLOR_RGB2BGR);
        }
        return row(cv::Rect(0, 0, picture.width, height));
    }

    cv::Range rows; ///< of tiles
    cv::Size picture;
    int type = 0;
    std::string compression;
    std::vector<uchar> profile;

private:
    [[noreturn]] void damaged() const
    {
        throw FileTrouble("cannot read " + shortened(path_) + ": it is cut short or damaged; make it anew");
    }

    std::string path_;
    std::unique_ptr<TIFF, void (*)(TIFF*)> tiff_;
};

/// Throws WrongUse unless the parts, in their order, make one picture.
void checkParts(const std::vector<std::unique_ptr<Part>>& parts)
{
    const Part& first = *parts.front();
    int next = 0;
    for (const auto& part : parts)
    {
        if (part->picture != first.picture || part->type != first.type || part->compression != first.compression)
            throw WrongUse("the parts are of different pictures; give those of one");
        if (part->rows.start != next)
            throw WrongUse(cv::format("rows of tiles %d to %d are %s; give each part once",
                                      std::min(part->rows.start, next) + 1, std::max(part->rows.start, next),
                                      part->rows.start > next ? "missing" : "there twice"));
        next = part->rows.end;
    }
    const int all = (first.picture.height + TILE - 1) / TILE;
    if (next != all)
        throw WrongUse(cv::format("rows of tiles %d to %d are missing; give all parts", next + 1, all));
}

} // namespace

std::string describePart(cv::Range tile_rows, cv::Size picture)
{
    return cv::format(DESCRIPTION, tile_rows.start + 1, tile_rows.end, picture.width, picture.height);
}

void joinParts(const StitchJob& job, const Console& console)
{
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
    std::vector<std::unique_ptr<Part>> parts;
    for (const std::string& path : job.paths)
        parts.push_back(std::make_unique<Part>(path));
    std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a->rows.start < b->rows.start; });
    checkParts(parts);
    const Part& first = *parts.front();
    const cv::Size size = first.picture;
    const HeldSignals signals;
    if (endingOf(job.output) == ".dzi")
    {
        DeepZoom zoom(job.output, size, job.format.quality);
        for (const auto& part : parts)
            for (int row = part->rows.start; row < part->rows.end && !signals.asked(); ++row)
                zoom.add(part->rowOfTiles(row - part->rows.start, std::min(TILE, size.height - row * TILE)));
        if (signals.asked())
            return;
        zoom.finish();
    }
    else
    {
        PictureFormat format;
        format.compression = first.compression;
        TiledTiff tiff(job.output, size, first.type, format, first.profile);
        for (const auto& part : parts)
            for (uint32_t tile = 0; tile < part->tiles() && !signals.asked(); ++tile)
                tiff.addTile(part->encoded(tile));
        if (signals.asked())
            return;
        tiff.finish();
    }
    console.tell(cv::format("%s: %d x %d of %zu parts", job.output.c_str(), size.width, size.height, parts.size()));
}
