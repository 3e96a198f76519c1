"""`surehit report`: what the page says, and how it looks in a browser.

    test_report.py SUREHIT [LIBRARY]
    test_report.py --picture REPORT.html PICTURE.png

LIBRARY is a candidate (tests/judge/candidates/one.c as it was built). Where Chromium is installed,
the page is opened in it at three widths, light and dark. REPORT_PICTURES=FOLDER keeps what is seen
there. The second form makes docs/report.png."""

import base64
import contextlib
import html.parser
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

SUREHIT = os.path.abspath(sys.argv[1])
LIBRARY = os.path.abspath(sys.argv[2]) if len(sys.argv) > 2 else None
REFERENCE = os.path.join(os.path.dirname(SUREHIT), "../../reference/surehit-reference")
HAS_REFERENCE = os.access(REFERENCE, os.X_OK)
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
PICTURES = os.environ.get("REPORT_PICTURES")
TIERS = ["float32", "textbook", "stable", "certain", "exact"]
SHAPES = ["plane", "disc", "sphere", "cylinder", "cone"]
PROMISING = ["certain", "exact"]  # what is said of them must not come from them
COUNT = 40
AS_MANY = 3  # times as many cases for them
WIDTHS = [360, 768, 1280]
LEAST_CONTRAST = 4.5  # WCAG 2.1, 1.4.3
HALF_LETTER = 3.35  # of a name in a plane: as wide as a browser makes "textbook"
LONGEST = 2600  # of a picture that is kept
EXTREME = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes", "extreme")
SOME = ["coincident", "ground", "on_cone", "on_sphere_without", "solids_1e9", "sphere_1e7",
        "ulp_apart"]
DRAWN = (80, 50)  # pixels of their pictures
ROUNDS = 3
VOID = {"meta", "br", "img", "path", "circle"}


def run(*words, status=0, program=SUREHIT, **more):
    got = subprocess.run([program, *words], capture_output=True, text=True, **more)
    if got.returncode != status:
        raise AssertionError(f"{words}: status {got.returncode}: {got.stderr}")
    return got


def report(folder, *words, **more):
    path = os.path.join(folder, "report.html")
    run("report", "-o", path, *words, **more)
    with open(path, encoding="utf-8") as page:
        return page.read()


