// Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
#include "perf_precomp.hpp"

#include "pair_problem.hpp"

namespace opencv_test { namespace {

/// px between samples
typedef perf::TestBaseWithParam<int> Gcpw_PhotometricTerm;

PERF_TEST_P(Gcpw_PhotometricTerm, pour_with_the_target_fixed, testing::Values(2, 3))
{
    const PairProblem problem(false);
    const gcpw::PhotometricTerm term = problem.pixels(GetParam());
    gcpw::NullEquations equations;
    double energy = 0;
    TEST_CYCLE() energy = term.linearize(problem.states(), false, problem.loss(), equations);
    CV_Assert(energy > 0);
    SANITY_CHECK_NOTHING();
}

PERF_TEST_P(Gcpw_PhotometricTerm, pour_with_both_moving, testing::Values(2, 3))
{
    const PairProblem problem(true);
    const gcpw::PhotometricTerm term = problem.pixels(GetParam());
    gcpw::NullEquations equations;
    double energy = 0;
    TEST_CYCLE() energy = term.linearize(problem.states(), true, problem.loss(), equations);
    CV_Assert(energy > 0);
    SANITY_CHECK_NOTHING();
}

}} // namespace
