#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Completion in bash offers the options that a program has, and files. Usage: test_completion.py PROGRAMS SCRATCH SAMPLES"""
import pathlib
import shutil
import subprocess

from harness import main

COMPLETION = pathlib.Path(__file__).resolve().parents[2] / "packaging/completion/gcpw"


def completions(bench, *words):
    """What bash offers for the last of these words."""
    script = 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _gcpw "$1" && printf "%s\\n" "${COMPREPLY[@]}"'
    command = ["bash", "--norc", "-c", script, "bash", COMPLETION, bench.place(words[0]), *words[1:]]
    return subprocess.run(command, cwd=bench.scratch, capture_output=True, text=True, check=False).stdout.split()


def test(bench):
    if shutil.which("bash") is None:
        print("there is no bash")
        return
    for program in ("gcpw_pair", "gcpw_stitch"):
        offered = completions(bench, program, "--")
        bench.check({"--output", "--report", "--help"} <= set(offered), f"{program} --: offers {offered}")
        offered = completions(bench, program, "--outp")
        bench.check(offered == ["--output"], f"{program} --outp: offers {offered}")
    bench.path("photograph.jpg").touch()
    offered = completions(bench, "gcpw_stitch", "photo")
    bench.check(offered == ["photograph.jpg"], f"gcpw_stitch photo: offers {offered}")


if __name__ == "__main__":
    main(test)
