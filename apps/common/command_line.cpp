// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/command_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <CLI/CLI.hpp>
#include <opencv2/core.hpp>
#include "common/exit_code.hpp"
#include "common/option_help.hpp"
#include "common/spelling.hpp"

namespace
{

const int MAX_THREADS = 1024; ///< more than any machine has; OpenCV aborts where it cannot start as many as it is told

/// The long name of "-o,--output".
std::string longName(const std::string& names)
{
    return names.substr(names.rfind("--"));
}

double numberOf(const std::string& name, const std::string& text, const Range& range, bool whole)
{
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool is_number = !text.empty() && *end == '\0' && (!whole || value == std::floor(value));
    if (is_number && value >= range.low && value <= range.high)
        return value;
    const std::string unit = *range.unit ? std::string(range.unit) + ", " : std::string();
    const std::string what = unit + (whole ? "a whole number" : "a number") +
                             (std::isinf(range.high) ? cv::format(" of at least %g", range.low)
                                                     : cv::format(" from %.10g to %.10g", range.low, range.high));
    throw WrongUse(name + " is " + what + "; got '" + text + "'");
}

std::string plain(double value)
{
    return cv::format("%g", value);
}

} // namespace

void CommandLine::add(const std::string& names, const std::string& kind, const std::string& preset,
                      const std::string& help, const std::function<void(const std::string&)>& set)
{
    options_.push_back({group_, names, longName(names), kind, preset, help, set});
}

void CommandLine::text(const std::string& names, std::string& value, const std::string& kind, const std::string& help)
{
    add(names, kind, value, help, [&value](const std::string& written) { value = written; });
}

void CommandLine::texts(const std::string& names, std::vector<std::string>& values, const std::string& kind,
                        const std::string& help)
{
    add(names, kind, "", help, [&values](const std::string& written) { values.push_back(written); });
    options_.back().many = true;
}

void CommandLine::flag(const std::string& names, bool& value, const std::string& help)
{
    add(names, "", "", help, [&value](const std::string& written) { value = written != "false"; });
}

void CommandLine::number(const std::string& names, double& value, const Range& range, const std::string& help)
{
    const std::string name = longName(names);
    add(names, "NUMBER", plain(value), help,
        [&value, name, range](const std::string& written) { value = numberOf(name, written, range, false); });
}

void CommandLine::integer(const std::string& names, int& value, const Range& range, const std::string& help)
{
    const std::string name = longName(names);
    add(names, "NUMBER", std::to_string(value), help,
        [&value, name, range](const std::string& written)
        { value = static_cast<int>(numberOf(name, written, range, true)); });
}

void CommandLine::choice(const std::string& names, std::string& value, const std::vector<std::string>& choices,
                         const std::string& help)
{
    const std::string name = longName(names);
    add(names, "NAME", value, help,
        [&value, name, choices](const std::string& written)
        {
        if (std::find(choices.begin(), choices.end(), written) == choices.end())
        {
            const std::string near = nearestWord(written, choices);
            throw WrongUse("there is no " + name + " '" + written + "'" +
                           (near.empty() ? "" : "; did you mean " + near + "?") + " Choose " + listed(choices));
        }
        value = written;
    });
}

void CommandLine::declareCommon()
{
    group("General");
    flag("-f,--force", force, "replace files that exist; without it they are kept, and nothing is done");
    integer("-t,--threads", threads, {-1, MAX_THREADS}, "threads to use; -1 leaves it to OpenCV");
    flag("-q,--quiet", quiet_, "say nothing but warnings and errors");
    flag("-v,--verbose", verbose_, "say more: what was read, how long each stage took, the log of OpenCV");
    flag("-h,--help", help_, "this text");
    flag("-V,--version", version_, "the version");
}

std::vector<std::string> CommandLine::knownNames() const
{
    std::vector<std::string> names;
    for (const Option& option : options_)
        names.push_back(option.name);
    return names;
}

