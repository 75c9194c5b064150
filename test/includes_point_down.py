#!/usr/bin/env python3
"""Reads every #include of the module and fails on one that points up or sideways (doc: architecture).

Usage: includes_point_down.py REPOSITORY

A room of modules/gcpw/src may include itself and rooms of lower floors. Rooms of one floor do not know each other.
Eigen stays in the solver room. Public headers and the module's samples know nothing private. Nothing in the
module knows evaluation, programs and tests. The evaluation library knows only public headers and itself; its tables and the
programs (apps) know both, and apps/common."""
import pathlib
import posixpath
import re
import sys

FLOORS = {
    "geometry": 0,
    "model": 1,
    "imaging": 1,
    "overlap": 2,
    "solver": 2,
    "rendering": 2,
    "energy": 3,
    "registration": 4,
    "cameras": 4,
    "color": 4,
    "optimization": 5,
    "api": 6,
    "stitching": 7,
}
EIGEN_ROOM = "solver"
OUTSIDE = ("evaluation", "apps", "common", "samples", "test", "perf")
PROGRAMS = ("apps", "samples", "test", "perf")
# Folders that look at public headers only, and what else they may not know.
PUBLIC_ONLY = {
    "modules/gcpw/include": OUTSIDE,
    "modules/gcpw/samples": OUTSIDE,
    "evaluation": (*PROGRAMS, "common", "evaluation/tables"),
    "evaluation/tables": PROGRAMS,
    "apps": PROGRAMS,
}
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
SUFFIXES = {".hpp", ".cpp", ".h", ".inl"}


def files_under(folder):
    return sorted(path for path in folder.rglob("*") if path.suffix in SUFFIXES)


def includes_of(path):
    text = path.read_text(encoding="utf-8")
    for match in INCLUDE.finditer(text):
        yield text.count("\n", 0, match.start()) + 1, match.group(1), match.group(2)


def is_eigen(name):
    return name.startswith(("Eigen/", "unsupported/Eigen/"))


def room_of(name, folder=""):
    """The room an include lands in, "" for none. A name may be relative to the folder of its file."""
    for candidate in (posixpath.normpath(name), posixpath.normpath(posixpath.join(folder, name))):
        first = candidate.split("/")[0]
        if "/" in candidate and first in FLOORS:
            return first
    return ""


def fault_in_source(src, path, quote, name):
    place = path.relative_to(src)
    room = place.parts[0]
    if is_eigen(name):
        return "" if room == EIGEN_ROOM else f"Eigen belongs in {EIGEN_ROOM}/ only"
    landing = posixpath.normpath(posixpath.join(place.parent.as_posix(), name))
    if quote == '"' and landing.startswith("../"):
        return "leads out of src/"
    if posixpath.normpath(name).split("/")[0] in OUTSIDE:
        return "the module does not know evaluation, programs, samples and tests"
    target = room_of(name, place.parent.as_posix() if quote == '"' else "")
    if not target or target == room:
        return ""
    if FLOORS[target] > FLOORS[room]:
        return f"points up: {room} is floor {FLOORS[room]}, {target} is floor {FLOORS[target]}"
    if FLOORS[target] == FLOORS[room]:
        return f"points sideways: {room} and {target} share floor {FLOORS[room]}"
    return ""


def public_folder_of(place):
    """The innermost folder of PUBLIC_ONLY in which a file lies, "" for none."""
    return max((folder for folder in PUBLIC_ONLY if place.startswith(folder + "/")), key=len, default="")


def fault_in_public(repository, path, quote, name):
    """Of a file that knows nothing private."""
    place = path.relative_to(repository).as_posix()
    folder = public_folder_of(place)
    landing = posixpath.normpath(posixpath.join(posixpath.dirname(place), name))
    if quote == '"' and "../" in name and not landing.startswith(folder + "/"):
        return f"leads out of {folder}/"
    if any((posixpath.normpath(name) + "/").startswith(above + "/") for above in PUBLIC_ONLY[folder]):
        return "points up"
    if is_eigen(name):
        return f"Eigen belongs in {EIGEN_ROOM}/ only"
    if room_of(name) or "src/" in name:
        return "is private to the module"
    return ""


def faults(repository):
    module = repository / "modules" / "gcpw"
    src = module / "src"
    for path in files_under(src):
        room = path.relative_to(src).parts[0]
        if room not in FLOORS:
            yield f"{path}: lies in no room; the rooms are {', '.join(FLOORS)}"
            continue
        for line, quote, name in includes_of(path):
            fault = fault_in_source(src, path, quote, name)
            if fault:
                yield f"{path}:{line}: {name}: {fault}"
    for folder in ("modules/gcpw/include", "modules/gcpw/samples", "evaluation", "apps"):
        for path in files_under(repository / folder):
            for line, quote, name in includes_of(path):
                fault = fault_in_public(repository, path, quote, name)
                if fault:
                    yield f"{path}:{line}: {name}: {fault}"


def main(arguments):
    if len(arguments) != 2:
        print(__doc__)
        return 2
    repository = pathlib.Path(arguments[1])
    count = len(files_under(repository / "modules" / "gcpw" / "src"))
    if count == 0:
        print(f"No sources under {repository}: nothing was checked.")
        return 2
    found = list(faults(repository))
    for fault in found:
        print(fault)
    print(f"{count} sources, {len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
