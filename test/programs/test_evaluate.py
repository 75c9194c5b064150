#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""gcpw_evaluate end to end on a folder with one synthetic pair: test_evaluate.py PROGRAMS SCRATCH"""
import csv
import pathlib
import shutil
import subprocess
import sys

PROGRAMS, SCRATCH = (pathlib.Path(argument) for argument in sys.argv[1:3])
OUT = SCRATCH / "out"
TIMES = ("align_ms", "match_ms")


def evaluate(*options, code=0, pairs=True):
    command = [PROGRAMS / "gcpw_evaluate", f"--out={OUT}", "--max_megapix=0.1"]
    command += [f"--pairs={SCRATCH}/pairs"] if pairs else []
    command += options
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == code, f"{options}: exit code {done.returncode}, expected {code}\n{done.stdout}{done.stderr}"
    return done.stderr


def rows():
    """Without the times, which differ from run to run."""
    with open(OUT / "results.csv", encoding="utf-8", newline="") as file:
        return [{key: value for key, value in row.items() if key not in TIMES} for row in csv.DictReader(file)]


def external(score):
    """Results of other programs: a warp and warped images are scored, a picture is shown, what is broken does not stop the rest."""
    theirs = SCRATCH / "theirs"
    for pair in "ab":
        place = SCRATCH / "pairs" / pair
        grid = [(x, y) for y in (0, 300, 599) for x in (0, 400, 799)]
        for method, left in (("warp", pair), ("warped", pair), ("picture", pair)):
            (theirs / method / left).mkdir(parents=True)
        (theirs / "warp" / pair / "warp.csv").write_text("".join(f"{x},{y},{x + 1},{y}\n" for x, y in grid), encoding="utf-8")
        subprocess.run([PROGRAMS / "gcpw_pair", place / "01.png", place / "02.png", "--method=global", "--view=target", f"--dump={theirs}/warped/{pair}",
                        f"--output={theirs}/picture/{pair}/panorama.png", "--force"], check=True, stdout=subprocess.DEVNULL)
    (theirs / "warp" / "b" / "warp.csv").write_text("0,0,1,0\n", encoding="utf-8")
    options = ",".join(f"{name}:{theirs}/{name}" for name in ("warp", "warped", "picture"))
    said = evaluate("--set=meshCols=16", "--degrees=0", "--inputs=1", "--methods=global,gcpw", f"--external={options}", code=1)
    assert "b/warp.csv" in said and "no grid" in said, said
    found = {(row["pair"], row["method"]): row for row in rows() if row["input"] == "1"}
    assert found["b", "warp"]["status"] == "failed" and found["b", "warped"]["status"] == "ok", found
    assert float(found["a", "warp"]["zncc"]) > 30 and float(found["a", "warp"]["shape"]) > 0, found["a", "warp"]
    assert 0.5 < float(found["a", "warped"]["zncc"]) / score["global"] < 2, (found["a", "warped"], score) # at another resolution
    assert found["a", "picture"]["status"] == "picture" and found["a", "warped"]["bend_p95"] == "", found
    report = (OUT / "report.md").read_text(encoding="utf-8")
    assert "| pair | Global | warp | warped | GCPW |" in report, report
    assert "--external takes NAME:FOLDER" in evaluate("--external=warp", code=2)
    assert "is taken" in evaluate(f"--external=gcpw:{theirs}", code=2)
    assert "there is no folder" in evaluate("--external=warp:/no/such", code=2)


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    for name in ("a", "b"):
        pair = SCRATCH / "pairs" / name
        pair.mkdir(parents=True)
        subprocess.run([PROGRAMS / "gcpw_pair", f"--synthetic={pair}"], check=True, stdout=subprocess.DEVNULL)
        (pair / "source.png").rename(pair / "01.png")
        (pair / "target.png").rename(pair / "02.png")

    evaluate("--degrees=0,16", "--inputs=1", "--workers=2")
    whole = rows()
    assert len(whole) == 2 * (4 + 4 * 2), whole
    assert all(row["status"] == "ok" for row in whole), whole
    score = {row["method"]: float(row["zncc"]) for row in whole if row["pair"] == "a" and row["degree"] == "00"}
    assert all(value < score["global"] for method, value in score.items() if method != "global"), score
    assert all(row["folds"] == "0" for row in whole if row["method"] == "gcpw"), whole
    looks = ("bend_p95", "bend_share", "shape", "seam_p95", "seam_worst", "cast", "crushed")
    seams = looks[3:5] # empty where the cut keeps to the border of the overlap, where nothing can be compared
    assert all(row[name] or name in seams for row in whole for name in looks if row["degree"] == "00"), whole
    assert not any(row[name] for row in whole for name in looks if row["degree"] == "16"), whole
    for row in whole:
        if row["degree"] == "00":
            assert (float(row["shape"]) == 0) == (row["method"] == "global"), row
            assert (float(row["cast"]) == 0) == (row["method"] != "gcpw"), row
    report = (OUT / "report.md").read_text(encoding="utf-8")
    assert "| mean over pairs | bend p95, px |" in report and "| pair, GCPW | bend p95, px |" in report, report
    assert "| pair | Global | APAP | CPW | DF-W | MF-W | LSH+MF-W | ROS+MF-W | GCPW |" in report, report
    assert (OUT / "sheets" / "a.jpg").stat().st_size > 10000

    # Interrupted after a few rows and a half, with another number of workers: the same table.
    text = (OUT / "results.csv").read_text(encoding="utf-8")
    (OUT / "results.csv").write_text(text[: len(text) // 2], encoding="utf-8")
    evaluate("--degrees=0,16", "--inputs=1", "--workers=1", "--no_sheets")
    assert rows() == whole

    # More degrees and inputs are added to what is there; other options are not mixed with it.
    evaluate("--degrees=0,8,16", "--inputs=1", "--methods=gcpw", "--no_sheets")
    assert len(rows()) == len(whole) + 2
    evaluate("--degrees=0", "--methods=global", "--no_sheets")
    assert len(rows()) == len(whole) + 2 + 2 * 4
    report = (OUT / "report.md").read_text(encoding="utf-8")
    assert "the median over 5 inputs" in report and "spread of zncc" in report, report
    assert "meshCols was 32, is 16" in evaluate("--set=meshCols=16", code=2)
    evaluate("--set=meshCols=16", "--degrees=0", "--inputs=1", "--methods=global", "--fresh", "--no_sheets")
    assert len(rows()) == 2

    # A photograph that cannot be read is told, and the other pair goes on.
    shutil.copytree(SCRATCH / "pairs" / "a", SCRATCH / "pairs" / "c")
    (SCRATCH / "pairs" / "c" / "01.png").write_text("no picture", encoding="utf-8")
    said = evaluate("--set=meshCols=16", "--degrees=0", "--inputs=2", "--methods=global,gcpw", code=1)
    assert said.count("c/01.png is not an image") == 2, said # the runs, and the sheet
    assert len(rows()) == 2 * 2 * 2
    shutil.rmtree(SCRATCH / "pairs" / "c")
    (SCRATCH / "pairs" / "half").mkdir()
    assert "half holds no pair and is left out" in evaluate("--set=meshCols=16", "--degrees=0", "--inputs=1", "--methods=global", code=1)
    (SCRATCH / "pairs" / "half").rmdir()

    external(score)
    # The inputs can be had as files, for other programs.
    evaluate(f"--write_inputs={SCRATCH}/inputs", "--inputs=2")
    assert sorted(path.relative_to(SCRATCH / "inputs").as_posix() for path in (SCRATCH / "inputs").rglob("*.png")) == \
        [f"{pair}/{number}/{photo}.png" for pair in "ab" for number in "12" for photo in ("01", "02")]

    # A set is stitched by both programs, and not again.
    street = SCRATCH / "sets" / "street"
    street.mkdir(parents=True)
    for name in ("01.png", "02.png"):
        shutil.copy(SCRATCH / "pairs" / "a" / name, street / name)
    sets = f"--sets={SCRATCH}/sets"
    assert "stitching street" in evaluate(sets, pairs=False)
    table = (OUT / "sets.md").read_text(encoding="utf-8")
    assert "| street | none | 0.00 | 0.0 | 0.000 | " in table, table
    assert (OUT / "sets" / "street" / "gcpw" / "model.yml.gz").is_file()
    assert "| street | none | 2 of 2 |" in table and "| street | gcpw | 2 of 2 |" in table, table
    assert "stitching street" not in evaluate(sets, pairs=False)
    assert (OUT / "sets.md").read_text(encoding="utf-8") == table

    # A set that cannot be stitched is told, and the other one stays.
    broken = SCRATCH / "sets" / "broken"
    broken.mkdir()
    shutil.copy(street / "01.png", broken / "01.png")
    (broken / "02.png").write_bytes((street / "02.png").read_bytes()[:60]) # its head is right
    said = evaluate(sets, pairs=False, code=1)
    assert "broken, none" in said and "| street | gcpw | 2 of 2 |" in (OUT / "sets.md").read_text(encoding="utf-8"), said
    shutil.rmtree(broken)

    assert "unknown method 'sift'" in evaluate("--methods=sift", code=2)
    assert "--degrees takes" in evaluate("--degrees=0..17", code=2)
    assert "--inputs is a whole number from 1 to 5" in evaluate("--inputs=6", code=2)
    assert "--write_inputs is for pairs" in evaluate("--write_inputs=x", sets, code=2, pairs=False)
    assert "no folder" in evaluate(f"--pairs={SCRATCH}/none", code=2, pairs=False)
    assert "photographs are needed" in evaluate(code=2, pairs=False)
    return 0


if __name__ == "__main__":
    sys.exit(main())
