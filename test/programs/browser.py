# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""A page in headless Chromium, driven over the DevTools protocol through two pipes: nothing but Python's own library is needed."""
import base64
import contextlib
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

PATIENCE = 60  # s for an answer, on a busy machine
TO_BROWSER, FROM_BROWSER = 3, 4  # file descriptors that --remote-debugging-pipe speaks of


def chromium():
    """The path of the browser, or nothing."""
    return next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


class Page:
    """One page, what its console said, and what it asked the network for."""

    def __init__(self, out, answers):
        self.pipes = out, answers
        self.session = None
        self.count = 0
        self.rest = b""
        self.console = []
        self.requests = []
        self.loaded = False

    def send(self, method, **parameters):
        """Calls a method of the protocol and waits for its result."""
        self.count += 1
        message = {"id": self.count, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.pipes[0], json.dumps(message).encode() + b"\0")
        return self.wait(lambda answer: answer.get("id") == message["id"])

    def wait(self, wanted):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            answer = self.receive(end)
            if wanted(answer):
                if "error" in answer:
                    raise RuntimeError(answer["error"])
                return answer.get("result", {})
        raise TimeoutError("the browser does not answer")

    def receive(self, end):
        while b"\0" not in self.rest:
            if not select.select([self.pipes[1]], [], [], max(0, end - time.monotonic()))[0]:
                raise TimeoutError("the browser does not answer")
            part = os.read(self.pipes[1], 1 << 16)
            if not part:
                raise EOFError("the browser has ended")
            self.rest += part
        message, _, self.rest = self.rest.partition(b"\0")
        answer = json.loads(message)
        self.note(answer.get("method"), answer.get("params", {}))
        return answer

    def note(self, method, event):
        if method == "Runtime.exceptionThrown":
            self.console.append(event["exceptionDetails"].get("exception", {}).get("description", "an exception"))
        elif method == "Runtime.consoleAPICalled" and event["type"] in ("error", "warning", "assert"):
            self.console.append(str([argument.get("value") for argument in event["args"]]))
        elif method == "Log.entryAdded" and event["entry"]["level"] in ("error", "warning"):
            self.console.append(event["entry"]["text"])
        elif method == "Network.requestWillBeSent":
            self.requests.append(event["request"]["url"])
        elif method == "Page.loadEventFired":
            self.loaded = True

    def open(self, url):
        target = self.send("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.send("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.send(domain + ".enable")
        self.loaded = False
        self.send("Page.navigate", url=url)
        while not self.loaded:
            self.receive(time.monotonic() + PATIENCE)

    def value(self, expression):
        """What a JavaScript expression gives."""
        answer = self.send("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def press(self, key, code):
        """A key on the keyboard, e.g. ArrowRight, 39."""
        for kind in ("keyDown", "keyUp"):
            self.send("Input.dispatchKeyEvent", type=kind, key=key, code=key, windowsVirtualKeyCode=code)

    def drag(self, start, end):
        """The mouse from one point to another, button held down."""
        for kind, (x, y), buttons in (("mousePressed", start, 1), ("mouseMoved", end, 1), ("mouseReleased", end, 0)):
            self.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=buttons, clickCount=1)

    def size(self, width, height):
        self.send("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def dark(self, is_dark):
        self.send("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark" if is_dark else "light"}])

    def screenshot(self, path):
        data = self.send("Page.captureScreenshot", format="png", captureBeyondViewport=False)["data"]
        path.write_bytes(base64.b64decode(data))


@contextlib.contextmanager
def page():
    """A page of a browser that lives as long as the block."""
    profile = tempfile.mkdtemp(prefix="gcpw_browser_")
    down, up = os.pipe(), os.pipe()

    def take_pipes():
        # Away from 3 and 4 first: a pipe may have either number.
        read, write = os.dup(down[0]), os.dup(up[1])
        read, write = (os.dup2(fd, fd + 50) for fd in (read, write))
        os.dup2(read, TO_BROWSER)
        os.dup2(write, FROM_BROWSER)

    command = [chromium(), "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-dev-shm-usage",
               "--remote-debugging-pipe", "--user-data-dir=" + profile, "about:blank"]
    # pylint: disable=subprocess-popen-preexec-fn
    browser = subprocess.Popen(command, preexec_fn=take_pipes, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(down[0])
    os.close(up[1])
    try:
        yield Page(down[1], up[0])
    finally:
        os.close(down[1])
        os.close(up[0])
        browser.kill()
        browser.wait()
        shutil.rmtree(profile, ignore_errors=True)
