#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""The samples of the module: they stitch, and refuse what they cannot.

Usage: test_tutorials.py PROGRAMS SCRATCH SAMPLES"""
from harness import NO_ANSWER, main


def test(bench):
    photos = bench.synthetic_pair()
    bench.flat_image("gray.pgm", 800, 600)
    bench.path("text.jpg").write_text("not a picture", encoding="utf-8")
    for name, usage in (("pair", "SOURCE TARGET"), ("plugin", "IMAGE IMAGE.."), ("detailed", "IMAGE IMAGE..")):
        program = "gcpw_sample_" + name
        said = bench.run(program, *photos, program + ".png")
        bench.check("plain warper" not in said, f"{program} did not refine: {said}")
        size = bench.png(program + ".png")
        bench.check(size is not None and 1000 < size[0] < 1300 and 560 <= size[1] < 700, f"{program} makes a picture of {size}")
        bench.refused(program, says=f"{name} {usage} PANORAMA")
        bench.refused(program, photos[0], "no.png", says=f"{usage} PANORAMA")
        bench.refused(program, photos[0], "text.jpg", "no.png", says="cannot read text.jpg")
        bench.refused(program, "text.jpg", photos[0], "no.png", says="cannot read text.jpg")
        bench.refused(program, photos[0], "gray.pgm", "no.png", expect=NO_ANSWER)
        bench.refused(program, *photos, "no_such_folder/pano.png", says="cannot write no_such_folder/pano.png")


if __name__ == "__main__":
    main(test)
