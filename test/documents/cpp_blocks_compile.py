#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Compiles every block of C++ in documents and public headers, syntax only. A block with includes is a file of its own; all
others are bodies of functions, with the names of prelude.hpp. Public headers are used as C++11; a block that includes files of
the sources ("..") is C++17, as these are.

Usage: cpp_blocks_compile.py REPOSITORY COMPILER [FLAG...]"""
import pathlib
import re
import subprocess
import sys

from documents import blocks, conclude

INCLUDE = re.compile(r"^#include ([<\"])", re.MULTILINE)


def at(block):
    """Makes the compiler name the document and its line."""
    return f'#line {block.line} "{block.document}"\n'


def units(found):
    """Name, standard and text of each file to compile."""
    together = '#include "prelude.hpp"\n'
    for number, block in enumerate(found):
        included = INCLUDE.findall(block.text)
        if included:
            yield f"{block.document}:{block.line}", "c++17" if '"' in included else "c++11", at(block) + block.text
        else:
            # A block may return, or not.
            together += f"bool block{number}();\nbool block{number}()\n{{\n{at(block)}{block.text}\nreturn true;\n}}\n"
    yield "all blocks without includes", "c++11", together


def main(arguments):
    repository, compiler = pathlib.Path(arguments[1]).resolve(), arguments[2:]
    module = repository / "modules/gcpw"
    includes = [f"-I{folder}" for folder in (module / "include", module / "src", repository, repository / "test/documents")]
    flags = ["-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-Wno-unused-variable", "-Wno-unused-but-set-variable", *includes]
    faults = []
    found = blocks(repository, "cpp")
    for name, standard, text in units(found):
        command = [*compiler, f"-std={standard}", *flags, "-x", "c++", "-"]
        done = subprocess.run(command, input=text, text=True, capture_output=True, check=False)
        if done.returncode:
            faults.append(f"{name} does not compile:\n{done.stderr}")
    return conclude(len(found), "blocks of C++", faults)


if __name__ == "__main__":
    sys.exit(main(sys.argv))
