// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_JPEG_END_HPP
#define GCPW_APPS_JPEG_END_HPP

#include <string>

/** @brief Whether a file begins as a JPEG and lacks its end, as after a broken copy.

Decoders fill what is missing with gray and do not tell: libjpeg prints a line, cv::imread() returns the image. The markers are
followed (ISO/IEC 10918-1, annex B), so that neither the end of a preview inside the file counts nor what cameras append behind
the picture. False where the file cannot be read. */
bool lacksJpegEnd(const std::string& path);

#endif
