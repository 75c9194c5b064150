// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/metadata.hpp"

#include <cmath>
#include <exiv2/exiv2.hpp>
#include "common/embed.hpp"

namespace
{

/// What is copied to a picture: how its photographs were taken, not how their pixels are stored.
const char* const COPIED[] = {"Exif.Image.Make",
                              "Exif.Image.Model",
                              "Exif.Image.Artist",
                              "Exif.Image.Copyright",
                              "Exif.Image.DateTime",
                              "Exif.Image.ImageDescription",
                              "Exif.Image.XResolution",
                              "Exif.Image.YResolution",
                              "Exif.Image.ResolutionUnit",
                              "Exif.Photo.ExposureTime",
                              "Exif.Photo.FNumber",
                              "Exif.Photo.ExposureProgram",
                              "Exif.Photo.ISOSpeedRatings",
                              "Exif.Photo.DateTimeOriginal",
                              "Exif.Photo.DateTimeDigitized",
                              "Exif.Photo.OffsetTimeOriginal",
                              "Exif.Photo.ExposureBiasValue",
                              "Exif.Photo.MeteringMode",
                              "Exif.Photo.Flash",
                              "Exif.Photo.FocalLength",
                              "Exif.Photo.FocalLengthIn35mmFilm",
                              "Exif.Photo.WhiteBalance",
                              "Exif.Photo.LensMake",
                              "Exif.Photo.LensModel",
                              "Exif.Photo.LensSpecification",
                              "Exif.Photo.ColorSpace"};
const char* const PLACE = "GPSInfo";
const double FILM_DIAGONAL = 43.2666; ///< mm of 24 x 36 mm film, what FocalLengthIn35mmFilm compares with

double numberAt(const Exiv2::ExifData& tags, const char* key)
{
    const Exiv2::ExifData::const_iterator found = tags.findKey(Exiv2::ExifKey(key));
    if (found == tags.end() || found->count() == 0)
        return 0;
    const double number = found->toFloat();
    return std::isfinite(number) ? number : 0;
}

bool isCopied(const Exiv2::Exifdatum& tag)
{
    for (const char* key : COPIED)
        if (tag.key() == key)
            return true;
    return tag.groupName() == PLACE;
}

std::vector<uchar> embedByExiv2(const std::vector<uchar>& encoded, const Exiv2::ExifData& tags,
                                const std::vector<uchar>& profile)
{
    const auto image = Exiv2::ImageFactory::open(encoded.data(), static_cast<long>(encoded.size()));
    image->readMetadata();
    for (const Exiv2::Exifdatum& tag : tags) // what the encoder wrote itself stays, in TIFF the picture depends on it
        image->exifData()[tag.key()] = tag.value();
    if (!profile.empty())
    {
        Exiv2::DataBuf copy(profile.data(), static_cast<long>(profile.size()));
        image->setIccProfile(copy);
    }
    image->writeMetadata();
    Exiv2::BasicIo& io = image->io();
    if (io.open() != 0)
        return encoded;
    std::vector<uchar> file(static_cast<size_t>(io.size()));
    const bool whole = io.read(file.data(), static_cast<long>(file.size())) == static_cast<long>(file.size());
    return whole ? file : encoded;
}

} // namespace

struct Metadata::Tags
{
    Exiv2::ExifData all;
};

Metadata::Metadata() = default;
Metadata::~Metadata() = default;
Metadata::Metadata(const Metadata&) = default;
Metadata& Metadata::operator=(const Metadata&) = default;

Metadata Metadata::read(const std::string& path)
{
    Exiv2::LogMsg::setLevel(Exiv2::LogMsg::mute); // odd tags are no concern of the user's
    Metadata metadata;
    try
    {
        const auto image = Exiv2::ImageFactory::open(path);
        image->readMetadata();
        const auto tags = std::make_shared<Tags>();
        tags->all = image->exifData();
        const int orientation = static_cast<int>(numberAt(tags->all, "Exif.Image.Orientation"));
        metadata.orientation_ = orientation >= 1 && orientation <= 8 ? orientation : 1;
        if (image->iccProfileDefined())
        {
            const Exiv2::DataBuf* const profile = image->iccProfile();
            metadata.profile_.assign(profile->pData_, profile->pData_ + profile->size_);
        }
        metadata.tags_ = tags;
    }
    catch (const std::exception&) // no metadata, or damaged: the pixels may be whole all the same
    {
    }
    return metadata;
}

double Metadata::pixelsOf(const std::string& path)
{
    try
    {
        const auto image = Exiv2::ImageFactory::open(path);
        image->readMetadata();
        return static_cast<double>(image->pixelWidth()) * image->pixelHeight();
    }
    catch (const std::exception&)
    {
        return 0;
    }
}

double Metadata::focalLength(cv::Size size) const
{
    if (!tags_)
        return 0;
    const double diagonal = std::hypot(size.width, size.height);
    const double on_film = numberAt(tags_->all, "Exif.Photo.FocalLengthIn35mmFilm");
    if (on_film > 0)
        return on_film / FILM_DIAGONAL * diagonal;
    // Pixels of the sensor per unit of its plane, of a photograph of PixelXDimension pixels.
    const double focal_mm = numberAt(tags_->all, "Exif.Photo.FocalLength");
    const double per_unit = numberAt(tags_->all, "Exif.Photo.FocalPlaneXResolution");
    const int unit = static_cast<int>(numberAt(tags_->all, "Exif.Photo.FocalPlaneResolutionUnit"));
    const double stored_width = numberAt(tags_->all, "Exif.Photo.PixelXDimension");
    const double unit_mm = unit == 3 ? 10 : unit == 4 ? 1 : 25.4;
    if (!(focal_mm > 0) || !(per_unit > 0) || !(stored_width > 0))
        return 0;
    const double longer = std::max(size.width, size.height);
    return focal_mm / unit_mm * per_unit * longer / stored_width;
}

std::vector<uchar> Metadata::addTo(const std::vector<uchar>& encoded, cv::Size size) const
{
    Exiv2::ExifData tags;
    if (tags_)
        for (const Exiv2::Exifdatum& tag : tags_->all)
            if (isCopied(tag))
                tags.add(tag);
    if (tags.empty() && profile_.empty())
        return encoded;
    try
    {
        if (isPng(encoded) || isWebp(encoded))
        {
            Exiv2::Blob exif;
            if (!tags.empty())
                Exiv2::ExifParser::encode(exif, Exiv2::littleEndian, tags);
            return isPng(encoded) ? embedInPng(encoded, exif, profile_) : embedInWebp(encoded, exif, profile_, size);
        }
        return embedByExiv2(encoded, tags, profile_);
    }
    catch (const std::exception&) // a format that takes none
    {
        return encoded;
    }
}

cv::Mat upright(const cv::Mat& stored, int orientation)
{
    cv::Mat picture = stored;
    if (orientation >= 5) // rows and columns change places
        cv::transpose(picture, picture);
    // What is left to mirror: EXIF says where the first row and the first column of the stored picture belong.
    const bool left_right = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
    const bool top_bottom = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
    if (left_right || top_bottom)
    {
        cv::Mat mirrored;
        cv::flip(picture, mirrored, left_right && top_bottom ? -1 : left_right ? 1 : 0);
        picture = mirrored;
    }
    return picture;
}
