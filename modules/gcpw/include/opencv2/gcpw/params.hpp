// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
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
    GCPW = 4    //!< MFW and a local colour model, estimated together with the mesh @cite chen2018gcpw
};

/** @brief The parameters of the method. Defaults are measured (see doc/results.md); paper() has the paper's values.

Most callers need six of them:
- method: leave it at GCPW, or compare with what came before it;
- meshCols, meshRows: a finer mesh follows stronger parallax, and costs time;
- workMegapix: the resolution of the estimation, and so its time;
- similarityWeight: larger values keep the shape of the photographs, smaller ones let the mesh bend more;
- referenceImage: of several images, the one that keeps its place.

@code
cv::gcpw::Params params;
params.meshCols = params.meshRows = 48; // strong parallax
params.similarityWeight = 0.1;
params.check(); // throws if a value is out of range; so does every function that takes Params
const cv::gcpw::Alignment alignment = cv::gcpw::alignPair(source, target, params);
@endcode

Units: lengths are pixels of the working resolution (workMegapix) unless another one is named. Intensities lie in [0, 1]. A
*sample* is one pixel at which two images are compared (sampleStep). Weights are relative to each other. Where no upper bound stands, it is 1e9 for a weight and for canvasPeriod, 1e6 for anything else.

"Two images" below means alignPair() and Aligner with two images of which one is fixed; "several images" means three or more,
or two with referenceImage -2. The labels of equations are those of @cite chen2018gcpw. */
struct CV_EXPORTS_W_SIMPLE Params
{
    /// The defaults. OpenCV's binding generator reads no initialiser of a member, so the constructor sets them all.
    CV_WRAP Params();

    /** @brief The constants of section 2 of the paper, and iterations until the mesh is stable.

    All additions that a member can switch off are off. What stays: matches are filtered, no quad folds (minQuadArea), and the
    result is compared with the rough alignment.
    @return parameters that pass check() */
    CV_WRAP static Params paper();

    /** @brief The weights for the closest alignment of the overlap, whatever it does to lines and shapes.

    straightnessWeight, outsideWeight, stretchLimit and distortionPrice are 0, similarityWeight is 0.2; everything else as by default.
    @return parameters that pass check() */
    CV_WRAP static Params alignmentOnly();

    /** @brief Looks at all members; called by every function that takes Params.
    @throws cv::Exception StsOutOfRange that names the first member out of its range, its value and the range */
    CV_WRAP void check() const;

    /** @brief Sets a numeric member by its name, without a check of its range.
    @param name one of names(), e.g. "meshCols"
    @param value the new value; a whole number where the member is an int
    @throws cv::Exception StsBadArg if there is no such member: the message lists all names; StsOutOfRange if a member that is
    an int is given a fraction */
    CV_WRAP void set(const std::string& name, double value);

    /** @brief Value of a numeric member by its name.
    @param name one of names()
    @return the value; of a member that is an int, the same number
    @throws cv::Exception StsBadArg if there is no such member */
    CV_WRAP double get(const std::string& name) const;

    /// Names of all numeric members.
    /// @return all but "method", in the order of their declaration
    CV_WRAP static std::vector<std::string> names();

    //! @name What is estimated
    //! @{

    /// Which terms of the energy are used. GcpwCompensator ignores it; findPairMatches() finds the matches of all methods.
    /// default GCPW
    CV_PROP_RW Method method;
    /// Quads across an image, 2..256. More follow finer parallax and colour, take proportionally longer, and have fewer samples
    /// each. Typical: 16..48. default 32
    CV_PROP_RW int meshCols;
    /// Quads down an image, 2..256. As meshCols. default 32
    CV_PROP_RW int meshRows;
    /// Images are scaled down to this area for the estimation, in 10^6 pixels, > 0 and at most 1000. Larger values resolve finer
    /// misalignment and take proportionally longer; smaller images are not enlarged. Typical: 0.3..1. alignRig() and attach()
    /// take up to twice the area where that saves one more scaling; GcpwCompensator::feed() ignores it. default 0.6
    CV_PROP_RW double workMegapix;
    /// Several images: index of the one that keeps its place and its colours. -1: the most central one keeps its place, colours
    /// are balanced over all; -2: no image keeps its place. At most 100000, and less than the number of images. For two images
    /// given to Aligner -1 takes one of both, which keeps its place; their colours are balanced. alignPair() ignores it: there the target keeps its
    /// place. With attach() it counts the images given to the stitcher. default -1
    CV_PROP_RW int referenceImage;
    //! @}

    //! @name Canvas
    //! @{

    /// Pixels of the canvas given to Aligner::align() after which x repeats: the full circle of a 360-degree panorama, at
    /// least the width of the widest image. 0: x never repeats. alignRig() and attach() replace it by their own, alignPair()
    /// and GcpwCompensator ignore it. default 0
    CV_PROP_RW double canvasPeriod;
    //! @}

    //! @name Weights of the terms (eq. totalfunction)
    //! @{

