// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "perf_precomp.hpp"

#include "pair_problem.hpp"
#include "thread_count.hpp"

namespace opencv_test { namespace {

/// Two photographs and what was matched between them.
struct MatchedPair
{
    Scene scene;
    gcpw::PairMatches matches;

    explicit MatchedPair(const SceneOptions& options)
        : scene(options), matches(gcpw::findPairMatches(scene.source(), scene.target()))
    {
    }
    gcpw::Alignment align(gcpw::Method method = gcpw::Method::GCPW) const
    {
        gcpw::Params params;
        params.method = method;
        return gcpw::alignPair(scene.source(), scene.target(), matches, params);
    }
};

const MatchedPair& recoloredPair()
{
    static const MatchedPair pair(pairOptions());
    return pair;
}

/// In the same light: here MF-W does what GCPW does, without the colours.
const MatchedPair& plainPair()
{
    static const MatchedPair pair = []
    {
        SceneOptions options = pairOptions();
        options.recolored = false;
        return MatchedPair(options);
    }();
    return pair;
}

PERF_TEST(Gcpw_Pair, find_matches)
{
    const ThreadCount threads(1);
    const Scene& scene = recoloredPair().scene;
    gcpw::PairMatches matches;
    TEST_CYCLE() matches = gcpw::findPairMatches(scene.source(), scene.target());
    CV_Assert(matches.status == gcpw::Status::OK);
    SANITY_CHECK_NOTHING();
}

PERF_TEST(Gcpw_Pair, align_in_equal_light)
{
    const ThreadCount threads(1);
    const MatchedPair& pair = plainPair();
    gcpw::Alignment alignment;
    TEST_CYCLE() alignment = pair.align();
    CV_Assert(alignment.ok());
    SANITY_CHECK_NOTHING();
}

PERF_TEST(Gcpw_Pair, align_in_equal_light_by_mfw)
{
    const ThreadCount threads(1);
    const MatchedPair& pair = plainPair();
    gcpw::Alignment alignment;
    TEST_CYCLE() alignment = pair.align(gcpw::Method::MFW);
    CV_Assert(alignment.ok());
    SANITY_CHECK_NOTHING();
}

/// threads
typedef perf::TestBaseWithParam<int> Gcpw_PairThreads;

PERF_TEST_P(Gcpw_PairThreads, align, testing::Values(1, 2))
{
    const MatchedPair& pair = recoloredPair();
    const ThreadCount threads(GetParam());
    gcpw::Alignment alignment;
    TEST_CYCLE() alignment = pair.align();
    CV_Assert(alignment.ok());
    SANITY_CHECK_NOTHING();
}

}} // namespace
