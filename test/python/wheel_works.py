#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Makes a wheel of the package with what is built already, installs it into an empty folder, and stitches with it there.
Skipped (77) without pip.

Usage: wheel_works.py REPOSITORY BUILD SCRATCH, run by the Python that the package is for"""
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import zipfile

SKIPPED = 77
EXPECTED = {"gcpw/__init__.py", "gcpw/__main__.py", "gcpw/_gcpw.pyi", "gcpw/py.typed"}


def main(arguments):
    repository, build, scratch = (pathlib.Path(argument).resolve() for argument in arguments[1:4])
    if any(importlib.util.find_spec(name) is None for name in ("pip", "setuptools", "wheel", "pybind11")):
        print("pip, setuptools, wheel or pybind11 is not installed (Debian: python3-pip, python3-setuptools, python3-wheel, python3-pybind11)")
        return SKIPPED
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    # Of a copy, because setuptools writes beside the sources.
    copy = scratch / "sources"
    shutil.copytree(repository / "python", copy / "python", ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("pyproject.toml", "setup.py", "LICENSE", "modules/gcpw/cmake/version.cmake"):
        (copy / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(repository / name, copy / name)
    environment = dict(os.environ, GCPW_BUILD_FOLDER=str(build), PIP_DISABLE_PIP_VERSION_CHECK="1", OPENCV_LOG_LEVEL="ERROR")
    pip = [sys.executable, "-m", "pip", "--quiet"]
    subprocess.run([*pip, "wheel", "--no-build-isolation", "--no-deps", "--no-index", "-w", scratch, copy], env=environment, check=True)
    wheel, = scratch.glob("gcpw-*.whl")
    names = set(zipfile.ZipFile(wheel).namelist())
    missing = EXPECTED - names
    if missing or not any(name.startswith("gcpw/_gcpw.") and name.endswith((".so", ".pyd")) for name in names):
        print(f"{wheel.name} lacks {missing or 'the compiled part'}: it has {sorted(names)}")
        return 1
    installed = scratch / "installed"
    subprocess.run([*pip, "install", "--no-deps", "--no-index", "--target", installed, wheel], env=environment, check=True)
    environment["PYTHONPATH"] = str(installed)
    program = ("import pathlib, sys, numpy, gcpw; assert pathlib.Path(gcpw.__file__).is_relative_to(sys.argv[1]), gcpw.__file__; "
               "sys.path.insert(0, sys.argv[2]); from conftest import smooth; "
               "scene = smooth(numpy.random.RandomState(7).randint(0, 256, (240, 400, 3)).astype(float)); "
               "[gcpw.write(f'{k}.png', scene[:, 80 * k:80 * k + 320]) for k in range(2)]")
    subprocess.run([sys.executable, "-B", "-c", program, installed, copy / "python/tests"], cwd=scratch, env=environment, check=True)
    subprocess.run([sys.executable, "-B", "-m", "gcpw", "0.png", "1.png", "--output=panorama.png"], cwd=scratch, env=environment, check=True)
    return 0 if (scratch / "panorama.png").exists() else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv))