    /// lambda_1, weight of a squared difference of intensities at one sample (eq. phototerm), >= 0. Larger values let pixels
    /// overrule matches. Typical: 50..200. default 100
    CV_PROP_RW double photometricWeight;
    /// lambda_2, weight of a squared distance of matches in px^2 (eq. geometerm), >= 0. Larger values hold the mesh to the
    /// matches. Typical: 0.5..2. default 1
    CV_PROP_RW double geometricWeight;
    /// lambda_3, weight of a squared deviation from a similarity in px^2 (eq. similarityterm), > 0; of several images for each other
    /// image that one overlaps, as each of them pulls at it. Larger values keep shapes,
    /// smaller ones let the mesh bend to the parallax. Typical: 0.1..1; the paper has 0.5. default 0.12
    CV_PROP_RW double similarityWeight;
    /// Stretch of a quad (ratio of its longer to its shorter axis, less 1) at which it resists further stretch twice as much as an
    /// unstretched one, >= 0; not in the paper. Of several images it is divided by the root of how many others one overlaps. Smaller
    /// values spread parallax over more quads, larger ones let single quads shear. 0: resistance never grows. Typical: 0.1..1.
    /// default 0.5
    CV_PROP_RW double stretchLimit;
    /// Weight of a squared change of the edge of a quad from the rough alignment, in px^2, >= 0; not in the paper. It grows with the
    /// distance of the quad from the overlap, from 0 there to this at a tenth of the diagonal, and on. Larger values keep size and
    /// direction of what only one image shows. 0: it turns and grows with the overlap. Ignored by alignPair(), whose homography is good in
    /// the overlap alone. Typical: 0.1..3. default 0.3
    CV_PROP_RW double outsideWeight;
    /// Weight of a squared bend in px^2 of what is straight in the photographs, at one sample, >= 0; not in the paper. Long line
    /// segments of every image, matched or not, and the borders of photographs where no other image shows them, may shift and turn but
    /// stay as straight as the rough alignment has them. Larger values hold them more strictly. 0: lines bend with the mesh.
    /// Typical: 1..20. default 8
    CV_PROP_RW double straightnessWeight;
    /// What a refinement must pay for the shapes that it changes, >= 0; not in the paper. With a distortion D, the root of the mean
    /// square of ln(s1 / s2) over all quads that move (s1, s2: singular values of a quad's change from the rough alignment), it must
    /// remove more than this times (D - 0.1) of the misalignment, or the rough alignment is kept: where near and far things ask for
    /// different warps, one mesh shears what lies between and lines up little. Larger values keep more rough alignments. 0: distortion
    /// is free. Typical: 1..4. default 2
    CV_PROP_RW double distortionPrice;
    /// lambda_4, weight of a squared difference of the colours of adjacent quads (eq. colorterm), > 0. Larger values make the
    /// colour correction smoother; the paper's 1 lets gains collapse in quads without texture. Typical: 10..300. default 100
    CV_PROP_RW double colorSmoothnessWeight;
    /// Weight of E_r (eq. initialfunction), > 0: the squared deviation of gain and bias of a quad without samples from no change
    /// (two images), or from the gain and bias of its image (several). Larger values make the correction fade sooner outside
    /// the overlap. Typical: 0.1..10. default 1
    CV_PROP_RW double colorRestWeight;
    //! @}

    //! @name Sampling
    //! @{

    /// Pixels from one sample to the next, in x and in y, on every pyramid level, 1..64. Smaller values use more of the image
    /// and take up to quadratically longer. Typical: 1..4; the paper has 3. default 2
    CV_PROP_RW int sampleStep;
    /// Pixels from one sample of a matched line to the next, at least 0.1. Smaller values give lines more weight against points.
    /// Typical: 2..10. default 5
    CV_PROP_RW double lineStep;
    /// Levels of the Gaussian pyramid, 1..8, each half as large as the one below. More levels bridge larger misalignment of the
    /// pixels; images too small for a level have fewer. Typical: 2..5; the paper has 3. default 4
    CV_PROP_RW int pyramidLevels;
    //! @}

    //! @name Iteration
    //! @{

    /// Gauss-Newton iterations a pyramid level, 1..1000. Few levels need more than the default. default 10
    CV_PROP_RW int maxIterations;
    /// A level ends when no vertex moves farther in one iteration: pixels of that level, > 0. Larger values stop sooner.
    /// Typical: 0.01..0.2. default 0.05
    CV_PROP_RW double stopMotion;
    /// A level ends when an iteration lowers the energy by less than this ratio, 0..1. 0: energy alone never ends it. Larger
    /// values stop sooner. Typical: 0..0.02. default 0.01
    CV_PROP_RW double stopGain;
    //! @}

    //! @name Additions to the paper
    //! @{

