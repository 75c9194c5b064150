#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Every block of Python in documents and public headers must parse, every name of cv2.gcpw in it be one that the public headers
export, and every name of gcpw one of the Python package. Whether they run, only a cv2 with this module can tell
(modules/gcpw/misc/python/test), and the tests of the package (python/tests).

Usage: python_blocks_are_sound.py REPOSITORY"""
import ast
import pathlib
import re
import sys

from documents import blocks, conclude

COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
CLASS = re.compile(r"\b(?:class|struct)\s+CV_EXPORTS_W\w*\s+(\w+)")
FUNCTION = re.compile(r"\bCV_EXPORTS_(?:W|AS\((\w+)\))\s+(?!class|struct)[^;(]*?(\w+)\s*\(")
ENUM = re.compile(r"\benum class (\w+)\s*\{(.*?)\}", re.DOTALL)


def exported(repository):
    names = set()
    for header in (pathlib.Path(repository) / "modules/gcpw/include").rglob("*.hpp"):
        code = COMMENT.sub("", header.read_text(encoding="utf-8"))
        names.update(CLASS.findall(code))
        names.update(alias or name for alias, name in FUNCTION.findall(code))
        for enum, values in ENUM.findall(code):
            prefix = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", enum).upper()
            names.update(f"{prefix}_{value}" for value in re.findall(r"(\w+)\s*=", values))
    return names


def of_package(repository):
    tree = ast.parse((pathlib.Path(repository) / "python/gcpw/__init__.py").read_text(encoding="utf-8"))
    return set(next(ast.literal_eval(node.value) for node in tree.body
                    if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__"))


def main(arguments):
    names = {"cv2.gcpw": exported(arguments[1]), "gcpw": of_package(arguments[1])}
    found = blocks(arguments[1], "python")
    faults = []
    for block in found:
        where = f"{block.document}:{block.line}"
        try:
            tree = ast.parse(block.text)
        except SyntaxError as error:
            faults.append(f"{where}: {error}")
            continue
        for node in ast.walk(tree):
            if isinstance(node, ast.Attribute) and node.attr not in names.get(ast.unparse(node.value), {node.attr}):
                faults.append(f"{where}: there is no {ast.unparse(node)}")
    return conclude(len(found), "blocks of Python", faults)


if __name__ == "__main__":
    sys.exit(main(sys.argv))
