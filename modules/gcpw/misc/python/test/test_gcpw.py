#!/usr/bin/env python3
"""The module as Python sees it, in a cv2 that OpenCV's own build made (PYTHONPATH: its python_loader folder)."""
import pathlib
import re
import tempfile
import unittest

import cv2
import numpy

HEADERS = pathlib.Path(__file__).resolve().parents[3] / "include"
DOCUMENTED = re.findall(r"CV_PROP_RW \w+ (\w+);", (HEADERS / "opencv2/gcpw/params.hpp").read_text(encoding="utf-8"))


class Params(unittest.TestCase):
    def test_every_member_is_an_attribute(self):
        params = cv2.gcpw.Params()
        self.assertGreater(len(DOCUMENTED), 25)
        for name in DOCUMENTED:
            self.assertTrue(hasattr(params, name), name)

    def test_names_are_the_numeric_members_in_their_order(self):
        self.assertEqual(["method", *cv2.gcpw.Params.names()], DOCUMENTED)

    def test_what_is_set_by_name_is_read_by_name_and_as_attribute(self):
        for name in cv2.gcpw.Params.names():
            params = cv2.gcpw.Params()
            value = params.get(name) + 1
            params.set(name, value)
            self.assertEqual(params.get(name), value)
            self.assertEqual(getattr(params, name), value)

    def test_an_attribute_that_is_set_is_read_by_name(self):
        params = cv2.gcpw.Params()
        params.similarityWeight = 0.7
        params.meshCols = 12
        self.assertEqual((params.get("similarityWeight"), params.get("meshCols")), (0.7, 12))

    def test_defaults_and_the_papers_constants_pass_the_check(self):
        cv2.gcpw.Params().check()
        cv2.gcpw.Params.paper().check()
        self.assertEqual(cv2.gcpw.Params.paper().similarityWeight, 0.5)
        self.assertEqual(cv2.gcpw.Params.paper().contrastFloor, 0)

    def test_a_member_out_of_range_is_named(self):
        params = cv2.gcpw.Params()
        params.meshRows = 1
        with self.assertRaisesRegex(cv2.error, "meshRows is 1"):
            params.check()

    def test_an_unknown_name_is_refused(self):
        with self.assertRaisesRegex(cv2.error, "simlarityWeight"):
            cv2.gcpw.Params().set("simlarityWeight", 1)


def two_views():
    """Two overlapping parts of one smooth, textured picture: the second starts 80 px further right."""
    noise = numpy.random.RandomState(7).randint(0, 256, (240, 400, 3)).astype(numpy.uint8)
    picture = cv2.normalize(cv2.GaussianBlur(noise, (0, 0), 2), None, 0, 255, cv2.NORM_MINMAX)
    return picture[:, :320].copy(), picture[:, 80:].copy()


