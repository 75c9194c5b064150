#!/usr/bin/python3
# Part of the GCPW module for OpenCV. Licence: Apache-2.0 (see LICENSE).
"""Prints how well each method aligns every pair of photographs in a folder.

    evaluation/tables/pairs_table.py PAIRS [--program build/release/apps/gcpw_pair] [--methods global,cpw,dfw,mfw,gcpw]
                        [--megapix 0.48] [--out build/pairs] [--set name=value,..] [--paper] [--quoted FILE] [--jobs 1]

PAIRS holds a folder a pair, each with 01.* (source) and 02.* (target). Both are scaled down to --megapix, stitched with
each method, and the dumped images are scored: zncc of the overlap, lower is better. Needs Debian's python3-opencv.
--quoted FILE: lines `pair value` of a method that is not ours, for comparison. Pictures stay in --out.
"""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
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


def capped(path, out, megapix):
    image = cv2.imread(str(path))
    scale = min(1.0, math.sqrt(megapix * 1e6 / (image.shape[0] * image.shape[1])))
    if scale < 1:
        size = (round(image.shape[1] * scale), round(image.shape[0] * scale))
        image = cv2.resize(image, size, interpolation=cv2.INTER_AREA)
    cv2.imwrite(str(out), image)


def run(options, pair, method):
    """Returns (zncc, folds, align in ms), or the message of a failure."""
    out = options.out / pair.name / method
    out.mkdir(parents=True, exist_ok=True)
    photos = []
    for number in ("01", "02"):
        small = out.parent / (number + ".png")
        if not small.exists():
            capped(next(pair.glob(number + ".*")), small, options.megapix)
        photos.append(str(small))
    command = [options.program, *photos, "--method=" + method, f"--output={out}/pano.png", f"--dump={out}",
               f"--report={out}/report.json", "--threads=1"]
    command += ["--set=" + options.set] if options.set else []
    command += ["--paper"] if options.paper else []
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return done.stderr.strip() or f"exit code {done.returncode}"
    report = json.loads((out / "report.json").read_text(encoding="utf-8"))
    return score(out), report["folds"], report["timings_ms"]["align"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pairs", type=pathlib.Path)
    parser.add_argument("--program", default="build/release/apps/gcpw_pair")
    parser.add_argument("--methods", default="global,cpw,dfw,mfw,gcpw")
    parser.add_argument("--megapix", type=float, default=0.48)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("build/pairs"))
    parser.add_argument("--set", default="")
    parser.add_argument("--paper", action="store_true")
    parser.add_argument("--quoted", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    pairs = sorted(p for p in options.pairs.iterdir() if p.is_dir())
    if not pairs:
        sys.exit(f"{options.pairs} holds no pairs")
    methods = options.methods.split(",")
    quoted = {}
    if options.quoted:
        quoted = {line.split()[0]: float(line.split()[1]) for line in options.quoted.read_text().splitlines() if line.strip()}
    columns = methods + (["quoted"] if quoted else []) + ["align ms"]
    print("| pair | " + " | ".join(columns) + " |\n|" + "---|" * (len(columns) + 1))
    logs = {method: [] for method in methods}
    folds, failures, slowest = 0, [], 0.0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        rows = pool.map(lambda pair: [run(options, pair, method) for method in methods], pairs)
        for pair, results in zip(pairs, rows):
            cells, milliseconds = [], math.nan
            for method, result in zip(methods, results):
                if isinstance(result, str):
                    failures.append(f"{pair.name} {method}: {result}")
                    cells.append("failed")
                    continue
                cells.append(f"{result[0]:.1f}")
                logs[method].append(math.log(result[0]))
                folds += result[1]
                milliseconds = result[2]
            slowest = max(slowest, milliseconds)
            cells += [f"{quoted[pair.name]:.1f}" if pair.name in quoted else ""] if quoted else []
            print(f"| {pair.name} | " + " | ".join(cells) + f" | {milliseconds:.0f} |", flush=True)
    means = [f"**{math.exp(sum(logs[m]) / len(logs[m])):.2f}**" if logs[m] else "" for m in methods]
    means += [f"**{math.exp(sum(map(math.log, quoted.values())) / len(quoted)):.2f}**"] if quoted else []
    print("| **geometric mean** | " + " | ".join(means) + f" | max {slowest:.0f} |")
    print(f"\nfolded quads: {folds}")
    for failure in failures:
        print("failed: " + failure)
    return 1 if failures or folds else 0


if __name__ == "__main__":
    sys.exit(main())
