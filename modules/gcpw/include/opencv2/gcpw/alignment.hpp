// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
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

/** @brief Called from time to time during a long call. Return false to cancel.

In Python a function of these two arguments; what it raises is written to standard error and cancels.

Arguments: the stage ("features", "homography", "cameras", "align") and the fraction of that stage that is done, 0..1. Called by one
thread at a time, not always by the same. */
typedef std::function<bool(const std::string& stage, double fraction)> Progress;

/// How an alignment ended.
enum class Status
{
    OK = 0,          //!< refined as asked, or lined up already: then the meshes are those of the rough alignment
    ROUGH = 1,       //!< the refinement failed or improved nothing; the rough alignment is returned (see Report::message)
    NO_ALIGNMENT = 2, //!< not even a rough alignment was found
    CANCELLED = 3    //!< the progress callback said stop; the rough alignment is returned
};

/// The name of a status, as reports and the Python package have it.
/// @param status any  @return "ok", "rough", "no_alignment" or "cancelled"; "unknown" for a number that is none of them
CV_EXPORTS const char* toString(Status status);

/// Energy of the terms of one name, weighted as in eq. totalfunction.
struct CV_EXPORTS_W_SIMPLE TermEnergy
{
    CV_PROP_RW std::string name; //!< "photometric", "points", "lines", "similarity", "color_smoothness", ..
    CV_PROP_RW double value;     //!< of the whole level

    /// @param term name of the terms  @param energy their weighted sum, >= 0
    CV_WRAP explicit TermEnergy(const std::string& term = std::string(), double energy = 0) : name(term), value(energy) {}
};

/// The sum of all.
/// @param energies of one level  @return sum of their values, >= 0
CV_EXPORTS double totalEnergy(const std::vector<TermEnergy>& energies);

/// Why the iterations on a level ended.
enum class StopReason
{
    ITERATION_LIMIT = 0, //!< Params::maxIterations, or the few iterations that the step of the method asks for
    MESH_STABLE = 1,     //!< no vertex moved farther than Params::stopMotion
    ENERGY_STABLE = 2,   //!< the energy sank by less than Params::stopGain
    NO_DESCENT = 3,      //!< no part of the step lowers the energy, or each folds a quad: the last state is the result
    SINGULAR = 4,        //!< the normal equations are singular; the last good state was kept
    CANCELLED = 5        //!< the progress callback said stop
};

/// The name of a reason, as reports and the Python package have it.
/// @param reason any  @return "iteration_limit", "mesh_stable", ..; "unknown" for a number that is none of them
CV_EXPORTS const char* toString(StopReason reason);

/** @brief What happened on one pyramid level.

Energies can be compared within a level only: another level has other samples, exposures and anchors. Even within one, weights
that a term chooses from the state hold for one iteration: it never raises the energy, while `end` may exceed `start` by what the
weights changed. */
struct CV_EXPORTS_W_SIMPLE LevelReport
{
    /// No iterations.
    CV_WRAP LevelReport() : scale(1), iterations(0), stop(StopReason::ITERATION_LIMIT) {}

    CV_PROP_RW double scale;   //!< working pixels per pixel of this level, >= 1
    CV_PROP_RW int iterations; //!< Gauss-Newton iterations made
    CV_PROP_RW std::vector<TermEnergy> start; //!< after the colours were initialised (eq. initialfunction)
    CV_PROP_RW std::vector<TermEnergy> end; //!< of the last state accepted; the same terms as start
    CV_PROP_RW StopReason stop; //!< why it ended
};

/// How well two images line up; lower is better, 0 is perfect, NaN where nothing could be compared.
struct CV_EXPORTS_W_SIMPLE Score
{
    /// Perfect: both are 0.
    CV_WRAP Score() : ncc(0), zncc(0) {}

    CV_PROP_RW double ncc;  //!< 100 * RMS of 1 - NCC over windows of 5 x 5 px, the paper's measure: 0..100
    CV_PROP_RW double zncc; //!< 100 * RMS of 1 - zero-mean NCC over windows of 5 x 5 px with texture in both images: 0..200
};

/// What was found between two images.
struct CV_EXPORTS_W_SIMPLE PairReport
{
    /// Of images 0 and 1, without matches.
    CV_WRAP PairReport() : a(0), b(1), points(0), lines(0), miss_before(0), miss_after(0) {}

    CV_PROP_RW int a;      //!< index of the one image
    CV_PROP_RW int b;      //!< index of the other
    CV_PROP_RW int points; //!< point matches used
    CV_PROP_RW int lines;  //!< line matches used
    /// Score::zncc of the rough alignment, found without rendering: over windows of 5 x 5 working pixels, of a large image only
    /// over as many rows as suffice. NaN where nothing could be compared.
    CV_PROP_RW double miss_before;
    CV_PROP_RW double miss_after; //!< the same of the result
};

/// Milliseconds of wall time.
struct CV_EXPORTS_W_SIMPLE Timings
{
    /// All are 0.
    CV_WRAP Timings() : features(0), homography(0), align(0), total(0) {}

    CV_PROP_RW double features;   //!< detection and description
    CV_PROP_RW double homography; //!< matching and rough alignment
    CV_PROP_RW double align;      //!< everything from the rough alignment to the final mesh and colours
    CV_PROP_RW double total;      //!< the whole call
};

