// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/program.hpp"

#include <iostream>
#include <new>
#include <sstream>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/logger.hpp>

using cv::gcpw::Params;

namespace
{

/// The log of OpenCV says as much as the program does.
void setLog(Console::Loudness loudness)
{
    namespace logging = cv::utils::logging;
    if (loudness == Console::Loudness::QUIET)
        logging::setLogLevel(logging::LOG_LEVEL_ERROR);
    if (loudness == Console::Loudness::VERBOSE)
        logging::setLogLevel(logging::LOG_LEVEL_INFO);
}

int parseAndRun(CommandLine& line, int argc, const char* const* argv, const std::function<int(Console&)>& run)
{
    const CommandLine::Asked asked = line.parse(argc, argv);
    Console console(line.program(), asked == CommandLine::Asked::WORK ? line.loudness() : Console::Loudness::NORMAL);
    int code = EXIT_STITCHED;
    if (asked == CommandLine::Asked::WORK)
    {
        setLog(console.loudness());
        if (line.threads >= 0)
            cv::setNumThreads(line.threads);
        code = run(console);
    }
    else
        std::cout << (asked == CommandLine::Asked::HELP ? line.help() : line.version());
    console.flush();
    return code;
}

} // namespace

void applySettings(const std::string& settings, Params& params)
{
    try
    {
        std::istringstream list(settings);
        std::string item;
        while (std::getline(list, item, ','))
        {
            const size_t equals = item.find('=');
            char* end = nullptr;
            const double value = equals == std::string::npos ? 0 : std::strtod(item.c_str() + equals + 1, &end);
            if (!end || *end != '\0' || end == item.c_str() + equals + 1)
                throw WrongUse("--set takes name=number,name=number; got '" + item + "'");
            params.set(item.substr(0, equals), value);
        }
        params.check();
    }
    catch (const cv::Exception& error)
    {
        throw WrongUse(error.err);
    }
}

int runProgram(CommandLine& line, int argc, const char* const* argv, const std::function<int(Console&)>& run)
{
    const Console console(line.program(), Console::Loudness::NORMAL);
    const auto fail = [&console](const std::string& message, ExitCode code)
    {
        console.warn(message);
        return static_cast<int>(code);
    };
    const char* const no_memory = "not enough memory; smaller photographs or a smaller --compose_megapix need less";
    try
    {
        return parseAndRun(line, argc, argv, run);
    }
    catch (const WrongUse& error)
    {
        return fail(error.what(), EXIT_WRONG_USE);
    }
    catch (const FileTrouble& error)
    {
        return fail(error.what(), EXIT_FILE_TROUBLE);
    }
    catch (const cv::Exception& error)
    {
        return fail(error.code == cv::Error::StsNoMem ? no_memory
                    : error.err.empty()               ? error.what()
                                                      : error.err.c_str(),
                    EXIT_NO_ANSWER);
    }
    catch (const std::bad_alloc&)
    {
        return fail(no_memory, EXIT_NO_ANSWER);
    }
    catch (const std::exception& error) // of the standard library, also from within OpenCV
    {
        return fail(error.what(), EXIT_NO_ANSWER);
    }
}
