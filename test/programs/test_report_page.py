#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""The page of --report of both programs, on a synthetic pair: what its file holds, and how it works in headless Chromium."""
import html.parser
import json
import re
import sys

import browser
from harness import NO_ANSWER, Bench

MOST_BYTES = 2_000_000  # of two photographs; six are to stay below 5 MB
LAYERS = ("picture", "misalignment", "mean", "lines", "mesh", "cuts", "light")
QUICK = ("--set=meshCols=16,meshRows=16",)
SKIPPED = 77  # what ctest takes for a test that did not run


class Links(html.parser.HTMLParser):
    """Everything that a page refers to, and its pictures."""

    def __init__(self):
        super().__init__()
        self.targets = []
        self.pictures = []
        self.open = []
        self.faults = []

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.targets += [attributes[name] for name in ("src", "href", "data", "action") if attributes.get(name)]
        if tag == "img":
            self.pictures.append(attributes)
        if tag not in ("img", "meta", "link", "input", "br", "path"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        if tag == "path":
            return
        if not self.open or self.open.pop() != tag:
            self.faults.append(f"</{tag}> closes nothing")


def holds_everything(bench, folder, before, after):
    """The page alone: no other file, alternative texts, the report beside it."""
    text = bench.path(folder + "/index.html").read_text(encoding="utf-8")
    bench.check(len(text) < MOST_BYTES, f"{folder}: {len(text)} bytes")
    links = Links()
    links.feed(text)
    bench.check(not links.faults and not links.open, f"{folder}: {links.faults} {links.open}")
    bench.check(all(target.startswith(("data:", "#")) for target in links.targets), f"{folder}: refers to {set(t[:40] for t in links.targets)}")
    bench.check(not re.search(r"url\(|@import|https?://", text), f"{folder}: asks for the network")
    bench.check(len(links.pictures) >= 8 and all(picture.get("alt") for picture in links.pictures), f"{folder}: pictures without a text")
    for word in (before, after, "zncc", "Messages", "Photographs and their colours", "Pairs", "Together"):
        bench.check(word in text, f"{folder}: does not say {word}")
    bench.check("{{" not in text, f"{folder}: a place of the template is left")
    report = json.loads(bench.path(folder + "/report.json").read_text(encoding="utf-8"))
    bench.check(report["status"] in ("ok", "stitched"), f"{folder}: report.json says {report['status']}")


def visible(page):
    """Ids of the layers that a reader sees on the right."""
    return page.value("[...document.querySelectorAll('.side.after [data-show]')]"
                      ".filter(part => getComputedStyle(part).visibility === 'visible').map(part => part.dataset.show)")


def clipped(page):
    """How much of the left picture is cut off, per cent."""
    shape = page.value("getComputedStyle(document.querySelector('.side.before')).clipPath")
    numbers = re.findall(r"([\d.]+)%", shape)
    return 100 - float(numbers[-1]) if numbers else shape


def works(bench, folder):
    """Slider by script, by keys and by mouse; layers; sizes; light and dark; narrow windows."""
    with browser.page() as page:
        page.open(bench.path(folder + "/index.html").as_uri())
        page.size(1200, 900)
        bench.check(page.value("[...document.images].every(image => image.complete && image.naturalWidth > 0)"), f"{folder}: a picture is broken")
        bench.check(page.value("getComputedStyle(document.querySelector('.viewer')).getPropertyValue('--split')") == "50%", "the line is not in the middle")
        page.value("(s => { s.value = 20; s.dispatchEvent(new Event('input', {bubbles: true})); })(document.querySelector('#split'))")
        place = page.value("parseFloat(getComputedStyle(document.querySelector('.handle')).left) / document.querySelector('.stage').clientWidth")
        bench.check(abs(place - 0.2) < 0.01, f"{folder}: moved to 20 by script, the line stands at {place}")
        bench.check(clipped(page) in (20, "inset(0px 80% 0px 0px)"), f"{folder}: the left picture shows {clipped(page)}")
        page.value("document.querySelector('#split').focus()")
        page.press("ArrowRight", 39)
        bench.check(page.value("document.querySelector('#split').value") == "20.5", "the arrow key does not move the slider")
        bench.check(page.value("getComputedStyle(document.querySelector('.viewer')).getPropertyValue('--split')") == "20.5%", "the key does not move the line")
        x, y, width, height = page.value("(b => [b.left, b.top, b.width, b.height])(document.querySelector('.stage').getBoundingClientRect())")
        page.drag((x + 0.3 * width, y + 0.5 * height), (x + 0.75 * width, y + 0.5 * height))
        bench.check(page.value("document.querySelector('#split').value") == "75", "the mouse does not drag the line")
        bench.check(page.value("location.hash") == "#layer=picture&split=75", "the address does not keep the view")
        for layer in LAYERS:
            page.value(f"document.querySelector('input[value={layer}]').click()")
            under = {"picture"} if layer in ("lines", "mesh", "cuts") else set()
            bench.check(set(visible(page)) == {layer} | under, f"{folder}: {layer} shows {visible(page)}")
            legend = page.value(f"document.querySelector('.legends [data-show={layer}]').offsetHeight")
            bench.check(legend > 0, f"{folder}: {layer} has no legend")
        page.value("location.hash = '#layer=mesh&split=30'")
        page.value("new Promise(done => setTimeout(done, 100))")
        bench.check(set(visible(page)) == {"picture", "mesh"}, "an address does not choose the layer")
        page.value("document.querySelector('[data-zoom=\"4\"]').click()")
        bench.check(page.value("document.querySelector('.stage').clientWidth / document.querySelector('.window').clientWidth") > 2, "nothing is enlarged")
        page.value("document.querySelector('[data-zoom=\"1\"]').click()")
        for is_dark in (False, True):
            page.dark(is_dark)
            light = page.value("getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)[0]")
            bench.check((light < 60) == is_dark, f"{folder}: dark is {is_dark}, the paper is {light}")
            page.screenshot(bench.path(f"{folder}/{'dark' if is_dark else 'light'}.png"))
        bench.check(bench.path(f"{folder}/dark.png").stat().st_size > 20000, "the screenshot is empty")
        page.size(360, 700)
        bench.check(page.value("document.documentElement.scrollWidth <= 360"), f"{folder}: is wider than a telephone")
        bench.check(not page.console, f"{folder}: the console says {page.console}")
        asked = [url[:60] for url in page.requests if not url.startswith(("data:", "file:", "about:"))]
        bench.check(not asked, f"{folder}: asks for {asked}")


def shows_what_was_written(bench, folder, output, is_cropped):
    """The size that the page tells is that of the file, and its picture has that shape."""
    text = bench.path(folder + "/index.html").read_text(encoding="utf-8")
    width, height, _ = bench.png(output)
    bench.check(f"{width} &times; {height} px" in text, f"{folder}: does not say that the picture is {width} x {height} px")
    bench.check(("cropped from" in text) == is_cropped, f"{folder}: cropped is {is_cropped}, and the page does not agree")
    shown = re.search(r"aspect-ratio: (\d+) / (\d+)", text)
    ratio = int(shown.group(1)) / int(shown.group(2))
    bench.check(not is_cropped or abs(ratio / (width / height) - 1) < 0.01, f"{folder}: the picture on the page is {shown.group()}")


def tells_failure(bench, source):
    """Where there is no picture, the page says why."""
    bench.flat_image("gray.pgm")
    for program, folder in (("gcpw_pair", "no_pair"), ("gcpw_stitch", "no_panorama")):
        bench.run(program, "gray.pgm", source, "--output=no.png", f"--report={folder}", expect=NO_ANSWER)
        text = bench.path(folder + "/index.html").read_text(encoding="utf-8")
        bench.check("Why there is no picture" in text and "match" in text, f"{folder} does not say why")
        bench.check("class=\"viewer\"" not in text and "gray.pgm" in text, f"{folder} shows what is not there")


def refuses(bench, source, target):
    bench.path("file").write_text("mine", encoding="utf-8")
    bench.keeps(("file",), "gcpw_pair", source, target, "--report=file", says="file")
    bench.keeps((source, target), "gcpw_pair", source, target, "--report=photos", says="photos")


def test(bench):
    source, target = bench.synthetic_pair()
    bench.run("gcpw_pair", source, target, *QUICK, "--output=pair.png", "--report=pair")
    bench.run("gcpw_stitch", source, target, *QUICK, "--output=panorama.png", "--report=panorama")
    bench.run("gcpw_stitch", source, target, "--method=none", "--output=plain.png", "--report=plain")
    bench.run("gcpw_pair", source, target, *QUICK, "--blend=average", "--output=mean.png", "--report=mean")
    holds_everything(bench, "pair", "Homography", "GCPW")
    holds_everything(bench, "panorama", "cv::Stitcher", "GCPW")
    for folder, output, is_cropped in (("pair", "pair.png", False), ("panorama", "panorama.png", True), ("plain", "plain.png", True)):
        shows_what_was_written(bench, folder, output, is_cropped)
    plain = bench.path("plain/index.html").read_text(encoding="utf-8")
    bench.check("id=\"split\"" not in plain and "class=\"viewer\"" in plain, "OpenCV alone is compared with itself")
    tells_failure(bench, source)
    refuses(bench, source, target)
    if browser.chromium():
        works(bench, "pair")
        works(bench, "panorama")


if __name__ == "__main__":
    BENCH = Bench(*sys.argv[1:4])
    test(BENCH)
    for fault in BENCH.faults:
        print(fault)
    print(f"{len(BENCH.faults)} faults")
    if not BENCH.faults and not browser.chromium():
        print("There is no Chromium (Debian: chromium): the pages were read, but not opened.")
        sys.exit(SKIPPED)
    sys.exit(1 if BENCH.faults else 0)
