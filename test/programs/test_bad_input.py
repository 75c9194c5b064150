#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Command lines with bad input: each ends with a sentence that names the cause and the file, with the right code, leaves no file and
changes no input.

Usage: test_bad_input.py PROGRAMS SCRATCH SAMPLES"""
import resource
import struct
import subprocess

from harness import FILE_TROUBLE, NO_ANSWER, WRONG_USE, main

PAIR, STITCH = "gcpw_pair", "gcpw_stitch"
A, B = "photos/source.png", "photos/target.png"
QUICK = {PAIR: ("--work_megapix=0.1", "--set=featureMegapix=0.1"), STITCH: ("--work_megapix=0.1", "--compose_megapix=0.1", "--seam=no")}
LONG = "n" * 300

# program, arguments, exit code, words of the message.
CASES = [
    # Options that cannot be.
    (PAIR, (), WRONG_USE, ("two photographs are needed",)),
    (PAIR, (A,), WRONG_USE, ("two photographs are needed",)),
    (PAIR, (A, B, A), WRONG_USE, ("gcpw_stitch takes more",)),
    (PAIR, (A, B, "--colour"), WRONG_USE, ("no option --colour",)),
    (PAIR, (A, B, "--outptu=x.png"), WRONG_USE, ("--outptu", "did you mean --output")),
    (PAIR, (A, B, "--output"), WRONG_USE, ("--output", "--help")),
    (PAIR, (A, B, "--output="), WRONG_USE, ("--output", "without a value")),
    (PAIR, (A, B, "--method=gcwp"), WRONG_USE, ("'gcwp'", "did you mean gcpw", "lsh_mfw")),
    (PAIR, (A, B, "--view", "middle"), WRONG_USE, ("'middle'", "natural or target")),
    (PAIR, (A, B, "--blend=hard"), WRONG_USE, ("'hard'", "multiband")),
    (PAIR, (A, B, "--work_megapix=abc"), WRONG_USE, ("--work_megapix", "'abc'", "million pixels")),
    (PAIR, (A, B, "--work_megapix=0"), WRONG_USE, ("--work_megapix", "0.0001")),
    (PAIR, (A, B, "--work_megapix=nan"), WRONG_USE, ("--work_megapix", "'nan'")),
    (PAIR, (A, B, "--threads=99999999"), WRONG_USE, ("--threads", "-1 to 1024", "99999999")),
    (PAIR, (A, B, "--threads=1.5"), WRONG_USE, ("--threads", "whole number")),
    (PAIR, (A, B, "--quality=101"), WRONG_USE, ("--quality", "1 to 100")),
    (PAIR, (A, B, "--set=meshCols=1"), WRONG_USE, ("meshCols",)),
    (PAIR, (A, B, "--set=quads=3"), WRONG_USE, ("quads",)),
    (PAIR, (A, B, "--set=meshCols"), WRONG_USE, ("name=number", "meshCols")),
    (PAIR, (A, ""), WRONG_USE, ("an argument is empty",)),
    (STITCH, (A,), WRONG_USE, ("two photographs or more",)),
    (STITCH, (A, A), WRONG_USE, ("two photographs or more",)),
    (STITCH, (A, B, "--warp=ball"), WRONG_USE, ("'ball'", "spherical", "paniniPortraitA1.5B1")),
    (STITCH, (A, B, "--reference=3"), WRONG_USE, ("--reference", "1 to 2")),
    (STITCH, (A, B, "--ba=ray"), WRONG_USE, ("--mode=panorama",)),
    (STITCH, (A, B, "--ba_refine_mask=xx"), WRONG_USE, ("--ba_refine_mask", "'xx'")),
    (STITCH, (A, B, "--compose_megapix=0"), WRONG_USE, ("--compose_megapix", "0.0001")),
    (STITCH, (A, B, "--conf_thresh=-1"), WRONG_USE, ("--conf_thresh",)),
    (STITCH, (A, B, "--method=none", "--save_model=m.yml"), WRONG_USE, ("--method=gcpw",)),
    (STITCH, (A, B, "--save_model=m.png"), WRONG_USE, ("m.png", ".yml")),
    (STITCH, (A, B, "--report=old.yml"), WRONG_USE, ("old.yml", "a folder is needed")),
    # Inputs that cannot be read.
    (PAIR, (A, "missing.png"), FILE_TROUBLE, ("no file missing.png",)),
    (PAIR, (A, "text.jpg"), FILE_TROUBLE, ("text.jpg is no picture",)),
    (PAIR, (A, "empty.jpg"), FILE_TROUBLE, ("empty.jpg", "empty")),
    (PAIR, (A, "half.jpg"), FILE_TROUBLE, ("half.jpg is cut short",)),
    (PAIR, (A, "half.png"), FILE_TROUBLE, ("half.png",)),
    (STITCH, (A, "half.tif"), FILE_TROUBLE, ("half.tif",)),
    (STITCH, (A, "half.webp"), FILE_TROUBLE, ("half.webp",)),
    (STITCH, (A, "half.bmp"), FILE_TROUBLE, ("half.bmp",)),
    (STITCH, (A, "half.pgm"), FILE_TROUBLE, ("half.pgm",)),
    (PAIR, (A, "float.pfm"), FILE_TROUBLE, ("float.pfm has pixels of kind CV_32FC3",)),
    (PAIR, (A, "dot.pgm"), FILE_TROUBLE, ("dot.pgm is 1 x 1 px",)),
    (STITCH, (A, "dot.pgm"), FILE_TROUBLE, ("dot.pgm is 1 x 1 px",)),
    (PAIR, (A, "loop"), FILE_TROUBLE, ("loop",)),
    (PAIR, (A, LONG + ".jpg"), FILE_TROUBLE, ("nnn.jpg",)),
    (STITCH, ("nothing/",), FILE_TROUBLE, ("nothing", "no pictures")),
    (STITCH, ("none-*.jpg",), FILE_TROUBLE, ("none-*.jpg",)),
    (STITCH, ("@missing.txt",), FILE_TROUBLE, ("missing.txt",)),
    (STITCH, ("--list=round.txt",), FILE_TROUBLE, ("round.txt", "itself")),
    (STITCH, (A, "text.jpg", "half.jpg", "--skip-bad"), FILE_TROUBLE, ("text.jpg", "half.jpg", "fewer than two")),
    (STITCH, (A, B, "--load_model=missing.yml"), FILE_TROUBLE, ("missing.yml",)),
    (STITCH, (A, B, "--load_model=bad.yml"), FILE_TROUBLE, ("bad.yml",)),
    # Outputs that must not or cannot be written.
    (PAIR, (A, B, f"--output={A}", "--force"), WRONG_USE, (A, "overwritten")),
    (PAIR, (A, B, f"--report=./photos/../{B}", "--force"), WRONG_USE, (B, "a folder is needed")),
    (PAIR, (A, B, "--output=linked.png", "--force"), WRONG_USE, ("linked.png", "overwritten")),
    (STITCH, (A, B, "--output=hard.png", "--force"), WRONG_USE, ("hard.png", "overwritten")),
    (PAIR, (A, B, "--dump=photos", "--force"), WRONG_USE, ("--dump=photos", "overwrite")),
    (PAIR, (A, B, "--output=old.png"), WRONG_USE, ("old.png exists", "--force")),
    (STITCH, (A, B, "--report=old.json"), WRONG_USE, ("old.json exists", "--force")),
    (STITCH, (A, B, "--save_model=old.yml"), WRONG_USE, ("old.yml exists", "--force")),
    (STITCH, (A, B, "--load_model=old.yml", "--save_model=old.yml", "--force"), WRONG_USE, ("old.yml", "overwritten")),
    (PAIR, (A, B, "--dump=full"), WRONG_USE, ("full", "not empty", "--force")),
    (PAIR, (A, B, "--dump=old.png", "--force"), WRONG_USE, ("old.png is a file",)),
    (PAIR, (A, B, "--output=full"), WRONG_USE, ("full",)),
    (PAIR, (A, B, "--output=pano.picture"), WRONG_USE, ("pano.picture", ".jpg")),
    (PAIR, (A, B, "--output=same.json.png", "--report=same.json.png"), WRONG_USE, ("same.json.png",)),
    (STITCH, (A, B, "--save_model=same.json", "--report=same.json"), WRONG_USE, ("same.json", "one file")),
    (PAIR, (A, B, "--output=no_such_folder/pano.png"), FILE_TROUBLE, ("no_such_folder/pano.png", "make it first")),
    (PAIR, (A, B, f"--output={LONG}.png"), FILE_TROUBLE, ("nnn.png", "too long")),
    (PAIR, (A, B, "--output=loop.png"), FILE_TROUBLE, ("loop.png",)),
    (PAIR, ("--synthetic=full",), WRONG_USE, ("full", "not empty")),
    # Photographs without an answer.
    (PAIR, (A, "gray.pgm"), NO_ANSWER, ("match",)),
    (STITCH, (A, "gray.pgm"), NO_ANSWER, ("match",)),
]


def prepare(bench):
    """The files that the cases name."""
    bench.synthetic_pair()
    bench.flat_image("gray.pgm", 800, 600)
    bench.flat_image("dot.pgm", 1, 1)
    for ending in ("jpg", "png", "tif", "webp", "bmp"):
        bench.run(PAIR, A, B, *QUICK[PAIR], "--method=global", f"--output=whole.{ending}")
        whole = bench.path(f"whole.{ending}").read_bytes()
        bench.path(f"half.{ending}").write_bytes(whole[:len(whole) // 2])
    bench.path("half.pgm").write_bytes(bench.path("gray.pgm").read_bytes()[:2000])
    bench.path("float.pfm").write_bytes(b"PF\n40 30\n-1.0\n" + struct.pack("<3600f", *([0.5] * 3600)))
    for name, text in (("text.jpg", "not a picture"), ("empty.jpg", ""), ("bad.yml", "%YAML:1.0\n---\nkind: something\n"),
                       ("old.png", "mine"), ("old.json", "mine"), ("old.yml", "mine"), ("round.txt", "@round.txt\n")):
        bench.path(name).write_text(text, encoding="utf-8")
    bench.path("nothing").mkdir()
    bench.path("full").mkdir()
    bench.path("full/mine.txt").write_text("mine", encoding="utf-8")
    bench.path("linked.png").symlink_to(bench.path(A))
    bench.path("hard.png").hardlink_to(bench.path(A))
    for name in ("loop", "loop.png"):
        bench.path(name).symlink_to(bench.path(name))


def contents(bench):
    return {path: path.read_bytes() for path in bench.scratch.rglob("*") if path.is_file()}


def refuses(bench):
    before = contents(bench)
    for program, arguments, code, words in CASES:
        defaults = () if any(str(one).startswith(("--output", "--synthetic")) for one in arguments) else ("--output=no.png",)
        said = bench.run(program, *QUICK[program], *arguments, *defaults, expect=code)
        call = f"{program} {arguments}"
        for word in words:
            bench.check(word in said, f"{call}: does not say '{word}': {said}")
        lines = [line for line in said.splitlines() if line.startswith(program + ": ")]
        bench.check(bool(lines), f"{call}: does not say who speaks: {said}")
        bench.check("terminate called" not in said and "OpenCV(" not in said, f"{call}: is not in words of our own: {said}")
        after = contents(bench)
        bench.check(after.keys() == before.keys(), f"{call}: leaves {sorted(map(str, after.keys() ^ before.keys()))}")
        bench.check(after == before, f"{call}: changes a file")
        for path in after.keys() - before.keys():
            path.unlink()


def no_room(bench):
    """No file may grow beyond some bytes, as on a full disk: an error, and nothing is left, of pictures and models alike."""
    def limit_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))

    for program, arguments in ((PAIR, ("--output=full.png",)), (PAIR, ("--output=full.bmp",)), (STITCH, ("--output=full.webp",)),
                               (STITCH, ("--output=full.tif",)), (PAIR, ("--output=/dev/full",)),
                               (STITCH, ("--output=/dev/null", "--save_model=full.yml")), (PAIR, ("--output=/dev/null", "--dump=new"))):
        before = bench.files()
        # Python ignores the signal of the limit, and so do the programs that it starts like this.
        done = subprocess.run([str(bench.place(program)), A, B, *QUICK[program], *arguments], cwd=bench.scratch, capture_output=True,
                              text=True, check=False, restore_signals=False, preexec_fn=limit_files)
        place = arguments[-1].partition("=")[2]
        bench.check(done.returncode == FILE_TROUBLE and place in done.stderr, f"{program} {arguments}: {done.returncode} {done.stderr}")
        left = {name for name in bench.files() - before if not bench.path(name).is_dir()}
        bench.check(not left, f"{program} {arguments}: leaves {left}")


def test(bench):
    prepare(bench)
    refuses(bench)
    no_room(bench)
    bench.check(len(CASES) >= 60, f"there are {len(CASES)} cases")


if __name__ == "__main__":
    main(test)
