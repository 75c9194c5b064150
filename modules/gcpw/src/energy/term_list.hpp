// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#ifndef OPENCV_GCPW_TERM_LIST_HPP
#define OPENCV_GCPW_TERM_LIST_HPP

#include "opencv2/gcpw/params.hpp"

namespace cv
{
namespace gcpw
{

/// Which terms a method is made of.
struct TermList
{
    bool points = false;
    bool lines = false;
    bool pixels = false;
    bool colors = false;

    bool movesMesh() const { return points; }
};

TermList termsOf(Method method);

} // namespace gcpw
} // namespace cv

#endif
