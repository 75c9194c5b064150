#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""gcpw_pair: pictures, dump, report, refusals.

Usage: test_gcpw_pair.py PROGRAMS SCRATCH SAMPLES"""
import gzip
import json
import pathlib
import subprocess

from harness import FILE_TROUBLE, NO_ANSWER, WRONG_USE, main

DUMP = {"source.png": 3, "source_mask.png": 1, "target.png": 3, "target_mask.png": 1, "source_corrected.png": 3, "mesh.png": 3}
REPORT = {"status", "message", "method", "points", "lines", "folds", "max_displacement_px", "gain_min", "gain_max", "levels", "scores",
          "timings_ms"}
LEVEL = {"scale", "iterations", "stop", "energy_start", "energy_end"}
# The energies of the terms that the default method has, and of those that it may have on a level.
ENERGY = {"points", "lines", "similarity", "total"}
ENERGY_TOO = {"straightness", "photometric", "color_smoothness", "color_prior", "anchors"}
TIMINGS = {"features", "homography", "align", "render", "total"}
MODEL = "model.yml.gz"  # Alignment::save()
QUICK = ("--work_megapix=0.15", "--set=featureMegapix=0.15")


def keys_of_report(bench, report):
    bench.check(set(report) == REPORT, f"the report has {sorted(report)}")
    bench.check(set(report["timings_ms"]) == TIMINGS, f"timings are {sorted(report['timings_ms'])}")
    bench.check(bool(report["levels"]), "no level is reported")
    for level in report["levels"]:
        bench.check(set(level) == LEVEL, f"a level has {sorted(level)}")
        for when in ("energy_start", "energy_end"):
            names = set(level[when])
            bench.check(ENERGY <= names <= ENERGY | ENERGY_TOO, f"energies are {sorted(names)}")
            bench.check("total" in names and abs(level[when]["total"] - sum(v for k, v in level[when].items() if k != "total"))
                        <= 1e-6 * level[when]["total"], f"the total is not the sum: {level[when]}")
    bench.check(ENERGY_TOO - {"anchors"} <= set(report["levels"][-1]["energy_end"]), "the last level has no pixels or no colours")
    for when in ("before", "after"):
        bench.check(set(report["scores"][when]) == {"ncc", "zncc"}, f"scores are {report['scores']}")


def stitches(bench, source, target):
    bench.run("gcpw_pair", source, target, "--output=pano.png", "--dump=dump/deep", "--report=report.json", says="pano.png")
    size = bench.png("pano.png")
    bench.check(size is not None and 1000 < size[0] < 1300 and 600 <= size[1] < 700, f"the panorama is {size}")
    found = {path.name for path in bench.path("dump/deep").iterdir()}
    bench.check(found == {*DUMP, MODEL}, f"the dump holds {sorted(found)}")
    for name, channels in DUMP.items():
        bench.check(bench.png("dump/deep/" + name) == (*size[:2], channels), f"{name} is {bench.png('dump/deep/' + name)}")
    model = gzip.decompress(bench.path("dump/deep/" + MODEL).read_bytes()).decode()
    for key in ("kind: gcpw_alignment", "canvas_scale:", "images:", "work_size:", "mesh:", "rough:"):
        bench.check(key in model, f"{MODEL} has no {key}")
    report = json.loads(bench.path("report.json").read_text(encoding="utf-8"))
    keys_of_report(bench, report)
    bench.check(report["status"] == "ok" and report["method"] == "gcpw" and report["folds"] == 0, f"the report says {report}")
    bench.check(report["scores"]["after"]["zncc"] < 0.3 * report["scores"]["before"]["zncc"], f"scores are {report['scores']}")


def views(bench, source, target):
    """Seen from between both or in the target's frame: another picture of another size, the same alignment and the same scores."""
    for view in ("natural", "target"):
        bench.run("gcpw_pair", source, target, *QUICK, f"--view={view}", f"--output={view}.png", f"--report={view}.json", f"--dump={view}")
    bench.run("gcpw_pair", source, target, *QUICK, "--output=default.png")
    bench.check(bench.same_bytes("default.png", "natural.png"), "the natural view is not the default")
    bench.check(bench.png("natural.png") != bench.png("target.png"), "both views have one size")
    natural, in_target = (json.loads(bench.path(view + ".json").read_text(encoding="utf-8")) for view in ("natural", "target"))
    bench.check(natural["scores"] == in_target["scores"], f"scores are {natural['scores']} and {in_target['scores']}")
    models = [gzip.decompress(bench.path(f"{view}/{MODEL}").read_bytes()) for view in ("natural", "target")]
    bench.check(models[0] == models[1], "the alignment depends on the view")
    bench.run("gcpw_pair", source, target, *QUICK, "--paper", "--output=paper.png", "--dump=paper")
    bench.run("gcpw_pair", source, target, *QUICK, "--paper", "--view=target", "--output=paper_target.png")
    bench.check(bench.same_bytes("paper.png", "paper_target.png"), "the paper's view is not the target's frame")


def repeats(bench, source, target):
    for threads in (1, 2):
        bench.run("gcpw_pair", source, target, *QUICK, f"--output=threads{threads}.png", f"--threads={threads}")
    bench.check(bench.same_bytes("threads1.png", "threads2.png"), "one thread and two give different pictures")


def methods(bench, source, target):
    for method in ("global", "mfw"):
        bench.run("gcpw_pair", source, target, *QUICK, f"--method={method}", f"--output={method}.png", f"--report={method}.json",
                  "--blend=average")
        report = json.loads(bench.path(method + ".json").read_text(encoding="utf-8"))
        bench.check(report["method"] == method, f"{method} reports {report['method']}")
    bench.check(not bench.same_bytes("global.png", "mfw.png"), "global and mfw give one picture")


