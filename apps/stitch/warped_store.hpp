// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_STITCH_WARPED_STORE_HPP
#define GCPW_APPS_STITCH_WARPED_STORE_HPP

#include <string>
#include <vector>
#include <opencv2/core.hpp>

/** @brief Warped photographs on disk: written one after the other, read where a tile needs them.

In a file without a name, which the system removes with the program, however that ends. Only blocks are kept in which a photograph
shows, or which a blender mixes in: the rest reads as zeros. */
class WarpedStore
{
public:
    /// @param folder with room for the file; 4 or 7 bytes for each pixel that is kept  @throws FileTrouble
    explicit WarpedStore(const std::string& folder);
    ~WarpedStore();
    WarpedStore(const WarpedStore&) = delete;
    WarpedStore& operator=(const WarpedStore&) = delete;

    /// A photograph inside a rectangle.
    struct Part
    {
        cv::Mat image;    ///< as added
        cv::Mat mask;     ///< CV_8UC1
        cv::Point corner; ///< on the canvas
    };

    /** @brief Adds the next photograph.
    @param image of any type, CV_8UC3 or CV_16SC3  @param mask CV_8UC1 of its size
    @param corner on the canvas  @param margin px around what is shown that are kept, too */
    void add(const cv::Mat& image, const cv::Mat& mask, cv::Point corner, int margin);

    /// The parts of all photographs that show inside a rectangle of the canvas, in their order. From any thread.
    std::vector<Part> read(cv::Rect rect) const;

    /// Where any photograph shows inside it: CV_8UC1, 255 or 0. From any thread.
    cv::Mat shown(cv::Rect rect) const;

private:
    struct Kept
    {
        cv::Rect place; ///< on the canvas
        int type;
        cv::Mat offsets; ///< CV_64FC1, one for each block: where in the file; -1 if not kept
    };

    void write(const cv::Mat& block);
    void readInto(cv::Mat& block, double offset) const;
    /// Image, if asked for, and mask of one photograph inside a rectangle that lies in its own.
    void readPart(const Kept& kept, cv::Rect inside, cv::Mat* image, cv::Mat& mask) const;

    std::string folder_;
    int file_ = -1;
    double end_ = 0; ///< bytes written
    std::vector<Kept> kept_;
};

#endif
