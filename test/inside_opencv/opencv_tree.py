"""A source tree of OpenCV as far as a compiler and the binding generator need it: nothing of it is built."""
import os
import pathlib
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

# What the compiler shall say in OpenCV's own build (cmake/OpenCVCompilerOptions.cmake).
WARNINGS = ["-W", "-Wall", "-Wreturn-type", "-Wnon-virtual-dtor", "-Wsequence-point", "-Wformat", "-Wformat-security",
            "-Wmissing-declarations", "-Wundef", "-Winit-self", "-Wpointer-arith", "-Wshadow", "-Wsign-promo",
            "-Wuninitialized", "-Werror"]
SKIPPED = 77  # ctest: SKIP_RETURN_CODE


class Tree:
    """The folders of one OpenCV source, and a scratch folder with what a configured build would have generated."""

    def __init__(self, source, scratch):
        self.source = pathlib.Path(source)
        self.scratch = pathlib.Path(scratch)
        if not (self.source / "modules/ts/include/opencv2/ts.hpp").exists():
            print(f"No source of OpenCV in {self.source}: scripts/opencv_source fetches it. Skipped.")
            sys.exit(SKIPPED)

    def modules(self, names):
        """The folders of those of these modules that this version of OpenCV has, contrib included."""
        roots = [self.source / "modules", self.source / "contrib/modules", self.source.parent / "opencv_contrib/modules"]
        found = [root / name for name in names for root in roots]
        return [folder for folder in found if folder.is_dir()]

    def configure(self, modules):
        """Stands in for CMake's generated headers; these modules are the ones that are built. Returns compiler flags."""
        names = "".join(f"#define HAVE_OPENCV_{folder.name.upper()}\n" for folder in modules)
        for name, text in {"opencv2/opencv_modules.hpp": names, "cvconfig.h": "", "cv_cpu_config.h": ""}.items():
            path = self.scratch / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        flags = ["-D__OPENCV_BUILD=1", f"-I{self.scratch}"]
        for folder in modules:
            flags += ["-isystem", str(folder / "include")]
        return flags


def check_syntax(compiler, flags, files):
    """Compiles every file without making an object of it; the names of those that fail."""
    def fails(file):
        return subprocess.run(compiler + flags + ["-fsyntax-only", str(file)], check=False).returncode != 0

    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        return [file.name for file, failed in zip(files, pool.map(fails, files)) if failed]
