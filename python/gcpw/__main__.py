# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""python -m gcpw FOLDER: a panorama of the photographs in a folder."""
from __future__ import annotations

import argparse
import os
import sys
from typing import List, Optional, Sequence

import numpy
from numpy.typing import NDArray

import gcpw
from gcpw._images import check_ending

STITCHED, NO_ALIGNMENT, WRONG_USE, FILE_FAULT, INTERRUPTED = 0, 1, 2, 3, 130


class Stop(Exception):
    """Ends the program with an exit code and a message."""

    def __init__(self, code: int, message: str) -> None:
        super().__init__(message)
        self.code = code


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="python -m gcpw", description="Stitches photographs that overlap, also those taken a step apart.",
        epilog="Exit code: 0 stitched, 1 the photographs do not match, 2 wrong use, 3 a file cannot be read or written. "
               "Example: python -m gcpw holiday --output=holiday.jpg")
    made.add_argument("photographs", nargs="+", metavar="PHOTOGRAPH", help="two photographs or more, or folders of photographs")
    made.add_argument("-o", "--output", default="panorama.jpg", help="the picture to write (default: %(default)s)")
    made.add_argument("-f", "--force", action="store_true", help="write the picture where a file of its name is already")
    made.add_argument("--projection", default="", help="plane, spherical, cylindrical, ..; chosen if not given")
    made.add_argument("--megapix", type=float, default=0, help="size of a photograph in the picture, million pixels; 0, the default: as it is")
    made.add_argument("--save-rig", metavar="FILE", help="write cameras, meshes and colours, .yml or .yml.gz")
    made.add_argument("--rig", metavar="FILE", help="use such a file instead of estimating")
    made.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="a parameter, see gcpw.Params; may be repeated")
    made.add_argument("--skip-bad", action="store_true", help="leave out files that cannot be read, and name them")
    made.add_argument("-q", "--quiet", action="store_true", help="say nothing but what went wrong")
    made.add_argument("--version", action="version", version=f"gcpw {gcpw.__version__}")
    return made


def names_of(given: Sequence[str]) -> List[str]:
    names: List[str] = []
    for name in given:
        names += gcpw.photographs_in(name) if os.path.isdir(name) else [name]
    return names


def check_output(path: Optional[str], inputs: Sequence[str], force: bool) -> None:
    """Before any work: nothing that is read is written, and nothing is replaced unasked."""
    if path is None:
        return
    if not os.path.isdir(os.path.dirname(path) or "."):
        raise Stop(FILE_FAULT, f"{path} cannot be written: there is no folder {os.path.dirname(path)}")
    if os.path.isdir(path):
        raise Stop(WRONG_USE, f"{path} is a folder; name a file in it")
    if not os.path.exists(path):
        return
    for name in inputs:
        if os.path.exists(name) and os.path.samefile(name, path):
            raise Stop(WRONG_USE, f"{path} is one of the files that are read; take another name")
    if not force:
        raise Stop(WRONG_USE, f"{path} is there already; take another name, or --force to replace it")


def params_of(settings: Sequence[str]) -> gcpw.Params:
    params = gcpw.Params()
    for setting in settings:
        name, found, value = setting.partition("=")
        if not found:
            raise Stop(WRONG_USE, f"--set={setting}: NAME=VALUE is wanted")
        if name == "method":
            params.method = value
            continue
        try:
            params.set(name, float(value))
        except ValueError as error:
            raise Stop(WRONG_USE, f"--set={setting}: {error}") from error
    params.check()
    return params


def read_all(names: Sequence[str], skip_bad: bool) -> List[NDArray[numpy.uint8]]:
    pictures = []
    for name in names:
        try:
            pictures.append(gcpw.read(name))
        except (OSError, ValueError) as error:
            if not skip_bad:
                raise Stop(FILE_FAULT, f"{error}; --skip-bad leaves it out") from error
            print(f"gcpw: left out: {error}", file=sys.stderr)
    return pictures


def run(arguments: Sequence[str]) -> None:
    options = parser().parse_args(arguments)
    names = names_of(options.photographs)
    if len(names) < 2:
        raise Stop(WRONG_USE, f"two photographs or more are needed; {len(names)} given")
    read = names + ([options.rig] if options.rig else [])
    for path in (options.output, options.save_rig):
        check_output(path, read, options.force)
    check_ending(options.output)
    params = params_of(options.set)
    rig = gcpw.Rig.load(options.rig) if options.rig else None
    panorama = gcpw.stitch(read_all(names, options.skip_bad), rig=rig, params=params, projection=options.projection,
                           megapix=options.megapix, progress=sys.stderr.isatty() and not options.quiet)
    panorama.save(options.output)
    if options.save_rig:
        panorama.rig.save(options.save_rig)
    if not options.quiet:
        height, width = panorama.mask.shape
        print(*panorama.decisions, sep="\n", end="\n" if panorama.decisions else "")
        print(f"{options.output}: {width} x {height} px of {len(panorama.used)} of {len(names)} photographs")


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """The program; returns its exit code."""
    try:
        run(sys.argv[1:] if arguments is None else arguments)
        return STITCHED
    except Stop as stop:
        code, message = stop.code, str(stop)
    except gcpw.NoAlignmentError as error:
        code, message = NO_ALIGNMENT, str(error)
    except OSError as error:
        code, message = FILE_FAULT, str(error)
    except (ValueError, gcpw.Error) as error:
        code, message = WRONG_USE, str(error)
    except KeyboardInterrupt:
        code, message = INTERRUPTED, "interrupted; nothing was written"
    print(f"gcpw: {message}", file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
