#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""What documents tell a reader to type or to follow must be there: our programs and scripts, the options of programs (as their
--help has them), the parameters of --set, and the files that links lead to.

Usage: commands_exist.py REPOSITORY"""
import pathlib
import re
import shlex
import sys

from documents import blocks, conclude, documents

PROGRAM = re.compile(r"^(?:\S*/)?(gcpw_\w+)$")
SCRIPT = re.compile(r"^(?:\./)?(scripts/\w\S*|evaluation/\w+\.py)$")
OPTION = re.compile(r'\bline_?\.\w+\(\s*"(-[^"]+)"|^    (?:flag|integer)\("(-[^"]+)"', re.MULTILINE)
PARAMETER = re.compile(r'^    \{"(\w+)", ', re.MULTILINE)
LINK = re.compile(r"\]\(([^)\s#]+)(?:#[^)\s]*)?\)")
INLINE = re.compile(r"(?<!`)`([^`\n]+)`(?!`)")
ANY = "any program"
# Calls of a program end there: what follows is a comment, or another program.
ENDS = {"#", "|", "&&", "||", ";", ">"}


def options_in(sources):
    """The options that sources declare, with their letters: `line.text("-o,--output", ..)`."""
    declared = {name for source in sources for match in OPTION.findall(source.read_text(encoding="utf-8")) for name in match if name}
    return {name.lstrip("-") for names in declared for name in names.split(",")}


def help_of(repository):
    """Options of each program, by its sources."""
    apps = repository / "apps"
    common = options_in(sorted((apps / "common").glob("*.cpp")))
    options = {}
    for source in sorted(apps.glob("gcpw_*.cpp")):
        own = sorted((apps / source.stem.partition("_")[2]).glob("*.cpp"))
        options[source.stem] = common | options_in([source, *own])
        assert len(options[source.stem]) > len(common), f"no options are found in {source}"
    for source in sorted((repository / "modules/gcpw/samples").glob("*.cpp")):
        options["gcpw_sample_" + source.stem] = set()
    options[ANY] = set().union(*options.values())
    return options


def words_of(line):
    try:
        return shlex.split(line)
    except ValueError:  # a quotation mark that is none of the shell's
        return line.split()


def calls(line):
    """The calls in a line: lists of words, a program or script first. Options alone (`--option=value`) are those of any program."""
    call = [ANY] if line.startswith("--") else []
    for word in words_of(line):
        if PROGRAM.match(word) or SCRIPT.match(word):
            if call:
                yield call
            call = [word]
        elif word in ENDS or word.startswith("#"):
            if call:
                yield call
            call = []
        elif call:
            call.append(word)
    if call:
        yield call


def faults_of(call, repository, options, parameters):
    script = SCRIPT.match(call[0])
    if script:
        if not (repository / script.group(1)).is_file():
            yield f"there is no {script.group(1)}"
        return
    program = PROGRAM.match(call[0]).group(1) if call[0] != ANY else ANY
    if program not in options:
        # A target of the build, or a library, is no program for users.
        if len(call) > 1 and any(word.startswith("--") for word in call):
            yield f"there is no program {program}"
        return
    for word in call[1:]:
        name, _, value = word.lstrip("-").partition("=")
        if word.startswith("-") and name not in options[program]:
            yield f"{program} has no option {word}"
        if word.startswith("--set=") and value != "..":
            for setting in value.split(","):
                if setting.partition("=")[0] not in parameters:
                    yield f"Params has no member {setting.partition('=')[0]}"


def lines_of(repository, path, shell):
    """Lines of shell blocks, and what stands in the text as code."""
    name = path.relative_to(repository).as_posix()
    for block in shell:
        if block.document == name:
            joined = re.sub(r" \\\n\s*", lambda _: " ", block.text)
            for line in joined.split("\n"):
                yield block.line, line.strip()
    if path.suffix != ".hpp":
        for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
            for code in INLINE.findall(line):
                yield number, code


def broken_links(path):
    text = path.read_text(encoding="utf-8")
    for match in LINK.finditer(text):
        if "://" not in match.group(1) and not (path.parent / match.group(1)).exists():
            yield text.count("\n", 0, match.start()) + 1, f"the link to {match.group(1)} leads nowhere"


def main(arguments):
    repository = pathlib.Path(arguments[1]).resolve()
    options = help_of(repository)
    parameters = set(PARAMETER.findall((repository / "modules/gcpw/src/api/params.cpp").read_text(encoding="utf-8")))
    shell = blocks(repository, "sh")
    count = 0
    faults = []
    for path in documents(repository):
        name = path.relative_to(repository).as_posix()
        for number, line in lines_of(repository, path, shell):
            for call in calls(line):
                count += 1
                faults += [f"{name}:{number}: {fault}" for fault in faults_of(call, repository, options, parameters)]
        if path.suffix != ".hpp":
            faults += [f"{name}:{number}: {fault}" for number, fault in broken_links(path)]
    return conclude(count, "commands", faults)


if __name__ == "__main__":
    sys.exit(main(sys.argv))
