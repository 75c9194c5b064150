// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/deep_zoom.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include "common/deep_zoom_page.hpp"
#include "common/exit_code.hpp"
#include "common/paths.hpp"
#include "common/read_photograph.hpp"

namespace fs = std::filesystem;

namespace
{

const int TILE = 254;  ///< px a side
const int OVERLAP = 1; ///< px of each neighbour: a file has 256 px a side

cv::Mat joined(const cv::Mat& above, const cv::Mat& below)
{
    if (above.empty())
        return below.clone();
    cv::Mat both;
    cv::vconcat(above, below, both);
    return both;
}

/// Means of 2 x 2 px; a last column without a partner counts twice.
cv::Mat halved(const cv::Mat& rows)
{
    cv::Mat even = rows;
    if (rows.cols % 2 == 1)
        cv::copyMakeBorder(rows, even, 0, 0, 0, 1, cv::BORDER_REPLICATE);
    cv::Mat half;
    cv::resize(even, half, cv::Size(even.cols / 2, even.rows / 2), 0, 0, cv::INTER_AREA);
    return half;
}

bool writeWhole(const std::string& path, const void* data, size_t size)
{
    std::ofstream file(path, std::ios::binary);
    file.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
    file.close();
    return file.good();
}

void replaceAll(std::string& text, const std::string& what, const std::string& with)
{
    for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
}

[[noreturn]] void fail(const std::string& path, const std::string& reason)
{
    throw FileTrouble("cannot write " + shortened(path) + ": " + reason);
}

} // namespace

DeepZoomFiles::DeepZoomFiles(const std::string& path) : description(path)
{
    const fs::path name(path);
    const std::string stem = (name.parent_path() / name.stem()).string();
    tiles = stem + "_files";
    page = stem + ".html";
}

DeepZoom::DeepZoom(const std::string& path, cv::Size size, int quality)
    : path_(path), size_(size), quality_(quality), files_(path), description_(files_.description), tiles_(files_.tiles),
      page_(files_.page)
{
    std::vector<Level> upwards;
    cv::Size side = size;
    for (;;)
    {
        Level level;
        level.size = side;
        upwards.push_back(level);
        if (side.width == 1 && side.height == 1)
            break;
        side = cv::Size((side.width + 1) / 2, (side.height + 1) / 2);
    }
    levels_.assign(upwards.rbegin(), upwards.rend());
    std::error_code error;
    for (size_t level = 0; level < levels_.size(); ++level)
        fs::create_directories(fs::path(tiles_.name()) / std::to_string(level), error);
    if (error)
        fail(path, error.message());
}

DeepZoom::~DeepZoom() = default;

void DeepZoom::add(const cv::Mat& rows)
{
    addTo(levels_.size() - 1, toBytes(rows));
}

void DeepZoom::addTo(size_t index, const cv::Mat& rows)
{
    Level& level = levels_[index];
    CV_Assert(rows.type() == CV_8UC3 && rows.cols == level.size.width);
    level.rows = joined(level.rows, rows);
    level.received += rows.rows;
    writeTiles(index);
    if (index == 0)
        return;
    cv::Mat pairs = joined(level.unpaired, rows);
    const bool is_last = level.received == level.size.height;
    if (is_last && pairs.rows % 2 == 1)
        pairs = joined(pairs, pairs.row(pairs.rows - 1));
    const int even = pairs.rows / 2 * 2;
    level.unpaired = pairs.rowRange(even, pairs.rows).clone();
    if (even > 0)
        addTo(index - 1, halved(pairs.rowRange(0, even)));
}

void DeepZoom::writeTiles(size_t index)
{
    Level& level = levels_[index];
    for (;;)
    {
        const int top = std::max(level.tile_row * TILE - OVERLAP, 0);
        const int bottom = std::min((level.tile_row + 1) * TILE + OVERLAP, level.size.height);
        if (level.tile_row * TILE >= level.size.height || level.received < bottom)
            return;
        writeTileRow(index, level.rows.rowRange(top - level.first, bottom - level.first));
        ++level.tile_row;
        const int next = std::min(level.tile_row * TILE - OVERLAP, level.received);
        level.rows = level.rows.rowRange(next - level.first, level.rows.rows).clone();
        level.first = next;
    }
}

void DeepZoom::writeTileRow(size_t index, const cv::Mat& rows) const
{
    const Level& level = levels_[index];
    const int columns = (level.size.width + TILE - 1) / TILE;
    bool whole = true;
    std::mutex mutex;
    cv::parallel_for_(cv::Range(0, columns),
                      [&](const cv::Range& range)
                      {
        for (int column = range.start; column < range.end; ++column)
        {
            const int left = std::max(column * TILE - OVERLAP, 0);
            const int right = std::min((column + 1) * TILE + OVERLAP, level.size.width);
            std::vector<uchar> data;
            cv::imencode(".jpg", rows.colRange(left, right), data, {cv::IMWRITE_JPEG_QUALITY, quality_});
            const std::string name = tiles_.name() + "/" + std::to_string(index) + "/" + std::to_string(column) + "_" +
                                     std::to_string(level.tile_row) + ".jpg";
            const bool written = writeWhole(name, data.data(), data.size());
            const std::lock_guard<std::mutex> lock(mutex);
            whole = whole && written;
        }
    });
    if (!whole)
        fail(path_, "the disk is full; make room or choose another place");
}

std::string DeepZoom::description(cv::Size size)
{
    return cv::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<Image xmlns=\"http://schemas.microsoft.com/deepzoom/2008\" Format=\"jpg\" Overlap=\"%d\" TileSize=\"%d\">\n"
        "  <Size Width=\"%d\" Height=\"%d\"/>\n</Image>\n",
        OVERLAP, TILE, size.width, size.height);
}

std::string DeepZoom::page(const std::string& title, const std::string& tiles, cv::Size size)
{
    const auto quoted = [](const std::string& text)
    {
        std::string result;
        for (const char letter : text)
            if (std::string("<>&\"'\\").find(letter) == std::string::npos)
                result += letter;
            else
                result += cv::format("%%%02X", static_cast<unsigned char>(letter));
        return result;
    };
    std::string text = DEEP_ZOOM_PAGE;
    replaceAll(text, "@WIDTH@", std::to_string(size.width));
    replaceAll(text, "@HEIGHT@", std::to_string(size.height));
    replaceAll(text, "@TILE@", std::to_string(TILE));
    replaceAll(text, "@OVERLAP@", std::to_string(OVERLAP));
    replaceAll(text, "@TILES@", quoted(tiles));
    replaceAll(text, "@TITLE@", quoted(title));
    return text;
}

void DeepZoom::finish()
{
    CV_Assert(levels_.back().received == size_.height);
    const std::string text = description(size_);
    const fs::path tiles(files_.tiles);
    const std::string shown = page(fs::path(path_).stem().string(), tiles.filename().string(), size_);
    if (!writeWhole(description_.name(), text.data(), text.size()) ||
        !writeWhole(page_.name(), shown.data(), shown.size()))
        fail(path_, "the disk is full; make room or choose another place");
    for (PartialFile* const part : {&tiles_, &page_, &description_})
    {
        const std::string reason = part->commit();
        if (!reason.empty())
            fail(path_, reason);
    }
}
