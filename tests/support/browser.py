"""Pages as a browser shows them, where Chromium is installed: headless, narrow and wide, light and
dark."""

import base64
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
SCHEMES = ["light", "dark"]
LEAST_CONTRAST = 4.5  # WCAG 2.1, 1.4.3
LONGEST = 2600  # of a picture that is kept

# What sticks out of the page: nothing may but inside what scrolls by itself.
STICKS_OUT = """[...document.querySelectorAll('body *')].filter(e => {
    const r = e.getBoundingClientRect();
    return r.width > 0 && (r.right > innerWidth + 0.5 || r.left < -0.5) && !e.closest('%s');
}).map(e => e.outerHTML.slice(0, 80))"""
COMPLAINTS = ("Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded")


def luminance(colour):
    parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a, b):
    low, high = sorted([luminance(a), luminance(b)])
    return (high + 0.05) / (low + 0.05)


def check_contrast(test, page, pairs):
    """Of the colours, by their names in a style, for light and dark."""
    modes = re.findall(r":root\{[^}]*", page)
    test.assertEqual(len(modes), 2)
    for mode in modes:
        colour = dict(re.findall(r"--(\w+):(#\w{6})", mode))
        for a, b in pairs:
            test.assertGreaterEqual(contrast(colour[a], colour[b]), LEAST_CONTRAST, (a, b))


class Browser:
    """Headless Chromium, spoken to through two pipes (the DevTools protocol).

    It has a profile and a session of its own: its processes write to the profile until each of
    them is killed, not only the first."""

    def __init__(self):
        to_browser, from_browser = os.pipe(), os.pipe()
        ends = to_browser[0], from_browser[1]

        def attach():
            there = [os.dup(end) for end in ends]
            high = [os.dup2(end, 20 + i, True) for i, end in enumerate(there)]
            os.dup2(high[0], 3, True)
            os.dup2(high[1], 4, True)

        self.profile = tempfile.mkdtemp(prefix="browser.")
        self.process = subprocess.Popen(
            [CHROMIUM, "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
             "--disable-dev-shm-usage", "--remote-debugging-pipe",
             f"--user-data-dir={self.profile}"],
            preexec_fn=attach, close_fds=False, start_new_session=True,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for end in ends:
            os.close(end)
        self.to, self.back = os.fdopen(to_browser[1], "wb"), os.fdopen(from_browser[0], "rb")
        self.count, self.waiting, self.events = 0, b"", []
        try:
            self.open_page()
        except (EOFError, BrokenPipeError): # it has ended by itself
            self.close()
            raise

    def open_page(self):
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(domain + ".enable")

    session = None

    def read(self):
        while b"\0" not in self.waiting:
            more = os.read(self.back.fileno(), 65536)
            if not more:
                raise EOFError("the browser has ended")
            self.waiting += more
        message, self.waiting = self.waiting.split(b"\0", 1)
        return json.loads(message)

    def ask(self, method, **params):
        self.count += 1
        question = {"id": self.count, "method": method, "params": params}
        if self.session:
            question["sessionId"] = self.session
        self.to.write(json.dumps(question).encode() + b"\0")
        self.to.flush()
        while True:
            message = self.read()
            if message.get("id") == self.count:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']}")
                return message["result"]
            self.events.append(message)

    def show(self, path, width, scheme):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=800,
                 deviceScaleFactor=1, mobile=width < 700)
        self.ask("Emulation.setEmulatedMedia",
                 features=[{"name": "prefers-color-scheme", "value": scheme}])
        self.events.clear()
        self.ask("Page.navigate", url="file://" + path)
        while not any(e.get("method") == "Page.loadEventFired" for e in self.events):
            self.events.append(self.read())

    def check(self, test, path, width, scheme, scrolls):
        """Shows the page, which is as wide as that, in its scheme, and asks for nothing from
        outside."""
        self.show(path, width, scheme)
        test.assertEqual(self.value("innerWidth"), width)
        test.assertLessEqual(self.value("document.documentElement.scrollWidth"), width)
        test.assertEqual(self.value(STICKS_OUT % scrolls), [])
        paper = self.value("getComputedStyle(document.body).backgroundColor")
        test.assertEqual(paper == "rgb(255, 255, 255)", scheme == "light")
        test.assertTrue(self.events)
        for event in self.events:
            test.assertNotIn(event.get("method"), COMPLAINTS)
            if event.get("method") == "Network.requestWillBeSent":
                test.assertRegex(event["params"]["request"]["url"], "^(file|data):")

    def value(self, expression):
        return self.ask("Runtime.evaluate", expression=expression,
                        returnByValue=True)["result"]["value"]

    def picture(self, width, top, bottom):
        clip = {"x": 0, "y": top, "width": width, "height": bottom - top, "scale": 1}
        shot = self.ask("Page.captureScreenshot", captureBeyondViewport=True, clip=clip)
        return base64.b64decode(shot["data"])

    def pictures(self, width):
        """The page in pieces, from the top: a longer picture stays empty."""
        height = self.value("document.documentElement.scrollHeight")
        for top in range(0, height, LONGEST):
            yield self.picture(width, top, min(top + LONGEST, height))

    def close(self):
        os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        self.to.close()
        self.back.close()
        # A killed process may still end the call it is in, which may make a file.
        patience = time.monotonic() + 10
        while os.path.exists(self.profile):
            shutil.rmtree(self.profile, ignore_errors=time.monotonic() < patience)
