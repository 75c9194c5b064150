#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""gcpw_stitch: pictures, choices, dump, report, models, the plain pipeline, refusals.

Usage: test_gcpw_stitch.py PROGRAMS SCRATCH SAMPLES"""
import json
import pathlib
import re

from harness import FILE_TROUBLE, NO_ANSWER, WRONG_USE, main

QUICK = ("--work_megapix=0.15", "--compose_megapix=0.15", "--seam=dp_color", "--crop=none")
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
    """Cameras of other photographs would give a displaced picture without a word."""
    model = bench.path("again.json").read_text(encoding="utf-8")
    bench.check(all(f'"{key}"' in model for key in ("projection", "image_size", "component")), "the model lacks warper, sizes or order")
    call = (*photos, "gray.pgm", *QUICK, "--output=no.png")
    bench.flat_image("small.pgm", 400, 400)
    bench.refused("gcpw_stitch", photos[0], "small.pgm", *QUICK, "--output=no.png", "--load_model=again.json", says="another size")
    bench.refused("gcpw_stitch", *call, "--load_model=again.json", "--warp=fisheye", says="leave out --warp=fisheye")
    component = re.search(r'"component": \[[^]]*\]', model).group()
    for other, says, code in (('"component": [ 0, 7 ]', "photograph 8", WRONG_USE), ('"component": [ 0, 1, 0 ]', "component", FILE_TROUBLE),
                              ('"component": []', "other photographs", WRONG_USE)):
        bench.path("other.json").write_text(model.replace(component, other), encoding="utf-8")
        bench.refused("gcpw_stitch", *call, "--load_model=other.json", expect=code, says=says)
    # Without a component all images are meant.
    bench.run("gcpw_stitch", *photos, *QUICK, "--output=all.png", "--load_model=other.json")
    bench.check(bench.same_bytes("pano.png", "all.png"), "a model without a component gives another picture")


def scales_a_model(bench, photos):
    """Photographs of another size and the same shape: the same picture, scaled. The resolution of the estimation is the model's."""
    bench.run("gcpw_stitch", *photos, "gray.pgm", *QUICK, "--work_megapix=0.3", "--output=other.png", "--load_model=model.yml.gz")
    bench.check(bench.same_bytes("pano.png", "other.png"), "--work_megapix changes the picture of a model")
    for index, photo in enumerate(photos):
        bench.halve(photo, f"half{index}.ppm")
    bench.run("gcpw_stitch", "half0.ppm", "half1.ppm", *QUICK, "--compose_megapix=-1", "--output=halves.png", "--load_model=other.json")
    bench.run("gcpw_stitch", *photos, *QUICK, "--compose_megapix=0.12", "--output=full.png", "--load_model=other.json")
    halves, full = bench.png("halves.png"), bench.png("full.png")
    bench.check(all(abs(a - b) <= 2 for a, b in zip(halves, full)), f"photographs of half the size give {halves}, not {full}")


def keeps_what_it_reads(bench, photos):
    for options in ((f"--output={photos[1]}",), ("--dump=photos",), ("--load_model=model.yml.gz", "--save_model=model.yml.gz")):
        bench.keeps((*photos, "model.yml.gz"), "gcpw_stitch", *photos, *QUICK, *options, says="overwrit")


def takes_folders_lists_and_patterns(bench, photos):
    """The same photographs, named in four ways: the same picture. A bad one among them is left out if the caller says so."""
    bench.path("many").mkdir()
    for index, photo in enumerate(photos):
        bench.path(f"many/IMG_{9 + index}.png").write_bytes(bench.path(photo).read_bytes())
    bench.path("many/notes.txt").write_text("no picture", encoding="utf-8")
    bench.path("lists").mkdir()
    bench.path("lists/list.txt").write_text("# two\n\n../many/IMG_9.png\n../many/IMG_10.png\n", encoding="utf-8")
    bench.run("gcpw_stitch", *photos, *QUICK, "--output=named.png")
    for index, arguments in enumerate((("many",), ("many/*.png",), ("@lists/list.txt",), ("--list", "lists/list.txt"))):
        bench.run("gcpw_stitch", *arguments, *QUICK, f"--output=way{index}.png")
        bench.check(bench.same_bytes("named.png", f"way{index}.png"), f"{arguments} are other photographs")
    bench.path("many/IMG_8.png").write_text("no picture", encoding="utf-8")
    bench.refused("gcpw_stitch", "many", *QUICK, "--output=no.png", expect=FILE_TROUBLE, says="IMG_8.png")
    said = bench.run("gcpw_stitch", "many", *QUICK, "--skip-bad", "--output=skipped.png", says="left out")
    bench.check("IMG_8.png" in said and bench.same_bytes("named.png", "skipped.png"), f"what is bad is not left out: {said}")


