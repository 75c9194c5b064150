#!/usr/bin/python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Draws the results of gcpw_evaluate: plot_results.py FOLDER [--pairs NAME,NAME,..]

FOLDER holds results.csv. Writes FOLDER/plots/degrees.svg, the error against the degree of synthetic colour variation for
six pairs (--pairs chooses them; else they are spread evenly over the list) and for the mean of all, and
FOLDER/plots/pairs.svg, the error of every method on every pair as it is. An error is the median over the inputs of the pair
(doc/evaluation.md), the thin lines in pairs.svg go from the smallest to the largest. Needs Debian's python3-matplotlib.
"""
import argparse
import collections
import csv
import math
import pathlib
import statistics
import sys

try:
    import matplotlib
except ImportError:
    sys.exit("plot_results.py needs matplotlib (Debian: python3-matplotlib)")
matplotlib.use("Agg")
# The same numbers give the same file.
matplotlib.rcParams.update({"svg.hashsalt": "gcpw", "svg.fonttype": "none", "font.size": 9})
from matplotlib import pyplot  # noqa: E402

# Name, label, colour (distinguishable by the colour-blind), line, and whether recoloured images change it.
METHODS = [
    ("global", "Global", "#999999", ":", False),
    ("apap", "APAP", "#cc79a7", ":", False),
    ("cpw", "CPW", "#f0e442", ":", False),
    ("dfw", "DF-W", "#56b4e9", "--", False),
    ("mfw", "MF-W", "#e69f00", "-", True),
    ("lsh_mfw", "LSH+MF-W", "#009e73", "-", True),
    ("ros_mfw", "ROS+MF-W", "#0072b2", "-", True),
    ("gcpw", "GCPW", "#d55e00", "-", True),
]
CURVES = ("dfw", "mfw", "lsh_mfw", "ros_mfw", "gcpw")
PANELS = 6


def read(path):
    """zncc of all inputs by pair, method and degree; failed runs are left out."""
    table = collections.defaultdict(lambda: collections.defaultdict(list))
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            value = float(row["zncc"])
            if math.isfinite(value):
                table[row["pair"]][row["method"], int(row["degree"])].append(value)
    return table


def middle(scores):
    return statistics.median(scores) if scores else math.nan


def reach(scores):
    """How far below and above the median the scores go."""
    return (middle(scores) - min(scores), max(scores) - middle(scores)) if scores else (0, 0)


def curve(runs, method, pixels, degrees):
    return [middle(runs.get((method, degree if pixels else 0))) for degree in degrees]


def save(figure, path):
    figure.savefig(path, metadata={"Date": None})
    print(path, "written")


def draw_degrees(table, chosen, path):
    degrees = sorted({degree for runs in table.values() for _, degree in runs})
    figure, axes = pyplot.subplots(2, 4, figsize=(12, 5.4), constrained_layout=True)
    panels = [(name, [table[name]]) for name in chosen] + [(f"mean of {len(table)} pairs", list(table.values()))]
    handles = []
    for axis, (title, sets) in zip(axes.flat, panels):
        handles = []
        for name, label, color, line, pixels in METHODS:
            if name not in CURVES:
                continue
            curves = [curve(runs, name, pixels, degrees) for runs in sets]
            mean = [sum(values) / len(values) for values in zip(*curves)]
            handles += axis.plot(degrees, mean, line, color=color, label=label, linewidth=2 if name == "gcpw" else 1.4)
        axis.set_title(title)
        axis.set_ylim(bottom=0)
        axis.grid(alpha=0.3)
    for axis in axes.flat[len(panels):]:
        axis.axis("off")
    axes.flat[-1].legend(handles=handles, loc="center", fontsize=11, frameon=False)
    figure.supxlabel("degree of colour variation")
    figure.supylabel("zncc, lower is better")
    save(figure, path)


def draw_pairs(table, path):
    names = sorted(table)
    figure, axis = pyplot.subplots(figsize=(12, 4.2), constrained_layout=True)
    width = 0.9 / len(METHODS)
    for k, (name, label, color, _, _) in enumerate(METHODS):
        places = [i + (k - (len(METHODS) - 1) / 2) * width for i in range(len(names))]
        scores = [table[pair].get((name, 0)) for pair in names]
        axis.bar(places, [middle(each) for each in scores], width, color=color, label=label,
                 yerr=list(zip(*map(reach, scores))), error_kw={"elinewidth": 0.7})
    axis.set_xticks(range(len(names)))
    axis.set_xticklabels(names, rotation=30, ha="right")
    axis.set_ylabel("zncc, lower is better")
    axis.legend(ncol=len(METHODS), fontsize=8, frameon=False, loc="upper center", bbox_to_anchor=(0.5, 1.12))
    save(figure, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--pairs", default="", help="six pairs at the most, by name")
    options = parser.parse_args()
    path = options.folder / "results.csv"
    if not path.is_file():
        parser.error(f"there is no {path}; run gcpw_evaluate first")
    table = read(path)
    if not table:
        parser.error(f"{path} holds no results")
    names = sorted(table)
    chosen = [name for name in options.pairs.split(",") if name]
    unknown = [name for name in chosen if name not in table]
    if unknown:
        parser.error(f"{path} has no pair {unknown[0]}")
    count = min(PANELS, len(names))
    chosen = chosen[:PANELS] or [names[i * len(names) // count] for i in range(count)]
    plots = options.folder / "plots"
    plots.mkdir(exist_ok=True)
    draw_pairs(table, plots / "pairs.svg")
    if any(degree for runs in table.values() for _, degree in runs):
        draw_degrees(table, chosen, plots / "degrees.svg")


if __name__ == "__main__":
    main()
