// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_PAIR_HPP
#define OPENCV_GCPW_PAIR_HPP

#include "opencv2/gcpw/pair_matches.hpp"

namespace cv
{
namespace gcpw
{

//! @addtogroup gcpw
//! @{

/** @brief Aligns a source photograph to a target photograph: the paper's two-image case.

Keypoints and line segments give a rough homography, then mesh and colour of the source are estimated together. The
canvas is the target's own frame.
@param source, target 8-bit BGR, gray or BGRA; 16-bit is scaled down. A 4th channel is the mask of valid pixels
@param params constants; see Params
@param progress may be empty
@return image 0 is the source, image 1 the target (at rest). Status NO_ALIGNMENT if the photographs do not match
@throws cv::Exception if an image is empty or of a type not listed, or params are out of range */
CV_EXPORTS Alignment alignPair(InputArray source, InputArray target, const Params& params = Params(),
                               const Progress& progress = Progress());

/** @brief The same with matches that are known already.

Matches hold where the photographs show the same things, so the images may be recoloured or filtered copies of those that
were matched: then the pixels are compared as the copies show them, and renderPair() takes either.
@param source, target as above, of the sizes that `matches` names
@param matches from findPairMatches(), or the caller's own. The methods use of them what they know: Method::CPW no lines,
Method::GLOBAL only the homography
@throws cv::Exception also if sizes, counts or values of the matches are not as PairMatches says, before any work */
CV_EXPORTS Alignment alignPair(InputArray source, InputArray target, const PairMatches& matches, const Params& params = Params(),
                               const Progress& progress = Progress());

/// How the two images become one picture.
enum class Blend
{
    AVERAGE = 0,  //!< plain mean in the overlap, as in the paper
    MULTIBAND = 1 //!< OpenCV's graph-cut seam and multi-band blender
};

/// Both photographs on one canvas at the target's resolution; all Mats have one size.
struct CV_EXPORTS PairCanvas
{
    Mat source;           //!< warped source, colours untouched, CV_8UC3
    Mat source_mask;      //!< 255 exactly where the mesh covers a pixel centre, CV_8UC1
    Mat source_corrected; //!< warped source with the colour model applied
    Mat target;           //!< the target, only translated
    Mat target_mask;
    Mat mesh;             //!< picture of the mesh over both
    Point target_origin;  //!< canvas pixel of the target's top-left pixel
};

/** @brief Renders an alignment at full resolution.
@param alignment from alignPair(), with a status other than NO_ALIGNMENT
@param source the aligned source or a recoloured copy of the same size  @param target the target
@throws cv::Exception if sizes do not fit, or if the canvas would exceed 2^15 px or 400 Mpx */
CV_EXPORTS PairCanvas renderPair(const Alignment& alignment, InputArray source, InputArray target);

/// One picture of a canvas, CV_8UC3. `average` mixes the untouched source, `multiband` the corrected one.
CV_EXPORTS Mat blendPair(const PairCanvas& canvas, Blend blend);

/// Scores of the overlap of a canvas at its own resolution, source with its colours untouched.
CV_EXPORTS Score scorePair(const PairCanvas& canvas);

/** @brief alignPair(), renderPair() and blendPair() in one call.
@param panorama receives the picture; untouched unless true is returned
@return false if no alignment was found */
CV_EXPORTS bool stitchPair(InputArray source, InputArray target, OutputArray panorama, const Params& params = Params(),
                           Blend blend = Blend::MULTIBAND);

//! @}

} // namespace gcpw
} // namespace cv

#endif