class Pair(unittest.TestCase):
    def test_two_photographs_become_one_picture(self):
        source, target = two_views()
        done, panorama = cv2.gcpw.stitchPair(source, target)
        self.assertTrue(done)
        self.assertGreaterEqual(panorama.shape[1], 395)

    def test_each_step_can_be_called_alone(self):
        source, target = two_views()
        alignment = cv2.gcpw.alignPair(source, target)
        self.assertEqual(alignment.imageCount(), 2)
        self.assertEqual(alignment.image(0).mesh.shape, (33, 33, 2))
        self.assertEqual(alignment.report().folds, 0)
        canvas = cv2.gcpw.renderPair(alignment, source, target)
        self.assertEqual(cv2.gcpw.blendPair(canvas, cv2.gcpw.BLEND_AVERAGE).shape, canvas.source.shape)
        self.assertLess(cv2.gcpw.scorePair(canvas).zncc, 20)
        natural = cv2.gcpw.renderPair(alignment, source, target, cv2.gcpw.VIEW_NATURAL)
        self.assertEqual(natural.canvas_from_target.shape, (3, 3))

    def test_matches_found_once_serve_other_parameters(self):
        source, target = two_views()
        matches = cv2.gcpw.findPairMatches(source, target)
        self.assertEqual(matches.status, cv2.gcpw.STATUS_OK)
        self.assertGreater(len(matches.source_points), 20)
        self.assertEqual(len(matches.source_points), len(matches.target_points))
        self.assertEqual(numpy.array(matches.target_from_source).shape, (3, 3))
        self.assertTrue(cv2.gcpw.alignPair(source, target, matches).ok())

    def test_the_report_says_what_happened(self):
        report = cv2.gcpw.alignPair(*two_views()).report()
        self.assertEqual((report.pairs[0].a, report.pairs[0].b), (0, 1))
        self.assertGreater(report.pairs[0].points, 20)
        self.assertGreater(report.timings_ms.total, 0)
        for level in report.levels:
            self.assertEqual([energy.name for energy in level.start], [energy.name for energy in level.end])

    def test_progress_is_told_and_can_cancel(self):
        stages = []
        cv2.gcpw.alignPair(*two_views(), cv2.gcpw.Params(), lambda stage, fraction: stages.append(stage))
        self.assertIn("features", stages)
        alignment = cv2.gcpw.alignPair(*two_views(), cv2.gcpw.Params(), lambda stage, fraction: False)
        self.assertEqual(alignment.report().status, cv2.gcpw.STATUS_CANCELLED)

    def test_every_value_type_can_be_made(self):
        for name in ("Alignment", "AlignedImage", "CameraEstimate", "CameraOptions", "LevelReport", "PairCanvas", "PairMatches",
                     "PairReport", "Report", "Rig", "Score", "TermEnergy", "Timings"):
            self.assertIsNotNone(getattr(cv2.gcpw, name)(), name)
        self.assertEqual(cv2.gcpw.Alignment().imageCount(), 0)


class Canvas(unittest.TestCase):
    def test_images_on_a_canvas_are_aligned(self):
        alignment = cv2.gcpw.Aligner.create().align([(0, 0), (82, 1)], list(two_views()), [])
        self.assertEqual(alignment.imageCount(), 2)
        self.assertTrue(alignment.ok(), alignment.report().message)

    def test_an_alignment_is_the_same_after_it_was_saved(self):
        alignment = cv2.gcpw.alignPair(*two_views())
        with tempfile.TemporaryDirectory() as folder:
            alignment.save(folder + "/alignment.yml.gz")
            loaded = cv2.gcpw.Alignment.load(folder + "/alignment.yml.gz")
        numpy.testing.assert_array_equal(loaded.image(0).mesh, alignment.image(0).mesh)


