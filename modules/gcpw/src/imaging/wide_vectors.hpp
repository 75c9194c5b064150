// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef OPENCV_GCPW_WIDE_VECTORS_HPP
#define OPENCV_GCPW_WIDE_VECTORS_HPP

/** @file
GCPW_WIDE_VECTORS before a function compiles it twice, for any processor and for those with AVX2; the loader chooses.

The additions keep their order and nothing is fused (AVX2 alone has no multiply-add), so both give the same bits. For the
few functions that run over every sample: they are a fifth faster. Not under sanitizers: these start after the loader has
chosen. */

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GCPW_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define GCPW_WIDE_VECTORS
#endif

#endif
