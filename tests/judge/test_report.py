"""`surehit report`: what its document says, and how the page draws it in a browser.

    test_report.py SUREHIT [LIBRARY]
    test_report.py --picture REPORT.html PICTURE.png

LIBRARY is a candidate (tests/judge/candidates/one.c as it was built). Where Chromium is installed,
the page is opened in it at three widths, light and dark. REPORT_PICTURES=FOLDER keeps what is seen
there. The second form makes docs/report.png."""

import base64
import contextlib
import decimal
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from shapes import SHAPES  # noqa: E402

SUREHIT = os.path.abspath(sys.argv[1])
LIBRARY = os.path.abspath(sys.argv[2]) if len(sys.argv) > 2 else None
REFERENCE = os.path.join(os.path.dirname(SUREHIT), "../../reference/surehit-reference")
HAS_REFERENCE = os.access(REFERENCE, os.X_OK)
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
PICTURES = os.environ.get("REPORT_PICTURES")
TIERS = ["float32", "textbook", "stable", "certain", "exact"]
PROMISING = ["certain", "exact"]  # what is said of them must not come from them
COUNT = 40
AS_MANY = 3  # times as many cases for them
WIDTHS = [360, 768, 1280]
LEAST_CONTRAST = 4.5  # WCAG 2.1, 1.4.3
LONGEST = 2600  # of a picture that is kept
EXTREME = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes", "extreme")
SOME = ["coincident", "ground", "on_cone", "on_sphere_without", "solids_1e9", "sphere_1e7",
        "ulp_apart"]
DRAWN = (80, 50)  # pixels of their pictures
ROUNDS = 3


def run(*words, status=0, program=SUREHIT, **more):
    got = subprocess.run([program, *words], capture_output=True, text=True, **more)
    if got.returncode != status:
        raise AssertionError(f"{words}: status {got.returncode}: {got.stderr}")
    return got


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def report(folder, *words, **more):
    """The document; the page is beside it."""
    path = os.path.join(folder, "report.json")
    run("report", "-o", os.path.join(folder, "report.html"), "--json", path, *words, **more)
    return json.loads(read(path))


def candidates(document):
    return {who["name"]: who for who in document["candidates"]}


def counts(who):
    """Of each shape and regime: what does not hang on the machine."""
    return {(row["shape"], row["regime"]):
            {key: row[key] for key in ("cases", "valid", "wrong", "unasked")}
            for row in who["rows"]}


def luminance(colour):
    parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a, b):
    low, high = sorted([luminance(a), luminance(b)])
    return (high + 0.05) / (low + 0.05)


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        # The browser may still be writing there.
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)


class Words(InFolder):
    def test_help(self):
        self.assertIn("--candidate=FILE", run("report", "--help").stdout)

    def test_wrong_usage(self):
        for words in ([], ["-o"], ["-o", "x.html", "--tier", "best"],
                      ["-o", "x.html", "--count", "0"], ["-o", "x.html", "--processes", "0"],
                      ["-o", "x.html", "--shape", "plane", "--regime", "apex"],
                      ["-o", "x.html", "--scenes"], ["-o", "x.html", "y.html"]):
            got = run("report", *words, status=2)
            self.assertEqual(len(got.stderr.splitlines()), 1, got.stderr)

    def test_no_place(self):
        run("report", "-o", os.path.join(self.folder, "none", "x.html"), status=1)

    def test_who_cannot_be_asked(self):
        path = os.path.join(self.folder, "x.json")
        missing = os.path.join(self.folder, "<missing>.so")
        got = run("report", "-o", os.path.join(self.folder, "x.html"), "--json", path, "--tier",
                  "stable", "--candidate", missing, "--shape", "plane", "--count", "5", status=1)
        self.assertIn("<missing>.so", got.stderr)
        who = candidates(json.loads(read(path)))
        self.assertIn("<missing>.so", who["<missing>"]["trouble"])
        self.assertEqual(who["<missing>"]["rows"], [])
        self.assertIsNone(who["stable"]["trouble"])

    def test_scenes_that_cannot_be_read(self):
        """The file is named, before anything is judged, and the page stays as it was."""
        page = os.path.join(self.folder, "x.html")
        scenes = os.path.join(self.folder, "scenes")

        def refused(named):
            got = run("report", "-o", page, "--scenes", scenes, "--count", "1000000", status=2,
                      timeout=60)
            self.assertEqual(len(got.stderr.splitlines()), 1, got.stderr)
            self.assertTrue(got.stderr.startswith(named), got.stderr)
            self.assertEqual(got.stdout, "")

        refused(f"{scenes}: error: cannot be read: ")
        os.mkdir(scenes)
        refused(f"{scenes}: error: no scene in it (*.rt)")
        shutil.copy(os.path.join(EXTREME, "up.rt"), scenes)
        with open(os.path.join(scenes, "wrong.rt"), "w", encoding="ascii") as file:
            file.write("A 1 9,9,9\nL 0,9,0 1\nC 0,0,0 0,0,-1 70\nsp 0,0,-3\n")
        self.assertEqual(os.listdir(self.folder), ["scenes"])
        with open(page, "w", encoding="ascii") as file:
            file.write("old")
        refused(os.path.join(scenes, "wrong.rt") + ":4:")
        with open(page, encoding="ascii") as file:
            self.assertEqual(file.read(), "old")
        self.assertEqual(sorted(os.listdir(self.folder)), ["scenes", "x.html"])


