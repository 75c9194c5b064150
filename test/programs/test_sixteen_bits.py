#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""gcpw_pair and gcpw_stitch: photographs of 16 bits make pictures of 16 bits, upright, with the profile and the camera's name.

Usage: test_sixteen_bits.py PROGRAMS SCRATCH SAMPLES"""
import struct
import zlib

from harness import main

QUICK = {"gcpw_pair": ("--work_megapix=0.15", "--set=featureMegapix=0.15"), "gcpw_stitch": ("--work_megapix=0.15", "--seam_megapix=0.05")}
MAKER = b"Test Camera Works\0"
# An ICC profile as far as programs look that pass it on: its length, and the signature at its place.
PROFILE = struct.pack(">I", 300) + bytes(32) + b"acsp" + bytes(range(200)) + bytes(60)
# Of TIFF: ImageWidth, ImageLength, BitsPerSample, .. as its specification numbers them.
WIDTH, HEIGHT, BITS, COMPRESSION, COLORS, MAKE, STRIPS, ORIENTATION, SAMPLES, ROWS, COUNTS, ICC = \
    256, 257, 258, 259, 262, 271, 273, 274, 277, 278, 279, 34675
SHORT, LONG, SIZES = 3, 4, {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 7: 1}


def write_tiff(path, width, rows, orientation):
    """A TIFF file of 16 bits in little-endian order; rows of bytes."""
    pixels = b"".join(rows)
    place = 8
    values = {WIDTH: (LONG, struct.pack("<I", width)), HEIGHT: (LONG, struct.pack("<I", len(rows))),
              BITS: (SHORT, struct.pack("<3H", 16, 16, 16)), COMPRESSION: (SHORT, struct.pack("<H", 1)),
              COLORS: (SHORT, struct.pack("<H", 2)), MAKE: (2, MAKER), STRIPS: (LONG, struct.pack("<I", place)),
              ORIENTATION: (SHORT, struct.pack("<H", orientation)), SAMPLES: (SHORT, struct.pack("<H", 3)),
              ROWS: (LONG, struct.pack("<I", len(rows))), COUNTS: (LONG, struct.pack("<I", len(pixels))), ICC: (7, PROFILE)}
    body, entries = pixels, b""
    for tag, (kind, data) in sorted(values.items()):
        at = data.ljust(4, b"\0")
        if len(data) > 4:
            at = struct.pack("<I", place + len(body))
            body += data + bytes(len(data) % 2)
        entries += struct.pack("<HHI", tag, kind, len(data) // SIZES[kind]) + at
    path.write_bytes(b"II*\0" + struct.pack("<I", place + len(body)) + body + struct.pack("<H", len(values)) + entries + bytes(4))


def read_tiff(path):
    """The values of a TIFF file's first picture, as bytes."""
    data = path.read_bytes()
    order = "<" if data[:2] == b"II" else ">"
    start = struct.unpack(order + "I", data[4:8])[0]
    values = {}
    for i in range(struct.unpack(order + "H", data[start:start + 2])[0]):
        entry = data[start + 2 + 12 * i:start + 14 + 12 * i]
        tag, kind, count = struct.unpack(order + "HHI", entry[:8])
        size = count * SIZES.get(kind, 1)
        at = struct.unpack(order + "I", entry[8:])[0]
        values[tag] = entry[8:8 + size] if size <= 4 else data[at:at + size]
    return {tag: struct.unpack(f"{order}{len(value) // 2}H", value)[0] if tag in (BITS, ORIENTATION) else value for tag, value in values.items()}


def read_png(path):
    """Width, height, bits, profile and EXIF of a PNG file."""
    data, place, found = path.read_bytes(), 8, {}
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        found.setdefault(kind, b"")
        found[kind] += data[place + 8:place + 8 + length]
        place += 12 + length
    width, height, bits = struct.unpack(">IIB", found[b"IHDR"][:9])
    profile = found.get(b"iCCP", b"")
    return width, height, bits, zlib.decompress(profile[profile.index(b"\0") + 2:]) if profile else b"", found.get(b"eXIf", b"")


