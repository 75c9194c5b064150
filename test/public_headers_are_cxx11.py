#!/usr/bin/env python3
"""Compiles each public header alone as strict C++11: it must stand by itself and ask for nothing newer.

Usage: public_headers_are_cxx11.py INCLUDE_FOLDER COMPILER [FLAG...]"""
import pathlib
import subprocess
import sys

FLAGS = ["-std=c++11", "-fsyntax-only", "-Wall", "-Wextra", "-pedantic-errors"]


def main(arguments):
    folder = pathlib.Path(arguments[1])
    compiler = arguments[2:]
    headers = sorted(folder.rglob("*.hpp"))
    failed = 0
    for header in headers:
        name = header.relative_to(folder).as_posix()
        command = compiler + FLAGS + [f"-I{folder}", "-x", "c++", "-"]
        result = subprocess.run(command, input=f"#include <{name}>\n", text=True)
        failed += result.returncode != 0
        print(f"{'FAILED' if result.returncode else 'ok':8}{name}", flush=True)
    print(f"{len(headers)} headers, {failed} failed")
    return 1 if failed or not headers else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
