// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_PYTHON_CALLS_HPP
#define GCPW_PYTHON_CALLS_HPP

#include <exception>
#include <filesystem>
#include <opencv2/gcpw/alignment.hpp>
#include <pybind11/pybind11.h>
#include <stdexcept>
#include <string>
#include <utility>

/** @brief Watches a long call: tells a Python function how far it is, and ends it where that says stop, raises, or Ctrl-C is pressed.

The call runs without the interpreter's lock; so does everything here but the function itself. */
class Watch
{
public:
    /// @param function called as function(stage, fraction), or None; returning False cancels
    explicit Watch(const pybind11::object& function) : function_(function) {}

    /// For the module's functions; valid as long as this.
    cv::gcpw::Progress progress();

    /// Tells a stage of our own. Throws Stopped where the call is to end.
    void tell(const std::string& stage, double fraction);

    /** @brief Runs the call without the interpreter's lock.
    @return what it returns
    @throws what the function raised; gcpw.CancelledError if it said stop */
    template <typename Call>
    auto run(const Call& call) -> decltype(call())
    {
        try
        {
            pybind11::gil_scoped_release unlocked;
            auto result = call();
            if (!stopped_)
                return result;
        }
        catch (...)
        {
            if (!stopped_)
                throw;
        }
        end();
    }

private:
    struct Stopped
    {
    };

    bool goOn(const std::string& stage, double fraction);
    [[noreturn]] void end() const;

    const pybind11::object& function_;
    bool stopped_ = false;
    std::exception_ptr raised_; ///< by the function, or by Ctrl-C
};

/// Throws OSError with the system's reason where a file cannot be opened.
void checkReadable(const std::string& path);

/// Throws OSError for a file that could not be written, and the exception itself for anything else.
[[noreturn]] void raiseOsError(const cv::Exception& error);

/// gcpw.NoAlignmentError: the photographs do not match.
struct NoAlignment : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// Reads a file by load(), without the interpreter's lock. Throws OSError where it cannot be opened.
template <typename Load>
auto readFrom(const std::filesystem::path& path, const Load& load) -> decltype(load(std::string()))
{
    checkReadable(path.string());
    pybind11::gil_scoped_release unlocked;
    return load(path.string());
}

/// Writes a file by save(), without the interpreter's lock. Throws OSError where it cannot be written.
template <typename Save>
void writeTo(const std::filesystem::path& path, const Save& save)
{
    try
    {
        pybind11::gil_scoped_release unlocked;
        save(path.string());
    }
    catch (const cv::Exception& error)
    {
        raiseOsError(error);
    }
}

/// Makes the exceptions of the package, and lets those of C++ arrive as these.
void bindErrors(pybind11::module_& module);

/// One of a few names, each with its value. Throws cv::Exception that lists them.
template <typename Value, size_t COUNT>
Value choose(const std::string& what, const std::string& name, const std::pair<const char*, Value> (&choices)[COUNT])
{
    std::string known;
    for (const auto& choice : choices)
    {
        if (name == choice.first)
            return choice.second;
        known += (known.empty() ? "\"" : ", \"") + std::string(choice.first) + "\"";
    }
    CV_Error(cv::Error::StsBadArg, "there is no " + what + " \"" + name + "\"; there are " + known);
}

#endif
