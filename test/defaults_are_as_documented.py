#!/usr/bin/env python3
"""Each member of Params says its default in words, beside its declaration; the constructor must set the same, and all.
The table behind Params::names() must have the numeric members in the order of their declaration, and the table of terms in the
tutorial name the same defaults.

Usage: defaults_are_as_documented.py REPOSITORY"""
import pathlib
import re
import sys

HEADER = "modules/gcpw/include/opencv2/gcpw/params.hpp"
TUTORIAL = "modules/gcpw/tutorials/how_it_works.markdown"
SOURCE = "modules/gcpw/src/api/params.cpp"
# The comment stands before the declaration or behind it on its line, and closes with the default.
MEMBER = re.compile(r"((?:^ *///[^\n]*\n)*)^ *CV_PROP_RW \w+ (\w+);([^\n]*)", re.MULTILINE)
DEFAULT = re.compile(r"\bdefault ([-\w.]+?)\.?$")
NAMED = re.compile(r'^    \{"(\w+)", ', re.MULTILINE)
# | term | `parameter` default, `parameter` default | what it does | more of it | less of it |
ROW = re.compile(r"^\|[^|\n]*\|([^|\n]*)\|[^|\n]*\|[^|\n]*\|[^|\n]*\|$", re.MULTILINE)
TOLD = re.compile(r"`(\w+)` ([-\d.]+)")
ASSIGNMENT = re.compile(r"^    (\w+) = (?:Method::)?([-\w.]+);", re.MULTILINE)


def main(arguments):
    repository = pathlib.Path(arguments[1])
    documented = {}
    for before, name, behind in MEMBER.findall((repository / HEADER).read_text(encoding="utf-8")):
        said = DEFAULT.search((before + behind).rstrip())
        documented[name] = said.group(1) if said else "not said"
    source = (repository / SOURCE).read_text(encoding="utf-8")
    constructor = source.split("Params::Params()")[1].split("\n}\n")[0]
    set_there = dict(ASSIGNMENT.findall(constructor))
    faults = [f"{name}: {documented.get(name, 'no member')} in the header, {set_there.get(name, 'not set')} in the constructor"
              for name in sorted(documented.keys() | set_there.keys()) if documented.get(name) != set_there.get(name)]
    if ["method", *NAMED.findall(source)] != list(documented):
        faults.append(f"names() gives {', '.join(NAMED.findall(source))}; declared are {', '.join(documented)}")
    told = [pair for cell in ROW.findall((repository / TUTORIAL).read_text(encoding="utf-8")) for pair in TOLD.findall(cell)]
    faults += [f"{name}: {value} in the tutorial, {set_there.get(name, 'not set')} in the constructor"
               for name, value in told if set_there.get(name) != value]
    if not told:
        faults.append(f"{TUTORIAL} has no table of terms")
    for fault in faults:
        print(fault)
    print(f"{len(documented)} members, {len(faults)} faults")
    return 1 if faults or not documented else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
