// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "stitch/warped_store.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <opencv2/imgproc.hpp>
#include <unistd.h>
#include "common/exit_code.hpp"
#include "common/grown.hpp"
#include "common/paths.hpp"

namespace
{

const int BLOCK = 512; ///< px a side: what lies in it is read at once

cv::Rect blockAt(int row, int col, cv::Size picture)
{
    return cv::Rect(col * BLOCK, row * BLOCK, BLOCK, BLOCK) & cv::Rect(cv::Point(), picture);
}

int blocksOf(int side)
{
    return (side + BLOCK - 1) / BLOCK;
}

int openNameless(const std::string& folder)
{
#ifdef O_TMPFILE
    const int nameless = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (nameless >= 0)
        return nameless;
#endif
    std::string name = folder + "/.gcpw-warped-" + std::string(6, 'X'); // which mkstemp() replaces
    const int file = mkstemp(&name[0]);
    if (file >= 0)
        unlink(name.c_str());
    return file;
}

} // namespace

WarpedStore::WarpedStore(const std::string& folder) : folder_(folder), file_(openNameless(folder))
{
    if (file_ < 0)
        throw FileTrouble("cannot write into " + shortened(folder) + ": " + std::strerror(errno));
}

WarpedStore::~WarpedStore()
{
    if (file_ >= 0)
        close(file_);
}

void WarpedStore::write(const cv::Mat& block)
{
    const cv::Mat whole = block.isContinuous() ? block : block.clone();
    const size_t size = whole.total() * whole.elemSize();
    for (size_t done = 0; done < size;)
    {
        const ssize_t count =
            pwrite(file_, whole.data + done, size - done, static_cast<off_t>(end_) + static_cast<off_t>(done));
        if (count <= 0)
            throw FileTrouble("cannot write into " + shortened(folder_) +
                              ": warped photographs are kept there while the picture is made, and the disk is full (" +
                              std::strerror(errno) + "); make room or choose another place for --output");
        done += static_cast<size_t>(count);
    }
    end_ += static_cast<double>(size);
}

void WarpedStore::readInto(cv::Mat& block, double offset) const
{
    const size_t size = block.total() * block.elemSize();
    for (size_t done = 0; done < size;)
    {
        const ssize_t count =
            pread(file_, block.data + done, size - done, static_cast<off_t>(offset) + static_cast<off_t>(done));
        if (count <= 0)
            throw FileTrouble("cannot read back from " + shortened(folder_) + ": " + std::strerror(errno));
        done += static_cast<size_t>(count);
    }
}

void WarpedStore::add(const cv::Mat& image, const cv::Mat& mask, cv::Point corner, int margin)
{
    CV_Assert(mask.type() == CV_8UC1 && mask.size() == image.size());
    Kept kept;
    kept.place = cv::Rect(corner, image.size());
    kept.type = image.type();
    kept.offsets = cv::Mat(blocksOf(image.rows), blocksOf(image.cols), CV_64FC1, cv::Scalar(-1));
    for (int row = 0; row < kept.offsets.rows; ++row)
        for (int col = 0; col < kept.offsets.cols; ++col)
        {
            const cv::Rect block = blockAt(row, col, image.size());
            const cv::Rect around = grown(block, margin) & cv::Rect(cv::Point(), image.size());
            if (cv::countNonZero(mask(around)) == 0)
                continue;
            kept.offsets.at<double>(row, col) = end_;
            write(image(block));
            write(mask(block));
        }
    kept_.push_back(kept);
}

void WarpedStore::readPart(const Kept& kept, cv::Rect inside, cv::Mat* image, cv::Mat& mask) const
{
    if (image)
        *image = cv::Mat(inside.size(), kept.type, cv::Scalar::all(0));
    mask = cv::Mat(inside.size(), CV_8UC1, cv::Scalar(0));
    const cv::Rect local = inside - kept.place.tl();
    for (int row = local.y / BLOCK; row <= (local.br().y - 1) / BLOCK; ++row)
        for (int col = local.x / BLOCK; col <= (local.br().x - 1) / BLOCK; ++col)
        {
            const double offset = kept.offsets.at<double>(row, col);
            if (offset < 0)
                continue;
            const cv::Rect block = blockAt(row, col, kept.place.size());
            const cv::Rect common = block & local;
            const cv::Rect from = common - block.tl();
            const cv::Rect to = common - local.tl();
            if (image)
            {
                cv::Mat pixels(block.size(), kept.type);
                readInto(pixels, offset);
                pixels(from).copyTo((*image)(to));
            }
            cv::Mat shown(block.size(), CV_8UC1);
            readInto(shown, offset + static_cast<double>(block.area()) * CV_ELEM_SIZE(kept.type));
            shown(from).copyTo(mask(to));
        }
}

std::vector<WarpedStore::Part> WarpedStore::read(cv::Rect rect) const
{
    std::vector<Part> parts;
    for (const Kept& kept : kept_)
    {
        const cv::Rect inside = kept.place & rect;
        if (inside.empty())
            continue;
        Part part;
        readPart(kept, inside, nullptr, part.mask);
        if (cv::countNonZero(part.mask) == 0)
            continue;
        readPart(kept, inside, &part.image, part.mask);
        part.corner = inside.tl();
        parts.push_back(part);
    }
    return parts;
}

cv::Mat WarpedStore::shown(cv::Rect rect) const
{
    cv::Mat all(rect.size(), CV_8UC1, cv::Scalar(0));
    for (const Kept& kept : kept_)
    {
        const cv::Rect inside = kept.place & rect;
        if (inside.empty())
            continue;
        cv::Mat mask;
        readPart(kept, inside, nullptr, mask);
        cv::Mat place = all(inside - rect.tl());
        place.setTo(cv::Scalar(255), mask);
    }
    return all;
}
