// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "api/model_text.hpp"

#include <algorithm>
#include <opencv2/core.hpp>

namespace cv
{
namespace gcpw
{

namespace
{

const int MAX_DEPTH = 1000; ///< a model's is below 10; OpenCV's parsers overflow a stack of 8 MB at some ten thousand

/// Follows how deep a text nests.
class Nesting
{
public:
    void add(char c)
    {
        countIndentation(c);
        countBrackets(c);
        countTags(c);
        deepest_ = std::max({deepest_, indentation_, brackets_, tags_});
        last_ = c;
    }
    int deepest() const { return deepest_; }

private:
    void countIndentation(char c)
    {
        at_start_ = c == '\n' || (at_start_ && c == ' ');
        indentation_ = at_start_ && c == ' ' ? indentation_ + 1 : 0;
    }

    /// A bracket that closes counts outside strings only: too many are better than too few.
    void countBrackets(char c)
    {
        if (c == '\n')
            quote_ = 0;
        else if (quote_ == 0 && (c == '"' || c == '\''))
            quote_ = c;
        else if (c == quote_ && last_ != '\\')
            quote_ = 0;
        if (c == '[' || c == '{')
            ++brackets_;
        else if ((c == ']' || c == '}') && quote_ == 0)
            brackets_ = std::max(0, brackets_ - 1);
    }

    /// Of <a> one begins, of </a> one ends, of <a/> both, of <?..> and <!..> neither.
    void countTags(char c)
    {
        if (last_ == '<' && c != '/' && c != '?' && c != '!')
            ++tags_;
        else if ((last_ == '<' && c == '/') || (last_ == '/' && c == '>'))
            tags_ = std::max(0, tags_ - 1);
    }

    int deepest_ = 0;
    int indentation_ = 0;
    int brackets_ = 0;
    int tags_ = 0;
    bool at_start_ = true; ///< of a line
    char quote_ = 0;       ///< that of the string that c lies in
    char last_ = 0;
};

} // namespace

std::string textFault(std::istream& text)
{
    Nesting nesting;
    char first = 0;
    char last = 0;
    char c = 0;
    while (text.get(c))
    {
        nesting.add(c);
        if (nesting.deepest() > MAX_DEPTH)
            return format("it nests deeper than %d", MAX_DEPTH);
        if (static_cast<unsigned char>(c) <= ' ')
            continue;
        first = first == 0 ? c : first;
        last = c;
    }
    return first == '<' && last != '>' ? "it ends inside a tag" : "";
}

} // namespace gcpw
} // namespace cv