std::vector<std::string> CommandLine::tidied(int argc, const char* const* argv) const
{
    const std::vector<std::string> known = knownNames();
    std::vector<std::string> words;
    for (int i = 1; i < argc; ++i)
    {
        std::string word = argv[i];
        const std::string name = word.substr(0, word.find('='));
        // As cv::CommandLineParser took it; a letter that takes the rest for its value would make a file of that name.
        if (name.size() > 2 && name[0] == '-' && name[1] != '-' &&
            std::find(known.begin(), known.end(), "-" + name) != known.end())
            word = "-" + word;
        if (word == "-?" || word == "--usage")
            word = "--help";
        if (word.size() > 2 && word.compare(0, 2, "--") == 0 && word.back() == '=' && word.find('=') == word.size() - 1)
            throw WrongUse(name + " is given without a value: write " + name + "=VALUE");
        if (word.empty())
            throw WrongUse("an argument is empty: is a variable of the script not set?");
        words.push_back(word);
    }
    return words;
}

CommandLine::Asked CommandLine::parse(int argc, const char* const* argv)
{
    declareCommon();
    CLI::App app;
    app.set_help_flag();
    app.allow_extras();
    std::vector<std::string> arguments;
    app.add_option("arguments", arguments);
    std::map<std::string, std::vector<std::string>> values;
    for (const Option& option : options_)
    {
        const std::string name = option.name;
        if (option.kind.empty())
            app.add_flag_function(option.names, [&values, name](std::int64_t count)
                                  { values[name] = {count > 0 ? "true" : "false"}; });
        else
            app.add_option_function<std::vector<std::string>>(
                   option.names, [&values, name](const std::vector<std::string>& given) { values[name] = given; })
                ->expected(1)
                ->allow_extra_args(false)
                ->multi_option_policy(option.many ? CLI::MultiOptionPolicy::TakeAll : CLI::MultiOptionPolicy::TakeLast);
    }
    std::vector<std::string> words = tidied(argc, argv);
    std::reverse(words.begin(), words.end()); // as CLI11 takes them
    try
    {
        app.parse(words);
    }
    catch (const CLI::ParseError& error)
    {
        throw WrongUse(std::string(error.what()) + "; --help lists the options and what they take");
    }
    for (const std::string& word : app.remaining())
    {
        const std::string near = nearestWord(word.substr(0, word.find('=')), knownNames());
        throw WrongUse("there is no option " + word + (near.empty() ? "" : "; did you mean " + near + "?") +
                       " --help lists them");
    }
    if (!values["--help"].empty())
        return Asked::HELP;
    if (!values["--version"].empty())
        return Asked::VERSION;
    if (arguments_)
        *arguments_ = arguments;
    else if (!arguments.empty())
        throw WrongUse("'" + arguments[0] + "' is not an option, and no other arguments are taken");
    for (const Option& option : options_)
        for (const std::string& value : values[option.name])
        {
            option.set(value);
            given_.insert(option.name);
        }
    return Asked::WORK;
}

std::string CommandLine::help() const
{
    std::string text = texts_.about + "\n\nUsage:\n  " + texts_.usage + "\n";
    if (!texts_.examples.empty())
        text += "\nExamples:\n";
    for (size_t i = 0; i + 1 < texts_.examples.size(); i += 2)
        text += "  " + texts_.examples[i] + "\n      " + texts_.examples[i + 1] + "\n";
    std::string last;
    for (const Option& option : options_)
    {
        if (option.group != last)
            text += "\n" + option.group + ":\n";
        last = option.group;
        text += optionHelp(option.names, option.kind, option.preset, option.help);
    }
    return text;
}

std::string CommandLine::version() const
{
    return texts_.program + " " GCPW_VERSION " with OpenCV " + CV_VERSION + "\n";
}

Console::Loudness CommandLine::loudness() const
{
    return quiet_ ? Console::Loudness::QUIET : verbose_ ? Console::Loudness::VERBOSE : Console::Loudness::NORMAL;
}
