#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Prints what gcpw_perf measured as ratios within the one run: ratios.py FILE

FILE is Google Benchmark's JSON (--benchmark_out=FILE --benchmark_out_format=json). Two ratios a row: of the best
repetitions, which others on the machine disturb least, and of the medians; where they differ much the machine was
not quiet. Processor time, but wall time where threads are compared. Exit code 1 if no row was measured.
"""
import collections
import json
import statistics
import sys

CPU, WALL = "cpu_time", "real_time"

# What, against what, their measurements, the clock.
ROWS = [
    ("mesh factor by rows of vertices", "sparse LDL^T of the same matrix",
     "Gcpw_BlockTridiagonal.factor_of_a_mesh", "Gcpw_BlockTridiagonal.sparse_factor_of_a_mesh", CPU),
    ("mesh solve, one image, assembly included", "sparse LDL^T without assembly",
     "Gcpw_MeshSystem.one_image", "Gcpw_BlockTridiagonal.sparse_factor_of_a_mesh", CPU),
    ("mesh solve, two tied images, assembly included", "sparse LDL^T of both without assembly",
     "Gcpw_MeshSystem.two_tied_images", "Gcpw_MeshSystem.sparse_factor_of_two_tied_images", CPU),
    ("joint step of mesh and colours, assembly included", "sparse LDL^T of all 8322 unknowns without assembly",
     "Gcpw_JointSystem.step_of_mesh_and_colors", "Gcpw_JointSystem.sparse_factor_of_all_unknowns", CPU),
    ("joint step of mesh and colours", "mesh step alone",
     "Gcpw_JointSystem.step_of_mesh_and_colors", "Gcpw_MeshSystem.one_image", CPU),
    ("photometric linearisation, every 2nd pixel, target fixed", "joint step",
     "Gcpw_PhotometricTerm.linearize_with_the_target_fixed/2", "Gcpw_JointSystem.step_of_mesh_and_colors", CPU),
    ("photometric linearisation, every 2nd pixel", "every 3rd pixel",
     "Gcpw_PhotometricTerm.linearize_with_the_target_fixed/2", "Gcpw_PhotometricTerm.linearize_with_the_target_fixed/3", CPU),
    ("photometric linearisation, both images moving", "target fixed",
     "Gcpw_PhotometricTerm.linearize_with_both_moving/2", "Gcpw_PhotometricTerm.linearize_with_the_target_fixed/2", CPU),
    ("photometric linearisation, both moving, every 2nd pixel", "every 3rd pixel",
     "Gcpw_PhotometricTerm.linearize_with_both_moving/2", "Gcpw_PhotometricTerm.linearize_with_both_moving/3", CPU),
    ("value and gradient at a point", "three `cv::remap`",
     "Gcpw_Sampler.value_and_gradient", "Gcpw_Sampler.value_and_gradient_by_remap", CPU),
    ("map of a mesh", "map of OpenCV's spherical warper",
     "Gcpw_InverseMap.map_of_a_mesh", "Gcpw_InverseMap.map_of_the_spherical_warper", CPU),
    ("colours of a grid, applied", "OpenCV's `BlocksChannelsCompensator`",
     "Gcpw_ColorField.colors_of_a_grid", "Gcpw_ColorField.colors_of_blocks_channels", CPU),
    ("frame of two cameras, composed", "one `cv::remap` of as many pixels",
     "Gcpw_Frames.compose/1", "Gcpw_Remap.as_many_pixels_as_a_frame", CPU),
    ("frame of two cameras, two threads", "one thread", "Gcpw_Frames.compose/2", "Gcpw_Frames.compose/1", WALL),
    ("keypoints matched near where expected, both ways", "brute force, one way",
     "Gcpw_Matching.near_where_it_is_expected", "Gcpw_Matching.everywhere_by_brute_force", CPU),
    ("pair: alignment", "features, homography and matches",
     "Gcpw_PairThreads.align/1", "Gcpw_Pair.find_matches", CPU),
    ("pair in equal light: GCPW", "MF-W, which has no colours",
     "Gcpw_Pair.align_in_equal_light", "Gcpw_Pair.align_in_equal_light_by_mfw", CPU),
    ("ring of 12 images, 12 overlaps", "chain of 5, 4 overlaps",
     "Gcpw_Aligner.ring_of_twelve/1", "Gcpw_Aligner.chain_of_five/1", CPU),
    ("`cv::Stitcher` with GCPW, SIFT keypoints", "without",
     "Gcpw_Stitcher.with_sift_and_gcpw", "Gcpw_Stitcher.with_sift", CPU),
    ("`cv::Stitcher` with GCPW, as it comes", "without",
     "Gcpw_Stitcher.as_it_comes_with_gcpw", "Gcpw_Stitcher.as_it_comes", CPU),
    ("pair, two threads", "one thread", "Gcpw_PairThreads.align/2", "Gcpw_PairThreads.align/1", WALL),
    ("chain of 5, two threads", "one thread", "Gcpw_Aligner.chain_of_five/2", "Gcpw_Aligner.chain_of_five/1", WALL),
    ("ring of 12, two threads", "one thread", "Gcpw_Aligner.ring_of_twelve/2", "Gcpw_Aligner.ring_of_twelve/1", WALL),
]


def read(path):
    """The times of every repetition, by name and clock; all in one unit."""
    with open(path, encoding="utf-8") as file:
        runs = json.load(file)["benchmarks"]
    times = collections.defaultdict(list)
    for run in runs:
        if run.get("run_type", "iteration") == "iteration" and not run.get("error_occurred"):
            for clock in (CPU, WALL):
                times[run["name"], clock].append(run[clock])
    return times


def shown(ratio):
    """Two significant digits."""
    return f"{ratio:#.2g}" if ratio < 9.95 else f"{ratio:.0f}"


def main(arguments):
    if len(arguments) != 2:
        print(__doc__)
        return 2
    times = read(arguments[1])
    print("| measured | against | best | median |\n|---|---|---:|---:|")
    measured = 0
    for what, other, numerator, denominator, clock in ROWS:
        above, below = times[numerator, clock], times[denominator, clock]
        if not above or not below:
            print(f"| {what} | {other} | not measured | |")
            continue
        measured += 1
        best, median = (shown(of(above) / of(below)) for of in (min, statistics.median))
        print(f"| {what} | {other} | {best} | {median} |")
    return 0 if measured else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv))
