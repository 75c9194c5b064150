# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Panoramas, rigs, and the program."""
import os
import subprocess
import sys

import numpy
import pytest

import gcpw
from gcpw.__main__ import main


@pytest.fixture(scope="module")
def panorama(strip):
    return gcpw.stitch(strip)


@pytest.fixture
def folder(strip, tmp_path):
    (tmp_path / "photos").mkdir()
    for index, image in enumerate(strip):
        gcpw.write(tmp_path / "photos" / f"{index}.png", image)
    (tmp_path / "photos" / "notes.txt").write_text("not a photograph")
    return tmp_path


def test_a_strip_becomes_a_panorama(panorama):
    assert panorama.used == [0, 1, 2]
    assert panorama.picture.shape[:2] == panorama.mask.shape
    assert set(numpy.unique(panorama.mask)) <= {0, 255}
    assert panorama.picture.shape[1] > 420
    assert panorama.decisions


def test_a_rig_serves_later_photographs(panorama, strip, tmp_path):
    assert panorama.rig.usable
    panorama.rig.save(tmp_path / "rig.yml.gz")
    rig = gcpw.Rig.load(tmp_path / "rig.yml.gz")
    again = gcpw.stitch(strip, rig=rig)
    numpy.testing.assert_array_equal(again.picture, panorama.picture)
    with pytest.raises(ValueError, match="photograph 3"):
        gcpw.stitch(strip[:2], rig=rig)
    smaller = [image[:200] for image in strip]
    with pytest.raises(ValueError, match="200 px.*resize"):
        gcpw.stitch(smaller, rig=rig)


def test_a_rig_warps_single_photographs(panorama, strip):
    rig = panorama.rig
    corner, picture, mask = rig.warp(1, strip[1])
    assert picture.shape[:2] == mask.shape and picture.shape[2] == 3
    camera = rig.cameras[1]
    warper = gcpw.Warper(rig.projection, rig.scale / rig.work_scale, rig)
    K = camera.K()
    K[:2] /= rig.work_scale
    x, y, width, height = warper.warpRoi((320, 240), K, camera.R)
    assert (corner, mask.shape) == ((x, y), (height, width))
    with pytest.raises(ValueError, match="no camera 9"):
        rig.warp(9, strip[1])


def test_cameras_and_rig_can_be_had_one_by_one(strip):
    estimate = gcpw.estimate_cameras(strip)
    assert len(estimate.cameras) == 3 and estimate.ok
    assert gcpw.align_rig(estimate).usable
    noted = gcpw.estimate_cameras(strip, focal=[0, 300, 0])
    assert len(noted.cameras) == 3 and noted.component == estimate.component
    with pytest.raises(ValueError, match="focal"):
        gcpw.estimate_cameras(strip, focal=[300])
    with pytest.raises(gcpw.CancelledError):
        gcpw.estimate_cameras(strip, progress=lambda stage, fraction: stage != "cameras")


def test_a_rig_of_cameras_of_somebody_else(pair):
    class Camera:  # as cv2.detail.CameraParams
        focal = aspect = 1.0
        ppx = ppy = 0.0

        def __init__(self, x):
            self.R = numpy.array([[1, 0, -x], [0, 1, 0], [0, 0, 1]], numpy.float32)  # image from canvas
    cameras = [Camera(0), Camera(83)]  # 3 px beside the truth
    rig = gcpw.align_rig(pair, cameras, "affine")
    assert rig.usable and rig.fits(cameras), rig.alignment.message
    warper = gcpw.Warper("affine", 1, rig)
    K = numpy.eye(3)
    first = warper.warpPoint((200, 120), K, cameras[0].R)
    second = warper.warpPoint((120, 120), K, cameras[1].R)
    numpy.testing.assert_allclose(first, second, atol=0.5)
    compensator = warper.compensator()
    assert len(compensator.getMatGains()) == 2
    with pytest.raises(ValueError, match="sperical"):
        gcpw.align_rig(pair, cameras, "sperical")
    with pytest.raises(TypeError, match="no attribute"):
        gcpw.align_rig(pair, [1, 2], "affine")


