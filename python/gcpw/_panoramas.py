# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Any number of photographs: panoramas, and rigs of cameras that stand still."""
from __future__ import annotations

import dataclasses
from typing import List, Optional, Sequence, Tuple, Union

from . import _gcpw
from ._gcpw import Alignment, Camera, CameraEstimate, Params, Rig
from ._images import Image, Path, Photograph, Picture, array_of, arrays_of, write
from ._progress import Progress, shown


@dataclasses.dataclass(frozen=True)
class Panorama:
    """A finished picture, and how it came about."""

    picture: Picture  #: uint8, rows x columns x 3, BGR; black where no photograph is
    mask: Picture  #: uint8, rows x columns: 255 where a photograph covers the picture
    rig: Rig  #: cameras, meshes and colours, for further photographs of the same cameras
    used: List[int]  #: which of the photographs are in the picture, from 0
    decisions: List[str]  #: one sentence for each choice that was made

    def save(self, path: Path) -> None:
        """Writes the picture; the ending of the name says how. Raises what write() raises."""
        write(path, self.picture)


def stitch(photographs: Union[Path, Sequence[Photograph]], *, rig: Optional[Rig] = None, params: Optional[Params] = None,
           projection: str = "", megapix: float = 0, progress: Progress = None) -> Panorama:
    """A panorama of photographs that overlap, in any order.

    photographs: a folder, or a list of two or more: names of files, or arrays of 8 or 16 bits (BGR, BGRA or gray)
    rig: of an earlier panorama of the same cameras: then nothing is estimated. Photographs in the order and sizes of the first time
    params: weights and resolution of the estimation
    projection: 'plane', 'spherical', 'cylindrical', ..; empty: chosen
    megapix: size of a photograph in the picture, million pixels; 0: as it is
    progress: called as progress(stage, fraction); stages are 'features', 'cameras', 'align' and 'render', and of a rig 'render'. True shows a bar
    Raises NoAlignmentError where the photographs do not match, CancelledError where `progress` said stop."""
    images = arrays_of(photographs)
    with shown(progress) as function:
        if rig is not None:
            made = _gcpw.stitch_by_rig(rig, images, megapix, function)
        else:
            made = _gcpw.stitch(images, params or Params(), projection, megapix, function)
    return Panorama(made.picture, made.mask, made.rig, made.used, made.decisions)


def estimate_cameras(photographs: Union[Path, Sequence[Photograph]], *, projection: str = "", work_megapix: float = 0.6,
                     focal: Sequence[float] = (), progress: Progress = None) -> CameraEstimate:
    """Cameras and a projection for photographs that overlap; align_rig() takes them.

    focal: focal length of each photograph in its pixels, as its file may note it, 0 where it is not known: a start of the search
    where the matches do not say enough
    progress: called as progress(stage, fraction); stages are 'features' and 'cameras'. True shows a bar
    Raises NoAlignmentError where there are none, CancelledError where `progress` said stop."""
    images = arrays_of(photographs)
    with shown(progress) as function:
        estimate = _gcpw.estimate_cameras(images, projection, work_megapix, focal, function)
    if not estimate.ok:
        raise _gcpw.NoAlignmentError(estimate.decisions[-1] if estimate.decisions else "no two of the photographs match")
    return estimate


def align_rig(images: Union[CameraEstimate, Sequence[Photograph]], cameras: Sequence[Camera] = (), projection: str = "", *,
              params: Optional[Params] = None, progress: Progress = None) -> Rig:
    """Meshes and colours for photographs whose cameras are known.

    images: two or more at the resolution that the cameras refer to; or what estimate_cameras() found, and nothing else
    cameras: Camera, or cv2.detail.CameraParams as OpenCV's bundle adjustment leaves them
    projection: name of the warper, as cv2.PyRotationWarper takes it
    Returns a rig; one that is not `usable` says why in `rig.alignment.message`."""
    with shown(progress) as function:
        if isinstance(images, CameraEstimate):
            return _gcpw.align_estimate(images, params or Params(), function)
        return _gcpw.align_rig([array_of(image) for image in images], cameras, projection, params or Params(), function)


def align_images(corners: Sequence[Tuple[int, int]], images: Sequence[Image], masks: Sequence[Image] = (), *,
                 params: Optional[Params] = None, progress: Progress = None) -> Alignment:
    """Refines images that lie on one canvas already.

    corners: canvas position x, y of the top-left pixel of each image
    masks: uint8 of the same sizes, not 0 inside; none: everywhere"""
    with shown(progress) as function:
        return _gcpw.align_images(corners, images, masks, params or Params(), function)
