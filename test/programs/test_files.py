#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""gcpw_pair and gcpw_stitch: photographs that are cut short or of the wrong kind, and places that take no more bytes.

Usage: test_files.py PROGRAMS SCRATCH SAMPLES"""
import pathlib
import resource
import struct
import subprocess

from harness import FILE_TROUBLE, main

QUICK = {"gcpw_pair": ("--work_megapix=0.15", "--set=featureMegapix=0.15"),
         "gcpw_stitch": ("--work_megapix=0.15", "--compose_megapix=0.15", "--seam=no")}


def cut_short(bench, source, target):
    """Decoders fill the rest of a cut JPEG with gray and say nothing."""
    bench.run("gcpw_pair", source, target, *QUICK["gcpw_pair"], "--output=whole.jpg")
    whole = bench.path("whole.jpg").read_bytes()
    for name, part in (("half.jpg", whole[:len(whole) // 2]), ("tail.jpg", whole[:-2])):
        bench.path(name).write_bytes(part)
        for program in QUICK:
            bench.refused(program, target, name, "--output=no.png", expect=FILE_TROUBLE, says=f"{name} is cut short")
    bench.path("trailer.jpg").write_bytes(whole + b"appended by a camera")
    for program in QUICK:
        bench.run(program, target, "trailer.jpg", *QUICK[program], "--output=pano.png")


def floating_point(bench, _, target):
    bench.path("float.pfm").write_bytes(b"PF\n40 30\n-1.0\n" + struct.pack("<3600f", *([0.5] * 3600)))
    for program in QUICK:
        bench.refused(program, "float.pfm", target, "--output=no.png", expect=FILE_TROUBLE,
                      says="float.pfm has pixels of kind CV_32FC3")


def no_room(bench, source, target):
    """No file may grow beyond some bytes, as on a full disk: an error, and nothing is left. Where messages go counts, too."""
    def limit_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))

    for program, quick in QUICK.items():
        call = [str(bench.place(program)), source, target, *quick]
        before = bench.files()
        for output in ("full.png", "full.bmp", "full.webp"):
            # Python ignores the signal of the limit, and so do the programs that it starts like this.
            done = subprocess.run([*call, f"--output={output}"], cwd=bench.scratch, capture_output=True, text=True, check=False,
                                  restore_signals=False, preexec_fn=limit_files)
            bench.check(done.returncode == FILE_TROUBLE and output in done.stderr, f"{program} {output}: {done.returncode} {done.stderr}")
        bench.check(bench.files() == before, f"{program} leaves {bench.files() - before}")
        if pathlib.Path("/dev/full").exists():
            with open("/dev/full", "w", encoding="utf-8") as full:
                for arguments in (call[1:], ["--help"]):
                    done = subprocess.run([call[0], *arguments, "--output=pano.png", "--force"], cwd=bench.scratch, stdout=full,
                                          stderr=subprocess.PIPE, text=True, check=False)
                    bench.check(done.returncode == FILE_TROUBLE and "standard output" in done.stderr,
                                f"{program} {arguments}: {done.returncode} {done.stderr}")


def test(bench):
    pair = bench.synthetic_pair()
    for part in (cut_short, floating_point, no_room):
        part(bench, *pair)


if __name__ == "__main__":
    main(test)
