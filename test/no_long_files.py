#!/usr/bin/env python3
"""Fails when a text file of the repository has 400 lines or more, a sample of the module 60 or more.

Usage: no_long_files.py REPOSITORY"""
import pathlib
import sys

WALL = 400
SAMPLE_WALL = 60
SAMPLES = "modules/gcpw/samples"
NOT_OURS = {".git", ".cache", "build", "__pycache__"}
DATA = {".png", ".jpg", ".svg", ".jpeg", ".json", ".yml", ".xml", ".csv"}


def text_files(folder):
    for path in sorted(folder.iterdir()):
        if path.is_dir():
            if path.name not in NOT_OURS and not path.name.startswith("build-"):
                yield from text_files(path)
        elif path.suffix not in DATA:
            yield path


def main(arguments):
    repository = pathlib.Path(arguments[1])
    count = 0
    too_long = []
    for path in text_files(repository):
        count += 1
        with path.open("rb") as file:
            lines = sum(1 for _ in file)
        wall = SAMPLE_WALL if repository / SAMPLES in path.parents else WALL
        if lines >= wall:
            too_long.append(f"{path}: {lines} lines, the wall is {wall}")
    for fault in too_long:
        print(fault)
    print(f"{count} files, {len(too_long)} too long")
    return 1 if too_long or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
