#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""gcpw_stitch: pictures, choices, dump, report, models, the plain pipeline, refusals.

Usage: test_gcpw_stitch.py PROGRAMS SCRATCH SAMPLES"""
import json
import re

from harness import NO_ALIGNMENT, main

QUICK = ("--work_megapix=0.15", "--compose_megapix=0.15", "--seam=dp_color")
REPORT = {"status", "method", "width", "height", "images", "dropped", "decisions", "timings_ms"}
ALIGNMENT = {"status", "message", "estimations", "folds", "max_displacement_px", "gain_min", "gain_max", "pairs", "timings_ms"}


def report_of(bench, name):
    return json.loads(bench.path(name).read_text(encoding="utf-8"))


def stitches(bench, photos):
    bench.run("gcpw_stitch", *photos, "gray.pgm", *QUICK, "--output=pano.png", "--dump=dump", "--report=report.json",
              "--save_model=model.yml.gz", says="dropped gray.pgm")
    size = bench.png("pano.png")
    report = report_of(bench, "report.json")
    bench.check(set(report) == REPORT | {"alignment"}, f"the report has {sorted(report)}")
    bench.check(set(report["alignment"]) == ALIGNMENT, f"the alignment has {sorted(report['alignment'])}")
    bench.check((report["width"], report["height"], 3) == size, f"the panorama is {size}, the report says {report}")
    bench.check(report["dropped"] == ["gray.pgm"] and report["images"] == 3, f"dropped are {report['dropped']}")
    alignment = report["alignment"]
    bench.check(alignment["status"] == "ok" and alignment["estimations"] == 1 and alignment["folds"] == 0, f"{alignment}")
    for pair in alignment["pairs"]:
        bench.check(pair["miss_after"] < 0.5 * pair["miss_before"], f"not refined: {pair}")


def tells_its_choices(bench, photos):
    """Mode auto says which cameras and projection it took; the modes by name choose nothing."""
    decisions = report_of(bench, "report.json")["decisions"]
    for word in ("cameras", "projection", "photograph 3 was left out"):
        bench.check(any(word in decision for decision in decisions), f"nothing is said of {word}: {decisions}")
    bench.run("gcpw_stitch", *photos, *QUICK, "--mode=panorama", "--ba=reproj", "--wave_correct=no", "--method=none", "--output=named.png",
              "--report=named.json")
    bench.check(report_of(bench, "named.json")["decisions"] == [], "mode panorama made choices of its own")
    bench.run("gcpw_stitch", *photos, *QUICK, "--warp=cylindrical", "--method=none", "--output=forced.png", says="projection is cylindrical")
    bench.run("gcpw_stitch", *photos, *QUICK, "--warp=affine", "--method=none", "--output=flat.png", says="projection is affine")


def dumps(bench):
    found = {path.name for path in bench.path("dump").iterdir()}
    expected = {f"{k:03d}_{what}.png" for k in (0, 1) for what in ("image", "corrected", "mask")} | {"corners.csv"}
    bench.check(found == expected, f"the dump holds {sorted(found)}")
    rows = [line.split(",") for line in bench.path("dump/corners.csv").read_text(encoding="utf-8").splitlines()]
    bench.check([row[0] for row in rows] == ["000", "001"], f"corners are of {rows}")
    boxes = []
    for number, x, y in rows:
        image, mask = bench.png(f"dump/{number}_image.png"), bench.png(f"dump/{number}_mask.png")
        bench.check(image[:2] == mask[:2] and (image[2], mask[2]) == (3, 1), f"{number}: {image}, {mask}")
        boxes.append((int(x), int(y), int(x) + image[0], int(y) + image[1]))
    width, height = (max(box[i + 2] for box in boxes) - min(box[i] for box in boxes) for i in (0, 1))
    bench.check((width, height, 3) == bench.png("pano.png"), f"corners and sizes give {width} x {height}")


def reuses_a_model(bench, photos):
    bench.run("gcpw_stitch", *photos, "gray.pgm", *QUICK, "--output=loaded.png", "--load_model=model.yml.gz", "--report=loaded.json",
              "--save_model=again.json")
    bench.check(bench.same_bytes("pano.png", "loaded.png"), "a loaded model gives another picture")
    bench.check(report_of(bench, "loaded.json")["alignment"]["estimations"] == 0, "a loaded model is estimated again")
    bench.run("gcpw_stitch", *photos, "gray.pgm", *QUICK, "--output=json.png", "--load_model=again.json")
    bench.check(bench.same_bytes("pano.png", "json.png"), "a model through JSON gives another picture")


def refuses_a_model_of_others(bench, photos):
    """Cameras at another scale, or of other photographs, would give a displaced picture without a word."""
    model = bench.path("again.json").read_text(encoding="utf-8")
    call = (*photos, "gray.pgm", *QUICK, "--output=no.png")
    bench.refused("gcpw_stitch", *call, "--load_model=again.json", "--work_megapix=0.3", says="--work_megapix")
    bench.flat_image("small.pgm", 400, 300)
    bench.refused("gcpw_stitch", photos[0], "small.pgm", *QUICK, "--output=no.png", "--load_model=again.json", says="another size")
    component = re.search(r'"component": \[[^]]*\]', model).group()
    for other, says in (('"component": [ 0, 7 ]', "image 8"), ('"component": [ 0, 1, 0 ]', "component"), ('"component": []', "other images")):
        bench.path("other.json").write_text(model.replace(component, other), encoding="utf-8")
        bench.refused("gcpw_stitch", *call, "--load_model=other.json", says=says)
    # Without a component all images are meant.
    bench.run("gcpw_stitch", *photos, *QUICK, "--output=all.png", "--load_model=other.json")
    bench.check(bench.same_bytes("pano.png", "all.png"), "a model without a component gives another picture")


def keeps_what_it_reads(bench, photos):
    for options in ((f"--output={photos[1]}",), (f"--report={photos[0]}",), (f"--save_model={photos[0]}",), ("--dump=photos",),
                    ("--load_model=model.yml.gz", "--save_model=model.yml.gz")):
        bench.keeps((*photos, "model.yml.gz"), "gcpw_stitch", *photos, *QUICK, *options, says="overwrit")
    bench.flat_image("tiny.pgm", 1, 1)
    bench.refused("gcpw_stitch", *photos, "tiny.pgm", "--output=no.png", says="tiny.pgm is 1 x 1 px")


def plain_pipeline(bench, photos):
    """Nothing of GCPW is in --method=none, and it is what GCPW falls back on."""
    bench.run("gcpw_stitch", *photos, *QUICK, "--method=none", "--output=none.png", "--report=none.json", "--dump=none")
    report = report_of(bench, "none.json")
    bench.check(set(report) == REPORT and report["method"] == "none", f"the report has {sorted(report)}")
    bench.check(not bench.same_bytes("none.png", "pano.png"), "gcpw gives the plain picture")
    # At so low a resolution no overlap is large enough to be refined.
    bench.run("gcpw_stitch", *photos, *QUICK, "--set=workMegapix=0.0001", "--output=rough.png", "--report=rough.json", says="overlap")
    bench.check(report_of(bench, "rough.json")["alignment"]["status"] == "rough", "the refinement found an answer after all")
    bench.check(bench.same_bytes("none.png", "rough.png"), "without a refinement the picture is not OpenCV's own")


def refuses(bench, photos):
    bench.path("text.jpg").write_text("not a picture", encoding="utf-8")
    bench.path("bad.yml").write_text("%YAML:1.0\n---\nkind: something\n", encoding="utf-8")
    out = ("--output=no.png", "--dump=no")
    for arguments, says in (((), "two photographs"), (photos[:1], "two photographs"), ((photos[0], "missing.png"), "missing.png"),
                            ((photos[0], "text.jpg"), "text.jpg"), ((*photos, "--method=best"), "gcpw, none"),
                            ((*photos, "--warp=ball"), "spherical"), ((*photos, "--mode=map"), "scans"),
                            ((*photos, "--ba=ray"), "--mode=panorama"), ((*photos, "--wave_correct=no"), "--mode=panorama"),
                            ((*photos, "--seams=no"), "--seams"), ((*photos, "--reference=3"), "--reference"),
                            ((*photos, "--work_megapix=-1"), "--work_megapix"), ((*photos, "--work_megapix=1e-9"), "at least 0.0001"),
                            ((*photos, "--set=meshCols=1"), "meshCols"),
                            ((*photos, "--load_model=missing.yml"), "missing.yml"), ((*photos, "--load_model=bad.yml"), "bad.yml"),
                            ((*photos, "--method=none", "--save_model=no.yml"), "--method=gcpw")):
        bench.refused("gcpw_stitch", *arguments, *out, says=says)
    bench.refused("gcpw_stitch", *photos, *QUICK, "--output=no_such_folder/pano.png", says="no_such_folder/pano.png")
    bench.refused("gcpw_stitch", photos[0], "gray.pgm", *out, expect=NO_ALIGNMENT, says="match")
    bench.run("gcpw_stitch", "--help", says="--save_model")


def test(bench):
    photos = bench.synthetic_pair()
    bench.flat_image("gray.pgm", 800, 600)
    stitches(bench, photos)
    tells_its_choices(bench, photos)
    dumps(bench)
    reuses_a_model(bench, photos)
    refuses_a_model_of_others(bench, photos)
    keeps_what_it_reads(bench, photos)
    plain_pipeline(bench, photos)
    refuses(bench, photos)


if __name__ == "__main__":
    main(test)
