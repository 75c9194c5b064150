#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Runs the tests of the Python package as it lies in the build folder, and mypy --strict over it where mypy is installed.
Skipped (77) without pytest.

Usage: tests_pass.py REPOSITORY FOLDER_OF_PACKAGE, run by the Python that the package is for"""
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77


def main(arguments):
    repository, place = (pathlib.Path(argument).resolve() for argument in arguments[1:3])
    if importlib.util.find_spec("pytest") is None:
        print("pytest is not installed (Debian: python3-pytest)")
        return SKIPPED
    environment = dict(os.environ, PYTHONPATH=str(place), PYTHONDONTWRITEBYTECODE="1", OPENCV_LOG_LEVEL="ERROR")
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", repository / "python/tests"]
    status = subprocess.run(command, env=environment, cwd=repository, check=False).returncode
    if shutil.which("mypy"):
        command = ["mypy", "--config-file", repository / "pyproject.toml", "--cache-dir", os.devnull, "--python-executable", sys.executable]
        status = subprocess.run(command, cwd=repository, check=False).returncode or status
    else:
        print("mypy is not installed: the types are not checked")
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv))
