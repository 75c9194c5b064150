#!/usr/bin/env python3
"""Plants includes into a copy of the sources and expects includes_point_down.py to name the wrong ones, and only those.

Usage: includes_point_down_can_fail.py REPOSITORY"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

CHECK = pathlib.Path(__file__).with_name("includes_point_down.py")
SRC = "modules/gcpw/src/"
INCLUDE = "modules/gcpw/include/opencv2/gcpw/"
SAMPLES = "modules/gcpw/samples/"

# file to plant, its include, and whether the check must name it
PLANTS = [
    (SRC + "geometry/planted.hpp", '"energy/point_term.hpp"', True),
    (SRC + "geometry/planted.hpp", "<model/mesh_grid.hpp>", True),
    (SRC + "solver/planted.cpp", '"../optimization/driver.hpp"', True),
    (SRC + "model/planted.hpp", '"imaging/sampler.hpp"', True),
    (SRC + "registration/planted.cpp", '"color/points.hpp"', True),
    (SRC + "energy/planted.cpp", "<Eigen/Core>", True),
    (SRC + "optimization/planted.cpp", '"../../test/test_precomp.hpp"', True),
    (SRC + "optimization/planted.cpp", '"common/report.hpp"', True),
    (SRC + "helpers/planted.hpp", "<vector>", True),
    (SRC + "planted.hpp", "<vector>", True),
    (INCLUDE + "planted.hpp", "<Eigen/Core>", True),
    (INCLUDE + "planted.hpp", '"model/mesh_grid.hpp"', True),
    (SRC + "optimization/planted.cpp", '"evaluation/apap.hpp"', True),
    (INCLUDE + "planted.hpp", '"evaluation/apap.hpp"', True),
    ("evaluation/planted.cpp", '"solver/mesh_system.hpp"', True),
    ("evaluation/planted.cpp", '"common/report.hpp"', True),
    ("evaluation/planted.cpp", '"../apps/common/report.hpp"', True),
    ("evaluation/planted.cpp", '"evaluation/tables/scores.hpp"', True),
    ("evaluation/tables/planted.cpp", '"solver/mesh_system.hpp"', True),
    ("apps/planted.cpp", '"solver/mesh_system.hpp"', True),
    ("apps/planted.cpp", '"test/scene.hpp"', True),
    ("apps/planted.cpp", '"../modules/gcpw/samples/pair.hpp"', True),
    (SAMPLES + "planted.cpp", '"solver/mesh_system.hpp"', True),
    (SAMPLES + "planted.cpp", '"../src/solver/mesh_system.hpp"', True),
    (SAMPLES + "planted.cpp", '"common/report.hpp"', True),
    (SAMPLES + "planted.cpp", '"evaluation/apap.hpp"', True),
    (SRC + "optimization/planted.cpp", '"apps/common/report.hpp"', True),
    (INCLUDE + "planted.hpp", '"apps/common/report.hpp"', True),
    (SRC + "stitching/planted.cpp", '"geometry/lattice.hpp"', False),
    (SRC + "energy/planted.cpp", '"energy/point_term.hpp"', False),
    (SRC + "energy/planted.cpp", '"point_term.hpp"', False),
    (SRC + "solver/planted.cpp", "<Eigen/SparseCholesky>", False),
    (SRC + "optimization/planted.cpp", "<opencv2/gcpw.hpp>", False),
    ("evaluation/planted.cpp", '"evaluation/apap.hpp"', False),
    ("evaluation/tables/planted.cpp", '"common/report.hpp"', False),
    ("apps/planted.cpp", '"common/report.hpp"', False),
    ("apps/planted.cpp", '"evaluation/apap.hpp"', False),
    (SAMPLES + "planted.cpp", "<opencv2/gcpw.hpp>", False),
]


def check(repository):
    result = subprocess.run([sys.executable, "-B", str(CHECK), str(repository)], stdout=subprocess.PIPE, text=True)
    return result.returncode, result.stdout


def wrong_answers(copy):
    for file_name, include, forbidden in PLANTS:
        planted = copy / file_name
        new_folder = not planted.parent.exists()
        planted.parent.mkdir(parents=True, exist_ok=True)
        planted.write_text(f"#include {include}\n", encoding="utf-8")
        status, output = check(copy)
        planted.unlink()
        if new_folder:
            planted.parent.rmdir()
        named = str(planted) in output
        if named != forbidden or (forbidden and status != 1):
            yield f"{file_name} with {include}: expected {'a fault' if forbidden else 'no fault'}, got:\n{output}"


def main(arguments):
    repository = pathlib.Path(arguments[1])
    with tempfile.TemporaryDirectory() as scratch:
        copy = pathlib.Path(scratch)
        for folder in ("modules/gcpw/src", "modules/gcpw/include", "modules/gcpw/samples", "evaluation", "apps"):
            shutil.copytree(repository / folder, copy / folder)
        wrong = list(wrong_answers(copy))
    for answer in wrong:
        print(answer)
    print(f"{len(PLANTS)} plants, {len(wrong)} wrong answers")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
