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

Lengths are pixels of the working resolution (workMegapix), intensities lie in [0, 1]. */
struct CV_EXPORTS_W_SIMPLE Params
{
    CV_WRAP Params() {} // NOLINT(modernize-use-equals-default): as OpenCV's binding generator reads it

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
    CV_PROP_RW Method method = Method::GCPW;
    CV_PROP_RW int meshCols = 32;         ///< quads across an image, 2..256
    CV_PROP_RW int meshRows = 32;         ///< quads down an image, 2..256
    CV_PROP_RW double workMegapix = 0.6;  ///< images are scaled down to this area for the estimation, > 0
    CV_PROP_RW int referenceImage = -1;   ///< several images: the one that stays unwarped; -1 chooses the most central one, -2 lets all move
    //! @}

    //! @name Canvas
    //! @{
    CV_PROP_RW double canvasPeriod = 0; ///< px of the canvas as given after which x repeats (360-degree panoramas); 0: it does not
    //! @}

    //! @name Weights of the terms (eq. totalfunction)
    //! @{
    CV_PROP_RW double photometricWeight = 100;     ///< lambda_1, >= 0
    CV_PROP_RW double geometricWeight = 1;         ///< lambda_2, >= 0
    CV_PROP_RW double similarityWeight = 0.2;      ///< lambda_3, > 0
    CV_PROP_RW double colorSmoothnessWeight = 100; ///< lambda_4, > 0; 1 lets gains collapse in flat quads
    CV_PROP_RW double colorRestWeight = 1;         ///< weight of E_r, > 0
    //! @}

    //! @name Sampling
    //! @{
    CV_PROP_RW int sampleStep = 2;    ///< px between photometric samples, on every pyramid level, 1..64
    CV_PROP_RW double lineStep = 5;   ///< px between samples of a line, > 0
    CV_PROP_RW int pyramidLevels = 3; ///< Gaussian pyramid levels, 1..8
    //! @}

    //! @name Iteration
    //! @{
    CV_PROP_RW int maxIterations = 10;   ///< per pyramid level, 1..1000
    CV_PROP_RW double stopMotion = 0.05; ///< a level ends when no vertex moves farther: px of the level, > 0
    CV_PROP_RW double stopGain = 0.002;  ///< a level ends when a step lowers the energy by less than this share, >= 0
    //! @}

    //! @name Additions to the paper
    //! @{
    /// Samples count by 0.01 / (local variance of Y + floor^2), so that faint texture is heard as well as strong edges;
    /// the floor is the intensity of noise, 0..1. 0: all samples count alike.
    CV_PROP_RW double contrastFloor = 0.03;
    /// Geman-McClure scale of a sample's residual on the finest level, in local standard deviations; doubled from level to
    /// coarser level. 0: plain squares.
    CV_PROP_RW double robustScale = 2;
    /// How firmly the gain of a quad whose samples do not correlate is held at the ratio of its contrasts; 0: not at all.
    CV_PROP_RW double gainSupport = 3;
    /// Geman-McClure scale of point and line matches, px. 0: plain squares.
    CV_PROP_RW double matchScale = 2;
    /// Weight that holds a quad where the matches alone had put it, if pixels made it worse. 0: never.
    CV_PROP_RW double anchorWeight = 1;
    /// How much worse counts for that: ratio of mean squared decorrelation, >= 1.
    CV_PROP_RW double revertRatio = 1.05;
    /// Three images or more: how firmly every quad is held where the rough alignment has it, so that long chains of images
    /// do not drift in scale and direction, >= 0.
    CV_PROP_RW double restWeight = 0.01;
    /// How firmly the colour of a quad with samples is held at the one gain and bias of its image that makes whole overlaps
    /// agree, so that faint texture keeps its contrast and none drains away along a chain, >= 0.
    CV_PROP_RW double exposureWeight = 8;
    /// The same, for each sample of a quad, for the colours that more than two images are shown with, and for GcpwCompensator
    /// by itself: these are found once the meshes stand, from means and contrasts; 0 shows the alignment's colours, >= 0.
    CV_PROP_RW double balanceWeight = 1.5;
    /// Least area of a quad's corner as a share of its rough area, in (0, 0.9]; what keeps the mesh from folding.
    CV_PROP_RW double minQuadArea = 0.1;
    //! @}

    //! @name Matching
    //! @{
    CV_PROP_RW double contrastThreshold = 0.005; ///< of SIFT; OpenCV's default is 0.04
    CV_PROP_RW double matchRatio = 0.85;         ///< ratio test of the guided matching, (0, 1)
    CV_PROP_RW double featureMegapix = 2;        ///< images are scaled down to this area for keypoints and lines, > 0
    //! @}
};

//! @}

} // namespace gcpw
} // namespace cv

#endif