class Rigs(unittest.TestCase):
    def setUp(self):
        self.images = list(two_views())
        self.cameras = []
        for x in (0, 83):  # 3 px beside the truth
            camera = cv2.detail.CameraParams()
            camera.focal = camera.aspect = 1  # Python makes cameras of zeros
            camera.ppx = camera.ppy = 0
            camera.R = numpy.float32([[1, 0, -x], [0, 1, 0], [0, 0, 1]])  # image from canvas
            self.cameras.append(camera)

    def test_a_rig_is_estimated_saved_and_used_by_a_warper(self):
        rig = cv2.gcpw.alignRig(self.images, self.cameras, "affine")
        self.assertTrue(rig.usable(), rig.alignment.report().message)
        with tempfile.TemporaryDirectory() as folder:
            rig.save(folder + "/rig.yml.gz")
            rig = cv2.gcpw.Rig.load(folder + "/rig.yml.gz")
        self.assertTrue(rig.fits(self.cameras))
        warper = cv2.gcpw.PyGcpwWarper("affine", 1, rig)
        K = numpy.eye(3, dtype=numpy.float32)
        first = warper.warpPoint((200, 120), K, self.cameras[0].R)
        second = warper.warpPoint((120, 120), K, self.cameras[1].R)
        numpy.testing.assert_allclose(first, second, atol=0.5)
        _, picture = warper.warp(self.images[1], K, self.cameras[1].R, cv2.INTER_LINEAR, cv2.BORDER_REFLECT)
        self.assertEqual(picture.shape[:2], warper.warpRoi((320, 240), K, self.cameras[1].R)[:1:-1])

    def test_the_compensator_of_a_warper_has_the_colours_of_the_rig(self):
        rig = cv2.gcpw.alignRig(self.images, self.cameras, "affine")
        self.assertEqual(rig.projection, "affine")
        gains = cv2.gcpw.PyGcpwWarper("affine", 1, rig).compensator().getMatGains()
        self.assertEqual(len(gains), 2)
        numpy.testing.assert_array_equal(gains[0], rig.alignment.image(0).color)

    def test_cameras_are_found_and_aligned(self):
        estimate = cv2.gcpw.estimateCameras(self.images)
        self.assertTrue(estimate.ok(), estimate.decisions)
        self.assertEqual(len(estimate.cameras), 2)
        rig = cv2.gcpw.alignEstimate(estimate)
        self.assertTrue(rig.usable(), rig.alignment.report().message)
        self.assertEqual(rig.projection, estimate.projection)

    def test_without_a_rig_the_warper_is_opencvs(self):
        K = numpy.float32([[300, 0, 160], [0, 300, 120], [0, 0, 1]])
        R = cv2.Rodrigues(numpy.array([0.05, 0.3, 0]))[0].astype(numpy.float32)
        ours = cv2.gcpw.PyGcpwWarper("spherical", 300)
        plain = cv2.PyRotationWarper("spherical", 300)
        self.assertEqual(ours.warpRoi((320, 240), K, R), plain.warpRoi((320, 240), K, R))
        self.assertEqual(ours.warpPoint((10, 20), K, R), plain.warpPoint((10, 20), K, R))
        for a, b in zip(ours.buildMaps((320, 240), K, R)[1:], plain.buildMaps((320, 240), K, R)[1:]):
            numpy.testing.assert_array_equal(a, b)
        at, picture = ours.warp(self.images[0], K, R, cv2.INTER_LINEAR, cv2.BORDER_REFLECT)
        same_at, same = plain.warp(self.images[0], K, R, cv2.INTER_LINEAR, cv2.BORDER_REFLECT)
        self.assertEqual(at, same_at)
        numpy.testing.assert_array_equal(picture, same)

    def test_a_warper_that_does_not_exist_is_refused(self):
        with self.assertRaisesRegex(cv2.error, "sperical"):
            cv2.gcpw.alignRig(self.images, self.cameras, "sperical")
        # What a constructor throws arrives as the cause of a SystemError, at least up to OpenCV 4.6.
        for name, scale in (("sperical", 300), ("spherical", 0)):
            with self.assertRaises((cv2.error, SystemError)):
                cv2.gcpw.PyGcpwWarper(name, scale)


class Stitching(unittest.TestCase):
    def test_a_stitcher_can_be_attached_to(self):
        binding = cv2.gcpw.attach(cv2.Stitcher.create())
        self.assertEqual(binding.estimations(), 0)
        self.assertEqual(list(binding.replacedParts()), [])
        self.assertFalse(binding.rig().usable())

    def test_the_compensator_makes_colours_agree(self):
        images = list(two_views())
        images[1] = (images[1] * 0.7).astype(numpy.uint8)
        corners = [(0, 0), (80, 0)]
        masks = [numpy.full(image.shape[:2], 255, numpy.uint8) for image in images]
        before = cv2.absdiff(images[0][:, 80:], images[1][:, :240]).mean()
        compensator = cv2.gcpw.GcpwCompensator()
        compensator.feed(corners, images, masks)
        for k in range(2):
            images[k] = compensator.apply(k, corners[k], images[k], masks[k])
        self.assertLess(cv2.absdiff(images[0][:, 80:], images[1][:, :240]).mean(), 0.2 * before)


class Constants(unittest.TestCase):
    def test_enumerations_are_constants_of_the_module(self):
        self.assertEqual(cv2.gcpw.METHOD_GLOBAL, 0)
        self.assertEqual(cv2.gcpw.Params().method, cv2.gcpw.METHOD_GCPW)
        self.assertEqual(cv2.gcpw.STATUS_OK, 0)
        self.assertNotEqual(cv2.gcpw.BLEND_AVERAGE, cv2.gcpw.BLEND_MULTIBAND)


if __name__ == "__main__":
    unittest.main()
