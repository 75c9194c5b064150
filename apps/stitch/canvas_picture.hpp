// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_CANVAS_PICTURE_HPP
#define GCPW_APPS_STITCH_CANVAS_PICTURE_HPP

#include "stitch/setup.hpp"
#include "stitch/warped_store.hpp"

/** @brief The picture of warped photographs, blended in rectangles as they are asked for.

A rectangle has the same bits whichever way the picture is cut into such: it is blended with a margin as wide as the blender reaches,
on the grid that the coarsest band has in the whole. */
class CanvasPicture
{
public:
    /** @param store of all photographs; outlives this
    @param canvas that they lie on  @param blending of the whole
    @param deep 16 bits  @param turns to the right, by 90 degrees, that make the picture stand
    @throws WrongUse if the blender reaches so far that tiles would be mostly margin */
    CanvasPicture(const WarpedStore& store, cv::Rect canvas, const Blending& blending, bool deep, int turns);

    /// Px around what a photograph shows that the blender mixes in.
    static int marginOf(const Blending& blending);

    cv::Size size() const;

    /// The part of the canvas that its pixels in a rectangle are made of.
    cv::Rect reach(cv::Rect rect) const;

    /// Its pixels in a rectangle, CV_8UC3 or CV_16UC3. From any thread.
    cv::Mat pixels(cv::Rect rect) const;

    /// Where it has pixels: CV_8UC1, 255 or 0.
    cv::Mat shown(cv::Rect rect) const;

    /// The largest rectangle without empty corners.
    cv::Rect largestRectangle() const;

private:
    /// The rectangle of the canvas that a rectangle of the picture shows.
    cv::Rect onCanvas(cv::Rect rect) const;
    cv::Mat stood(const cv::Mat& part) const;

    const WarpedStore& store_;
    cv::Rect canvas_;
    Blending blending_;
    bool deep_;
    int turns_;
};

#endif
