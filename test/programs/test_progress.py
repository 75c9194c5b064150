#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""gcpw_pair and gcpw_stitch: the line on a terminal goes on in every stage, never back, and is wiped in the end.

Usage: test_progress.py PROGRAMS SCRATCH SAMPLES"""
import os
import re
import subprocess
import sys

from harness import main

SKIPPED = 77  # what ctest takes for a test that did not run
LINE = re.compile(r"\r([a-z ]+?) +(\d+) %")


def shown(bench, program, *arguments):
    """Stages and per cents as a terminal gets them, and all that it got."""
    mine, theirs = os.openpty()
    command = [str(bench.place(program)), *arguments, "--force"]
    with subprocess.Popen(command, cwd=bench.scratch, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=theirs) as running:
        os.close(theirs)
        text = b""
        while True:
            try:
                part = os.read(mine, 1 << 16)
            except OSError:  # what Linux says at the end of a terminal
                break
            if not part:
                break
            text += part
        bench.check(running.wait() == 0, f"{program} {arguments}: exit code {running.returncode}")
    os.close(mine)
    said = text.decode()
    return [(stage, int(percent)) for stage, percent in LINE.findall(said)], said


def goes_on(bench, stages, program, *arguments):
    """stages: those that are shown, in order, each with the least number of different per cents."""
    lines, said = shown(bench, program, *arguments)
    call = f"{program} {' '.join(arguments)}"
    order = list(dict.fromkeys(stage for stage, _ in lines))
    bench.check(order == list(stages), f"{call}: stages are {order}")
    percents = [percent for _, percent in lines]
    bench.check(percents == sorted(percents), f"{call}: goes back: {lines}")
    bench.check(percents and percents[-1] >= 85, f"{call}: ends at {percents[-1:]}")
    for stage, least in stages.items():
        seen = {percent for one, percent in lines if one == stage}
        bench.check(len(seen) >= least, f"{call}: {stage} shows {sorted(seen)} only")
    last = said.rstrip("\r\n").split("\r")[-2:]
    bench.check("%" not in said.replace("\r\n", "\n").split("\r")[-1], f"{call}: the line is left: {last}")


def test(bench):
    source, target = bench.synthetic_pair()
    quick = ("--work_megapix=0.15", "--output=pano.png")
    goes_on(bench, {"reading": 2, "matching": 3, "aligning": 5, "rendering": 3}, "gcpw_pair", source, target, *quick)
    stages = {"reading": 2, "finding cameras": 4, "aligning": 5, "cutting seams": 3, "composing": 2}
    goes_on(bench, stages, "gcpw_stitch", source, target, *quick)
    goes_on(bench, stages, "gcpw_stitch", source, target, *quick, "--mode=panorama")
    silent, said = shown(bench, "gcpw_stitch", source, target, *quick, "--quiet")
    bench.check(not silent and not said.strip(), f"--quiet shows {said}")


if __name__ == "__main__":
    if not hasattr(os, "openpty"):
        print("This system has no terminals to look at.")
        sys.exit(SKIPPED)
    main(test)
