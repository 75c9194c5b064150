// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "energy/term_list.hpp"

namespace cv
{
namespace gcpw
{

TermList termsOf(Method method)
{
    const int rank = static_cast<int>(method);
    TermList terms_used;
    terms_used.points = rank >= static_cast<int>(Method::CPW);
    terms_used.lines = rank >= static_cast<int>(Method::DFW);
    terms_used.pixels = rank >= static_cast<int>(Method::MFW);
    terms_used.colors = rank >= static_cast<int>(Method::GCPW);
    return terms_used;
}

} // namespace gcpw
} // namespace cv
