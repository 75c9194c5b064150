// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/program.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <unistd.h>

namespace fs = std::filesystem;
using cv::gcpw::Params;
using cv::gcpw::Status;

namespace
{

/// Path of the temporary file: the same folder and the same ending, which cv::imwrite chooses the format by.
fs::path partialOf(const fs::path& path)
{
    return path.parent_path() / (path.stem().string() + ".partial" + path.extension().string());
}

template <typename Write>
void writeThenRename(const std::string& path, Write write)
{
    const fs::path partial = partialOf(path);
    std::string reason = "is the folder there and writable?";
    bool written = false;
    try
    {
        written = write(partial.string());
    }
    catch (const cv::Exception& e)
    {
        reason = e.err;
    }
    std::error_code error;
    if (written)
        fs::rename(partial, path, error);
    if (written && !error)
        return;
    fs::remove(partial, error);
    throw WrongUse("cannot write " + path + ": " + reason);
}

} // namespace

void checkOptions(int argc, const char* const* argv, const std::string& keys)
{
    for (int i = 1; i < argc; ++i)
    {
        const std::string argument = argv[i];
        if (argument.empty() || argument[0] != '-')
            continue;
        const std::string name = argument.substr(argument.find_first_not_of('-') == std::string::npos
                                                     ? argument.size()
                                                     : argument.find_first_not_of('-'));
        const std::string bare = name.substr(0, name.find('='));
        // Keys are written {name alias | default | help}.
        if (bare.empty() || (keys.find("{" + bare + " ") == std::string::npos && keys.find(" " + bare + " ") == std::string::npos))
            throw WrongUse("unknown option " + argument + "; --help lists them");
    }
}

cv::Mat readImage(const std::string& path)
{
    if (!fs::exists(path))
        throw WrongUse("there is no file " + path);
    cv::Mat image = cv::imread(path, cv::IMREAD_UNCHANGED);
    // Only this mode keeps alpha, but it also ignores the orientation that a camera notes.
    if (!image.empty() && image.channels() != 4)
        image = cv::imread(path, cv::IMREAD_COLOR | cv::IMREAD_ANYDEPTH);
    if (image.empty())
        throw WrongUse(path + " is not an image that OpenCV can read");
    return image;
}

cv::Mat readBgr(const std::string& path)
{
    cv::Mat image = readImage(path);
    if (image.depth() == CV_16U)
        image.convertTo(image, CV_8U, 1.0 / 257);
    if (image.channels() == 1)
        cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
    if (image.channels() == 4)
        cv::cvtColor(image, image, cv::COLOR_BGRA2BGR);
    return image;
}

int notedTurn(const std::string& path)
{
    const cv::Mat seen = cv::imread(path, cv::IMREAD_GRAYSCALE);
    const cv::Mat stored = cv::imread(path, cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
    for (const int turn : {1, 3})
    {
        cv::Mat turned;
        cv::rotate(stored, turned, turn == 1 ? cv::ROTATE_90_CLOCKWISE : cv::ROTATE_90_COUNTERCLOCKWISE);
        if (!seen.empty() && turned.size() == seen.size() && cv::norm(turned, seen, cv::NORM_INF) == 0)
            return turn;
    }
    return 0;
}

void writeImage(const std::string& path, const cv::Mat& image)
{
    writeThenRename(path, [&](const std::string& partial) { return cv::imwrite(partial, image); });
}

void writeText(const std::string& path, const std::string& text)
{
    writeThenRename(path, [&](const std::string& partial)
    {
        std::ofstream file(partial);
        file << text;
        file.close();
        return file.good();
    });
}

void makeFolder(const std::string& path)
{
    std::error_code error;
    fs::create_directories(path, error);
    if (!fs::is_directory(path))
        throw WrongUse("cannot make the folder " + path);
}

std::string nameOf(Status status)
{
    switch (status)
    {
    case Status::OK:
        return "ok";
    case Status::ROUGH:
        return "rough";
    case Status::NO_ALIGNMENT:
        return "no_alignment";
    case Status::CANCELLED:
        return "cancelled";
    }
    return "unknown";
}

void applySettings(const std::string& settings, Params& params)
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
}

cv::gcpw::Progress terminalProgress()
{
    if (!isatty(STDERR_FILENO))
        return cv::gcpw::Progress();
    return [](const std::string& stage, double fraction)
    {
        std::fprintf(stderr, "\r%-12s %3.0f %%", stage.c_str(), 100 * fraction);
        std::fflush(stderr);
        return true;
    };
}

void endProgress()
{
    if (isatty(STDERR_FILENO))
        std::fprintf(stderr, "\r%24s\r", "");
}

int runProgram(const std::string& name, int argc, const char* const* argv, const std::string& keys, const std::string& about,
               const std::function<int(const cv::CommandLineParser&)>& run)
{
    try
    {
        cv::CommandLineParser parser(argc, argv, keys);
        parser.about(about);
        if (parser.has("help"))
        {
            parser.printMessage();
            return EXIT_STITCHED;
        }
        checkOptions(argc, argv, keys);
        return run(parser);
    }
    catch (const WrongUse& e)
    {
        endProgress();
        std::cerr << name << ": " << e.what() << '\n';
    }
    catch (const cv::Exception& e)
    {
        endProgress();
        std::cerr << name << ": " << (e.err.empty() ? e.what() : e.err) << '\n';
    }
    return EXIT_WRONG_USE;
}
