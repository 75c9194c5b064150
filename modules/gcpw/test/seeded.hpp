// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_TEST_SEEDED_HPP
#define OPENCV_GCPW_TEST_SEEDED_HPP

#include "test_precomp.hpp"

#include <cstdint>

namespace opencv_test
{

/// A bijection of 64 bits that leaves no pattern (splitmix64).
inline uint64_t mixBits(uint64_t z)
{
    z += 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
}

/// Repeatable random numbers. RNG(1) and RNG(2) give numbers that are multiples of each other; these do not.
inline RNG seeded(uint64_t seed)
{
    return RNG(mixBits(seed));
}

} // namespace opencv_test

#endif
