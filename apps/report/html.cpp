// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "report/html.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <opencv2/imgcodecs.hpp>

namespace report
{

namespace
{

const int BEST_QUALITY = 88;
const int LEAST_QUALITY = 40;
const int QUALITY_STEP = 6;

/// Bytes of the UTF-8 character that begins here, 0 if none does.
size_t lengthOfCharacter(const std::string& text, size_t at)
{
    const auto byte = [&](size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U; };
    const unsigned first = byte(at);
    const size_t length = first < 0x80                    ? 1
                          : first >= 0xC2 && first < 0xE0 ? 2
                          : first >= 0xE0 && first < 0xF0 ? 3
                          : first >= 0xF0 && first < 0xF5 ? 4
                                                          : 0;
    for (size_t k = 1; k < length; ++k)
        if ((byte(at + k) & 0xC0) != 0x80)
            return 0;
    return length;
}

} // namespace

std::string escaped(const std::string& text)
{
    static const std::map<char, std::string> NAMED = {
        {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
    std::string result;
    for (size_t at = 0; at < text.size();)
    {
        const size_t length = lengthOfCharacter(text, at);
        const auto named = NAMED.find(text[at]);
        if (length == 0 || (static_cast<unsigned char>(text[at]) < 0x20 && text[at] != '\n' && text[at] != '\t'))
            result += '?';
        else
            result += named == NAMED.end() ? text.substr(at, length) : named->second;
        at += std::max<size_t>(length, 1);
    }
    return result;
}

std::string numberOrDash(double value, const char* form)
{
    return std::isfinite(value) ? cv::format(form, value) : std::string("&ndash;");
}

std::string change(double value)
{
    return std::abs(value) < 0.05 ? "0.0" : numberOrDash(value, "%+.1f");
}

std::string filled(const std::string& page, const std::map<std::string, std::string>& values)
{
    std::string result;
    std::set<std::string> used;
    size_t from = 0;
    for (size_t open = page.find("{{"); open != std::string::npos; open = page.find("{{", from))
    {
        const size_t close = page.find("}}", open);
        const std::string name = page.substr(open + 2, close == std::string::npos ? close : close - open - 2);
        const auto value = values.find(name);
        if (close == std::string::npos || value == values.end())
            CV_Error(cv::Error::StsObjectNotFound, "the page asks for '" + name + "', which nobody fills in");
        result += page.substr(from, open - from) + value->second;
        used.insert(name);
        from = close + 2;
    }
    for (const auto& value : values)
        if (!used.count(value.first))
            CV_Error(cv::Error::StsObjectNotFound, "the page has no place for '" + value.first + "'");
    return result + page.substr(from);
}

std::string base64(const std::vector<uchar>& bytes)
{
    static const char* const DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve(bytes.size() / 3 * 4 + 4);
    for (size_t i = 0; i < bytes.size(); i += 3)
    {
        const size_t count = std::min<size_t>(3, bytes.size() - i);
        unsigned bits = 0;
        for (size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (k < count ? bytes[i + k] : 0U);
        for (size_t k = 0; k < 4; ++k)
            text += k <= count ? DIGITS[bits >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

DataUri jpegUri(const cv::Mat& picture, int kilobytes)
{
    std::vector<uchar> bytes;
    DataUri uri;
    for (uri.quality = BEST_QUALITY;; uri.quality = std::max(uri.quality - QUALITY_STEP, LEAST_QUALITY))
    {
        cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, uri.quality, cv::IMWRITE_JPEG_OPTIMIZE, 1});
        if (bytes.size() <= 1000 * static_cast<size_t>(kilobytes) || uri.quality == LEAST_QUALITY)
            break;
    }
    uri.text = "data:image/jpeg;base64," + base64(bytes);
    return uri;
}

std::string Table::html() const
{
    const auto classOf = [&](size_t column) {
        return column < classes.size() && !classes[column].empty() ? " class=\"" + classes[column] + "\""
                                                                   : std::string();
    };
    std::string text = "<div class=\"scroll\" tabindex=\"0\"><table>\n<thead><tr>";
    for (size_t k = 0; k < heads.size(); ++k)
        text += "<th scope=\"col\"" + classOf(k) + ">" + heads[k] + "</th>";
    text += "</tr></thead>\n<tbody>\n";
    for (const std::vector<std::string>& row : rows)
    {
        text += "<tr>";
        for (size_t k = 0; k < row.size(); ++k)
            text += "<td" + classOf(k) + ">" + row[k] + "</td>";
        text += "</tr>\n";
    }
    return text + "</tbody>\n</table></div>\n";
}

} // namespace report
