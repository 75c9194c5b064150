#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""gcpw_stitch in tiles: the same pixels as in memory, Deep Zoom, what is refused, and what is left after Ctrl-C.

Usage: test_tiled.py PROGRAMS SCRATCH SAMPLES"""
import signal
import struct
import subprocess
import time

from harness import main

ESTIMATE = "--work_megapix=0.15"


def tags_of(data):
    """Tag -> list of numbers of a little-endian classic TIFF file."""
    place, = struct.unpack("<I", data[4:8])
    count, = struct.unpack("<H", data[place:place + 2])
    tags = {}
    for i in range(count):
        tag, kind, number = struct.unpack("<HHI", data[place + 2 + 12 * i:place + 10 + 12 * i])
        code, size = {1: ("B", 1), 3: ("H", 2), 4: ("I", 4)}.get(kind, (None, 0))
        if code:
            at = place + 10 + 12 * i
            if number * size > 4:
                at, = struct.unpack("<I", data[at:at + 4])
            tags[tag] = list(struct.unpack(f"<{number}{code}", data[at:at + number * size]))
    return tags


def rows_of_tiles(data):
    """(width, height, rows) of an uncompressed tiled TIFF file of RGB, rows as bytes of BGR of 8 bits as Bench.pixels() has PNG's."""
    tags = tags_of(data)
    width, height, side = tags[256][0], tags[257][0], tags[322][0]
    columns = -(-width // side)
    rows = []
    for y in range(height):
        row = b""
        for column in range(columns):
            start = tags[324][y // side * columns + column] + y % side * side * 3
            row += data[start:start + 3 * side]
        rows.append(row[:3 * width])
    return width, height, rows


def same_pixels(bench, source, target):
    call = (source, target, ESTIMATE)
    bench.run("gcpw_stitch", *call, "--output=whole.png", "--save_model=model.yml.gz")
    for extra in ((), ("--load_model=model.yml.gz",)):
        bench.run("gcpw_stitch", *call[:2], *(extra or call[2:]), "--output=tiled.tif", "--tiled=yes", "--compression=none")
        found = rows_of_tiles(bench.path("tiled.tif").read_bytes())
        expected = bench.pixels("whole.png")
        bench.check(found[:2] == expected[:2], f"in tiles {extra}: {found[:2]} px instead of {expected[:2]}")
        bench.check(found[2] == expected[2], f"in tiles {extra}: other pixels")
    bench.run("gcpw_stitch", *call, "--output=small.tif", "--compression=none")
    bench.check(322 not in tags_of(bench.path("small.tif").read_bytes()), "a small picture is made in tiles without being asked for")


def deep_zoom(bench, source, target):
    call = (source, target, "--load_model=model.yml.gz")
    bench.run("gcpw_stitch", *call, "--output=zoom.dzi")
    bench.check("<Image" in bench.path("zoom.dzi").read_text(encoding="utf-8"), "zoom.dzi is no description")
    bench.check("zoom_files" in bench.path("zoom.html").read_text(encoding="utf-8"), "zoom.html does not show zoom_files")
    bench.check(bench.path("zoom_files/0/0_0.jpg").is_file(), "zoom_files has no level 0")
    bench.refused("gcpw_stitch", *call, "--output=zoom.dzi", says="zoom.dzi exists")
    bench.path("zoom.dzi").unlink()
    bench.refused("gcpw_stitch", *call, "--output=zoom.dzi", says="zoom.html exists")
    bench.path("zoom.html").unlink()
    bench.refused("gcpw_stitch", *call, "--output=zoom.dzi", says="is not empty")


def in_parts(bench, source, target):
    """Any cut into parts, joined, is the file that one call writes."""
    call = (source, target, "--load_model=model.yml.gz", "--crop=none")
    bench.run("gcpw_stitch", *call, "--output=one.tif", "--tiled=yes")
    bench.run("gcpw_stitch", *call, "--output=upper.tif", "--tiles=1-1")
    bench.run("gcpw_stitch", *call, "--output=lower.tif", "--tiles=2-99")
    bench.run("gcpw_stitch", "--join", "lower.tif", "upper.tif", "--output=joined.tif")
    bench.check(bench.same_bytes("one.tif", "joined.tif"), "parts joined are not the file of one call")
    bench.run("gcpw_stitch", *call, "--output=share.tif", "--tiles=1/2")
    bench.run("gcpw_stitch", *call, "--output=zoom2.dzi")
    bench.run("gcpw_stitch", "--join", "upper.tif", "lower.tif", "--output=joined.dzi")
    for level in ("0/0_0", "9/0_0", "10/1_1"):
        bench.check(bench.same_bytes(f"zoom2_files/{level}.jpg", f"joined_files/{level}.jpg"), f"parts joined to a .dzi: other tile {level}")
    bench.path("copy.tif").write_bytes(bench.path("upper.tif").read_bytes())
    for names, says in ((("upper.tif",), "are missing"), (("lower.tif",), "are missing"), (("upper.tif", "copy.tif", "lower.tif"), "twice"),
                        (("one.tif",), "is no part")):
        bench.refused("gcpw_stitch", "--join", *names, "--output=no.tif", says=says)
    bench.run("gcpw_stitch", source, target, ESTIMATE, "--tiles=none", "--save_model=again.yml.gz", says="again.yml.gz")
    bench.check(bench.same_bytes("again.yml.gz", "model.yml.gz"), "--tiles=none saves another model")
    for tiles in ("0-2", "3-2", "3/2", "x", "1-2-3"):
        bench.refused("gcpw_stitch", *call, "--output=no.tif", f"--tiles={tiles}", says="--tiles is")
    bench.refused("gcpw_stitch", *call, "--output=no.tif", "--tiles=90-99", says="the picture has")
    bench.refused("gcpw_stitch", source, target, "--output=no.tif", "--tiles=1-2", says="--load_model")


def refusals(bench, source, target):
    call = (source, target)
    bench.refused("gcpw_stitch", *call, "--output=a.png", "--tiled=yes", says="write .tif or .dzi")
    bench.refused("gcpw_stitch", *call, "--output=a.dzi", "--tiled=no", says="Deep Zoom")
    bench.refused("gcpw_stitch", *call, "--output=a.dzi", "--report=page", says="--report")
    bench.refused("gcpw_stitch", *call, "--output=a.tif", "--tiled=yes", "--method=none", says="--method=none")
    bench.refused("gcpw_stitch", *call, "--output=a.tif", "--tiled=yes", "--mode=scans", says="--mode=scans")


def ended_early(bench, source, target):
    """Whenever it is ended, nothing is left."""
    call = [str(bench.place("gcpw_stitch")), source, target, "--load_model=model.yml.gz"]
    before = bench.files()
    for output in ("cancelled.tif", "cancelled.dzi"):
        for pause in (0.05, 0.3, 0.6):
            process = subprocess.Popen([*call, f"--output={output}", "--tiled=yes"], cwd=bench.scratch, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            time.sleep(pause)
            process.send_signal(signal.SIGINT)
            done = process.wait(timeout=60)
            left = bench.files() - before
            bench.check(done in (-signal.SIGINT, 0), f"{output}: ends with {done} after an interrupt")
            if done != 0:
                bench.check(not left, f"{output}: an interrupt after {pause} s leaves {left}")
            else:
                before = bench.files()
                break


def test(bench):
    pair = bench.synthetic_pair()
    for part in (same_pixels, deep_zoom, in_parts, refusals, ended_early):
        part(bench, *pair)


if __name__ == "__main__":
    main(test)
