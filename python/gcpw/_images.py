# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Photographs: files, folders and arrays."""
from __future__ import annotations

import os
import pathlib
from typing import Any, List, Sequence, Union

import numpy
from numpy.typing import NDArray

from . import _gcpw

Path = Union[str, "os.PathLike[str]"]
Image = NDArray[Any]
Picture = NDArray[numpy.uint8]
Photograph = Union[Path, Image]

ENDINGS = (".jpg", ".jpeg", ".png", ".tif", ".tiff", ".webp", ".bmp", ".jp2")


def read(path: Path) -> Picture:
    """A photograph, upright as its camera noted.

    Returns rows x columns x 3, BGR. Raises OSError where there is no such file, ValueError that names it where it is no picture."""
    name = os.fspath(path)
    with open(name, "rb"):  # says why a file cannot be opened; OpenCV does not
        pass
    picture = _gcpw.read_picture(name)
    if picture is None:
        raise ValueError(f"{name} is not a picture that OpenCV can read, or it is damaged; save it again as JPEG, PNG or TIFF")
    return picture


def write(path: Path, picture: Image) -> None:
    """Writes a picture as a whole or not at all; the ending of the name says how, as for cv2.imwrite().

    Raises ValueError where OpenCV does not know the ending, OSError where the file cannot be written; what was there is kept."""
    check_ending(path)
    place = pathlib.Path(path)
    unfinished = place.with_name(f".{os.getpid()}.partial{place.suffix}")
    try:
        unfinished.touch()
        if not _gcpw.write_picture(str(unfinished), numpy.asarray(picture)):
            raise OSError(f"{place} cannot be written: the disk is full, or the picture is too large for this format; try .png or .tif")
        os.replace(unfinished, place)
    finally:
        unfinished.unlink(missing_ok=True)


def check_ending(path: Path) -> None:
    """Raises ValueError where OpenCV writes no pictures of this ending."""
    name = os.fspath(path)
    if not _gcpw.can_write(name):
        raise ValueError(f"{name}: OpenCV writes no picture with the ending '{pathlib.Path(name).suffix}'; take .jpg, .png or .tif")


def photographs_in(folder: Path) -> List[str]:
    """The photographs of a folder, by name.

    Raises OSError where there is no such folder, ValueError where it has no pictures."""
    names = sorted(entry.path for entry in os.scandir(folder) if entry.is_file() and entry.name.lower().endswith(ENDINGS))
    if not names:
        raise ValueError(f"{os.fspath(folder)} has no photographs; looked for {', '.join(ENDINGS)}")
    return names


def array_of(photograph: Photograph) -> Image:
    """The pixels of a photograph that is given as an array or as the name of a file."""
    if isinstance(photograph, (str, os.PathLike)):
        return read(photograph)
    array: Image = numpy.asarray(photograph)
    if array.dtype == object or array.ndim == 0:
        raise TypeError(f"{type(photograph).__name__} is no photograph; the name of a file is, and an array as cv2.imread() gives it "
                        "(which gives None where it cannot read)")
    return array


def arrays_of(photographs: Union[Path, Sequence[Photograph]]) -> List[Image]:
    """The pixels of photographs that are given as arrays, names of files, or the name of one folder."""
    if isinstance(photographs, (str, os.PathLike)):
        if not os.path.isdir(photographs):
            raise ValueError(f"{os.fspath(photographs)} is no folder; give a folder, or a list of two photographs or more")
        photographs = photographs_in(photographs)
    return [array_of(photograph) for photograph in photographs]
