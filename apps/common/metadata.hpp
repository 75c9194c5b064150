// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_METADATA_HPP
#define GCPW_APPS_METADATA_HPP

#include <memory>
#include <string>
#include <vector>
#include <opencv2/core.hpp>

/** @brief What a file says about its photograph besides the pixels: orientation, focal length, colour profile, when and how it was
taken. Read by Exiv2 from JPEG, PNG, TIFF, WebP and HEIC. */
class Metadata
{
public:
    /// None.
    Metadata();
    ~Metadata();
    Metadata(const Metadata&);
    Metadata& operator=(const Metadata&);

    /// @return none where the file has none or cannot be read
    static Metadata read(const std::string& path);

    /// Pixels of the picture in a file, without decoding it; 0 if it cannot be told.
    static double pixelsOf(const std::string& path);

    /// EXIF's 1 to 8: how the stored picture has to be turned or mirrored to stand upright; 1 means not at all.
    int orientation() const { return orientation_; }

    /// Focal length in pixels of a photograph of this size; 0 if the file does not say it.
    double focalLength(cv::Size size) const;

    /// The ICC profile of the colours, empty if there is none.
    const std::vector<uchar>& profile() const { return profile_; }

    /** @brief Adds the profile and what is known of the taking (camera, lens, exposure, time, place, author; not the orientation, as
    pictures are written upright) to a picture.
    @param encoded a whole file as cv::imencode() makes it  @param size of the picture in it
    @return the file with them; as it is where its format takes none, such as .bmp */
    std::vector<uchar> addTo(const std::vector<uchar>& encoded, cv::Size size) const;

private:
    struct Tags;

    std::shared_ptr<const Tags> tags_; ///< null if there are none
    std::vector<uchar> profile_;
    int orientation_ = 1;
};

/// A picture as stored, turned and mirrored as EXIF's orientation says (1 to 8).
cv::Mat upright(const cv::Mat& stored, int orientation);

#endif
