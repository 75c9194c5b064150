# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""The documents of the repository, and the blocks of code in them: what the tests in this folder share."""
import pathlib
import re
from typing import NamedTuple

# CHANGELOG.md tells what has been, so it may name what is no more.
DOCUMENTS = ("README.md", "CONTRIBUTING.md", "SECURITY.md", "samples/README.md", "doc/*.md", "modules/gcpw/README.md", "packaging/README.md", "python/README.md",
             "modules/gcpw/tutorials/*.markdown", "modules/gcpw/include/**/*.hpp")
FENCE = re.compile(r"^```\.?(\w*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
CODE = re.compile(r"@code(?:\{\.(\w+)\})?\n(.*?)@endcode", re.DOTALL)
INDENTED = re.compile(r"(?<=\n\n)(?: {4}[^\n]*\n)+")
OTHER_NAMES = {"bash": "sh", "shell": "sh", "py": "python", "c++": "cpp"}


class Block(NamedTuple):
    document: str  # path in the repository
    line: int      # of the block's first line, from 1
    language: str  # "cpp", "python", "sh", .., or "" where the document does not say
    text: str


def documents(repository):
    for pattern in DOCUMENTS:
        yield from sorted(pathlib.Path(repository).glob(pattern))


def blocks_of(repository, path):
    text = path.read_text(encoding="utf-8")
    name = path.relative_to(repository).as_posix()
    # In a header, code is C++ where nothing else is said.
    found = [(match.start(2), match.group(1) or ("cpp" if path.suffix == ".hpp" else ""), match.group(2)) for match in CODE.finditer(text)]
    if path.suffix != ".hpp":
        found += [(match.start(2), match.group(1), match.group(2)) for match in FENCE.finditer(text)]
        found += [(match.start(), "sh", match.group()) for match in INDENTED.finditer(FENCE.sub(lambda m: "\n" * m.group().count("\n"), text))]
    for start, language, block in sorted(found):
        yield Block(name, text.count("\n", 0, start) + 1, OTHER_NAMES.get(language, language), block)


def blocks(repository, language):
    repository = pathlib.Path(repository)
    return [block for path in documents(repository) for block in blocks_of(repository, path) if block.language == language]


def conclude(count, what, faults):
    """Tells the result of a test and returns its exit code; a test that found nothing to look at has failed."""
    for fault in faults:
        print(fault)
    print(f"{count} {what}, {len(faults)} faults")
    return 1 if faults or not count else 0
