// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_ALIGNMENT_HPP
#define OPENCV_GCPW_ALIGNMENT_HPP

#include <functional>
#include <string>
#include <vector>
#include "opencv2/gcpw/params.hpp"

namespace cv
{
namespace gcpw
{

//! @addtogroup gcpw
//! @{

/** @brief Called now and then with the stage ("features", "homography", "align", "render") and the share of it that is
done, 0..1. Return false to cancel. */
typedef std::function<bool(const std::string& stage, double fraction)> Progress;

/// How an alignment ended.
enum class Status
{
    OK = 0,          //!< refined as asked
    ROUGH = 1,       //!< the refinement had no answer or none that is better; the rough alignment is returned (see Report::message)
    NO_ALIGNMENT = 2, //!< not even a rough alignment was found
    CANCELLED = 3    //!< the progress callback said stop; the rough alignment is returned
};

/// Energy of the terms of one name, weighted as in eq. totalfunction.
struct CV_EXPORTS TermEnergy
{
    std::string name; //!< "photometric", "points", "lines", "similarity", "color_smoothness", ..
    double value;

    explicit TermEnergy(const std::string& term = std::string(), double energy = 0) : name(term), value(energy) {}
};

/// The sum of all.
CV_EXPORTS double totalEnergy(const std::vector<TermEnergy>& energies);

/// Why the iterations on a level ended.
enum class StopReason
{
    ITERATION_LIMIT = 0, //!< Params::maxIterations, or the few iterations that the step of the method asks for
    MESH_STABLE = 1,     //!< no vertex moved farther than Params::stopMotion
    ENERGY_STABLE = 2,   //!< the energy sank by less than Params::stopGain
    NO_DESCENT = 3,      //!< no part of the step lowers the energy, or each folds a quad: the last state is the result
    SINGULAR = 4,        //!< the equations had no answer; the last good state was kept
    CANCELLED = 5        //!< the progress callback said stop
};

/// What happened on one pyramid level.
struct CV_EXPORTS LevelReport
{
    double scale = 1; //!< working pixels per pixel of this level
    int iterations = 0;
    std::vector<TermEnergy> start; //!< after the colours were initialised (eq. initialfunction)
    std::vector<TermEnergy> end;
    StopReason stop = StopReason::ITERATION_LIMIT; //!< why it ended
};

/// How well two images line up; lower is better, 0 is perfect, NaN where nothing could be compared.
struct CV_EXPORTS Score
{
    double ncc = 0;  //!< 100 * RMS of 1 - NCC over 5 x 5 windows, the paper's measure
    double zncc = 0; //!< 100 * RMS of 1 - zero-mean NCC over windows with texture in both images
};

/// What was found between two images.
struct CV_EXPORTS PairReport
{
    int a = 0;
    int b = 1;
    int points = 0; //!< point matches used
    int lines = 0;  //!< line matches used
    /// 100 * RMS of 1 - zero-mean NCC over windows of 5 x 5 working pixels with texture in both images: Score::zncc without
    /// rendering, over the rows of a large image that suffice. Of the rough alignment; NaN where nothing could be compared.
    double miss_before = 0;
    double miss_after = 0; //!< the same of the result
};

/// Milliseconds of wall time.
struct CV_EXPORTS Timings
{
    double features = 0;   //!< detection and description
    double homography = 0; //!< matching and rough alignment
    double align = 0;      //!< everything from the rough alignment to the final mesh and colours
    double total = 0;
};

/// Everything worth knowing about how an alignment came about.
struct CV_EXPORTS Report
{
    Status status = Status::OK;
    std::string message; //!< why the status is not OK, or what is missing although it is; else empty
    std::vector<LevelReport> levels; //!< coarse to fine
    std::vector<PairReport> pairs;
    int folds = 0;                  //!< folded or flipped quads of all meshes; 0 by construction
    double max_displacement_px = 0; //!< largest move of a vertex from the rough alignment, working pixels
    double gain_min = 1;            //!< over all quads and channels
    double gain_max = 1;
    Timings timings_ms;
};

/** @brief The result of an alignment: where every image lies on the canvas, and how its colours change.

Immutable. Meshes and colours are kept at the working resolution; scaling acts on pixel squares:
work = (full + 0.5) * work_size / full_size - 0.5, on the canvas and on each image. */
class CV_EXPORTS Alignment
{
public:
    struct Image
    {
        Size full_size; //!< pixels of the image as it was given
        Size work_size; //!< pixels at which its mesh is expressed
        Mat mesh;       //!< (rows + 1) x (cols + 1), CV_64FC2: canvas position of each vertex, working pixels
        Mat rough;      //!< the same before refinement
        Mat color;      //!< rows x cols, CV_32FC(6): gain Y, Cr, Cb, bias Y, Cr, Cb of each quad; intensities in [0, 1]
    };

    Alignment() = default;

    /** @param images none, or images of sizes of at least 1 px, of 2..256 quads a side and of finite values
    @param canvas_scale see canvasScale(), finite and > 0
    @param report how they came about
    @throws cv::Exception that names the image and the part of it that is not as described at Image */
    Alignment(const std::vector<Image>& images, Size2d canvas_scale, const Report& report);

    bool ok() const { return report_.status == Status::OK; }
    int imageCount() const { return static_cast<int>(images_.size()); }

    /// @throws cv::Exception StsOutOfRange if there is no such image
    const Image& image(int index) const;

    /// Working canvas pixels per full-resolution canvas pixel, x and y.
    Size2d canvasScale() const { return canvas_scale_; }

    const Report& report() const { return report_; }

    /// The same images where the rough alignment has them, colours untouched.
    Alignment rough() const;

    /** @brief Writes everything that rendering needs: .yml, .xml or .json, with .gz compressed. Numbers are kept exactly.
    @throws cv::Exception StsError if not all of it can be written; a file that was there before is kept then */
    void save(const std::string& path) const;

    /// @throws cv::Exception StsError if there is no such file, StsParseError if it is not an alignment; both name the file
    static Alignment load(const std::string& path);

private:
    std::vector<Image> images_;
    Size2d canvas_scale_ = Size2d(1, 1);
    Report report_;
};

//! @}

} // namespace gcpw
} // namespace cv

#endif
