#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Puts measured tables into the documents: evaluation/fill_results.py OUT [PAPER] [--sets=SETS]

OUT is the folder of `scripts/evaluate PAIRS OUT`, PAPER that of `scripts/evaluate PAIRS PAPER --paper --methods=gcpw
--degrees=0`; without it the column of the paper's constants stays. SETS is the folder of `gcpw_evaluate --sets` (default: OUT).
Rewrites what stands between `<!-- NAME -->` and `<!-- /NAME -->` in doc/results.md (zncc, place, spread, appearance,
appearance_pairs, appearance_sets, degrees, cost) and README.md (means), and copies the plots to doc/images. A part that OUT does not have, such as degrees of a run with one degree, stays as it is. The text around the tables
is for people to check.
"""
import pathlib
import re
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SHOWN_DEGREES = ("degree", "---", "0", "1", "4", "8", "12", "16")
PAPER, QUOTED = "`Params::paper()`", "REW (quoted)"


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def line_of(row):
    return "| " + " | ".join(row) + " |"


def sections(report):
    """The text below each heading of a report."""
    parts = re.split(r"^## (.*)\n", report, flags=re.MULTILINE)
    return dict(zip(parts[1::2], (part.strip() for part in parts[2::2])))


def table_in(text):
    return "\n".join(line for line in text.splitlines() if line.startswith("|"))


def column(table, name):
    """The cells of a column by the first cell of their row, without the bold."""
    lines = [cells(line) for line in table.splitlines()]
    place = lines[0].index(name)
    return {row[0]: row[place].strip("*") for row in lines[2:]}


def block(text, name):
    found = re.search(rf"<!-- {name} -->\n(.*?)<!-- /{name} -->", text, re.DOTALL)
    if not found:
        sys.exit(f"there is no <!-- {name} -->")
    return found


def filled(text, name, new):
    found = block(text, name)
    return text[:found.start(1)] + new.strip() + "\n" + text[found.end(1):]


def pair_table(measured, before, paper):
    """The table of a report with the columns that other programs or constants gave."""
    own = column(table_in(paper), "GCPW") if paper else column(before, PAPER)
    quoted = column(before, QUOTED)
    lines = measured.splitlines()
    rows = [cells(line) for line in lines]
    result = [line_of(rows[0] + [PAPER, QUOTED]), lines[1] + "---:|---:|"]
    return "\n".join(result + [line_of(row + [own.get(row[0], "-"), quoted.get(row[0], "-")]) for row in rows[2:]])


def main():
    folders = [argument for argument in sys.argv[1:] if not argument.startswith("--")]
    options = [argument for argument in sys.argv[1:] if argument.startswith("--")]
    if not 1 <= len(folders) <= 2 or len(options) > 1 or not all(option.startswith("--sets=") for option in options):
        sys.exit(__doc__)
    out = pathlib.Path(folders[0])
    sets = pathlib.Path(options[0][len("--sets="):] if options else out) / "sets.md"
    parts = sections((out / "report.md").read_text(encoding="utf-8"))
    paper = ""
    if len(folders) == 2:
        paper = sections((pathlib.Path(folders[1]) / "report.md").read_text(encoding="utf-8"))["Photographs as they are: zncc"]
    path = ROOT / "doc" / "results.md"
    text = path.read_text(encoding="utf-8")
    scores = parts["Photographs as they are: zncc"]
    table = pair_table(table_in(scores), table_in(block(text, "zncc").group(1)), paper)
    text = filled(text, "zncc", table)
    text = filled(text, "place", scores[scores.index("GCPW is ahead"):])
    text = filled(text, "cost", table_in(parts["Folds and time, all degrees"]))
    if "Photographs as they are: spread of zncc" in parts:
        text = filled(text, "spread", table_in(parts["Photographs as they are: spread of zncc"]))
    for name, heading in (("appearance", "Photographs as they are: appearance"),
                          ("appearance_pairs", "Photographs as they are: appearance on each pair")):
        if heading in parts:
            text = filled(text, name, table_in(parts[heading]))
    of_sets = sections(sets.read_text(encoding="utf-8")) if sets.is_file() else {}
    if "Appearance" in of_sets:
        text = filled(text, "appearance_sets", table_in(of_sets["Appearance"]))
    if "Synthetic colour variation: mean zncc by degree" in parts:
        lines = table_in(parts["Synthetic colour variation: mean zncc by degree"]).splitlines()
        text = filled(text, "degrees", "\n".join(line for line in lines if cells(line)[0] in SHOWN_DEGREES))
    path.write_text(text, encoding="utf-8")

    readme = ROOT / "README.md"
    rows = [cells(line) for line in table.splitlines()]
    means = next(row for row in rows if row[0].startswith("geometric mean"))[1:-1]
    head = [name if name != PAPER else "GCPW, paper's constants" for name in rows[0][1:-1]]
    new = "\n".join([line_of(head), "|" + "---|" * len(head), line_of(means)])
    readme.write_text(filled(readme.read_text(encoding="utf-8"), "means", new), encoding="utf-8")

    for plot in sorted((out / "plots").glob("*.svg")) if (out / "plots").is_dir() else ():
        shutil.copy(plot, ROOT / "doc" / "images" / plot.name)
    print(f"{path} and {readme} rewritten; read the text around the tables")


if __name__ == "__main__":
    main()
