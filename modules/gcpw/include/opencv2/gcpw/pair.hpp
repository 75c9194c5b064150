// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
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
canvas of the alignment is the target's own frame; renderPair() shows it in any View.

@code
const cv::gcpw::Alignment alignment = cv::gcpw::alignPair(source, target);
if (alignment.report().status == cv::gcpw::Status::NO_ALIGNMENT)
    return false;
cv::Mat panorama;
cv::gcpw::blendPair(cv::gcpw::renderPair(alignment, source, target), cv::gcpw::Blend::MULTIBAND, panorama);
@endcode

@param source photograph to be warped: BGR, gray or BGRA of 8 or 16 bits; the estimate is made on 8. A 4th channel is the mask of
valid pixels
@param target photograph that it is aligned to, of the same types
@param params see Params; referenceImage, canvasPeriod, restWeight and balanceWeight are ignored
@return image 0 is the source, image 1 the target, undeformed. No images and Status::NO_ALIGNMENT if the photographs do not match;
Status::ROUGH if they match and the refinement failed or improved nothing
@throws cv::Exception if an image is empty or of a type not listed, or params are out of range */
CV_EXPORTS_W Alignment alignPair(InputArray source, InputArray target, const Params& params = Params());

/** @overload
@param source, target as above
@param params as above
@param progress may be empty; cancelling returns Status::CANCELLED
@return as above
@throws cv::Exception as above */
CV_EXPORTS_W Alignment alignPair(InputArray source, InputArray target, const Params& params, const Progress& progress);

/** @brief The same with matches that are known already.

Matches hold where the photographs show the same things, so the images may be recoloured or filtered copies of those that
were matched: then the pixels are compared as the copies show them, and renderPair() takes either.
@param source, target as above, of the sizes that `matches` names
@param matches from findPairMatches(), or the caller's own. Each method uses those that it has a term for: Method::CPW no lines,
Method::GLOBAL only the homography
@param params as above; those of matching are ignored
@param progress may be empty; cancelling returns Status::CANCELLED
@return as above; its report counts the matches used
@throws cv::Exception also if sizes, counts or values of the matches are not as PairMatches says, before any work */
CV_EXPORTS_W Alignment alignPair(InputArray source, InputArray target, const PairMatches& matches, const Params& params = Params(),
                                 const Progress& progress = Progress());

/// How the two images become one picture.
enum class Blend
{
    AVERAGE = 0,  //!< plain mean in the overlap, of the source as it is: as in the paper, shows misalignment as ghosts
    MULTIBAND = 1 //!< OpenCV's graph-cut seam and multi-band blender, of the source with its colours corrected
};

/** @brief From where the two photographs of a picture are seen.

In the target's own frame all distortion is the source's: where the camera turned far between the two, the source is stretched
and the canvas grows. The natural view shares it out, and both still meet where they met. It is the first of these that fits:

- the homography of the canvas that stretches both photographs least, if no pixel is enlarged more than 1.25 times. Its scale
  keeps the area of both together. It is upright halfway between both photographs; quarter turns of a camera held on its side are
  not halved;
- that of a panorama, where a camera that turned about its vertical axis explains the pair: levelled along the turn, on a plane, or
  where that enlarges more than 1.9 times (a view of about 80 degrees), on a sphere. A pixel in its middle is a pixel of the
  photographs. On a sphere lines that are neither upright nor on the horizon bend, as they do in cv::Stitcher's default;
- the homography all the same.

Colours follow the view. In the target's frame the source takes the light of the target, by the colours of the alignment. In the
natural view both are corrected, so that together they keep the light of both: the colours are found anew with the photographs as
aligned, unless the alignment leaves them unchanged (Method::MFW). */
enum class View
{
    TARGET = 0, //!< the target's frame, as in the paper: the target is only shifted and its pixels are copied
    NATURAL = 1 //!< between both photographs: both are resampled
};

/// Both photographs on one canvas, in pixels of its view; all images and masks have one size. The pictures are CV_8UC3, or CV_16UC3 if
/// either photograph was of 16 bits.
struct CV_EXPORTS_W_SIMPLE PairCanvas
{
    /// Empty.
    CV_WRAP PairCanvas() {}

    CV_PROP_RW Mat source;           //!< warped source, colours unchanged; black outside its mask
    CV_PROP_RW Mat source_mask;      //!< CV_8UC1: 255 exactly where the mesh covers a pixel centre with a valid pixel
    CV_PROP_RW Mat source_corrected; //!< warped source with the colours that it is shown with
    CV_PROP_RW Mat target;           //!< the target as its view has it, colours unchanged; black outside its mask
    CV_PROP_RW Mat target_corrected; //!< the same with the colours that it is shown with; empty counts as `target`
    CV_PROP_RW Mat target_mask;      //!< CV_8UC1: 255 where the target has a valid pixel
    CV_PROP_RW Mat mesh;             //!< the mesh drawn over the mean of both, always CV_8UC3
    CV_PROP_RW Point target_origin;  //!< canvas pixel of the target's top-left pixel, rounded
    /// 3 x 3, CV_64FC1: homography from pixels of the target; a shift for View::TARGET. If the view is a sphere, it is right at the
    /// middle of the target and nearly so around it.
    CV_PROP_RW Mat canvas_from_target;
};

/** @brief Renders an alignment at full resolution.
@param alignment from alignPair(), with a status other than NO_ALIGNMENT
@param source the aligned source or a recoloured copy of the same size, of 8 or 16 bits whatever it was aligned with
@param target the target or a recoloured copy of the same size
@param view from where both are seen. Scores of different alignments compare only in View::TARGET
@return both photographs on a canvas that holds all of their pixels
@throws cv::Exception if sizes do not fit, or if the canvas would exceed 32766 px a side or 400 Mpx */
CV_EXPORTS_W PairCanvas renderPair(const Alignment& alignment, InputArray source, InputArray target, View view = View::TARGET);

/** @brief One picture of a canvas.
@param canvas from renderPair()
@param blend how
@param picture of the canvas's size and type; black where neither image has pixels. Of 16 bits MULTIBAND keeps 13
@throws cv::Exception if the canvas is empty */
CV_EXPORTS_W void blendPair(const PairCanvas& canvas, Blend blend, OutputArray picture);

/** @overload
@param canvas from renderPair()
@param blend how
@return the picture, of the canvas's size and type
@throws cv::Exception if the canvas is empty */
CV_EXPORTS Mat blendPair(const PairCanvas& canvas, Blend blend);

/** @brief How well the images agree in the overlap of a canvas, at its own resolution, the source with its colours unchanged.
@param canvas from renderPair(), best in View::TARGET
@return see Score; NaN where the photographs do not overlap or nothing in the overlap has texture
@throws cv::Exception if the canvas is empty */
CV_EXPORTS_W Score scorePair(const PairCanvas& canvas);

/** @brief alignPair(), renderPair() and blendPair() in one call.
@param source, target photographs, see alignPair()
@param panorama receives the picture, CV_8UC3, or CV_16UC3 if either photograph is of 16 bits; not touched unless true is returned
@param params see alignPair()
@param blend how the two become one picture
@param view from where both are seen
@return false if no alignment was found; true also for a rough one
@throws cv::Exception see alignPair() and renderPair() */
CV_EXPORTS_W bool stitchPair(InputArray source, InputArray target, OutputArray panorama, const Params& params = Params(),
                             Blend blend = Blend::MULTIBAND, View view = View::NATURAL);

//! @}

} // namespace gcpw
} // namespace cv

#endif
