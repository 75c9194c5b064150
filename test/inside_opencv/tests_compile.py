#!/usr/bin/env python3
"""Compiles the module's tests and measurements, syntax only, against OpenCV's own ts with OpenCV's warnings as errors.

Usage: tests_compile.py OPENCV_SOURCE SCRATCH MODULE COMPILER [FLAG...]"""
import pathlib
import sys

from opencv_tree import WARNINGS, Tree, check_syntax

# What ts and our tests include; OpenCV 5 has other names for features2d and calib3d.
MODULES = ["ts", "core", "imgproc", "imgcodecs", "videoio", "highgui", "flann", "features2d", "features", "calib3d", "geometry",
           "calib", "stereo", "stitching", "ximgproc"]


def main(arguments):
    tree = Tree(arguments[1], arguments[2])
    module = pathlib.Path(arguments[3])
    flags = arguments[5:] + WARNINGS + ["-std=c++17"] + tree.configure(tree.modules(MODULES))
    flags += [f"-I{module / folder}" for folder in ("include", "src", "test", "perf")]
    files = sorted(module.glob("test/**/*.cpp")) + sorted(module.glob("perf/**/*.cpp"))
    failed = check_syntax([arguments[4]], flags, files)
    for name in failed:
        print(f"FAILED {name}")
    print(f"{len(files)} files, {len(failed)} failed")
    return 1 if failed or not files else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
