# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Photographs for the tests: parts of one smooth, textured picture that overlap."""
import numpy
import pytest

SHIFT = 80  # px from one part to the next


def smooth(noise, times=8):
    """The mean over 3 x 3 px, several times: NumPy alone, as the package needs nothing else."""
    for _ in range(times):
        noise = sum(numpy.roll(noise, (y, x), (0, 1)) for y in (-1, 0, 1) for x in (-1, 0, 1)) / 9
    noise -= noise.min()
    return (noise * (255 / noise.max())).astype(numpy.uint8)


@pytest.fixture(scope="session")
def scene():
    return smooth(numpy.random.RandomState(7).randint(0, 256, (240, 480, 3)).astype(float))


@pytest.fixture(scope="session")
def pair(scene):
    return scene[:, :320].copy(), scene[:, SHIFT:SHIFT + 320].copy()


@pytest.fixture(scope="session")
def strip(scene):
    """Three photographs; the third is darker."""
    parts = [scene[:, k * SHIFT:k * SHIFT + 320].copy() for k in range(3)]
    parts[2] = (parts[2] * 0.8).astype(numpy.uint8)
    return parts


@pytest.fixture
def blank():
    return numpy.full((240, 320, 3), 128, numpy.uint8)
