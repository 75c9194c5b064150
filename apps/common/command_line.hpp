// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_COMMAND_LINE_HPP
#define GCPW_APPS_COMMAND_LINE_HPP

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>
#include "common/console.hpp"

/// Numbers that an option takes, both ends included, and what they count.
struct Range
{
    double low;
    double high;
    const char* unit = ""; ///< for the message: "million pixels"
};

/** @brief The options of a program, one parser for all (CLI11).

Every option is written `--name value` or `--name=value`, some also with a letter; the last one counts. Declare them in groups, each
bound to the variable that holds its default; then parse(). All troubles are WrongUse that names the option, the value and what
would be right. */
class CommandLine
{
public:
    struct Texts
    {
        std::string program;
        std::string about;                 ///< what it does, and what each exit code means
        std::string usage;                 ///< "gcpw_pair SOURCE TARGET [options]"
        std::vector<std::string> examples; ///< call, then what it does, in turn
    };

    /// What the caller asks for.
    enum class Asked
    {
        WORK,
        HELP,
        VERSION
    };

    explicit CommandLine(const Texts& texts) : texts_(texts) {}

    /// Heading of the options that follow.
    void group(const std::string& heading) { group_ = heading; }

    /// @param names "-o,--output": a letter, if any, then the name  @param kind what the value is: "FILE"
    void text(const std::string& names, std::string& value, const std::string& kind, const std::string& help);
    void texts(const std::string& names, std::vector<std::string>& values, const std::string& kind,
               const std::string& help);
    void flag(const std::string& names, bool& value, const std::string& help);
    void number(const std::string& names, double& value, const Range& range, const std::string& help);
    void integer(const std::string& names, int& value, const Range& range, const std::string& help);
    void choice(const std::string& names, std::string& value, const std::vector<std::string>& choices,
                const std::string& help);

    /// Arguments that are no options.
    void arguments(std::vector<std::string>& values) { arguments_ = &values; }

    /// @throws WrongUse
    Asked parse(int argc, const char* const* argv);

    /// Whether the caller wrote this option. @param name "--output"
    bool given(const std::string& name) const { return given_.count(name) > 0; }

    std::string help() const;
    std::string version() const;
    const std::string& program() const { return texts_.program; }

    // The options that every program has.
    Console::Loudness loudness() const;
    bool force = false; ///< files that exist may be replaced
    int threads = -1;   ///< -1 leaves it to OpenCV

private:
    struct Option
    {
        std::string group;
        std::string names;
        std::string name;   ///< the long one: "--output"
        std::string kind;   ///< empty for a flag
        std::string preset; ///< the default as text, may be empty
        std::string help;
        std::function<void(const std::string&)> set;
        bool many = false;
    };

    void add(const std::string& names, const std::string& kind, const std::string& preset, const std::string& help,
             const std::function<void(const std::string&)>& set);
    void declareCommon();
    std::vector<std::string> knownNames() const;
    std::vector<std::string> tidied(int argc, const char* const* argv) const;

    Texts texts_;
    std::string group_;
    std::vector<Option> options_;
    std::vector<std::string>* arguments_ = nullptr;
    std::set<std::string> given_;
    bool help_ = false;
    bool version_ = false;
    bool quiet_ = false;
    bool verbose_ = false;
};

#endif
