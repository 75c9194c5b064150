#!/usr/bin/env python3
"""Runs OpenCV's own binding generator over the public headers, looks for everything they export in what it wrote, and
compiles the whole of cv2 with it, syntax only (needs Python.h and NumPy).

Usage: bindings_compile.py OPENCV_SOURCE SCRATCH MODULE COMPILER [FLAG...]"""
import pathlib
import re
import shutil
import subprocess
import sys

from opencv_tree import Tree, check_syntax

# The modules whose types the public headers use, with all that these need. OpenCV 5 has other names for some.
MODULES = ["core", "flann", "imgproc", "features2d", "features", "calib3d", "geometry", "calib", "stereo", "stitching"]
# As modules/python/bindings/CMakeLists.txt of OpenCV.
NOT_WRAPPED = re.compile(r"/cuda/|/hal/|/opencl/|/utils/|\.inl\.|_inl\.|\.details\.|\.private\.|/private\.|/legacy/")

CLASS = re.compile(r"^\s*(?:class|struct)\s+CV_EXPORTS_W\w*\s+(\w+)", re.MULTILINE)
PROPERTY = re.compile(r"\bCV_PROP(?:_RW)?\s+[\w:<>]+\s+(\w+)")
# The name is the alias where there is one: CV_WRAP_AS(alias), CV_EXPORTS_AS(alias).
FUNCTION = re.compile(r"\bCV_(?:WRAP|EXPORTS_W|(?:WRAP|EXPORTS)_AS\((\w+)\))\s+(?!class|struct)(?:[^;(){}]*?\s)?[&*]?(\w+)\s*\(")


def headers_of(modules, module, own):
    """All headers to wrap, and those with converters that cv2 includes, as OpenCV's CMake collects them."""
    wrapped, converters = [], sorted((module / "misc/python").glob("pyopencv*.hpp"))
    for folder in modules:
        include = folder / "include/opencv2"
        for place in (include, include / folder.name, include / folder.name / "detail"):
            wrapped += [path for path in sorted(place.glob("*.hpp")) if not NOT_WRAPPED.search(path.as_posix())]
        extra = sorted((folder / "misc/python").glob("*.hpp"))
        wrapped += [path for path in extra if path.name.startswith(("python_", "shadow"))]
        converters += [path for path in extra if path.name.startswith(("python_", "pyopencv"))]
    return wrapped + own, converters


def exports_of(text):
    """Every name that a header exports, as a pattern of what the generator must have written for it."""
    code = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.DOTALL)
    classes = [(match.start(), match.group(1)) for match in CLASS.finditer(code)]
    for match in PROPERTY.finditer(code):
        owner = [name for start, name in classes if start < match.start()][-1]
        yield rf'\{{\(char\*\)"{match.group(1)}", \(getter\)pyopencv_gcpw_{owner}_get_{match.group(1)},'
    for match in FUNCTION.finditer(code):
        yield rf"\bstatic [\w* ]+ pyopencv_cv_gcpw_(\w+_)?{match.group(1) or match.group(2)}\("
    for _, name in classes:
        yield rf"\bCVPY_TYPE\(\w*{name},"


def python_flags():
    """Where Python.h and NumPy's headers are, for the first Python that has both; None without one."""
    probe = "import numpy, sysconfig; print(sysconfig.get_path('include'), numpy.get_include())"
    for python in (sys.executable, "/usr/bin/python3", "python3"):
        if not shutil.which(python):
            continue
        answer = subprocess.run([python, "-c", probe], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
        if answer.returncode == 0 and (pathlib.Path(answer.stdout.split()[0]) / "Python.h").exists():
            return [part for folder in answer.stdout.split() for part in ("-isystem", folder)]
    return None


def main(arguments):
    tree = Tree(arguments[1], arguments[2])
    module = pathlib.Path(arguments[3]).resolve()
    include = module / "include"
    own = sorted(include.glob("**/*.hpp"))
    modules = tree.modules(MODULES)
    flags = tree.configure(modules)
    wrapped, converters = headers_of(modules, module, own)
    (tree.scratch / "headers.txt").write_text("\n".join(map(str, wrapped)), encoding="utf-8")
    (tree.scratch / "pyopencv_custom_headers.h").write_text(
        "".join(f'#include "{path}"\n' for path in converters), encoding="utf-8")

    python = tree.source / "modules/python/src2"
    subprocess.run([sys.executable, "-B", python / "gen2.py", tree.scratch, tree.scratch / "headers.txt"], check=True)
    written = "".join(path.read_text(encoding="utf-8") for path in sorted(tree.scratch.glob("pyopencv_generated_*.h")))
    expected = [(path.name, pattern) for path in own for pattern in exports_of(path.read_text(encoding="utf-8"))]
    missing = [(name, pattern) for name, pattern in expected if not re.search(pattern, written)]
    for name, pattern in missing:
        print(f"FAILED {name}: the generator wrote nothing like {pattern}")
    print(f"{len(expected)} exports, {len(missing)} missing")

    found = python_flags()
    if found is None:
        print("cv2 is not compiled: no Python with Python.h and NumPy here (Debian: python3-dev, python3-numpy).")
        failed = []
    else:
        flags = [flag for flag in flags if flag != "-D__OPENCV_BUILD=1"]
        flags = arguments[5:] + ["-std=c++11", "-w", f"-I{include}", f"-I{python}"] + flags + found
        failed = check_syntax([arguments[4]], flags, [python / "cv2.cpp"])
        print("cv2 does not compile" if failed else "cv2 compiles")
    return 1 if missing or failed or not expected else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