def several_panoramas(bench, photos):
    """Two scenes: a picture of each."""
    for index, photo in enumerate(photos):
        bench.mirror(photo, f"mirrored{index}.ppm")
    bench.run("gcpw_stitch", *photos, "mirrored0.ppm", "gray.pgm", "mirrored1.ppm", *QUICK, "--output=scene.png", says="dropped gray.pgm")
    bench.check(bench.png("scene.png") is not None and bench.png("scene-2.png") is not None, "two scenes do not give two pictures")
    bench.path("scene-2.png").unlink()
    bench.run("gcpw_stitch", *photos, "mirrored0.ppm", "mirrored1.ppm", *QUICK, "--output=scene.png", "--panoramas=largest")
    bench.check(not bench.path("scene-2.png").exists(), "--panoramas=largest writes two")


def crops(bench, photos):
    bench.run("gcpw_stitch", *photos, *QUICK, "--output=whole.png")
    bench.run("gcpw_stitch", *photos, *QUICK, "--crop=auto", "--output=inner.png")
    whole, inner = bench.png("whole.png"), bench.png("inner.png")
    bench.check(inner[0] <= whole[0] and inner[1] < whole[1] and inner[0] > 0.8 * whole[0], f"{whole} is cropped to {inner}")
    bench.run("gcpw_stitch", *photos, "--preview", "--crop=none", "--output=preview.png")
    bench.check(bench.png("preview.png")[0] < 800, f"a preview is {bench.png('preview.png')}")


def detailed(bench, photos):
    """What OpenCV's stitching_detailed takes."""
    for options in (("--mode=panorama", "--matcher=homography", "--estimator=homography", "--ba=ray", "--ba_refine_mask=x_xxx",
                     "--wave_correct=vert", "--try_cuda=no"),
                    ("--expos_comp=gain_blocks", "--expos_comp_nr_feeds=2", "--expos_comp_nr_filtering=1", "--expos_comp_block_size=16"),
                    ("--expos_comp=no",), ("--blend_strength=1",), ("--blend=feather", "--blend_strength=5"), ("--features=orb",),
                    ("--warp=paniniPortraitA2B1", "--rangewidth=1"), ("--mode=scans", "--matcher=affine", "--estimator=affine")):
        bench.run("gcpw_stitch", *photos, *QUICK, *options, "--output=detailed.png")
    bench.run("gcpw_stitch", *photos, *QUICK, "--save_graph=graph.dot", "--timelapse=as_is", "--output=pano.png")
    bench.check("graph matches_graph" in bench.path("graph.dot").read_text(encoding="utf-8"), "there is no graph of matches")
    frames = [bench.png(f"fixed_{pathlib.Path(photo).name}") for photo in photos]
    bench.check(frames[0] == frames[1] == bench.png("pano.png"), f"frames are {frames}")


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


def no_answer(bench, photos):
    bench.refused("gcpw_stitch", photos[0], "gray.pgm", "--output=no.png", "--dump=no", expect=NO_ANSWER, says="match")
    bench.run("gcpw_stitch", "--help", says="--save_model")


def test(bench):
    photos = bench.synthetic_pair()
    bench.flat_image("gray.pgm", 800, 600)
    stitches(bench, photos)
    tells_its_choices(bench, photos)
    dumps(bench)
    reuses_a_model(bench, photos)
    refuses_a_model_of_others(bench, photos)
    for part in (scales_a_model, keeps_what_it_reads, plain_pipeline, takes_folders_lists_and_patterns, several_panoramas, crops, detailed,
                 no_answer):
        part(bench, photos)


if __name__ == "__main__":
    main(test)
