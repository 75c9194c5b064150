#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Patches OpenCV's sample stitching_detailed.py as the module's samples say, and stitches with it. The cv2 of a distribution has no
cv2.gcpw: the package stands in for it, with NumPy arrays for UMats.
Skipped (77) without OpenCV's source, cv2 or patch.

Usage: stitching_detailed_works.py REPOSITORY FOLDER_OF_PACKAGE OPENCV_SOURCE SCRATCH, run by the Python that the package is for"""
import importlib.util
import pathlib
import runpy
import shutil
import subprocess
import sys
import types

SKIPPED = 77


def stand_in(cv2, gcpw, numpy):
    """cv2.gcpw, as far as the sample uses it."""
    class Array(numpy.ndarray):
        def get(self):
            return numpy.asarray(self)

    class PyGcpwWarper(gcpw.Warper):
        def __init__(self, name, scale, rig):
            super().__init__(name, scale, rig.own)

        def warp(self, *arguments):
            corner, picture = super().warp(*arguments)
            return corner, picture.view(Array)
    made = []

    def align_rig(*arguments):
        rig = gcpw.align_rig(*arguments)
        made.append(rig)
        alignment = types.SimpleNamespace(report=lambda: rig.alignment.report)
        return types.SimpleNamespace(own=rig, usable=lambda: rig.usable, alignment=alignment)
    cv2.gcpw = types.SimpleNamespace(alignRig=align_rig, PyGcpwWarper=PyGcpwWarper)
    cv2.UMat = lambda array: array.view(Array)
    cv2.imshow = cv2.waitKey = cv2.destroyAllWindows = lambda *_: None
    return made


def main(arguments):
    repository, place, source, scratch = (pathlib.Path(argument).resolve() for argument in arguments[1:5])
    sample = source / "samples/python/stitching_detailed.py"
    if not sample.exists() or importlib.util.find_spec("cv2") is None or shutil.which("patch") is None:
        print(f"{sample}, cv2 (Debian: python3-opencv) or patch is not there")
        return SKIPPED
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    patched = scratch / "stitching_detailed_gcpw.py"
    patch = repository / "modules/gcpw/samples/stitching_detailed.patch"
    subprocess.run(["patch", "-o", patched, sample, patch], check=True)
    sys.path[:0] = [str(place), str(repository / "python/tests")]
    import cv2
    import gcpw
    import numpy
    from conftest import smooth
    scene = smooth(numpy.random.RandomState(7).randint(0, 256, (240, 400, 3)).astype(float))
    names = [str(scratch / f"{k}.png") for k in range(2)]
    random = numpy.random.RandomState(1)
    for k, name in enumerate(names):
        # OpenCV forgets photographs that match too well: it takes them for one and the same.
        noise = random.normal(0, 16, (240, 320, 3))
        gcpw.write(name, numpy.clip(scene[:, 80 * k:80 * k + 320] + noise, 0, 255).astype(numpy.uint8))
    rigs = stand_in(cv2, gcpw, numpy)
    result = scratch / "result.png"
    sys.argv = [str(patched), *names, "--output", str(result), "--features", "sift", "--warp", "plane"]
    runpy.run_path(str(patched), run_name="__main__")
    width = gcpw.read(result).shape[1]
    print(f"{rigs}, {width} px")
    return 0 if len(rigs) == 1 and rigs[0].usable and 390 < width < 450 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv))