class Page(html.parser.HTMLParser):
    """The page as a list of elements; complains about tags out of step."""

    def __init__(self, text):
        super().__init__()
        self.open, self.found, self.tables, self.faults = [], [], [], []
        self.feed(text)
        self.close()
        self.faults += [f"<{tag}> is left open" for tag, _ in self.open]

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.found.append((tag, attrs))
        if tag == "table":
            self.tables.append((attrs.get("class"), []))
        if tag == "tr":
            self.tables[-1][1].append([])
        if tag in ("th", "td"):
            self.tables[-1][1][-1].append("")
        if tag not in VOID:
            self.open.append((tag, attrs))

    def handle_startendtag(self, tag, attrs):
        self.found.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        if not self.open or self.open[-1][0] != tag:
            self.faults.append(f"</{tag}> after {[t for t, _ in self.open[-3:]]}")
        else:
            self.open.pop()

    def handle_data(self, data):
        tags = [tag for tag, _ in self.open]
        if "table" in tags and ("td" in tags or "th" in tags) and "abbr" not in tags:
            self.tables[-1][1][-1][-1] += data

    def table(self, first):
        """The rows of the tables whose heads begin so, by their names."""
        return [{row[0]: row[1:] for row in rows} for _, rows in self.tables
                if [cell for row in rows for cell in row if cell][0] == first]

    def heat(self):
        """For each shape, in their order: {regime: {candidate: text of the cell}}."""
        maps = []
        for kind, rows in self.tables:
            if kind == "heat":
                names = rows[0][2:]
                maps.append({row[0]: dict(zip(names, row[2:])) for row in rows[1:]})
        return maps


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
        self.assertIn("--candidate FILE", run("report", "--help").stdout)

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
        path = os.path.join(self.folder, "x.html")
        missing = os.path.join(self.folder, "<missing>.so")
        got = run("report", "-o", path, "--tier", "stable", "--candidate", missing, "--shape",
                  "plane", "--count", "5", status=1)
        self.assertIn("<missing>.so", got.stderr)
        with open(path, encoding="utf-8") as page:
            text = page.read()
        self.assertIn("not asked: ", text)
        self.assertNotIn("<missing>", text)
        self.assertIn("&lt;missing&gt;", text)


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

    SCENES = f"scenes, of {len(SOME) + 2}"

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
        cls.text = report(cls.shared, "--tier", "textbook", "--shape", "plane", "--count", "1",
                          "--scenes", cls.scenes)
        cls.page = Page(cls.text)
        (cls.rows,) = [rows for kind, rows in cls.page.tables if kind == "trade"]
        cls.cells = {row[0]: row[1:] for row in cls.rows[2:]}
        cls.section = re.search("<section id=scenes>.*?</section>", cls.text, re.S)[0]

    def wrong(self, name):
        return [int(cell.replace(",", "")) for cell in self.cells[name][:len(TIERS) - 1]]

    def test_well_formed(self):
        self.assertEqual(self.page.faults, [])
        self.assertIn(("a", {"href": "#scenes"}), self.page.found)
        self.assertIn(f"--scenes {self.scenes}", self.text)

    def test_not_asked(self):
        text = report(self.folder, "--tier", "textbook", "--shape", "plane", "--count", "1")
        self.assertNotIn("scenes>", text)
        self.assertNotIn("#scenes", text)

    def test_every_scene_in_order(self):
        names = [row[0] for row in self.rows[2:]]
        self.assertEqual(names, ["Up", "a<b&c", *SOME, "all", self.SCENES])
        self.assertEqual(self.rows[1], ["scene", *TIERS, *TIERS])
        self.assertEqual({cells[len(TIERS) - 1] for cells in self.cells.values()}, {"="})

    def drawn(self, scene, tier):
        path = os.path.join(self.folder, tier + ".ppm")
        run("render", scene, "-o", path, "--tier", tier, "--size", "%dx%d" % DRAWN, "--quiet")
        return read_ppm(path)

    def test_wrong_pixels(self):
        """As pictures have them in which each object has its own colour."""
        scene = os.path.join(self.folder, "own.rt")
        for name in SOME:
            with open(os.path.join(self.scenes, name + ".rt"), encoding="ascii") as file:
                text = in_own_colours(file.read())
            with open(scene, "w", encoding="ascii") as file:
                file.write(text)
            right = self.drawn(scene, "exact")
            expected = [sum(a != b for a, b in zip(self.drawn(scene, tier), right))
                        for tier in TIERS[:-1]]
            self.assertEqual(self.wrong(name), expected, name)

    def test_what_parts_them(self):
        """That there is something to be seen, and that certain is never wrong."""
        by_tier = list(zip(*[self.wrong(name) for name in SOME]))
        self.assertGreater(min(sum(counts) for counts in by_tier[:3]), 0)
        self.assertEqual(set(by_tier[3]), {0})
        self.assertEqual(self.wrong("Up"), [0, 0, 0, 0])

    def test_sums(self):
        rows = [name for name in self.cells if name not in ("all", self.SCENES)]
        for tier, counts in enumerate(zip(*[self.wrong(name) for name in rows])):
            self.assertEqual(self.wrong("all")[tier], sum(counts))
            self.assertEqual(self.wrong(self.SCENES)[tier],
                             sum(count > 0 for count in counts))
        for column in range(len(TIERS), 2 * len(TIERS)):
            times = [float(self.cells[name][column]) for name in rows]
            # Each is rounded, to a tenth or finer.
            self.assertAlmostEqual(float(self.cells["all"][column]), sum(times) / len(times),
                                   delta=0.1)

    def test_colours(self):
        """A cell's colour tells the share of the pixels."""
        cells = re.findall(r"<td class=h(\d)>([\d,]+)</td>", self.section.split("class=sum")[0])
        self.assertEqual(len(cells), (len(SOME) + 2) * (len(TIERS) - 1))
        for level, text in cells:
            share = int(text.replace(",", "")) / (DRAWN[0] * DRAWN[1])
            self.assertEqual(int(level), sum(share > most for most in (0, 1e-3, 1e-2, 5e-2, 0.2)))

    def test_times(self):
        """In microseconds: by far less than ten times what the whole command takes for a pixel."""
        times = [float(cell) for cell in self.cells["on_cone"][len(TIERS):]]
        self.assertGreater(times[-1], times[1])  # tens of times
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        size = (400, 250)
        run("render", os.path.join(EXTREME, "on_cone.rt"), "-o",
            os.path.join(self.folder, "x.ppm"), "--tier", "exact", "--threads", "1", "--size",
            "%dx%d" % size, "--quiet")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        taken = 1e6 * (after.ru_utime - before.ru_utime) / (size[0] * size[1])
        self.assertGreater(times[-1], taken / 10)
        self.assertLess(times[-1], taken * 10)

    def test_how_it_was_counted(self):
        count, pixels = len(SOME) + 2, DRAWN[0] * DRAWN[1]
        self.assertIn(f"<p>{count} scenes by every tier", self.section)
        self.assertIn("%d × %d pixels" % DRAWN, self.section)
        self.assertIn(f"{pixels:,} a scene, {count * pixels:,} in all", self.section)
        self.assertIn(f"the median of {ROUNDS} rounds", self.section)


