// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#include "perf_precomp.hpp"

#include "pair_problem.hpp"

namespace opencv_test { namespace {

/// px between samples
typedef perf::TestBaseWithParam<int> Gcpw_PhotometricTerm;

PERF_TEST_P(Gcpw_PhotometricTerm, linearize_with_the_target_fixed, testing::Values(2, 3))
{
    const PairProblem problem(false);
    const gcpw::OverlapSamples samples = problem.samples(GetParam());
    gcpw::PhotometricTerm term(samples, problem.options());
    gcpw::EquationBuffer equations;
    double energy = 0;
    TEST_CYCLE()
    {
        equations.clear();
        energy = term.linearize(problem.states(), equations);
    }
    CV_Assert(energy > 0);
    SANITY_CHECK_NOTHING();
}

PERF_TEST_P(Gcpw_PhotometricTerm, linearize_with_both_moving, testing::Values(2, 3))
{
    const PairProblem problem(true);
    const gcpw::OverlapSamples samples = problem.samples(GetParam());
    gcpw::PhotometricTerm term(samples, problem.options());
    gcpw::EquationBuffer equations;
    double energy = 0;
    TEST_CYCLE()
    {
        equations.clear();
        energy = term.linearize(problem.states(), equations);
    }
    CV_Assert(energy > 0);
    SANITY_CHECK_NOTHING();
}

PERF_TEST_P(Gcpw_PhotometricTerm, evaluate_with_the_target_fixed, testing::Values(2, 3))
{
    const PairProblem problem(false);
    const gcpw::OverlapSamples samples = problem.samples(GetParam());
    gcpw::PhotometricTerm term(samples, problem.options());
    gcpw::EquationBuffer equations;
    term.linearize(problem.states(), equations);
    double energy = 0;
    TEST_CYCLE() energy = term.evaluate(problem.states());
    CV_Assert(energy > 0);
    SANITY_CHECK_NOTHING();
}

}} // namespace
