// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_PROGRAM_HPP
#define GCPW_APPS_PROGRAM_HPP

#include <functional>
#include <opencv2/core.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/gcpw.hpp>
#include <stdexcept>
#include <string>
#include <vector>

/// Exit codes of the programs.
enum ExitCode
{
    EXIT_STITCHED = 0,
    EXIT_NO_ALIGNMENT = 1,
    EXIT_WRONG_USE = 2
};

/// Least resolution of an estimation that makes sense, million pixels: a photograph of 10 x 10 px.
const double LEAST_MEGAPIX = 1e-4;

/// The caller asked for something that cannot be: ends the program with EXIT_WRONG_USE and this message.
struct WrongUse : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// Throws WrongUse if an argument is no option of `keys` (cv::CommandLineParser passes over them in silence).
void checkOptions(int argc, const char* const* argv, const std::string& keys);

/// Reads a photograph of 8 or 16 bits with its orientation and alpha. Throws WrongUse that names the file, also where it is cut short.
cv::Mat readImage(const std::string& path);

/// The same as 8-bit BGR, which is all that cv::Stitcher takes.
cv::Mat readBgr(const std::string& path);

/// Quarter turns to the right by which the orientation that a camera noted turns a photograph when it is read: 0, 1 or 3, and 0
/// for half a turn.
int notedTurn(const std::string& path);

/** @brief Refuses, before any work, what would overwrite a file that is read or another one that is written, an option without a
name, and an image's ending that OpenCV does not know. Throws WrongUse that names the file.
@param inputs files that are read
@param images, others files to be written; empty for none
@param dump folder whose names the program chooses: no input may lie in it; empty for none */
void checkOutputs(const std::vector<std::string>& inputs, const std::vector<std::string>& images, const std::vector<std::string>& others,
                  const std::string& dump);

/// Writes an image under a temporary name first, so that no half-written file is ever left. Throws WrongUse.
void writeImage(const std::string& path, const cv::Mat& image);

/// The same for text.
void writeText(const std::string& path, const std::string& text);

/// Calls save(path), which writes a file as a whole or not at all, and lets no signal stop it halfway.
void writeModel(const std::string& path, const std::function<void(const std::string&)>& save);

/// Makes a folder and its parents. Throws WrongUse.
void makeFolder(const std::string& path);

/// "ok", "rough", "no_alignment", "cancelled".
std::string nameOf(cv::gcpw::Status status);

/// Applies "name=value,name=value" to params. Throws WrongUse.
void applySettings(const std::string& settings, cv::gcpw::Params& params);

/// Shows stage and percentage on the terminal; silent if standard error is none.
cv::gcpw::Progress terminalProgress();
void endProgress();

/** @brief A program's main(): shows the help or calls run() with the checked options, and turns exceptions into a message
and an exit code.
@param keys as cv::CommandLineParser takes them, with "help"  @param about what the help says above the options */
int runProgram(const std::string& name, int argc, const char* const* argv, const std::string& keys, const std::string& about,
               const std::function<int(const cv::CommandLineParser&)>& run);

#endif