class Content(InFolder):
    @classmethod
    def setUpClass(cls):
        cls.shared = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.shared, ignore_errors=True)
        tiers = [word for tier in TIERS for word in ("--tier", tier)]
        library = ["--candidate", LIBRARY] if LIBRARY else []
        cls.text = report(cls.shared, *tiers, *library, "--count", str(COUNT), "--seed", "3")
        cls.page = Page(cls.text)

    def test_well_formed(self):
        self.assertEqual(self.page.faults, [])

    def test_nothing_from_outside(self):
        tags = {tag for tag, _ in self.page.found}
        self.assertFalse(tags & {"script", "link", "iframe", "object", "embed"}, tags)
        self.assertNotIn("url(", self.text)
        self.assertNotIn("@import", self.text)
        for tag, attrs in self.page.found:
            for name in ("src", "href"):
                value = attrs.get(name, "#")
                self.assertTrue(value.startswith(("#", "data:image/png;base64,")), value[:80])

    def test_every_link_leads_somewhere(self):
        places = {attrs["id"] for _, attrs in self.page.found if "id" in attrs}
        self.assertLessEqual(set(SHAPES), places)
        links = [attrs["href"][1:] for tag, attrs in self.page.found if tag == "a"]
        self.assertLessEqual(set(links), places)

    def test_planes(self):
        """A point a candidate in each of the two planes of a shape."""
        planes = re.findall(r"<svg class=plane.*?</svg>", self.text, re.S)
        self.assertEqual(len(planes), 2 * len(SHAPES))
        for plane in planes:
            for tier in TIERS:
                self.assertEqual(plane.count(f"<title>{tier}: "), 1)
        self.assertEqual(len(re.findall("<svg class=histogram", self.text)), len(SHAPES))

    def test_places_of_points(self):
        """Farther right is slower, higher is wrong more often, and who is never wrong is on the
        line that says so."""
        point = re.compile(r"<title>(\w+): ([\d.]+) (ns|µs|ms) a ray; wrong decisions[^:]*: "
                           r"([^<]*)<.*?class=dot cx=([\d.]+) cy=([\d.]+)")
        unit = {"ns": 1, "µs": 1e3, "ms": 1e6}
        for plane in re.findall(r"<svg class=plane.*?</svg>", self.text, re.S):
            points = [(float(time) * unit[of], 0 if wrong.startswith("none") else
                       float(wrong.replace(",", "")), float(x), float(y))
                      for _, time, of, wrong, x, y in point.findall(plane)]
            self.assertEqual(len(points), len(TIERS))
            none = float(re.search(r"class=none d='M\d+ (\d+)H", plane)[1])
            for time, wrong, x, y in points:
                self.assertEqual(wrong == 0, y == none)
                for other in points:
                    if time > 1.1 * other[0]:  # as far as a rounded time tells
                        self.assertGreater(x, other[2])
                    if wrong > other[1]:
                        self.assertLess(y, other[3])

    def test_names_are_apart(self):
        """No name in a plane lies on another."""
        place = re.compile(r"class=name x=([\d.]+) y=([\d.]+) text-anchor=middle>([^<]*)<")
        for plane in re.findall(r"<svg class=plane.*?</svg>", self.text, re.S):
            names = [(float(x), float(y), len(name)) for x, y, name in place.findall(plane)]
            self.assertGreaterEqual(len(names), len(TIERS))
            for i, (x, y, length) in enumerate(names):
                for other in names[:i]:
                    wide = HALF_LETTER * (length + other[2])
                    self.assertTrue(abs(y - other[1]) >= 10 or abs(x - other[0]) >= wide, names)

    def test_names_are_beside_their_points(self):
        """The point that is nearest to a name is its own, unless a line leads there."""
        group = re.compile(r"<title>.*?(class=lead.*?)?class=dot cx=([\d.]+) cy=([\d.]+).*?"
                           r"class=name x=([\d.]+) y=([\d.]+) text-anchor=middle>([^<]*)<")
        for plane in re.findall(r"<svg class=plane.*?</svg>", self.text, re.S):
            groups = group.findall(plane)
            self.assertEqual(len(groups), len(TIERS))
            for i, (led, _, _, x, y, name) in enumerate(groups):
                half = HALF_LETTER * len(name)
                distances = [((max(abs(float(px) - float(x)) - half, 0)) ** 2 +
                              (max(abs(float(py) - float(y) + 3.6) - 5.5, 0)) ** 2) ** 0.5
                             for _, px, py, _, _, _ in groups]
                others = min(distances[:i] + distances[i + 1:])
                self.assertGreater(others, 8 if led else distances[i] - 1, name)

    def test_cells_are_what_the_judge_says(self):
        for shape, heat in zip(SHAPES, self.page.heat()):
            for tier in ("textbook", "float32"):
                path = os.path.join(self.folder, "verdict.json")
                run("judge", "--tier", tier, "--shape", shape, "--count", str(COUNT), "--seed", "3",
                    "--json", path)
                with open(path, encoding="utf-8") as verdict:
                    rows = json.load(verdict)["rows"]
                for row in rows:
                    if row["regime"] in ("typical", "bits", "degenerate"):
                        continue  # of other counts
                    cell = heat[row["regime"]][tier]
                    if row["cases"] == 0:
                        self.assertEqual(cell, "")
                        continue
                    share = 100 * row["wrong"] / row["valid"] if row["valid"] else 0
                    self.assertAlmostEqual(float(cell), share, delta=0.5, msg=(shape, row))
                    self.assertEqual(float(cell) == 0, row["wrong"] == 0)

    @unittest.skipUnless(HAS_REFERENCE, "no reference")
    def test_certain_is_never_wrong(self):
        maps = self.page.heat()
        self.assertEqual(len(maps), len(SHAPES))
        for heat in maps:
            self.assertGreater(len(heat), 10)
            for regime, cells in heat.items():
                self.assertEqual((cells["certain"], cells["exact"]), ("0", "0"), regime)

    @unittest.skipUnless(HAS_REFERENCE, "no reference")
    def test_who_is_held_against_what(self):
        """And over how many cases: as many as the judge asks."""
        path = os.path.join(self.folder, "verdict.json")
        run("judge", "--tier", "textbook", "--count", "1", "--json", path)
        with open(path, encoding="utf-8") as verdict:
            regimes = [row["regime"] for row in json.load(verdict)["rows"]]
        special = {"typical": 20 * COUNT, "bits": COUNT // 4, "degenerate": COUNT // 4}
        cases = sum(special.get(regime, COUNT) for regime in regimes)
        (who,) = self.page.table("routine")[-1:]
        for tier in ["textbook", "stable"]:
            self.assertEqual(who[tier][2:4], ["exact", f"{cases:,}"])
        for tier in PROMISING:
            self.assertEqual(who[tier][2:4], ["CGAL", f"{AS_MANY * cases:,}"])
            self.assertEqual(who[tier][4], f"--tier {tier} --truth reference")
        self.assertNotIn("no independent evidence", self.text)
        self.assertNotIn("*", self.text.split("</style>")[1].split("<pre>")[0])
        self.assertIn("are held against CGAL", self.text)

    def report_alone(self):
        """By a program that finds no reference but what lies beside it, on planes."""
        program = os.path.join(self.folder, "surehit")
        shutil.copy(SUREHIT, program)
        return report(self.folder, *[word for tier in TIERS for word in ("--tier", tier)],
                      "--shape", "plane", "--count", str(COUNT), "--seed", "3", program=program,
                      env={"PATH": "/usr/bin:/bin",
                           "LD_LIBRARY_PATH": os.path.join(os.path.dirname(SUREHIT), os.pardir)})

    def test_the_reference_is_asked(self):
        """One that says miss to everything contradicts certain and exact, and nobody else."""
        reference = os.path.join(self.folder, "surehit-reference")
        with open(reference, "w", encoding="ascii") as script:
            script.write("#!/bin/sh\nexec sed 's/.*/miss/'\n")
        os.chmod(reference, 0o755)
        (heat,) = Page(self.report_alone()).heat()
        for regime, cells in heat.items():
            for tier in PROMISING:
                self.assertGreater(float(cells[tier]), 10, (regime, tier))
            self.assertEqual(cells["textbook"], self.page.heat()[0][regime]["textbook"])

    def test_without_the_reference(self):
        """It says what its word on itself is worth."""
        text = self.report_alone()
        page = Page(text)
        (heat,), who = page.heat(), page.table("routine")[-1]
        for cells in heat.values():
            self.assertEqual(cells["exact*"], "=")
            self.assertLessEqual({"textbook", "certain*"}, set(cells))
        self.assertEqual(who["certain*"][2], "exact: no independent evidence")
        self.assertEqual(who["exact*"][2], "itself: no independent evidence")
        self.assertEqual(who["exact*"][4], "--tier exact")
        self.assertEqual(who["stable"][2], "exact")
        self.assertIn("surehit-reference, for which CGAL would be asked, was not found", text)
        self.assertNotIn("held against CGAL", text)

    def test_times_are_of_hits_alone(self):
        """The candidate gives normals, and is marked; no tier is."""
        (glance,) = self.page.table("wrong where it is hard, %")
        times = {name: cells[len(SHAPES):] for name, cells in glance.items()
                 if name not in ("", "routine")}
        self.assertEqual(set(times), set(TIERS) | ({"one"} if LIBRARY else set()))
        for name, cells in times.items():
            self.assertEqual(len(cells), len(SHAPES))
            for cell in cells:
                self.assertRegex(cell, r"^[\d.]+ (ns|µs)" + ("$" if name in TIERS else "ⁿ$"))
        self.assertEqual("ⁿ : the normal is in the time" in self.text, bool(LIBRARY))

    def test_none_is_said_with_its_number(self):
        self.assertIn(f"none in {20 * COUNT}", self.text)

    def test_same_command_same_decisions(self):
        again = report(self.folder, "--tier", "stable", "--shape", "cone", "--count", str(COUNT),
                       "--seed", "3", "--processes", "1")
        cone = self.page.heat()[SHAPES.index("cone")]
        for regime, cells in Page(again).heat()[0].items():
            self.assertEqual(cells["stable"], cone[regime]["stable"], regime)

    def test_pictures(self):
        images = [attrs for tag, attrs in self.page.found if tag == "img"]
        if not images:
            self.skipTest("this build writes no PNG")
        self.assertEqual(len(images), 2 * (2 * len(TIERS) - 1))
        for image in images:
            data = base64.b64decode(image["src"].split(",")[1], validate=True)
            self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
            size = (int.from_bytes(data[16:20], "big"), int.from_bytes(data[20:24], "big"))
            self.assertEqual(size, (int(image["width"]), int(image["height"])))
        self.assertEqual(self.text.count("every pixel as exact"), 4)  # stable and certain, twice

    def test_contrast(self):
        style = self.text[:self.text.index("</style>")]
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


@unittest.skipUnless(CHROMIUM, "Chromium is not installed")
class InBrowser(InFolder):
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
        self.assertEqual(browser.value("[...document.images].filter(i => !i.naturalWidth).length"),
                         0)
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