def deepen(bench, name, deep):
    """A TIFF of 16 bits of a PNG of 8, lying on its side as a camera stores it; the lower bits are what 8 do not say."""
    width, height, rows = bench.pixels(name)
    # Turned to the left: the last column is the first row. Orientation 6 turns it back.
    lying = []
    for x in range(width - 1, -1, -1):
        column = b"".join(row[3 * x:3 * x + 3] for row in rows)
        lying.append(b"".join(bytes(((i * 31 + x * 17) & 255, value)) for i, value in enumerate(column)))
    write_tiff(bench.path(deep), height, lying, 6)


def keeps_depth(bench, program, *arguments):
    """All of it in PNG and TIFF; 8 bits in what takes no more."""
    bench.run(program, "left.tif", "right.tif", *arguments, "--output=deep.png")
    bench.run(program, "left.tif", "right.tif", *arguments, "--output=deep.tif", "--compression=none")
    bench.run(program, "left.tif", "right.tif", *arguments, "--output=shallow.jpg")
    width, height, bits, profile, exif = read_png(bench.path("deep.png"))
    bench.check(bits == 16, f"{program}: PNG of {bits} bits")
    bench.check(width > height, f"{program}: {width} x {height} px is not upright")
    bench.check(profile == PROFILE, f"{program}: the profile is lost in PNG")
    bench.check(MAKER.rstrip(b"\0") in exif, f"{program}: the camera's name is lost in PNG")
    values = read_tiff(bench.path("deep.tif"))
    bench.check(values[BITS] == 16, f"{program}: TIFF of {values[BITS]} bits")
    bench.check(values.get(ORIENTATION, 1) == 1, f"{program}: an upright picture is noted as turned")
    bench.check(values.get(ICC) == PROFILE, f"{program}: the profile is lost in TIFF")
    bench.check(values.get(MAKE) == MAKER, f"{program}: the camera's name is lost in TIFF")
    pixels = bench.path("deep.tif").read_bytes()
    finer = sum(low != high for low, high in zip(pixels[100000:200000:2], pixels[100001:200001:2]))  # 8 bits 257 times have equal bytes
    bench.check(finer > 40000, f"{program}: the picture is one of 8 bits: {finer} of 50000 values lie between two of them")
    for part in (PROFILE, MAKER):
        bench.check(part in bench.path("shallow.jpg").read_bytes(), f"{program}: the profile or the camera's name is lost in JPEG")


def stays_the_same_alignment(bench):
    """The estimate is that of 8 bits."""
    for name in ("left", "right"):
        width, _, rows = bench.pixels({"left": "photos/source.png", "right": "photos/target.png"}[name])
        write_tiff(bench.path(f"{name}_up.tif"), width, [b"".join(bytes((v, v)) for v in row) for row in rows], 1)
    for output, pair in (("eight", ("photos/source.png", "photos/target.png")), ("sixteen", ("left_up.tif", "right_up.tif"))):
        bench.run("gcpw_pair", *pair, *QUICK["gcpw_pair"], f"--dump={output}", f"--output={output}.png")
    bench.check(bench.same_bytes("eight/model.yml.gz", "sixteen/model.yml.gz"), "the alignment depends on the depth")
    bench.check(read_png(bench.path("sixteen/source_corrected.png"))[2] == 16, "the dump has lost bits")
    bench.check(read_png(bench.path("sixteen/mesh.png"))[2] == 8, "the drawing of the mesh has 16 bits")


def test(bench):
    source, target = bench.synthetic_pair()
    deepen(bench, source, "left.tif")
    deepen(bench, target, "right.tif")
    for program, quick in QUICK.items():
        keeps_depth(bench, program, *quick)
    keeps_depth(bench, "gcpw_pair", *QUICK["gcpw_pair"], "--view=target", "--blend=average", "--crop=auto")
    keeps_depth(bench, "gcpw_pair", *QUICK["gcpw_pair"], "--method=apap", "--report=page")
    stays_the_same_alignment(bench)


if __name__ == "__main__":
    main(test)
