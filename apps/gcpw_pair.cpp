// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
//
// Stitches two overlapping photographs: the source is warped onto the target, and both are shown from a view between them.
#include "common/program.hpp"
#include "pair/run.hpp"

int main(int argc, char** argv)
{
    PairOptions options;
    return runProgram(options.line(), argc, argv,
                      [&options](Console& console) { return runPair(options.job(console), console); });
}