def read_ppm(path):
    """The pixels, three bytes each."""
    with open(path, "rb") as file:
        head, size, levels, data = file.read().split(b"\n", 3)
    width, height = map(int, size.split())
    if (head, levels, len(data)) != (b"P6", b"255", 3 * width * height):
        raise AssertionError(f"{path}: no picture")
    return [data[i:i + 3] for i in range(0, len(data), 3)]


def in_own_colours(scene):
    """The scene with an object told by its colour alone: no lights, no mirrors."""
    lines, objects = ["A 1 255,255,255"], 0
    for line in scene.splitlines():
        words = line.split()
        if words and words[0] in ("pl", "sp", "cy", "co"):
            objects += 1
            least = {"pl": 3, "sp": 3, "cy": 5, "co": 5}[words[0]]
            lines.append(" ".join(words[:least] + [f"{objects},255,{255 - objects}"]))
        elif words and words[0] == "C":
            lines.append(line)
    return "\n".join(lines) + "\n"


class Scenes(InFolder):
    """--scenes: every scene of a folder by every tier."""

    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.shared, ignore_errors=True)
        cls.scenes = os.path.join(cls.shared, "scenes")
        os.mkdir(cls.scenes)
        for name in SOME:
            shutil.copy(os.path.join(EXTREME, name + ".rt"), cls.scenes)
        for name in ("a<b&c.rt", "Up.rt"):
            shutil.copy(os.path.join(EXTREME, "up.rt"), os.path.join(cls.scenes, name))
        for name in (".hidden.rt", "notes.txt", ".rt"):
            with open(os.path.join(cls.scenes, name), "w", encoding="ascii") as file:
                file.write("no scene\n")
        cls.found = report(cls.shared, "--tier", "textbook", "--shape", "plane", "--count", "1",
                           "--scenes", cls.scenes)
        cls.rows = {row["name"]: row for row in cls.found["scenes"]["rows"]}

    def test_command(self):
        self.assertIn(f"--scenes {self.scenes}", self.found["command"])

    def test_not_asked(self):
        found = report(self.folder, "--tier", "textbook", "--shape", "plane", "--count", "1")
        self.assertIsNone(found["scenes"])

    def test_every_scene_in_order(self):
        self.assertEqual([row["name"] for row in self.found["scenes"]["rows"]],
                         ["Up", "a<b&c", *SOME])
        self.assertEqual(self.found["scenes"]["tiers"], TIERS)
        self.assertEqual((self.found["scenes"]["width"], self.found["scenes"]["height"]), DRAWN)

    def drawn(self, scene, tier):
        path = os.path.join(self.folder, tier + ".ppm")
        run("render", scene, "-o", path, "--tier", tier, "--size", "%dx%d" % DRAWN, "--quiet")
        return read_ppm(path)

    def test_wrong_pixels(self):
        """As pictures have them in which each object has its own colour."""
        scene = os.path.join(self.folder, "own.rt")
        for name in SOME:
            text = in_own_colours(read(os.path.join(self.scenes, name + ".rt")))
            with open(scene, "w", encoding="ascii") as file:
                file.write(text)
            right = self.drawn(scene, "exact")
            expected = [sum(a != b for a, b in zip(self.drawn(scene, tier), right))
                        for tier in TIERS]
            self.assertEqual(self.rows[name]["wrong_pixels"], expected, name)

    def test_what_parts_them(self):
        """That there is something to be seen, and that certain is never wrong."""
        by_tier = list(zip(*[self.rows[name]["wrong_pixels"] for name in SOME]))
        self.assertGreater(min(sum(wrong) for wrong in by_tier[:3]), 0)
        self.assertEqual(set(by_tier[3]), {0})
        self.assertEqual(self.rows["Up"]["wrong_pixels"], [0] * len(TIERS))

    def test_times(self):
        """By far less than ten times what the whole command takes for a pixel."""
        times = self.rows["on_cone"]["nanoseconds_a_pixel"]
        self.assertGreater(times[-1], times[1])  # tens of times
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        size = (400, 250)
        run("render", os.path.join(EXTREME, "on_cone.rt"), "-o",
            os.path.join(self.folder, "x.ppm"), "--tier", "exact", "--threads", "1", "--size",
            "%dx%d" % size, "--quiet")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        taken = 1e9 * (after.ru_utime - before.ru_utime) / (size[0] * size[1])
        self.assertGreater(times[-1], taken / 10)
        self.assertLess(times[-1], taken * 10)