def test_the_compensator_makes_colours_agree_in_place(pair):
    images = [pair[0].copy(), (pair[1] * 0.7).astype(numpy.uint8)]
    corners = [(0, 0), (80, 0)]
    masks = [numpy.full(image.shape[:2], 255, numpy.uint8) for image in images]

    def difference():
        return numpy.abs(images[0][:, 80:].astype(int) - images[1][:, :240]).mean()
    before = difference()
    compensator = gcpw.Compensator()
    compensator.feed(corners, images, masks)
    for k in range(2):
        assert compensator.apply(k, corners[k], images[k], masks[k]) is images[k]
    assert difference() < 0.2 * before


def test_images_on_a_canvas_are_aligned(pair):
    alignment = gcpw.align_images([(0, 0), (82, 1)], pair)
    assert alignment.ok, alignment.message


def test_progress_tells_all_stages_and_can_cancel(strip):
    stages = []
    gcpw.stitch(strip, progress=lambda stage, fraction: stages.append(stage))
    assert stages[0] == "features" and stages[-1] == "render" and {"cameras", "align"} <= set(stages)
    assert stages.count("cameras") >= len(strip), "a step for each pair"
    with pytest.raises(gcpw.CancelledError):
        gcpw.stitch(strip, progress=lambda stage, fraction: stage != "align")


def test_a_bar_is_shown(strip, capsys):
    gcpw.stitch(strip, progress=True)
    assert "render" in capsys.readouterr().err


def test_photographs_that_do_not_match_are_an_error(strip, blank):
    with pytest.raises(gcpw.NoAlignmentError):
        gcpw.stitch([strip[0], blank])
    with pytest.raises(ValueError, match="two photographs or more"):
        gcpw.stitch(strip[:1])


def test_the_program_stitches_a_folder(folder, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    assert main(["photos", "--output=pano.png", "--save-rig=rig.yml.gz"]) == 0
    assert "3 of 3 photographs" in capsys.readouterr().out
    assert main(["photos", "--output=again.png", "--rig=rig.yml.gz", "-q"]) == 0
    numpy.testing.assert_array_equal(gcpw.read("pano.png"), gcpw.read("again.png"))
    assert sorted(os.listdir()) == ["again.png", "pano.png", "photos", "rig.yml.gz"]


@pytest.mark.parametrize("arguments, code, says", [
    (["photos", "--output=photos/0.png", "--force"], 2, "one of the files that are read"),
    (["photos", "--output=photos/notes.txt"], 2, "is there already"),
    (["photos", "--output=nowhere/pano.png"], 3, "no folder nowhere"),
    (["photos", "--output=pano.xyz"], 2, "ending '.xyz'"),
    (["photos/0.png"], 2, "two photographs or more"),
    (["photos/0.png", "missing.png"], 3, "missing.png"),
    (["photos/0.png", "photos/notes.txt"], 3, "notes.txt is not a picture"),
    (["photos", "--set=meshCols=1"], 2, "meshCols is 1"),
    (["photos", "--set=mesh=1"], 2, "--set=mesh=1"),
    (["photos", "--rig=photos/notes.txt"], 2, "notes.txt"),
    (["photos", "--projection=globe"], 2, "globe"),
])
def test_the_program_says_what_is_wrong_and_leaves_nothing(folder, monkeypatch, capsys, arguments, code, says):
    monkeypatch.chdir(folder)
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    assert main(arguments) == code
    assert says in capsys.readouterr().err
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before


def test_the_program_is_started_by_its_name(folder):
    done = subprocess.run([sys.executable, "-m", "gcpw", "--version"], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == f"gcpw {gcpw.__version__}"