def renders_another_source(bench, source, target):
    """Estimated on one picture, rendered from another: the mesh is the same, the colours of the panorama are not."""
    bench.run("gcpw_pair", source, target, *QUICK, "--output=plain.png", "--dump=plain", "--report=plain.json")
    bench.run("gcpw_pair", source, target, *QUICK, f"--render_source={source}", "--output=itself.png")
    bench.check(bench.same_bytes("plain.png", "itself.png"), "rendering the source itself changes the picture")
    bench.flat_image("flat.pgm", 800, 600)
    bench.run("gcpw_pair", source, target, *QUICK, "--render_source=flat.pgm", "--output=flat.png", "--dump=flat",
              "--report=flat.json")
    bench.check(bench.same_bytes("plain/source_mask.png", "flat/source_mask.png"), "the mesh depends on what is rendered")
    bench.check(not bench.same_bytes("plain/source.png", "flat/source.png"), "the other source is not rendered")
    plain, flat = (json.loads(bench.path(name).read_text(encoding="utf-8")) for name in ("plain.json", "flat.json"))
    bench.check(plain["levels"] == flat["levels"], "the estimation depends on what is rendered")
    bench.flat_image("small.pgm")
    bench.refused("gcpw_pair", source, target, "--render_source=small.pgm", "--output=no.png", says="small.pgm")


def no_answer(bench, _, target):
    """What has no answer has a report all the same, and no pictures."""
    bench.run("gcpw_pair", "gray.pgm", target, "--output=no.png", "--dump=no", "--report=none.json", expect=NO_ANSWER, says="matches")
    bench.check(not bench.path("no.png").exists() and not bench.path("no").exists(), "a failure leaves pictures")
    report = json.loads(bench.path("none.json").read_text(encoding="utf-8"))
    bench.check(report["status"] == "no_alignment" and report["message"], f"the report of a failure says {report}")


def says_what_it_takes(bench, source, target):
    """Help and version; options with a space, an equals sign, a letter, one dash; the last one counts."""
    bench.run("gcpw_pair", "--help", says="--render_source")
    bench.run("gcpw_pair", "--version", says="gcpw_pair ")
    bench.run("gcpw_pair", "-o", "letter.png", source, "--output", "space.png", target, "-work_megapix=0.1", *QUICK, "-q", "-t", "1")
    bench.check(bench.path("space.png").exists() and not bench.path("letter.png").exists(), "the last of two outputs is not taken")
    said = bench.run("gcpw_pair", source, target, *QUICK, "--quiet", "--output=quiet.png")
    bench.check(said == "", f"quiet says {said}")
    bench.run("gcpw_pair", source, target, *QUICK, "--verbose", "--output=loud.png", says="800 x 600")


def crops_and_pipes(bench, source, target):
    bench.run("gcpw_pair", source, target, *QUICK, "--output=whole.png")
    bench.run("gcpw_pair", source, target, *QUICK, "--crop=auto", "--output=inner.png")
    whole, inner = bench.png("whole.png"), bench.png("inner.png")
    bench.check(inner[0] < whole[0] and inner[1] < whole[1] and inner[0] > 0.8 * whole[0], f"{whole} is cropped to {inner}")
    for name in ("-", "/dev/stdout"):
        with open(bench.path("piped.png"), "wb") as piped:
            command = [str(bench.place("gcpw_pair")), source, target, *QUICK, f"--output={name}"]
            done = subprocess.run(command, cwd=bench.scratch, stdout=piped, stderr=subprocess.PIPE, check=False)
        bench.check(done.returncode == 0 and b"zncc" in done.stderr, f"to {name}: {done.returncode} {done.stderr}")
        bench.check(bench.same_bytes("whole.png", "piped.png"), f"what goes to {name} is not the picture")


def keeps_what_it_reads(bench, source, target):
    other = "photos/../" + target
    for options, says in (((f"--output={source}",), "overwritten"), ((f"--output={other}",), "overwritten"),
                          (("--output=a.json.png", "--dump=photos"), "choose another folder")):
        bench.keeps((source, target), "gcpw_pair", source, target, *options, says=says)
    # A file of the user's that has the name of an unfinished one, and a link, which stays one.
    bench.path("pano.png.partial0").write_text("mine", encoding="utf-8")
    bench.path("link.png").symlink_to(bench.path("behind.png"))
    bench.path("behind.png").write_text("old", encoding="utf-8")
    bench.run("gcpw_pair", source, target, *QUICK, "--output=link.png")
    bench.check(bench.path("link.png").is_symlink() and bench.png("behind.png"), "a link is replaced")
    bench.run("gcpw_pair", source, target, *QUICK, "--output=pano.png", "--report=/dev/stdout", says='"status"')
    bench.check(bench.path("pano.png.partial0").read_text(encoding="utf-8") == "mine", "a file of the user's is lost")
    bench.refused("gcpw_pair", source, target, *QUICK, "--output=pano.png", expect=WRONG_USE, says="pano.png exists")
    if pathlib.Path("/dev/full").exists():
        bench.refused("gcpw_pair", source, target, *QUICK, "--output=full.png", "--method=cpw", "--report=/dev/full", expect=FILE_TROUBLE,
                      says="disk is full", leaves=("full.png",))


def test(bench):
    pair = bench.synthetic_pair()
    bench.flat_image("gray.pgm", 800, 600)
    for photo in pair:
        bench.check(bench.png(photo) == (800, 600, 3), f"{photo} is {bench.png(photo)}")
    for part in (stitches, views, repeats, methods, renders_another_source, no_answer, says_what_it_takes, crops_and_pipes, keeps_what_it_reads):
        part(bench, *pair)


if __name__ == "__main__":
    main(test)