class Content(InFolder):
    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.shared, ignore_errors=True)
        tiers = [word for tier in TIERS for word in ("--tier", tier)]
        library = ["--candidate", LIBRARY] if LIBRARY else []
        cls.found = report(cls.shared, *tiers, *library, "--count", str(COUNT), "--seed", "3")
        cls.who = candidates(cls.found)
        cls.page = read(os.path.join(cls.shared, "report.html"))

    def test_the_page_holds_the_document(self):
        (text,) = re.findall(r"<script type=\"application/json\" id=report>(.*?)</script>",
                             self.page, re.S)
        self.assertEqual(json.loads(text), self.found)
        self.assertNotIn("<", text)

    def test_nothing_from_outside(self):
        code = re.sub(r"<script type=\"application/json\".*?</script>", "", self.page, flags=re.S)
        for word in (" src=", "<link", "<iframe", "url(", "@import", "fetch(", "XMLHttp",
                     "@SCRIPT@", "https:"):
            self.assertNotIn(word, code)
        self.assertEqual(set(re.findall("http:[^']*", code)), {"http://www.w3.org/2000/svg"})

    def test_every_name_is_explained(self):
        for regime in self.found["regimes"]:
            self.assertIn(f"    {regime['name']}: '", self.page)
        for tier in TIERS:
            self.assertIn(f"    {tier}: '", self.page)

    def test_rows_are_what_the_judge_says(self):
        for tier in ("textbook", "float32"):
            path = os.path.join(self.folder, "verdict.json")
            run("judge", "--tier", tier, "--count", str(COUNT), "--seed", "3", "--json", path)
            expected = counts(json.loads(read(path)))
            of = counts(self.who[tier])
            for pair, row in expected.items():
                if pair[1] in ("typical", "bits", "degenerate"):
                    continue # of other counts
                self.assertEqual(of.get(pair, dict.fromkeys(row, 0)), row, (tier, pair))
            self.assertLessEqual(set(of), set(expected))

    @unittest.skipUnless(HAS_REFERENCE, "no reference")
    def test_certain_is_never_wrong(self):
        for tier in PROMISING:
            self.assertGreater(len(self.who[tier]["rows"]), 100)
            for row in self.who[tier]["rows"]:
                self.assertEqual((row["wrong"], row["breaches"]), (0, 0), row)

    @unittest.skipUnless(HAS_REFERENCE, "no reference")
    def test_who_is_held_against_what(self):
        """And over how many cases."""
        special = {"typical": 20 * COUNT, "bits": COUNT // 4, "degenerate": COUNT // 4}
        cases = {regime["name"]: regime["cases"] for regime in self.found["regimes"]}
        self.assertEqual(cases, {name: special.get(name, COUNT) for name in cases})
        self.assertEqual(self.found["reference_cases"], AS_MANY)
        for tier in TIERS:
            promises = tier in PROMISING
            self.assertEqual(self.who[tier]["truth"], "reference" if promises else "exact")
            for row in self.who[tier]["rows"] if tier != "float32" else []:
                self.assertEqual(row["cases"], cases[row["regime"]] * (AS_MANY if promises else 1))

    def report_alone(self):
        """By a program that finds no reference but what lies beside it, on planes."""
        program = os.path.join(self.folder, "surehit")
        shutil.copy(SUREHIT, program)
        return candidates(report(
            self.folder, *[word for tier in TIERS for word in ("--tier", tier)], "--shape", "plane",
            "--count", str(COUNT), "--seed", "3", program=program,
            env={"PATH": "/usr/bin:/bin",
                 "LD_LIBRARY_PATH": os.path.join(os.path.dirname(SUREHIT), os.pardir)}))

    def test_the_reference_is_asked(self):
        """One that says miss to everything contradicts certain and exact, and nobody else."""
        reference = os.path.join(self.folder, "surehit-reference")
        with open(reference, "w", encoding="ascii") as script:
            script.write("#!/bin/sh\nexec sed 's/.*/miss/'\n")
        os.chmod(reference, 0o755)
        who = self.report_alone()
        for tier in PROMISING:
            for row in who[tier]["rows"]:
                self.assertGreater(10 * row["wrong"], row["valid"], row)
        textbook = {pair: row for pair, row in counts(self.who["textbook"]).items()
                    if pair[0] == "plane"}
        self.assertEqual(counts(who["textbook"]), textbook)

    def test_without_the_reference(self):
        """It says what its word on itself is worth."""
        who = self.report_alone()
        self.assertEqual({name: one["truth"] for name, one in who.items()},
                         {**dict.fromkeys(TIERS, "exact"), **dict.fromkeys(PROMISING, "like")})

    def test_times_are_of_hits_alone(self):
        """The candidate gives normals, and is marked; no tier is."""
        for name, who in self.who.items():
            self.assertEqual(who["with_normals"], name not in TIERS)
            typical = [row["nanoseconds"] for row in who["rows"] if row["regime"] == "typical"]
            self.assertEqual(len(typical), len(SHAPES))
            self.assertGreater(min(typical), 0)

    def test_same_command_same_decisions(self):
        again = report(self.folder, "--tier", "stable", "--shape", "cone", "--count", str(COUNT),
                       "--seed", "3", "--processes", "1")
        cone = {pair: row for pair, row in counts(self.who["stable"]).items() if pair[0] == "cone"}
        self.assertEqual(counts(candidates(again)["stable"]), cone)

    def test_pictures(self):
        """All pixels, and where they should be the same."""
        self.assertEqual(len(self.found["pictures"]), 2)
        for scene in self.found["pictures"]:
            drawn = {tier: base64.b64decode(text, validate=True)
                     for tier, text in scene["tiers"].items()}
            self.assertEqual(list(drawn), TIERS)
            for rgb in drawn.values():
                self.assertEqual(len(rgb), 3 * scene["width"] * scene["height"])
            path = os.path.join(self.folder, "scene.rt")
            with open(path, "w", encoding="ascii") as file:
                file.write(scene["file"])
            for tier in TIERS:
                picture = os.path.join(self.folder, "x.ppm")
                run("render", path, "-o", picture, "--tier", tier, "--quiet")
                self.assertEqual(drawn[tier], b"".join(read_ppm(picture)))
            self.assertEqual([tier for tier in TIERS if drawn[tier] == drawn["exact"]], TIERS[2:])

    def test_contrast(self):
        style = self.page[:self.page.index("</style>")]
        modes = re.findall(r":root\{[^}]*", style)
        self.assertEqual(len(modes), 2)
        for mode in modes:
            colour = dict(re.findall(r"--(\w+):(#\w{6})", mode))
            pairs = [(f"h{i}", f"t{i}") for i in range(1, 6)]
            pairs += [("paper", name) for name in ("ink", "soft", "tier", "peer", "hard")]
            for a, b in pairs:
                self.assertGreaterEqual(contrast(colour[a], colour[b]), LEAST_CONTRAST, (a, b))


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


# What sticks out of the page: nothing may but inside a box that scrolls by itself.
STICKS_OUT = """[...document.querySelectorAll('body *')].filter(e => {
    const r = e.getBoundingClientRect();
    return r.width > 0 && (r.right > innerWidth + 0.5 || r.left < -0.5) &&
           !e.closest('.box, pre');
}).map(e => e.outerHTML.slice(0, 80))"""
# Letters of a drawing that are too small to be read, in CSS pixels.
SMALLEST = """Math.min(...[...document.querySelectorAll('svg text')].map(
    e => parseFloat(getComputedStyle(e).fontSize) * Math.hypot(e.getScreenCTM().a,
                                                               e.getScreenCTM().b)))"""
LEAST_LETTER = 8.5
OUT_OF_DRAWING = """[...document.querySelectorAll('svg text')].filter(e => {
    const r = e.getBoundingClientRect(), s = e.ownerSVGElement.getBoundingClientRect();
    return r.left < s.left - 1 || r.right > s.right + 1 || r.bottom > s.bottom + 1 ||
           r.top < s.top - 2;
}).map(e => e.textContent)"""
WIDEST_NAME = """Math.max(...[...document.querySelectorAll('.trade tbody th')].map(
    e => e.getBoundingClientRect().width))"""
# Names in a plane as the browser's own letters make them.
ON_EACH_OTHER = """[...document.querySelectorAll('svg.plane')].flatMap(s => {
    const all = [...s.querySelectorAll('text.name')].map(e => [e.getBoundingClientRect(), e]);
    return all.flatMap(([a, e], i) => all.slice(0, i).filter(([b]) =>
        Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 &&
        Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 0.35 * a.height)
        .map(([, f]) => e.textContent + ' on ' + f.textContent));
})"""


# What the page says: of the glance its cells, of each shape the cells of the map and the points of
# the planes as [name, time, wrong, x, y].
GLANCE = """Object.fromEntries([...document.querySelectorAll('#glance tbody tr')].map(
    r => [r.cells[0].textContent, [...r.cells].slice(1).map(c => c.textContent)]))"""
MAP = """(() => {
    const [top, ...rows] = document.querySelectorAll('#%s .heat tr');
    const names = [...top.cells].map(c => c.textContent);
    return rows.flatMap(r => [...r.cells].slice(2).map((c, i) =>
        [r.cells[0].textContent, names[i + 2], c.textContent, c.className]));
})()"""
POINTS = """[...document.querySelectorAll('#%s .plane')].map(
    s => [...s.querySelectorAll('g')].map(g => {
    const [all, name, time, wrong] = g.querySelector('title').textContent.match(
        /^(.*): (.*) a ray; wrong decisions[^:]*: (.*)$/);
    const r = g.querySelector('.dot').getBoundingClientRect();
    return [name, time, wrong, r.left + r.width / 2, r.top + r.height / 2];
}))"""
UNITS = {"ns": 1, "µs": 1e3, "ms": 1e6}


def percent(share):
    """Rounded as JavaScript does."""
    of100 = decimal.Decimal(100 * share)
    places = "0.01" if of100 < 0.995 else "0.1" if of100 < 9.95 else "1"
    return ("0" if share == 0 else "<0.01" if of100 < 0.005 else
            str(of100.quantize(decimal.Decimal(places), decimal.ROUND_HALF_UP)))


@unittest.skipUnless(CHROMIUM, "Chromium is not installed")
class InBrowser(InFolder):
    def test_what_it_says(self):
        found = report(self.folder, "--count", str(COUNT))
        browser = Browser()
        self.addCleanup(browser.close)
        browser.show(os.path.join(self.folder, "report.html"), WIDTHS[-1], "light")
        who = candidates(found)
        glance = browser.value(GLANCE)
        self.assertEqual(list(glance), list(who))
        for name, cells in glance.items():
            self.assertEqual([cell == "–" for cell in cells],
                             2 * [not any(row["shape"] == shape for row in who[name]["rows"])
                                  for shape in SHAPES])
        for shape in SHAPES:
            cells = browser.value(MAP % shape)
            self.assertGreater(len(cells), 100)
            for regime, name, text, kind in cells:
                self.check_cell(who[name], shape, regime, text, kind)
            planes = browser.value(POINTS % shape)
            self.assertEqual(len(planes), 2)
            for points in planes:
                self.assertGreaterEqual(len(points), len(TIERS))
                self.check_points(points)

    def check_cell(self, who, shape, regime, text, kind):
        rows = [row for row in who["rows"] if (row["shape"], row["regime"]) == (shape, regime)]
        share = rows[0]["wrong"] / rows[0]["valid"] if rows and rows[0]["valid"] else 0
        mark = "†" if rows and rows[0]["breaches"] + rows[0]["unasked"] else ""
        self.assertEqual(text, percent(share) + mark if rows else "", (who["name"], shape, regime))
        self.assertEqual(kind, f"h{sum(share > most for most in (0, 1e-3, 1e-2, 5e-2, 0.2))}")

    def check_points(self, points):
        """Farther right is slower, higher is wrong more often, and those who are never wrong are on
        one line, below."""
        placed = []
        for _, time_text, wrong, x, y in points:
            number, unit = time_text.split()
            placed.append((float(number) * UNITS[unit],
                           0 if wrong.startswith("none") else float(wrong.replace(",", "")), x, y))
        for one in placed:
            for other in placed:
                if one[0] > 1.1 * other[0]: # as far as a rounded time tells
                    self.assertGreater(one[2], other[2])
                if one[1] > other[1]:
                    self.assertLess(one[3], other[3])
                if one[1] == other[1] == 0:
                    self.assertAlmostEqual(one[3], other[3], delta=0.5)

    def test_looks(self):
        scenes = os.path.join(self.folder, "scenes")
        os.mkdir(scenes)
        for name in (*SOME, "n" * 100):
            shutil.copy(os.path.join(EXTREME, (name if name in SOME else "up") + ".rt"),
                        os.path.join(scenes, name + ".rt"))
        report(self.folder, "--count", "20", "--scenes", scenes)
        path = os.path.join(self.folder, "report.html")
        browser = Browser()
        self.addCleanup(browser.close)
        for scheme in ("light", "dark"):
            for width in WIDTHS:
                with self.subTest(width=width, scheme=scheme):
                    self.look(browser, path, width, scheme)
                    # A name that stays in sight leaves room for what scrolls beneath it.
                    self.assertLess(browser.value(WIDEST_NAME), width / 2)

    def look(self, browser, path, width, scheme):
        browser.show(path, width, scheme)
        self.assertEqual(browser.value("innerWidth"), width)
        self.assertLessEqual(browser.value("document.documentElement.scrollWidth"), width)
        self.assertEqual(browser.value(STICKS_OUT), [])
        self.assertEqual(browser.value(OUT_OF_DRAWING), [])
        self.assertEqual(browser.value(ON_EACH_OTHER), [])
        self.assertGreaterEqual(browser.value(SMALLEST), LEAST_LETTER)
        self.assertEqual(browser.value("document.querySelectorAll('canvas').length"),
                         2 * (2 * len(TIERS) - 1))
        paper = browser.value("getComputedStyle(document.body).backgroundColor")
        self.assertEqual(paper == "rgb(255, 255, 255)", scheme == "light")
        for event in browser.events:
            self.assertNotIn(event.get("method"), ("Runtime.exceptionThrown",
                                                   "Runtime.consoleAPICalled", "Log.entryAdded"))
            if event.get("method") == "Network.requestWillBeSent":
                self.assertRegex(event["params"]["request"]["url"], "^(file|data):")
        for number, picture in enumerate(browser.pictures(width) if PICTURES else []):
            name = os.path.join(PICTURES, f"report-{width}-{scheme}-{number}.png")
            with open(name, "wb") as file:
                file.write(picture)


def picture_of(page, path):
    """The sphere's planes, map and histograms."""
    with contextlib.closing(Browser()) as browser:
        browser.show(os.path.abspath(page), 1200, "light")
        place = "document.querySelector('%s').getBoundingClientRect().%s"
        top = browser.value(place % ("#sphere h2", "top"))
        bottom = browser.value(place % ("#sphere .wide", "bottom"))
        with open(path, "wb") as file:
            file.write(browser.picture(1200, top - 10, bottom + 10))


if sys.argv[1] == "--picture":
    picture_of(*sys.argv[2:])
elif __name__ == "__main__":
    result = unittest.main(argv=sys.argv[:1], exit=False).result
    failed = len(result.failures) + len(result.errors)
    print(f"{result.testsRun - failed - len(result.skipped)} passed, {failed} failed")
    sys.exit(1 if failed else 0)