    /// Standard deviation of the noise in intensities, 0..1. A sample is weighted by 0.01 / (v + contrastFloor^2), where v is the
    /// local variance of luma and 0.01 its typical value: low-contrast texture then counts as much as strong edges. Smaller
    /// values trust fainter texture, larger ones approach equal weights for all samples; 0 means exactly equal weights of 1.
    /// Typical: 0.01..0.1. default 0.03
    CV_PROP_RW double contrastFloor;
    /// Scale of the Geman-McClure loss of a sample's residual on the finest level, in local standard deviations of luma (in units
    /// of 0.1 intensity if contrastFloor is 0); doubled on each coarser level. Smaller values ignore more of what differs (moving
    /// objects, reflections). 0: squared loss. Typical: 1..4. default 2
    CV_PROP_RW double robustScale;
    /// Two images: weight of E_v, a prior on the gain of each quad, relative to photometricWeight, >= 0. It draws the gain to the
    /// ratio of the standard deviations of both images in the quad, the more so the less they correlate. Larger values keep
    /// the contrast of misaligned quads; with smaller ones their gain falls below 1, as least squares prefers. 0 switches off
    /// E_v and, for any number of images, the weighting of a quad's colours by its correlation. Typical: 1..5. default 3
    CV_PROP_RW double gainSupport;
    /// Scale of the Geman-McClure loss of point and line matches, pixels. Smaller values ignore more matches that disagree with
    /// the mesh. 0: squared loss. Typical: 1..5. default 2
    CV_PROP_RW double matchScale;
    /// Weight of a squared distance in px^2 of each corner of a quad from where matches alone had put it, >= 0. It acts only on
    /// quads that the pixels made worse (revertRatio). Larger values put them back more strictly. 0: they stay where the pixels
    /// put them, and bend more around them. Typical: 0.03..3. default 0.5
    CV_PROP_RW double anchorWeight;
    /// By which factor the mean squared decorrelation (1 - NCC) of a quad may rise before anchorWeight acts on it, >= 1. Larger
    /// values let pixels decide more often. Ignored where anchorWeight is 0. Typical: 1..1.5. default 1.05
    CV_PROP_RW double revertRatio;
    /// Several images; ignored for two. Weight of a squared distance in px^2 of each corner of every quad from its place in the
    /// rough alignment, >= 0: keeps long chains of images from drifting in scale and direction. Larger values keep closer to the
    /// cameras and align less. Typical: 0.003..0.1. default 0.01
    CV_PROP_RW double restWeight;
    /// Weight, per quad with samples, of the squared deviation of its gain and bias from the one gain and bias of its image that
    /// make whole overlaps agree, >= 0. Larger values give more uniform colours and keep the contrast of faint texture, smaller
    /// ones follow local light. Per quad, not per sample, unlike balanceWeight. Typical: 1..20. default 8
    CV_PROP_RW double exposureWeight;
    /// Images on a canvas, and GcpwCompensator without a rig; ignored by alignPair() and, of two images, where referenceImage names
    /// one. The same deviation when the colours
    /// to be shown are found, from the means and contrasts of overlapping quads with the meshes fixed; weighted by the number of
    /// samples that a full quad has, >= 0. Larger values give more uniform colours. 0: an alignment shows the colours that it
    /// found together with the meshes. Typical: 0.2..2. default 0.4
    CV_PROP_RW double balanceWeight;
    /// Smallest allowed area of each corner triangle of a quad, relative to its area in the rough alignment, in (0, 0.9]. What
    /// keeps the mesh from folding: larger values make the mesh stiffer where it is compressed. Typical: 0.05..0.3. default 0.1
    CV_PROP_RW double minQuadArea;
    //! @}

    //! @name Matching
    //! @{

    /// 1: corners of one image are followed to where the rough alignment expects them in the other (Lucas and Kanade, there and back);
    /// SIFT keypoints of small copies only find the homography of two photographs, and lead where there are any. 0: SIFT keypoints of
    /// all images are matched, as in the paper, which takes several times longer and aligns no better. Ignored where matches are given.
    /// default 1
    CV_PROP_RW int cornerTracking;
    /// Contrast threshold of cv::SIFT, in (0, 1]; OpenCV's own default is 0.04. Smaller values find more and weaker keypoints.
    /// Ignored where keypoints or matches are given. Typical: 0.003..0.04. default 0.005
    CV_PROP_RW double contrastThreshold;
    /// Ratio test of the matching around the rough alignment, in (0, 1]. Larger values give more matches and more wrong ones,
    /// which are filtered. Ignored where matches are given. Typical: 0.7..0.9. default 0.85
    CV_PROP_RW double matchRatio;
    /// 1: match a second time, near where the mesh fitted to the first matches expects each keypoint; finds more matches under
    /// parallax. 0: match once, as in the paper. Ignored where matches are given. default 1
    CV_PROP_RW int guidedMatching;
    /// Images are scaled down to this area for keypoints, in 10^6 pixels, > 0 and at most 1000; line segments are found there too,
    /// or at workMegapix if corners are followed. Larger values find more features and take longer. With cornerTracking keypoints are
    /// found at up to 0.15, and at this area only where those agree on no homography. Ignored where keypoints or matches are given.
    /// Typical: 0.5..4. default 2
    CV_PROP_RW double featureMegapix;
    //! @}
};

//! @}

} // namespace gcpw
} // namespace cv

#endif
