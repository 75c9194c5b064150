// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/program.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <opencv2/core/check.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <unistd.h>
#include "common/held_signals.hpp"
#include "common/jpeg_end.hpp"

namespace fs = std::filesystem;
using cv::gcpw::Params;
using cv::gcpw::Status;

namespace
{

/// An unused name in the same folder for what is not complete yet.
fs::path partialOf(const fs::path& path)
{
    for (int i = 0;; ++i)
    {
        const fs::path partial = path.parent_path() / (path.filename().string() + ".partial" + std::to_string(i));
        std::error_code unknown;
        if (!fs::exists(fs::symlink_status(partial, unknown)))
            return partial;
    }
}

/// Returns what went wrong, or nothing.
std::string writeTo(const fs::path& path, const char* data, size_t size)
{
    std::ofstream file(path, std::ios::binary);
    if (!file)
        return "is the folder there and writable?";
    file.write(data, static_cast<std::streamsize>(size));
    file.close();
    return file ? "" : "the disk is full or the file is too large";
}

/// A device or a pipe is nothing to be replaced.
bool isReplaceable(const std::string& path)
{
    std::error_code unknown;
    const fs::file_status status = fs::status(path, unknown);
    return !fs::exists(status) || fs::is_regular_file(status);
}

void writeThenRename(const std::string& path, const char* data, size_t size)
{
    std::error_code error;
    std::string reason;
    if (!isReplaceable(path))
        reason = writeTo(path, data, size);
    else
    {
        const HeldSignals held;
        // A link stays one: what it leads to is replaced.
        const fs::path target = fs::exists(path, error) ? fs::canonical(path) : fs::path(path);
        const fs::path partial = partialOf(target);
        reason = writeTo(partial, data, size);
        if (reason.empty())
        {
            fs::rename(partial, target, error);
            reason = error ? error.message() : "";
        }
        if (!reason.empty())
            fs::remove(partial, error);
    }
    if (!reason.empty())
        throw WrongUse("cannot write " + path + ": " + reason);
}

bool sameFile(const fs::path& a, const fs::path& b)
{
    std::error_code unknown;
    return fs::equivalent(a, b, unknown) || fs::weakly_canonical(a, unknown) == fs::weakly_canonical(b, unknown);
}

/// The exit code of a program whose last words were printed.
int printed(int code)
{
    std::cout.flush();
    if (!std::cout || std::ferror(stdout) != 0)
        throw WrongUse("cannot write to standard output: the disk is full or the file is too large");
    return code;
}

fs::path folderOf(const fs::path& path)
{
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
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
    std::error_code error;
    if (!fs::exists(path, error))
        throw WrongUse("there is no file " + path + (error ? " that can be reached: " + error.message() : ""));
    cv::Mat image = cv::imread(path, cv::IMREAD_UNCHANGED);
    // Only this mode keeps alpha, but it also ignores the orientation that a camera notes.
    if (!image.empty() && image.channels() != 4)
        image = cv::imread(path, cv::IMREAD_COLOR | cv::IMREAD_ANYDEPTH);
    if (image.empty())
        throw WrongUse(path + " is not an image that OpenCV can read");
    if (image.depth() != CV_8U && image.depth() != CV_16U)
        throw WrongUse(path + " has pixels of kind " + cv::typeToString(image.type()) + "; save it with 8 or 16 bits a channel");
    if (lacksJpegEnd(path))
        throw WrongUse(path + " is cut short: its end is missing, and with it a part of the picture; copy it anew");
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

void checkOutputs(const std::vector<std::string>& inputs, const std::vector<std::string>& images, const std::vector<std::string>& others,
                  const std::string& dump)
{
    std::vector<std::string> taken = inputs;
    std::vector<std::string> outputs = images;
    outputs.insert(outputs.end(), others.begin(), others.end());
    for (const std::string& output : outputs)
    {
        if (output.empty())
            continue;
        if (output == "true") // what cv::CommandLineParser makes of --output
            throw WrongUse("an option that takes a file is given without one: write --option=NAME");
        for (const std::string& other : taken)
            if (sameFile(output, other))
                throw WrongUse(output + " would be overwritten: it is read, or written by another option");
        taken.push_back(output);
    }
    for (const std::string& image : images)
        if (!image.empty() && !cv::haveImageWriter(image))
            throw WrongUse("OpenCV cannot write an image named " + image + ": .png and .jpg are endings that it knows");
    if (dump.empty())
        return;
    for (const std::string& input : inputs)
        if (sameFile(dump, folderOf(input)))
            throw WrongUse("--dump=" + dump + " could overwrite " + input + ", which lies there: choose another folder");
}

void writeImage(const std::string& path, const cv::Mat& image)
{
    std::vector<uchar> data;
    const std::string ending = fs::path(path).extension().string();
    if (!cv::imencode(ending, image, data))
        throw WrongUse("cannot write " + path + ": OpenCV cannot encode the image as " + ending);
    writeThenRename(path, reinterpret_cast<const char*>(data.data()), data.size());
}

void writeText(const std::string& path, const std::string& text)
{
    writeThenRename(path, text.data(), text.size());
}

void writeModel(const std::string& path, const std::function<void(const std::string&)>& save)
{
    if (!isReplaceable(path))
        save(path); // may last until somebody reads
    else
    {
        const HeldSignals held;
        save(path);
    }
}

void makeFolder(const std::string& path)
{
    std::error_code error;
    fs::create_directories(path, error);
    if (!fs::is_directory(path, error))
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
            return printed(EXIT_STITCHED);
        }
        checkOptions(argc, argv, keys);
        return printed(run(parser));
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
    catch (const std::bad_alloc&)
    {
        endProgress();
        std::cerr << name << ": not enough memory\n";
    }
    catch (const std::exception& e) // of the standard library, also from within OpenCV
    {
        endProgress();
        std::cerr << name << ": " << e.what() << '\n';
    }
    return EXIT_WRONG_USE;
}
