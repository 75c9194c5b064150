// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_JSON_HPP
#define GCPW_APPS_JSON_HPP

#include <string>
#include <vector>

/** @brief Writes one JSON document, value by value.

cv::FileStorage has no way to say "no number", and writes .Nan where JSON has null. */
class Json
{
public:
    Json& beginObject(const std::string& key = std::string());
    Json& endObject();
    Json& beginArray(const std::string& key);
    Json& endArray();
    Json& add(const std::string& key, const std::string& text);
    Json& add(const std::string& key, const char* text);
    Json& add(const std::string& key, double number); ///< null if not finite
    Json& add(const std::string& key, int number);
    Json& add(const std::string& key, bool value);

    /// The document, once every object and array is closed.
    const std::string& text() const { return text_; }

private:
    void open(const std::string& key, char bracket);
    void close(char bracket);
    void startValue(const std::string& key);

    std::string text_;
    std::vector<bool> empty_; ///< of every open object or array
};

#endif
