# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Two photographs: a source that is warped onto a target."""
from __future__ import annotations

from typing import Optional

from . import _gcpw
from ._gcpw import Alignment, PairCanvas, PairMatches, Params, Score
from ._images import Image, Photograph, array_of
from ._progress import Progress, shown

_REMEDY = "let a third of each show what the other shows, in good light"


def find_pair_matches(source: Photograph, target: Photograph, *, params: Optional[Params] = None, progress: Progress = None) -> PairMatches:
    """Keypoints and line segments that two photographs have in common; found once, they serve any number of align_pair().

    Raises NoAlignmentError where there are too few."""
    with shown(progress) as function:
        matches = _gcpw.find_pair_matches(array_of(source), array_of(target), params or Params(), function)
    if matches.status != "ok":
        raise _gcpw.NoAlignmentError(f"the photographs do not match: {matches.message}; {_REMEDY}")
    return matches


def align_pair(source: Photograph, target: Photograph, *, params: Optional[Params] = None, matches: Optional[PairMatches] = None,
               progress: Progress = None) -> Alignment:
    """Mesh and colours that bring a source photograph onto a target photograph.

    source, target: names of files, or arrays of 8 or 16 bits: BGR, gray, or BGRA with a mask as the fourth channel
    matches: from find_pair_matches() or any other matcher
    Returns image 0, the source, and image 1, the target, undeformed. Where the refinement finds nothing better, the alignment is
    the rough one (`alignment.status`, `alignment.message`).
    Raises NoAlignmentError where the photographs do not match."""
    with shown(progress) as function:
        alignment = _gcpw.align_pair(array_of(source), array_of(target), params or Params(), matches, function)
    if alignment.status == "no_alignment":
        raise _gcpw.NoAlignmentError(f"the photographs do not match: {alignment.message}; {_REMEDY}")
    return alignment


def render_pair(alignment: Alignment, source: Photograph, target: Photograph, *, view: str = "natural") -> PairCanvas:
    """Both photographs on one canvas, at their full resolution: uint8, or uint16 where one of them is.

    view: 'natural', between both photographs, or 'target', in its frame, where scores can be compared"""
    return _gcpw.render_pair(alignment, array_of(source), array_of(target), view)


def blend_pair(canvas: PairCanvas, blend: str = "multiband") -> Image:
    """One picture of a canvas, BGR of its type, uint8 or uint16.

    blend: 'multiband', along a seam, or 'average', which shows what does not line up as double"""
    return _gcpw.blend_pair(canvas, blend)


def score_pair(canvas: PairCanvas) -> Score:
    """How well both photographs agree where they overlap; render them with view='target' to compare alignments."""
    return _gcpw.score_pair(canvas)


def stitch_pair(source: Photograph, target: Photograph, *, params: Optional[Params] = None, blend: str = "multiband",
                view: str = "natural", progress: Progress = None) -> Image:
    """align_pair(), render_pair() and blend_pair() in one call.

    Returns the picture, BGR: uint8, or uint16 where a photograph is. Raises NoAlignmentError where the photographs do not match."""
    images: tuple[Image, Image] = (array_of(source), array_of(target))
    alignment = align_pair(*images, params=params, progress=progress)
    return blend_pair(render_pair(alignment, *images, view=view), blend)
