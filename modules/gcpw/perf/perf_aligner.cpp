// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "perf_precomp.hpp"

#include "canvas_views.hpp"
#include "thread_count.hpp"

namespace opencv_test { namespace {

gcpw::Alignment align(const CanvasViews& views)
{
    gcpw::Params params;
    params.canvasPeriod = views.period;
    return gcpw::Aligner::create(params)->align(views.corners, views.images, noArray(),
                                                std::vector<gcpw::Correspondences>(), gcpw::Progress(), views.keypoints);
}

/// threads
typedef perf::TestBaseWithParam<int> Gcpw_Aligner;

PERF_TEST_P(Gcpw_Aligner, chain_of_five, testing::Values(1, 2))
{
    static const CanvasViews chain(5, false);
    const ThreadCount threads(GetParam());
    gcpw::Alignment alignment;
    TEST_CYCLE() alignment = align(chain);
    CV_Assert(alignment.ok() && alignment.report().pairs.size() == 4);
    SANITY_CHECK_NOTHING();
}

PERF_TEST_P(Gcpw_Aligner, ring_of_twelve, testing::Values(1, 2))
{
    static const CanvasViews ring(12, true);
    const ThreadCount threads(GetParam());
    gcpw::Alignment alignment;
    TEST_CYCLE() alignment = align(ring);
    CV_Assert(alignment.ok() && alignment.report().pairs.size() == 12);
    SANITY_CHECK_NOTHING();
}

}} // namespace
