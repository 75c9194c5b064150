# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Stitches photographs which no single homography aligns: Generalized Content-Preserving Warps.

    import gcpw

    gcpw.stitch("holiday").save("panorama.jpg")                   # a folder of photographs
    panorama = gcpw.stitch(["one.jpg", "two.jpg"], progress=True)  # or files, or arrays as cv2.imread() gives them
    panorama.picture                                              # numpy.uint8, rows x columns x 3, BGR

Pictures are NumPy arrays in the order of channels that OpenCV has: blue, green, red. Long calls let other Python threads run;
they take a `progress` function, called as progress(stage, fraction), that may return False to cancel.

What is wrong with an argument is a ValueError or TypeError, what is wrong with a file an OSError, photographs that do not match a
NoAlignmentError. Each says what to do.
"""
from ._gcpw import (AlignedImage, Alignment, Camera, CameraEstimate, CancelledError, Compensator, Error, LevelReport,
                    NoAlignmentError, PairCanvas, PairMatches, PairReport, Params, Report, Rig, Score, Warper, __version__)
from ._images import photographs_in, read, write
from ._pairs import align_pair, blend_pair, find_pair_matches, render_pair, score_pair, stitch_pair
from ._panoramas import Panorama, align_images, align_rig, estimate_cameras, stitch

__all__ = ["AlignedImage", "Alignment", "Camera", "CameraEstimate", "CancelledError", "Compensator", "Error", "LevelReport",
           "NoAlignmentError", "PairCanvas", "PairMatches", "PairReport", "Panorama", "Params", "Report", "Rig", "Score", "Warper",
           "__version__", "align_images", "align_pair", "align_rig", "blend_pair", "estimate_cameras", "find_pair_matches",
           "photographs_in", "read", "render_pair", "score_pair", "stitch", "stitch_pair", "write"]
