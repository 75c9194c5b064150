// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/json.hpp"

#include <cmath>
#include <cstdio>

namespace
{

std::string quoted(const std::string& text)
{
    std::string result = "\"";
    for (const char c : text)
    {
        if (c == '"' || c == '\\')
            result += std::string("\\") + c;
        else if (static_cast<unsigned char>(c) < 0x20)
        {
            char code[8];
            std::snprintf(code, sizeof(code), "\\u%04x", static_cast<unsigned>(c));
            result += code;
        }
        else
            result += c;
    }
    return result + "\"";
}

} // namespace

void Json::startValue(const std::string& key)
{
    if (!empty_.empty())
    {
        text_ += empty_.back() ? "\n" : ",\n";
        empty_.back() = false;
        text_ += std::string(2 * empty_.size(), ' ');
    }
    if (!key.empty())
        text_ += quoted(key) + ": ";
}

void Json::open(const std::string& key, char bracket)
{
    startValue(key);
    text_ += bracket;
    empty_.push_back(true);
}

void Json::close(char bracket)
{
    const bool empty = empty_.back();
    empty_.pop_back();
    if (!empty)
        text_ += "\n" + std::string(2 * empty_.size(), ' ');
    text_ += bracket;
    if (empty_.empty())
        text_ += "\n";
}

Json& Json::beginObject(const std::string& key)
{
    open(key, '{');
    return *this;
}

Json& Json::endObject()
{
    close('}');
    return *this;
}

Json& Json::beginArray(const std::string& key)
{
    open(key, '[');
    return *this;
}

Json& Json::endArray()
{
    close(']');
    return *this;
}

Json& Json::add(const std::string& key, const std::string& text)
{
    startValue(key);
    text_ += quoted(text);
    return *this;
}

Json& Json::add(const std::string& key, const char* text)
{
    return add(key, std::string(text));
}

Json& Json::add(const std::string& key, double number)
{
    startValue(key);
    char digits[32];
    std::snprintf(digits, sizeof(digits), "%.9g", number);
    text_ += std::isfinite(number) ? digits : "null";
    return *this;
}

Json& Json::add(const std::string& key, int number)
{
    startValue(key);
    text_ += std::to_string(number);
    return *this;
}

Json& Json::add(const std::string& key, bool value)
{
    startValue(key);
    text_ += value ? "true" : "false";
    return *this;
}
