// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_PARAMS_HPP
#define OPENCV_GCPW_PARAMS_HPP

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace cv
{
namespace gcpw
{

//! @addtogroup gcpw
//! @{

/** @brief Which terms of the energy are used. Each method is the next one's special case. */
enum class Method
{
    GLOBAL = 0, //!< the rough alignment alone
    CPW = 1,    //!< point matches and the similarity term @cite liu2009content
    DFW = 2,    //!< CPW and line matches @cite li2015dual
    MFW = 3,    //!< DFW and pixels, colours taken as equal @cite lin2017direct
    GCPW = 4    //!< MFW and a local colour model, estimated together with the mesh
};

/** @brief Every constant of the method. Defaults are measured (see doc/results.md); paper() has the paper's values.

Lengths are pixels of the working resolution (workMegapix), intensities lie in [0, 1]. Where no upper bound stands, it is 1e9 for
a weight and 1e6 for anything else. */
struct CV_EXPORTS_W_SIMPLE Params
{
    /// The defaults. OpenCV's binding generator reads no initialiser of a member, so the constructor sets them all.
    CV_WRAP Params();

    /** @brief The constants of its section 2, and iterations until the mesh is stable.

    All additions that a member can switch off are off. What stays: matches are filtered, no quad folds (minQuadArea), and the
    result is compared with the rough alignment. */
    CV_WRAP static Params paper();

    /// Throws cv::Exception (StsOutOfRange) that names the first member out of its range, its value and the range.
    CV_WRAP void check() const;

    /** @brief Sets a numeric member by its name.
    @throws cv::Exception StsBadArg if there is no such member; the message lists all names */
    CV_WRAP void set(const std::string& name, double value);

    /// Value of a numeric member by its name; throws like set().
    CV_WRAP double get(const std::string& name) const;

    /// Names of all numeric members, in the order of their declaration.
    CV_WRAP static std::vector<std::string> names();

    //! @name What is estimated
    //! @{
    CV_PROP_RW Method method;      ///< default GCPW
    CV_PROP_RW int meshCols;       ///< quads across an image, 2..256; default 32
    CV_PROP_RW int meshRows;       ///< quads down an image, 2..256; default 32
    CV_PROP_RW double workMegapix; ///< images are scaled down to this area for the estimation, > 0; default 0.6
    CV_PROP_RW int referenceImage; ///< several images: stays unwarped; -1: the most central one, -2: none; default -1
    //! @}

    //! @name Canvas
    //! @{
    /// px of the given canvas after which x repeats (360 degrees), at least the widest image; 0: never; default 0
    CV_PROP_RW double canvasPeriod;
    //! @}

    //! @name Weights of the terms (eq. totalfunction)
    //! @{
    CV_PROP_RW double photometricWeight;     ///< lambda_1, >= 0; default 100
    CV_PROP_RW double geometricWeight;       ///< lambda_2, >= 0; default 1
    CV_PROP_RW double similarityWeight;      ///< lambda_3, > 0; default 0.2
    CV_PROP_RW double colorSmoothnessWeight; ///< lambda_4, > 0; 1 lets gains collapse in flat quads; default 100
    CV_PROP_RW double colorRestWeight;       ///< weight of E_r, > 0; default 1
    //! @}

    //! @name Sampling
    //! @{
    CV_PROP_RW int sampleStep;    ///< px between photometric samples, on every pyramid level, 1..64; default 2
    CV_PROP_RW double lineStep;   ///< px between samples of a line, at least 0.1; default 5
    CV_PROP_RW int pyramidLevels; ///< Gaussian pyramid levels, 1..8; default 3
    //! @}

    //! @name Iteration
    //! @{
    CV_PROP_RW int maxIterations; ///< per pyramid level, 1..1000; default 10
    CV_PROP_RW double stopMotion; ///< a level ends when no vertex moves farther: px of the level, > 0; default 0.05
    CV_PROP_RW double stopGain; ///< a level ends when a step lowers the energy by a smaller share, 0..1; default 0.002
    //! @}

    //! @name Additions to the paper
    //! @{
    /// Samples count by 0.01 / (local variance of Y + floor^2), so that faint texture is heard as well as strong edges;
    /// the floor is the intensity of noise, 0..1. 0: all samples count alike; default 0.03.
    CV_PROP_RW double contrastFloor;
    /// Geman-McClure scale of a sample's residual on the finest level, in local standard deviations; doubled from level to
    /// coarser level. 0: plain squares; default 2.
    CV_PROP_RW double robustScale;
    /// How firmly the gain of a quad whose samples do not correlate is held at the ratio of its contrasts; 0: not at all;
    /// default 3.
    CV_PROP_RW double gainSupport;
    /// Geman-McClure scale of point and line matches, px. 0: plain squares; default 2.
    CV_PROP_RW double matchScale;
    /// Weight that holds a quad where the matches alone had put it, if pixels made it worse. 0: never; default 1.
    CV_PROP_RW double anchorWeight;
    /// How much worse counts for that: ratio of mean squared decorrelation, >= 1; default 1.05.
    CV_PROP_RW double revertRatio;
    /// Three images or more: how firmly every quad is held where the rough alignment has it, so that long chains of images
    /// do not drift in scale and direction, >= 0; default 0.01.
    CV_PROP_RW double restWeight;
    /// How firmly the colour of a quad with samples is held at the one gain and bias of its image that makes whole overlaps
    /// agree, so that faint texture keeps its contrast and none drains away along a chain, >= 0; default 8.
    CV_PROP_RW double exposureWeight;
    /// The same, for each sample of a quad, for the colours that more than two images are shown with, and for GcpwCompensator
    /// by itself: these are found once the meshes stand, from means and contrasts; 0 shows the alignment's colours, >= 0;
    /// default 1.5.
    CV_PROP_RW double balanceWeight;
    /// Least area of a quad's corner as a share of its rough area, in (0, 0.9]; what keeps the mesh from folding; default 0.1.
    CV_PROP_RW double minQuadArea;
    //! @}

    //! @name Matching
    //! @{
    CV_PROP_RW double contrastThreshold; ///< of SIFT, which OpenCV itself has at 0.04; default 0.005
    CV_PROP_RW double matchRatio;        ///< ratio test of the matching around the rough alignment, (0, 1); default 0.85
    /// 1: match once more near where the first fitted mesh expects each keypoint; 0: once, as in the paper; default 1.
    CV_PROP_RW int guidedMatching;
    CV_PROP_RW double featureMegapix; ///< images are scaled down to this area for keypoints and lines, > 0; default 2
    //! @}
};

//! @}

} // namespace gcpw
} // namespace cv

#endif
