// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/tile_rows.hpp"

#include <algorithm>
#include <regex>
#include "common/exit_code.hpp"

TileRows::TileRows(const std::string& text) : text_(text)
{
    std::smatch found;
    const std::regex form("([0-9]{1,6})([-/])([0-9]{1,6})");
    const bool matches = std::regex_match(text, found, form);
    if (matches)
    {
        first_ = std::stoi(found[1]);
        second_ = std::stoi(found[3]);
        is_share_ = found[2] == "/";
    }
    if (!matches || first_ < 1 || second_ < first_)
        throw WrongUse("--tiles is a range of rows of tiles, 1-8, or a share of them, 2/4; got " + text);
}

cv::Range TileRows::in(int count) const
{
    cv::Range rows(first_ - 1, std::min(second_, count));
    if (is_share_)
    {
        const auto start = [&](int share) { return static_cast<int>(static_cast<int64>(count) * share / second_); };
        rows = cv::Range(start(first_ - 1), start(first_));
    }
    if (rows.end <= rows.start)
        throw WrongUse(cv::format("--tiles=%s: the picture has %d rows of tiles", text_.c_str(), count));
    return rows;
}
