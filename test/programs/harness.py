# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""What the end-to-end tests share: running a program in a scratch folder and looking at what it left there.

A test is a script `test_*.py PROGRAMS SCRATCH SAMPLES`; it needs nothing but Python's own library."""
import pathlib
import shutil
import struct
import subprocess
import sys
import zlib

STITCHED, NO_ANSWER, WRONG_USE, FILE_TROUBLE = 0, 1, 2, 3


class Bench:
    """The folders of the programs and of the samples, an empty scratch folder, and the faults found so far."""

    def __init__(self, programs, scratch, samples):
        self.folders = pathlib.Path(programs), pathlib.Path(samples)
        self.scratch = pathlib.Path(scratch)
        self.faults = []
        shutil.rmtree(self.scratch, ignore_errors=True)
        self.scratch.mkdir(parents=True)

    def check(self, truth, fault):
        if not truth:
            self.faults.append(fault)

    def place(self, program):
        programs, samples = self.folders
        return (samples if program.startswith("gcpw_sample_") else programs) / program

    def run(self, program, *arguments, expect=STITCHED, says=""):
        """Runs a program in the scratch folder; its exit code and a word of its messages are checked.

        What is to succeed may replace the files of calls before."""
        if expect == STITCHED and program in ("gcpw_pair", "gcpw_stitch"):
            arguments = (*arguments, "--force")
        command = [str(self.place(program)), *map(str, arguments)]
        done = subprocess.run(command, cwd=self.scratch, capture_output=True, text=True, check=False)
        said = done.stdout + done.stderr
        call = " ".join([program, *map(str, arguments)])
        self.check(done.returncode == expect, f"{call}: exit code {done.returncode} instead of {expect}: {said}")
        self.check(says in said, f"{call}: does not say '{says}': {said}")
        return said

    def refused(self, program, *arguments, expect=WRONG_USE, says="", leaves=()):
        """The same for a call that must leave nothing else behind, neither files nor folders."""
        before = self.files()
        said = self.run(program, *arguments, expect=expect, says=says)
        left = sorted(self.files() - before - set(leaves))
        self.check(said.strip(), f"{program} {arguments}: refuses without a word")
        self.check(not left, f"{program} {arguments}: leaves {left}")

    def files(self):
        return {str(path.relative_to(self.scratch)) for path in self.scratch.rglob("*")}

    def path(self, name):
        return self.scratch / name

    def keeps(self, names, program, *arguments, says=""):
        """A call that is refused even by force and leaves the files of these names as they are."""
        before = [self.path(name).read_bytes() for name in names]
        self.refused(program, *arguments, "--force", says=says)
        for name, content in zip(names, before):
            self.check(self.path(name).read_bytes() == content, f"{program} {arguments}: {name} was overwritten")

    def same_bytes(self, a, b):
        return self.path(a).read_bytes() == self.path(b).read_bytes()

    def png(self, name):
        """(width, height, channels) of a PNG file of 8 bits, or nothing and a fault."""
        head = self.path(name).read_bytes()[:26] if self.path(name).is_file() else b""
        if len(head) < 26 or head[:8] != b"\x89PNG\r\n\x1a\n":
            self.faults.append(f"{name} is no PNG file")
            return None
        width, height, depth, color = struct.unpack(">IIBB", head[16:26])
        self.check(depth == 8, f"{name} has {depth} bits a channel")
        return width, height, {0: 1, 2: 3, 6: 4}.get(color)

    def flat_image(self, name, width=400, height=300):
        """A gray picture in which nothing can be matched."""
        self.path(name).write_bytes(b"P5 %d %d 255\n" % (width, height) + b"\x80" * (width * height))

    def pixels(self, name):
        """(width, height, rows) of a PNG file of 8-bit BGR, by way of Python's own library."""
        data = self.path(name).read_bytes()
        place, packed = 8, b""
        while place < len(data):
            length, kind = struct.unpack(">I4s", data[place:place + 8])
            packed += data[place + 8:place + 8 + length] if kind == b"IDAT" else b""
            place += 12 + length
        width, height, channels = self.png(name)
        raw, rows, above = zlib.decompress(packed), [], bytes(width * channels)
        for y in range(height):
            start = y * (width * channels + 1)
            above = unfiltered(raw[start], raw[start + 1:start + 1 + width * channels], above, channels)
            rows.append(above)
        return width, height, rows

    def write_ppm(self, name, width, rows):
        self.path(name).write_bytes(b"P6 %d %d 255\n" % (width, len(rows)) + b"".join(rows))

    def mirror(self, name, mirrored):
        """A picture with left and right swapped, which matches none."""
        width, _, rows = self.pixels(name)
        self.write_ppm(mirrored, width, [b"".join(row[3 * x:3 * x + 3] for x in range(width - 1, -1, -1)) for row in rows])

    def halve(self, name, half):
        """A picture of half the size: the mean of four pixels each."""
        width, height, rows = self.pixels(name)
        means = []
        for y in range(0, height - 1, 2):
            a, b = rows[y], rows[y + 1]
            means.append(bytes((a[i] + a[i + 3] + b[i] + b[i + 3]) // 4 for x in range(0, width - 1, 2) for i in range(3 * x, 3 * x + 3)))
        self.write_ppm(half, width // 2, means)

    def synthetic_pair(self):
        """Paths of two photographs of 800 x 600 px that overlap, with parallax and different exposure."""
        self.run("gcpw_pair", "--synthetic=photos", says="written")
        return "photos/source.png", "photos/target.png"


def unfiltered(kind, row, above, channels):
    """A row of a PNG file without its filter; RFC 2083, chapter 6."""
    out = bytearray(row)
    for i, value in enumerate(row):
        left = out[i - channels] if i >= channels else 0
        corner = above[i - channels] if i >= channels else 0
        guess = (0, left, above[i], (left + above[i]) // 2, 0)[kind]
        if kind == 4:
            estimate = left + above[i] - corner
            near = sorted((abs(estimate - one), order, one) for order, one in enumerate((left, above[i], corner)))
            guess = near[0][2]
        out[i] = (value + guess) & 255
    return bytes(out)


def main(test):
    """Runs test(bench) with the folders of the command line and tells the result."""
    bench = Bench(*sys.argv[1:4])
    test(bench)
    for fault in bench.faults:
        print(fault)
    print(f"{len(bench.faults)} faults")
    sys.exit(1 if bench.faults else 0)
