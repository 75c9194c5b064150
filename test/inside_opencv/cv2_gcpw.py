#!/usr/bin/env python3
"""The module as Python sees it, in a cv2 that OpenCV's own build made (PYTHONPATH: its python_loader folder).

Usage: cv2_gcpw.py PUBLIC_HEADERS [UNITTEST_OPTION...]"""
import pathlib
import re
import sys
import unittest

import cv2

HEADERS = pathlib.Path(sys.argv.pop(1))
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


class Constants(unittest.TestCase):
    def test_enumerations_are_constants_of_the_module(self):
        self.assertEqual(cv2.gcpw.METHOD_GLOBAL, 0)
        self.assertEqual(cv2.gcpw.Params().method, cv2.gcpw.METHOD_GCPW)
        self.assertEqual(cv2.gcpw.STATUS_OK, 0)
        self.assertNotEqual(cv2.gcpw.BLEND_AVERAGE, cv2.gcpw.BLEND_MULTIBAND)


if __name__ == "__main__":
    unittest.main(verbosity=2)