/// How an alignment came about.
struct CV_EXPORTS_W_SIMPLE Report
{
    /// Status::OK, no change of mesh or colour.
    CV_WRAP Report() : status(Status::OK), folds(0), max_displacement_px(0), gain_min(1), gain_max(1) {}

    CV_PROP_RW Status status;       //!< how it ended
    CV_PROP_RW std::string message; //!< why the status is not OK, or what is missing although it is; else empty
    CV_PROP_RW std::vector<LevelReport> levels; //!< coarse to fine
    CV_PROP_RW std::vector<PairReport> pairs;   //!< one for each pair of images that was aligned to each other
    CV_PROP_RW int folds;                  //!< folded or flipped quads of all meshes; 0 by construction
    CV_PROP_RW double max_displacement_px; //!< largest distance of a vertex from its rough position, working pixels
    CV_PROP_RW double gain_min;            //!< smallest gain of all quads and channels, 1: no change
    CV_PROP_RW double gain_max;            //!< largest gain of all quads and channels
    CV_PROP_RW Timings timings_ms;         //!< how long it took
};

/** @brief Where one image lies on the canvas, and how its colours change.

A mesh of cols x rows quads of equal size covers the image; vertex (r, c) lies at ((c / cols) * work_size.width - 0.5,
(r / rows) * work_size.height - 0.5) of the image, in working pixels. */
struct CV_EXPORTS_W_SIMPLE AlignedImage
{
    /// Without sizes, mesh and colours: to be filled in.
    CV_WRAP AlignedImage() {}

    CV_PROP_RW Size full_size; //!< pixels of the image as it was given, 1 x 1 or more
    CV_PROP_RW Size work_size; //!< pixels of the image as it was aligned: the unit of its mesh
    CV_PROP_RW Mat mesh;       //!< (rows + 1) x (cols + 1), CV_64FC2: canvas position x, y of each vertex, working pixels
    CV_PROP_RW Mat rough;      //!< the same before refinement
    CV_PROP_RW Mat color; //!< rows x cols, CV_32FC(6): gain of Y, Cr, Cb, then bias of Y, Cr, Cb of each quad; intensities in [0, 1]
};

/** @brief The result of an alignment.

Immutable. Meshes and colours are kept at the working resolution; scaling acts on pixel squares:
work = (full + 0.5) * work_size / full_size - 0.5, on the canvas and on each image.

@code
const cv::gcpw::Alignment alignment = cv::gcpw::alignPair(source, target);
if (!alignment.ok())
    std::cout << alignment.report().message << std::endl;
alignment.save("pair.yml.gz");
const cv::Vec2d corner = alignment.image(0).mesh.at<cv::Vec2d>(0, 0); // canvas position of the top-left vertex
@endcode */
class CV_EXPORTS_W_SIMPLE Alignment
{
public:
    typedef AlignedImage Image; //!< its name in earlier versions

    /// No images, Status::OK.
    CV_WRAP Alignment() {}

    /** @brief Images with a mesh and colours each.
    @param images none, or images with sizes of at least 1 px, 2..256 quads a side and finite values
    @param canvas_scale see canvasScale(), finite and > 0
    @param report how they came about
    @throws cv::Exception that names the image and the part of it that is not as described at AlignedImage */
    Alignment(const std::vector<AlignedImage>& images, Size2d canvas_scale, const Report& report);

    /// Whether the images were refined as asked.
    /// @return whether the status of the report is Status::OK
    CV_WRAP bool ok() const { return report_.status == Status::OK; }

    /// Number of images.
    /// @return 0 if there is no alignment at all
    CV_WRAP int imageCount() const { return static_cast<int>(images_.size()); }

    /** @brief One image; its Mats are shared with the alignment: clone them before you write.
    @param index 0..imageCount() - 1, in the order in which the images were given
    @return the alignment's own, valid as long as the alignment
    @throws cv::Exception StsOutOfRange if there is no such image */
    CV_WRAP const AlignedImage& image(int index) const;

    /// Scale of the canvas on which the meshes are given.
    /// @return working canvas pixels per full-resolution canvas pixel, in x and in y, > 0
    Size2d canvasScale() const { return canvas_scale_; }

    /// How it came about, and how well.
    /// @return the alignment's own, valid as long as the alignment
    CV_WRAP const Report& report() const { return report_; }

    /// The alignment before refinement.
    /// @return the same images where the rough alignment has them, with gains of 1 and biases of 0
    CV_WRAP Alignment rough() const;

    /** @brief Writes everything that rendering needs. Numbers are kept exactly.
    @param path ending in .yml, .xml or .json; with .gz behind it compressed
    @throws cv::Exception StsError if not all of it can be written; a file that was there before is kept then */
    CV_WRAP void save(const std::string& path) const;

    /** @brief Reads what save() wrote.

    Damaged files are refused, also where OpenCV's parser would crash, and compressed ones (.gz) of more than 256 MB of text.
    @param path of the file
    @return equal to what was saved
    @throws cv::Exception StsError if there is no such file, StsParseError if it is not an alignment; both name the file */
    CV_WRAP static Alignment load(const std::string& path);

private:
    std::vector<AlignedImage> images_;
    Size2d canvas_scale_ = Size2d(1, 1);
    Report report_;
};

//! @}

} // namespace gcpw
} // namespace cv

#endif
