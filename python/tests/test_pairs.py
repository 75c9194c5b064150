# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Two photographs, step by step and in one call."""
import gc
import threading

import numpy
import pytest

import gcpw


def test_two_photographs_become_one_picture(pair):
    picture = gcpw.stitch_pair(*pair)
    assert picture.dtype == numpy.uint8 and picture.shape[2] == 3
    assert picture.shape[1] >= 395


def test_each_step_can_be_called_alone(pair):
    alignment = gcpw.align_pair(*pair)
    assert alignment.ok and alignment.status == "ok" and len(alignment) == 2
    assert alignment[0].mesh.shape == (33, 33, 2) and alignment[0].color.shape == (32, 32, 6)
    assert alignment[0].full_size == (320, 240)
    assert alignment.report.folds == 0 and alignment.report.pairs[0].points > 20
    canvas = gcpw.render_pair(alignment, *pair, view="target")
    assert gcpw.score_pair(canvas).zncc < 20
    assert gcpw.blend_pair(canvas, "average").shape == canvas.target.shape


def test_matches_found_once_serve_other_parameters(pair):
    matches = gcpw.find_pair_matches(*pair)
    assert matches.source_points.shape == matches.target_points.shape and matches.source_points.shape[1] == 2
    assert gcpw.align_pair(*pair, matches=matches, params=gcpw.Params(similarityWeight=1)).ok
    matches.source_points = matches.source_points[:-1]
    with pytest.raises(ValueError, match="source_points|points"):
        gcpw.align_pair(*pair, matches=matches)


def test_photographs_may_be_files_gray_16_bit_or_views(pair, tmp_path):
    names = []
    for index, image in enumerate(pair):
        names.append(tmp_path / f"{index}.png")
        gcpw.write(names[-1], image)
    expected = gcpw.align_pair(*pair)[0].mesh
    numpy.testing.assert_array_equal(gcpw.align_pair(*names)[0].mesh, expected)
    wide = [image.astype(numpy.uint16) * 257 for image in pair]
    numpy.testing.assert_allclose(gcpw.align_pair(*wide)[0].mesh, expected, atol=0.1)
    padded = [numpy.pad(image, ((5, 5), (7, 7), (0, 0)))[5:-5, 7:-7] for image in pair]
    numpy.testing.assert_array_equal(gcpw.align_pair(*padded)[0].mesh, expected)
    assert gcpw.align_pair(pair[0][:, :, 1], pair[1][:, :, 1]).ok
    turned = [image[::-1, ::-1] for image in pair]
    assert gcpw.align_pair(*turned).ok


def test_an_alignment_is_the_same_after_it_was_saved(pair, tmp_path):
    alignment = gcpw.align_pair(*pair)
    alignment.save(tmp_path / "pair.yml.gz")
    loaded = gcpw.Alignment.load(tmp_path / "pair.yml.gz")
    numpy.testing.assert_array_equal(loaded[0].mesh, alignment[0].mesh)
    with pytest.raises(FileNotFoundError, match="nowhere"):
        gcpw.Alignment.load(tmp_path / "nowhere.yml")
    with pytest.raises(OSError):
        alignment.save(tmp_path / "no_folder" / "pair.yml")
    (tmp_path / "bad.yml").write_text("%YAML:1.0\n---\n")
    with pytest.raises(ValueError, match="bad.yml"):
        gcpw.Alignment.load(tmp_path / "bad.yml")


def test_arrays_outlive_what_made_them(pair):
    mesh = gcpw.align_pair(*pair)[0].mesh
    before = mesh.copy()
    gc.collect()
    gcpw.align_pair(*pair)
    numpy.testing.assert_array_equal(mesh, before)


def test_photographs_that_do_not_match_are_an_error_with_a_remedy(pair, blank):
    with pytest.raises(gcpw.NoAlignmentError, match="do not match.*let a third"):
        gcpw.align_pair(pair[0], blank)
    assert issubclass(gcpw.NoAlignmentError, gcpw.Error)


def test_what_is_wrong_with_an_argument_is_named(pair):
    with pytest.raises(ValueError, match="sideways.*natural"):
        gcpw.render_pair(gcpw.align_pair(*pair), *pair, view="sideways")
    with pytest.raises(TypeError, match="NoneType is no photograph"):
        gcpw.align_pair(None, pair[1])
    with pytest.raises(TypeError, match="uint8 are wanted"):
        gcpw.align_pair(pair[0].astype(complex), pair[1])
    with pytest.raises(FileNotFoundError, match="nowhere.jpg"):
        gcpw.align_pair("nowhere.jpg", pair[1])


def test_sixteen_bits_stay_sixteen(pair):
    deep = [image.astype(numpy.uint16) * 257 for image in pair]
    picture = gcpw.stitch_pair(*deep)
    assert picture.dtype == numpy.uint16
    eight = gcpw.stitch_pair(*pair)
    assert picture.shape == eight.shape
    assert abs(picture / 257 - eight).mean() < 3, "of another alignment"


def test_progress_is_told_and_can_cancel(pair):
    seen = []
    gcpw.align_pair(*pair, progress=lambda stage, fraction: seen.append((stage, fraction)))
    assert seen and all(0 <= fraction <= 1 for _, fraction in seen)
    with pytest.raises(gcpw.CancelledError):
        gcpw.align_pair(*pair, progress=lambda stage, fraction: False)


def test_what_a_progress_function_raises_arrives(pair):
    def broken(stage, fraction):
        raise ZeroDivisionError(stage)
    with pytest.raises(ZeroDivisionError):
        gcpw.align_pair(*pair, progress=broken)


def test_other_threads_run_meanwhile(pair):
    turns = 0
    done = threading.Event()

    def count():
        nonlocal turns
        while not done.wait(0.001):
            turns += 1
    other = threading.Thread(target=count)
    other.start()
    gcpw.align_pair(*pair)
    done.set()
    other.join()
    assert turns > 5
