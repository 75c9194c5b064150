#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""apps/batch/Snakefile: killed in the middle and called again, no finished job runs again, and the pictures are those of serial calls.

Usage: test_batch.py PROGRAMS SCRATCH SAMPLES"""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

from harness import main

SNAKEFILE = pathlib.Path(__file__).resolve().parents[2] / "apps" / "batch" / "Snakefile"
ESTIMATE = "--work_megapix=0.15"


def call(bench, *more):
    return ["snakemake", "--snakefile", str(SNAKEFILE), "--cores", "2", *more, "--config", "photographs=trips", "panoramas=done",
            f"gcpw_stitch={bench.place('gcpw_stitch')}", f"model_options={ESTIMATE}"]


def times(bench):
    return {str(path): path.stat().st_mtime_ns for path in (bench.scratch / "done").rglob("*") if path.is_file()}


def joined(bench):
    """Names of panoramas that the workflow has done with: it takes their blocks away then."""
    return {path.stem for path in bench.scratch.glob("done/*.tif") if not list(bench.scratch.glob(f"done/blocks/{path.stem}.*"))}


def test(bench):
    if not shutil.which("snakemake"):
        print("skipped: there is no snakemake")
        sys.exit(77)
    source, target = bench.synthetic_pair()
    for name in ("a", "b", "c"):
        bench.path(f"trips/{name}").mkdir(parents=True)
        for photograph in (source, target):
            shutil.copy(bench.path(photograph), bench.path(f"trips/{name}"))
    workflow = subprocess.Popen(call(bench), cwd=bench.scratch, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    end = time.monotonic() + 200
    while not joined(bench) and workflow.poll() is None and time.monotonic() < end:
        time.sleep(0.1)
    os.killpg(workflow.pid, signal.SIGKILL)
    workflow.wait()
    whole = {path: at for path, at in times(bench).items() if pathlib.Path(path).stem in joined(bench)}
    bench.check(whole, "nothing was done before the kill")
    subprocess.run(call(bench, "--unlock"), cwd=bench.scratch, capture_output=True, check=False)
    done = subprocess.run(call(bench, "--rerun-incomplete"), cwd=bench.scratch, capture_output=True, text=True, check=False)
    bench.check(done.returncode == 0, f"does not go on after a kill: {done.stderr[-2000:]}")
    after = times(bench)
    for path in whole:
        bench.check(after.get(path) == whole[path], f"{path} was made again")
    bench.run("gcpw_stitch", source, target, "--load_model=done/models/a.yml.gz", "--crop=none", "--tiled=yes", "--output=serial.tif")
    for name in ("a", "b", "c"):
        bench.check(bench.path(f"done/{name}.tif").is_file() and bench.same_bytes("serial.tif", f"done/{name}.tif"),
                    f"done/{name}.tif is not the picture of a serial call")
    again = subprocess.run(call(bench), cwd=bench.scratch, capture_output=True, text=True, check=False)
    bench.check("Nothing to be done" in again.stdout + again.stderr, "a second call does something")


if __name__ == "__main__":
    main(test)
