// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
//
// Stitches any number of photographs with OpenCV's pipeline, plain or with GCPW inside.
#include "common/program.hpp"
#include "stitch/run.hpp"

int main(int argc, char** argv)
{
    StitchOptions options;
    return runProgram(options.line(), argc, argv,
                      [&options](Console& console) { return runStitch(options.job(console), console); });
}
