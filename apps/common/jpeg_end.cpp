// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "common/jpeg_end.hpp"

#include <fstream>

namespace
{

/// The second byte of markers.
enum Marker
{
    STUFFED = 0x00, ///< no marker: a byte of 255 among the data
    TEMPORARY = 0x01,
    FIRST_RESTART = 0xd0,
    LAST_RESTART = 0xd7,
    START = 0xd8,
    END = 0xd9,
    FILL = 0xff
};

/// Markers that stand alone among the data of a scan.
bool belongsToData(int marker)
{
    return marker == STUFFED || marker == TEMPORARY || (marker >= FIRST_RESTART && marker <= LAST_RESTART);
}

/// The next marker behind the data of a scan, of which there may be none; -1 at the end of the file.
int nextMarker(std::istream& file)
{
    int byte = file.get();
    while (file)
    {
        const bool marks = byte == FILL;
        byte = file.get();
        if (marks && file && byte != FILL && !belongsToData(byte))
            return byte;
    }
    return -1;
}

/// Passes over what belongs to a marker; false where the file ends before.
bool passSegment(std::istream& file)
{
    const int high = file.get();
    const int low = file.get();
    const int length = high * 256 + low; // with its own two bytes
    file.ignore(length - 2);
    return static_cast<bool>(file);
}

} // namespace

bool lacksJpegEnd(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (file.get() != FILL || file.get() != START)
        return false;
    for (;;)
    {
        const int marker = nextMarker(file);
        if (marker == END)
            return false;
        if (marker == -1 || !passSegment(file))
            return true;
    }
}
