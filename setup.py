# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Builds the compiled part of the Python package with CMake; all else about it is in pyproject.toml.

GCPW_BUILD_FOLDER names a folder that CMake has configured already (build/release): what is built there is not built again.
CMAKE_ARGS has further options for CMake, e.g. -DOpenCV_DIR=.."""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = pathlib.Path(__file__).resolve().parent
VERSION = re.search(r"^set\(GCPW_VERSION ([\d.]+)\)", (HERE / "modules/gcpw/cmake/version.cmake").read_text(encoding="utf-8"),
                    re.MULTILINE).group(1)
OPTIONS = ["-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O3 -DNDEBUG", "-DBUILD_SHARED_LIBS=OFF", "-DGCPW_BUILD_PYTHON=ON",
           "-DGCPW_BUILD_APPS=OFF", "-DGCPW_BUILD_SAMPLES=OFF", "-DGCPW_BUILD_TESTS=OFF"]


class CMakeBuild(build_ext):
    """The target _gcpw of CMakeLists.txt as a setuptools extension."""

    def build_extension(self, ext):
        folder = os.environ.get("GCPW_BUILD_FOLDER")
        if not folder:
            folder = pathlib.Path(self.build_temp).resolve()
            options = OPTIONS + [f"-DGCPW_PYTHON={sys.executable}"] + shlex.split(os.environ.get("CMAKE_ARGS", ""))
            subprocess.run(["cmake", "-S", HERE, "-B", folder, *options], check=True)
        command = ["cmake", "--build", folder, "--target", "_gcpw", "--config", "Release"]
        jobs = self.parallel or os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or os.cpu_count() or 1
        subprocess.run([*command, "--parallel", str(jobs)], check=True)
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        built = pathlib.Path(folder) / "python/gcpw" / target.name
        if not built.exists():
            raise SystemExit(f"{folder} has been configured for another Python: {built.name} is not there")
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(built, target)


setup(version=VERSION, ext_modules=[Extension("gcpw._gcpw", sources=[])], cmdclass={"build_ext": CMakeBuild})
