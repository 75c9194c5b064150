#!/usr/bin/python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Prints how well each method aligns every pair of photographs in a folder.

    evaluation/tables/pairs_table.py PAIRS [--program build/release/apps/gcpw_pair] [--methods global,cpw,dfw,mfw,gcpw] [--inputs 5]
                        [--megapix 0.48] [--out build/pairs] [--set name=value,..] [--paper] [--quoted FILE] [--jobs 1]

PAIRS holds a folder a pair, each with 01.* (source) and 02.* (target). gcpw_evaluate, which lies beside --program, brings both
to the first --inputs of five inputs of --megapix that differ by about a pixel (doc/evaluation.md). They are stitched with each
method and the dumped images are scored: zncc of the overlap, lower is better. A cell is the median over the inputs and their
spread, largest over smallest; 1 input is a quick look. Needs Debian's python3-opencv.
--quoted FILE: lines `pair value` of a method that is not ours, for comparison. Pictures stay in --out.
"""
import argparse
import concurrent.futures
import json
import math
import pathlib
import statistics
import subprocess
import sys

import cv2
import numpy as np

WINDOW, BORDER, MIN_VARIANCE = 5, 7, 16.0


def score(folder):
    """zncc of a dump: 100 * RMS of one minus the zero-mean normalised correlation over 5 x 5 windows with texture."""
    read = lambda name: cv2.imread(str(folder / name), cv2.IMREAD_GRAYSCALE)
    gray = lambda name: cv2.cvtColor(cv2.imread(str(folder / name)), cv2.COLOR_BGR2GRAY).astype(np.float64)
    a, b, mask = gray("source.png"), gray("target.png"), cv2.bitwise_and(read("source_mask.png"), read("target_mask.png"))
    mean = lambda image: cv2.blur(image, (WINDOW, WINDOW))
    mean_a, mean_b = mean(a), mean(b)
    var_a, var_b, cov = mean(a * a) - mean_a ** 2, mean(b * b) - mean_b ** 2, mean(a * b) - mean_a * mean_b
    inside = cv2.erode(mask, np.ones((BORDER, BORDER), np.uint8), borderType=cv2.BORDER_CONSTANT, borderValue=0) > 0
    textured = inside & (var_a > MIN_VARIANCE) & (var_b > MIN_VARIANCE)
    miss = 1 - np.clip(cov[textured] / np.sqrt(var_a[textured] * var_b[textured]), -1, 1)
    return float(100 * np.sqrt((miss ** 2).mean())) if miss.size else math.nan


def run(options, pair, method, number):
    """Returns (zncc, folds, align in ms of wall time) on one input, or the message of a failure."""
    out = options.out / pair / str(number) / method
    out.mkdir(parents=True, exist_ok=True)
    photos = [str(options.out / "inputs" / pair / str(number) / name) for name in ("01.png", "02.png")]
    command = [options.program, *photos, "--method=" + method, f"--output={out}/pano.png", f"--dump={out}", "--view=target",
               f"--report={out}/report.json", "--threads=1", "--force"]
    command += ["--set=" + options.set] if options.set else []
    command += ["--paper"] if options.paper else []
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return done.stderr.strip() or f"exit code {done.returncode}"
    report = json.loads((out / "report.json").read_text(encoding="utf-8"))
    return score(out), report["folds"], report["timings_ms"]["align"]


def write_inputs(options):
    """Writes the inputs of all pairs; wrong use stops with the message of gcpw_evaluate."""
    command = [str(pathlib.Path(options.program).with_name("gcpw_evaluate")), f"--pairs={options.pairs}", f"--inputs={options.inputs}",
               f"--max_megapix={options.megapix}", f"--write_inputs={options.out / 'inputs'}"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode > 1:
        sys.exit(done.stderr.strip())
    print(done.stderr, end="", file=sys.stderr) # a pair that cannot be read is told, the others go on


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pairs", type=pathlib.Path)
    parser.add_argument("--program", default="build/release/apps/gcpw_pair")
    parser.add_argument("--methods", default="global,cpw,dfw,mfw,gcpw")
    parser.add_argument("--inputs", type=int, choices=range(1, 6), default=5)
    parser.add_argument("--megapix", type=float, default=0.48)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("build/pairs"))
    parser.add_argument("--set", default="")
    parser.add_argument("--paper", action="store_true")
    parser.add_argument("--quoted", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    write_inputs(options)
    pairs = sorted(folder.name for folder in options.pairs.iterdir() if folder.is_dir())
    methods = options.methods.split(",")
    quoted = {}
    if options.quoted:
        quoted = {line.split()[0]: float(line.split()[1]) for line in options.quoted.read_text().splitlines() if line.strip()}
    columns = methods + (["quoted"] if quoted else []) + ["align ms (wall)"]
    print("| pair | " + " | ".join(columns) + " |\n|" + "---|" * (len(columns) + 1))
    medians = {method: [] for method in methods}
    folds, failures, slowest = 0, [], 0.0
    numbers = range(1, options.inputs + 1)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        rows = {pair: {method: [pool.submit(run, options, pair, method, number) for number in numbers] for method in methods}
                for pair in pairs}
        for pair in pairs:
            cells, milliseconds = [], math.nan
            for method in methods:
                results = [future.result() for future in rows[pair][method]]
                failed = [f"{pair} {method}, input {number}: {result}"
                          for number, result in zip(numbers, results) if isinstance(result, str)]
                failures += failed
                folds += sum(result[1] for result in results if not isinstance(result, str))
                if failed:
                    cells.append("failed")
                    continue
                scores = [result[0] for result in results]
                middle = statistics.median(scores)
                medians[method].append(middle)
                cells.append(f"{middle:.1f}" + (f" (x {max(scores) / min(scores):.2f})" if options.inputs > 1 else ""))
                milliseconds = statistics.median(result[2] for result in results)
                slowest = max(slowest, *(result[2] for result in results), 0.0)
            cells += [f"{quoted[pair]:.1f}" if pair in quoted else ""] if quoted else []
            print(f"| {pair} | " + " | ".join(cells) + f" | {milliseconds:.0f} |", flush=True)
    means = [f"**{geometric_mean(medians[m]):.2f}**" if medians[m] else "" for m in methods]
    means += [f"**{geometric_mean(list(quoted.values())):.2f}**"] if quoted else []
    print("| **geometric mean** | " + " | ".join(means) + f" | max {slowest:.0f} |")
    print(f"\nfolded quads: {folds}")
    for failure in failures:
        print("failed: " + failure)
    return 1 if failures or folds else 0


if __name__ == "__main__":
    sys.exit(main())
