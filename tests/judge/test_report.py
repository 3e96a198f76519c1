# SPDX-License-Identifier: MIT
"""`surehit report`: what its document says, and how the page draws it in a browser.

    test_report.py SUREHIT [LIBRARY]
    test_report.py --picture REPORT.html PICTURE.png

LIBRARY is a candidate (tests/judge/candidates/one.c as it was built). Where Chromium is installed,
the page is opened in it at three widths, light and dark. REPORT_PICTURES=FOLDER keeps what is seen
there. The second form makes docs/report.png."""

import base64
import decimal
import json
import math
import os
import re
import shutil
import statistics
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import commands  # noqa: E402
import browser  # noqa: E402
from commands import (PROGRAM, ROOT, TIERS, contents, loaded, put,  # noqa: E402
                      rows_of)
from shapes import SHAPES  # noqa: E402

LIBRARY = os.path.abspath(sys.argv[2]) if len(sys.argv) > 2 else None
REFERENCE = os.path.join(os.path.dirname(PROGRAM), "../../reference/surehit-reference")
HAS_REFERENCE = os.access(REFERENCE, os.X_OK)
PICTURES = os.environ.get("REPORT_PICTURES")
PROMISING = ["certain", "exact"]  # what is said of them must not come from them
EVENTS = ["surface", "inside", "end", "touch", "tie", "clear"]
COUNT = 40
AS_MANY = 3  # times as many cases for them
WIDTHS = [360, 768, 1280]


def candidates(document):
    return {who["name"]: who for who in document["candidates"]}


def counts(who):
    """Of each shape and regime: what does not hang on the machine."""
    return {(row["shape"], row["regime"]):
            {key: row[key] for key in ("cases", "valid", "wrong", "unasked")}
            for row in who["rows"]}


class InFolder(commands.InFolder):
    def report(self, line, *words, **more):
        """The document, which is in report.json; the page is in report.html."""
        self.ask(0, "report", "-o", "report.html", "--json", "report.json", *line.split(), *words,
                 **more)
        return loaded("report.json")

    def pixels(self, scene, tier, *words):
        """In one row."""
        self.ask(0, "render", scene, "-o", "x.ppm", "--tier", tier, "--quiet", *words)
        return sum(rows_of("x.ppm"), [])


class MadeOnce:
    """The tests of a class share a report, which is made in their first folder."""

    made = None

    def setUp(self):
        super().setUp()
        if not self.made:
            type(self).made = self.make()


class Words(InFolder):
    def test_who_cannot_be_asked(self):
        result = self.ask(1, "report", "-o", "x.html", "--json", "x.json", "--tier", "stable",
                          "--candidate", "<missing>.so", "--shape", "plane", "--count", "5")
        self.assertIn("<missing>.so", result.stderr)
        who = candidates(loaded("x.json"))
        self.assertIn("<missing>.so", who["<missing>"]["trouble"])
        self.assertEqual(who["<missing>"]["rows"], [])
        self.assertIsNone(who["stable"]["trouble"])
        self.assertNotIn("<missing>", contents("x.html").decode())

    def test_others_children_are_not_waited_for(self):
        """Nor is standard output needed."""
        words = ["report", "-o", "x.html", "--json", "x.json", "--tier", "stable", "--tier",
                 "textbook", "--shape", "plane", "--regime", "typical", "--count", "2000"]
        script = """for n in 1 2 3 4; do sh -c 'sleep 0.0$0; exit 3' $n & done
                    exec "$0" "$@" --quiet >&-"""
        subprocess.run(["sh", "-c", script, PROGRAM, *words], check=True)
        for who in candidates(loaded("x.json")).values():
            self.assertEqual([row["unasked"] for row in who["rows"]], [0], who["name"])

    def test_a_name_that_is_no_text(self):
        name = b"\xe9.so".decode(errors="surrogateescape")
        put(name, "no library")
        self.ask(1, "report", "-o", "x.html", "--json", "x.json", "--candidate", f"./{name}",
                 "--shape", "plane", "--count", "5", errors="replace")
        self.assertIn("?", candidates(loaded("x.json")))

    def test_a_candidate_stays(self):
        """Whatever the page is called."""
        put("mine.so", "mine")
        os.symlink("mine.so", "page.html")
        for words in (["-o", "page.html"], ["-o", "x.html", "--json", "./mine.so"]):
            self.refuse(f"'{words[-1]}' may not take the place of a file", "report", *words,
                        "--candidate", os.path.abspath("mine.so"))

    @unittest.skipUnless(LIBRARY, "no candidate")
    def test_who_computes_in_float_and_ends(self):
        """Who is given up on is told with all of its cases, and without times."""
        shutil.copy(LIBRARY, "libmine.so")
        in_float = os.path.join(os.path.dirname(LIBRARY), "float.so")
        found = self.report("--count 50 --shape plane --regime typical --tier float32 "
                            "--tier stable --candidate ./libmine.so", "--candidate", in_float,
                            env={**os.environ, "SUREHIT_WRONG": "always aborts"})
        self.assertEqual({name: who["in_float"] for name, who in candidates(found).items()},
                         {"float32": True, "stable": False, "mine": False, "float": True})
        self.assertEqual({regime["name"]: regime["cases"] for regime in found["regimes"]
                          if regime["cases"] != 50}, {"camera": 250, "bits": 13, "degenerate": 13})
        for name, who in candidates(found).items():
            (row,) = who["rows"]
            ends = name in ("mine", "float")
            self.assertEqual((row["unasked"] > 0, row["nanoseconds"] is None), (ends, ends))
            self.assertEqual(row["cases"], 50)

    @unittest.skipUnless(LIBRARY, "no candidate")
    def test_times_are_of_all_rays(self):
        """Of a routine that takes 10 microseconds a ray, asked in eight turns."""
        env = {**os.environ, "SUREHIT_WRONG": "is slow"}
        found = self.report("--count 6400 --shape sphere --regime camera --regime bits",
                            "--candidate", LIBRARY, env=env)
        row, few = found["candidates"][0]["rows"]
        self.assertEqual(row["cases"], 32000)
        self.assertGreaterEqual(row["nanoseconds"], 10000)
        self.assertLess(row["nanoseconds"], 40000)
        self.assertGreaterEqual(few["nanoseconds"], 10000)


class Content(MadeOnce, InFolder):
    def make(self):
        library = ["--candidate", LIBRARY] if LIBRARY else []
        found = self.report("".join(f"--tier {tier} " for tier in TIERS) +
                            f"--count {COUNT} --seed 3", *library)
        return found, candidates(found), contents("report.html").decode()

    def setUp(self):
        super().setUp()
        self.found, self.who, self.page = self.made

    def test_what_was_asked_for(self):
        self.assertEqual((self.found["count"], self.found["seed"]), (COUNT, "3"))

    def test_the_page_holds_the_document(self):
        (text,) = re.findall(r"<script type=\"application/json\" id=report>(.*?)</script>",
                             self.page, re.S)
        self.assertEqual(json.loads(text), self.found)
        self.assertNotIn("<", text)

    def test_nothing_from_outside(self):
        code = re.sub(r"<script type=.*?</script>", "", self.page, flags=re.S)
        for word in (" src=", "<link", "<iframe", "url(", "@import", "fetch(", "XMLHttp",
                     "@trade", "@page", "@plots", "https:"):
            self.assertNotIn(word, code)
        self.assertEqual(set(re.findall("http:[^']*", code)), {"http://www.w3.org/2000/svg"})

    def test_every_name_is_explained(self):
        for regime in self.found["regimes"]:
            self.assertIn(f"    {regime['name']}: '", self.page)
        for tier in TIERS:
            self.assertIn(f"    {tier}: '", self.page)

    def test_rows_are_what_the_judge_says(self):
        for tier in ("textbook", "float32"):
            self.ask(0, "judge", "--tier", tier, "--count", str(COUNT), "--seed", "3", "--json",
                     "verdict.json")
            expected = counts(loaded("verdict.json"))
            of = counts(self.who[tier])
            for pair, row in expected.items():
                if pair[1] in ("camera", "bits", "degenerate"):
                    continue # of other counts
                self.assertEqual(of.get(pair, dict.fromkeys(row, 0)), row, (tier, pair))
            self.assertLessEqual(set(of), set(expected))

    def test_errors_are_what_the_judge_says(self):
        self.ask(0, "judge", "--tier", "float32", "--regime", "camera", "--count",
                 str(5 * COUNT), "--seed", "3", "--json", "verdict.json")
        camera = [row for row in self.who["float32"]["rows"] if row["regime"] == "camera"]
        for row, said in zip(camera, loaded("verdict.json")["rows"], strict=True):
            self.assertGreater(row["t_pixels"]["most"], 0)
            for name in ("t_extents", "t_pixels"):
                self.assertEqual(row[name], said[name])

    @unittest.skipUnless(HAS_REFERENCE, "no reference")
    def test_certain_is_never_wrong(self):
        for tier in PROMISING:
            self.assertGreater(len(self.who[tier]["rows"]), 100)
            for row in self.who[tier]["rows"]:
                self.assertEqual((row["wrong"], row["breaches"]), (0, 0), row)

    @unittest.skipUnless(HAS_REFERENCE, "no reference")
    def test_who_is_held_against_what(self):
        """And over how many cases."""
        special = {"camera": 5 * COUNT, "bits": COUNT // 4, "degenerate": COUNT // 4}
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
        shutil.copy(PROGRAM, "surehit")
        return candidates(self.report(
            "".join(f"--tier {tier} " for tier in TIERS) +
            f"--shape plane --count {COUNT} --seed 3", program="./surehit",
            env={"PATH": "/usr/bin:/bin",
                 "LD_LIBRARY_PATH": os.path.join(os.path.dirname(PROGRAM), os.pardir)}))

    def test_the_reference_is_asked(self):
        """One that says miss to everything contradicts certain and exact, and nobody else."""
        put("surehit-reference", "#!/bin/sh\nexec sed 's/.*/miss/'\n")
        os.chmod("surehit-reference", 0o755)
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
            camera = [row["nanoseconds"] for row in who["rows"] if row["regime"] == "camera"]
            self.assertEqual(len(camera), len(SHAPES))
            self.assertGreater(min(camera), 0)

    def test_same_command_same_decisions(self):
        again = self.report(f"--tier stable --shape cone --count {COUNT} --seed 3 --processes 1")
        cone = {pair: row for pair, row in counts(self.who["stable"]).items() if pair[0] == "cone"}
        self.assertEqual(counts(candidates(again)["stable"]), cone)

    def test_worst_cases(self):
        """They are the judge's, of each kind that occurs one, and each does it again."""
        self.assertEqual(self.who["exact"]["worst"], [])
        for tier in ("float32", "textbook"):
            rows, worst = self.who[tier]["rows"], self.who[tier]["worst"]
            for shape in SHAPES:
                faults = {name for row in rows if row["shape"] == shape for name in row["faults"]}
                kinds = [one["kind"] for one in worst if one["shape"] == shape]
                self.assertEqual(len(kinds), len(set(kinds)))
                self.assertEqual(set(kinds) - {"largest error of t", "largest error of the normal"},
                                 faults)
                self.assertEqual(max(one.get("margin", 0) for one in worst
                                     if one["shape"] == shape),
                                 max(row["margins"]["most"] for row in rows
                                     if row["shape"] == shape and "margins" in row))
        for one in self.who["textbook"]["worst"]:
            self.ask(0, "judge", "--cases", "-", "--tier", "textbook", "--json", "again.json",
                     input=f"{one['case']} # {one['regime']}\n")
            (row,) = loaded("again.json")["rows"]
            self.assertEqual((row["shape"], row["regime"]), (one["shape"], one["regime"]))
            if "ulps" not in one:
                self.assertEqual(row["faults"][one["kind"]], 1)
            if "event" in one:
                self.assertEqual(row["decisions"]["wrong"][one["event"]], 1)

    def test_margins_are_what_the_judge_says(self):
        self.ask(0, "judge", *"--tier textbook --shape cone --seed 3 --json verdict.json".split(),
                 "--count", str(COUNT))
        rows = {row["regime"]: row for row in self.who["textbook"]["rows"]
                if row["shape"] == "cone"}
        for said in loaded("verdict.json")["rows"]:
            row = rows[said["regime"]]
            if said["regime"] in ("camera", "bits", "degenerate"):
                continue # of other counts
            self.assertEqual(row["faults"],
                             {name: count for name, count in said["faults"].items() if count})
            self.assertEqual("margins" in row, row["wrong"] > 0)
            for key in ("margins", "decisions") if row["wrong"] else ():
                self.assertEqual(row[key], said[key])

    def test_pictures(self):
        """All pixels, and where they should be the same."""
        self.assertEqual(len(self.found["pictures"]), 2)
        for scene in self.found["pictures"]:
            drawn = {tier: base64.b64decode(text, validate=True)
                     for tier, text in scene["tiers"].items()}
            self.assertEqual(list(drawn), TIERS)
            for rgb in drawn.values():
                self.assertEqual(len(rgb), 3 * scene["width"] * scene["height"])
            put("scene.rt", scene["file"])
            for tier in TIERS:
                self.assertEqual(drawn[tier], b"".join(map(bytes, self.pixels("scene.rt", tier))))
            self.assertEqual([tier for tier in TIERS if drawn[tier] == drawn["exact"]], TIERS[2:])

    def test_blocks(self):
        """Of every shape, and what a call takes by itself is shared by its rays."""
        self.assertEqual([one["shape"] for one in self.found["blocks"]], SHAPES)
        for one in self.found["blocks"]:
            self.assertEqual([call["rays"] for call in one["calls"]],
                             [1, 2, 4, 8, 16, 32, 64, 128, 256, 1024, 4096])
            first, *_, last = one["calls"]
            self.assertGreater(min(one["naive"], one["certain"], last["certain"],
                                   last["naive_block"]), 0)
            self.assertLess(2 * last["certain"], first["certain"])

    def test_contrast(self):
        browser.check_contrast(self, self.page[:self.page.index("</style>")], [
            *((f"h{i}", f"t{i}") for i in range(1, 6)),
            *(("paper", name) for name in ("ink", "soft", "tier", "peer", "hard"))])


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
# Names in a plane as the browser's own letters make them.
ON_EACH_OTHER = """[...document.querySelectorAll('svg.plane')].flatMap(s => {
    const all = [...s.querySelectorAll('text.name')].map(e => [e.getBoundingClientRect(), e]);
    return all.flatMap(([a, e], i) => all.slice(0, i).filter(([b]) =>
        Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 &&
        Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 0.35 * a.height)
        .map(([, f]) => e.textContent + ' on ' + f.textContent));
})"""


# Cells and boxes without a name, and boxes that are not marked as they should be.
UNNAMED = """document.querySelectorAll('th:not([scope])').length +
    document.querySelectorAll('.box:not([role=region][aria-label])').length +
    [...document.querySelectorAll('.box')].filter(e => e.classList.contains('cut') !==
        e.scrollWidth > e.clientWidth + 1).length"""

# What it says of worst cases, and of margins.
WORST = """[...document.querySelectorAll('#%s .worst')].map(d => [
    [...d.querySelectorAll('tbody tr')].map(r => [...r.cells].map(c => c.textContent)),
    d.querySelector('pre').textContent])"""
MARGINS = """Object.fromEntries([...document.querySelectorAll('#%s .margins tbody tr')].map(
    r => [r.cells[0].textContent, [...r.cells].slice(1).map(c => c.textContent)]))"""

# What the page says: of the glance its cells, of each shape the cells of the map and the points of
# the planes as [name, time, wrong, x, y].
COMMANDS = "document.querySelector('#how pre').textContent"
GLANCE = """Object.fromEntries([...document.querySelectorAll('#glance tbody tr')].map(
    r => [r.cells[0].textContent, [...r.cells].slice(1).map(c => c.textContent)]))"""
MAP = """(() => {
    const [top, ...rows] = document.querySelectorAll('#%s .heat tr');
    const names = [...top.cells].map(c => c.textContent);
    return rows.flatMap(r => [...r.cells].slice(2).map((c, i) =>
        [r.cells[0].textContent, names[i + 2], c.textContent, c.className]));
})()"""
TRADE = """[...document.querySelectorAll('#trade tbody tr')].map(
    r => [...r.cells].map(c => c.textContent))"""
IS_DRAWN = "document.querySelector('#trade img').naturalWidth"
LENGTHS = """[...document.querySelectorAll('#%s .lengths tbody tr')].map(
    r => [...r.cells].map(c => c.textContent))"""
POINTS = """[...document.querySelectorAll('#%s .plane')].map(
    s => [...s.querySelectorAll('g')].map(g => {
    const [all, name, time, wrong] = g.querySelector('title').textContent.match(
        /^(.*): (.*) a ray; wrong decisions[^:]*: (.*)$/);
    const r = g.querySelector('.dot').getBoundingClientRect();
    return [name, time, wrong, r.left + r.width / 2, r.top + r.height / 2];
}))"""
UNITS = {"ns": 1, "µs": 1e3, "ms": 1e6}
CELLS = """[...document.querySelectorAll('[aria-label="%s"] tbody tr')].map(
    r => [...r.cells].map(c => c.textContent))"""
CAPTIONS = "[...document.querySelectorAll('#pictures figcaption')].map(c => c.textContent)"
# Of the histogram's rows how many bars there are upwards and downwards.
BARS = """[...document.querySelectorAll('#%s .histogram .camera, #%s .histogram .hard')].map(
    e => (e.getAttribute('d').match(/M/g) || []).length)"""


def rounded(number, places):
    """As JavaScript does."""
    return str(decimal.Decimal(number).quantize(decimal.Decimal(1).scaleb(-places),
                                                decimal.ROUND_HALF_UP))


def percent(share):
    of100 = 100 * share
    return ("0" if share == 0 else "<0.01" if of100 < 0.005 else
            rounded(of100, 2 if of100 < 0.995 else 1 if of100 < 9.95 else 0))


def per_million(rows):
    """The mean of the rows' shares."""
    valid, wrong = (sum(row[key] for row in rows) for key in ("valid", "wrong"))
    share = 0
    for row in rows: # one after the other, as JavaScript does
        share += row["wrong"] / row["valid"] if row["valid"] else 0
    share = share / len(rows) * 1e6
    return (f"none in {valid:,}" if wrong == 0 else rounded(share, 1) if share < 9.95 else
            f"{int(rounded(share, 0)):,}")


def time_of(nanoseconds, who):
    if not nanoseconds:
        return "–"
    unit = "ns" if nanoseconds < 999.5 else "µs" if nanoseconds < 999.5e3 else "ms"
    number = nanoseconds / UNITS[unit]
    return (f"{rounded(number, 1 if number < 10 else 0)} {unit}" +
            ("ⁿ" if who["with_normals"] else ""))


def ulps_of(number):
    power = number and number >= 10000 and round(math.log10(number))
    return ("∞" if number is None else rounded(number, 0) if not power else
            "10" + str(power).translate(str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")))


@unittest.skipUnless(browser.CHROMIUM, "Chromium is not installed")
class InBrowser(InFolder):
    def test_what_it_says(self):
        found = self.report(f"--count {COUNT}")
        who = candidates(found)
        glance, trade, drawn, captions, asked, *shown = browser.values(
            "report.html", WIDTHS[-1], "light", GLANCE, TRADE, IS_DRAWN, CAPTIONS,
            CELLS % "Who was asked", *(
                expression % shape for shape in SHAPES for expression in (MAP, LENGTHS, POINTS)))
        self.assertGreater(drawn, 0)
        self.assertEqual(list(glance), list(who))
        for name, cells in glance.items():
            self.assertEqual([cell == "–" for cell in cells],
                             2 * [not any(row["shape"] == shape for row in who[name]["rows"])
                                  for shape in SHAPES])
        self.check_trade(trade, who)
        self.assertEqual(captions, [f"{tier} {self.caption(scene, tier)}"
                                    for scene in found["pictures"] for tier in TIERS])
        self.assertEqual([(name, cases) for name, _, _, _, cases, _ in asked],
                         [(name, f"{sum(row['cases'] for row in one['rows']):,}")
                          for name, one in who.items()])
        for shape, cells, lengths, planes in zip(SHAPES, shown[::3], shown[1::3], shown[2::3]):
            self.assertGreater(len(cells), 100)
            for regime, name, text, kind in cells:
                self.check_cell(who[name], shape, regime, text, kind)
            for name, *cells in lengths:
                self.check_lengths(who[name], shape, cells)
            self.assertEqual(len(planes), 2)
            for points in planes:
                self.assertGreaterEqual(len(points), len(TIERS))
                self.check_points(points)
        self.check_figures(found, who, SHAPES)

    def caption(self, scene, tier):
        right, drawn = (base64.b64decode(scene["tiers"][name]) for name in ("exact", tier))
        pixels = len(right) // 3
        wrong = sum(right[i:i + 3] != drawn[i:i + 3] for i in range(0, len(right), 3))
        return ("the right picture" if tier == "exact" else "every pixel as exact" if not wrong else
                rounded(100 * wrong / pixels, 1 if 10 * wrong < pixels else 0) +
                " % of the pixels wrong")

    def check_figures(self, found, who, shapes):
        """Of each shape those of its table, the blocks' times, and how many bars there are."""
        blocks, *shown = browser.values(
            "report.html", WIDTHS[-1], "light", CELLS % "Nanoseconds a ray by the rays of a call",
            *(one for shape in shapes for one in (CELLS % f"In figures: {shape}",
                                                  BARS % (shape, shape))))
        for cells, one in zip(blocks, found["blocks"], strict=True):
            calls = one["calls"]
            times = [one["naive"], one["certain"], *(call["certain"] for call in calls),
                     calls[-1]["naive_block"]]
            self.assertEqual(cells, [one["shape"], *(rounded(time, 1) for time in times)])
        for shape, figures, bars in zip(shapes, shown[::2], shown[1::2], strict=True):
            expected = []
            for name, *cells in figures:
                parts = self.parts(who[name], shape)
                self.assertEqual(cells, self.figures(who[name], *parts), (shape, name))
                expected += [sum(any(of) for of in zip(*(row["t_ulps"]["by_powers_of_two"]
                                                         for row in rows))) for rows in parts]
            self.assertEqual(bars, expected, shape)

    def parts(self, who, shape):
        """Rows of pictures, and the hard ones."""
        rows = [row for row in who["rows"] if row["shape"] == shape]
        return ([row for row in rows if row["regime"] == "camera"],
                [row for row in rows if row["regime"] not in ("camera", "typical")])

    def figures(self, who, camera, hard):
        times = [row["nanoseconds"] for row in hard if row["nanoseconds"]] or [0]
        of_pictures = ([per_million(camera), time_of(camera[0]["nanoseconds"], who)] if camera else
                       ["–", "–"])
        return [*of_pictures, per_million(hard), time_of(statistics.median(times), who),
                time_of(max(times), who),
                f"{sum(row['breaches'] for row in camera + hard):,}"]

    def test_commands(self):
        """What the page says to run again runs, and judges the cell that it names."""
        library = "./it's one; or $two.so"
        shutil.copy(LIBRARY, library)
        self.report("--count 20 --shape sphere --regime rim --regime grazing", "--candidate",
                    library)
        (commands_shown,) = browser.values("report.html", WIDTHS[-1], "light", COMMANDS)
        page, cell = commands_shown.splitlines()
        self.assertEqual(subprocess.run(page, shell=True, capture_output=True).returncode, 0)
        said = subprocess.run(cell, shell=True, capture_output=True, text=True, check=True).stdout
        self.assertIn(" 20 cases a row", said)
        self.assertRegex(said, r"(?m)^sphere +grazing +")

    def test_cases_to_start_from(self):
        """With a line for each that can be pasted; a crash is called one."""
        library = "./it's <one>.so"
        shutil.copy(LIBRARY, library)
        env = {**os.environ, "SUREHIT_WRONG": "aborts"}
        found = self.report("--count 40 --shape sphere --regime typical --regime far",
                            "--tier", "textbook", "--candidate", library, env=env)
        glance, heat, margins, cases = browser.values(
            "report.html", WIDTHS[-1], "light", GLANCE, MAP % "sphere", MARGINS % "sphere",
            WORST % "sphere")
        name = "it's <one>"
        self.assertRegex(glance[name][0], "^[0-9.]+, crash$")
        self.assertIn([name, "crash"], [[who, text] for _, who, text, _ in heat])
        for who in found["candidates"]:
            counted = [row["decisions"]["wrong"] for row in who["rows"] if row["wrong"]]
            of = [row["margins"] for row in who["rows"] if row["wrong"]]
            *shown, most = margins[who["name"]]
            valid = sum(row["valid"] for row in who["rows"])
            self.assertEqual(shown, [str(sum(of[event] for of in counted)) for event in EVENTS] + [
                percent(sum(one["wrong"][i]["wrong"] for one in of) / valid) for i in range(6)])
            self.assertAlmostEqual(float(most), max([0] + [one["most"] for one in of]),
                                   delta=0.06 * float(most))
        self.check_figures(found, candidates(found), ["sphere"])
        for row in candidates(found)[name]["rows"]:  # who crashes has no times
            self.assertGreater(row["breaches"], 0)
            self.assertIsNone(row["nanoseconds"])
        kinds = [one["kind"] for who in found["candidates"] for one in who["worst"]]
        self.assertIn("crash", kinds)
        self.assertEqual([row[0] for rows, _ in cases for row in rows], kinds)
        lines = "\n".join(text for _, text in cases).splitlines()
        for line, kind in zip(lines, kinds, strict=True):
            again = subprocess.run(line, shell=True, env=env, capture_output=True, text=True,
                                   check=True).stdout
            self.assertRegex(again, r"(?m)^sphere +(typical|far) ")
            self.assertIn(f"\n{kind} (sphere ", again)

    @unittest.skipUnless(shutil.which("valgrind"), "valgrind is not installed")
    def test_instructions(self):
        found = self.report("--tier exact --count 2 --shape box --regime camera --instructions")
        (glance,) = browser.values("report.html", WIDTHS[-1], "light", GLANCE)
        (row,) = found["candidates"][0]["rows"]
        self.assertEqual(glance["exact"][2:], [f"{row['instructions']:.0f}"])

    def check_cell(self, who, shape, regime, text, kind):
        rows = [row for row in who["rows"] if (row["shape"], row["regime"]) == (shape, regime)]
        share = rows[0]["wrong"] / rows[0]["valid"] if rows and rows[0]["valid"] else 0
        self.assertNotIn("crash", rows[0]["faults"] if rows else [])
        mark = "†" if rows and rows[0]["breaches"] + rows[0]["unasked"] else ""
        self.assertEqual(text, percent(share) + mark if rows else "", (who["name"], shape, regime))
        self.assertEqual(kind, f"h{sum(share > most for most in (0, 1e-3, 1e-2, 5e-2, 0.2))}")

    def check_trade(self, rows, who):
        """As the README has it, but for what this report finds at the extremes."""
        readme = contents(os.path.join(ROOT, "README.md")).decode().split("trade -->")[1]
        expected = [[cell.strip(" `") for cell in line.split("|")[1:-1]]
                    for line in readme.splitlines() if line.startswith("|")][2:]
        self.assertEqual([[row[0], *row[2:]] for row in rows],
                         [[row[0], *row[2:]] for row in expected])
        hard = [[row["wrong"] / row["valid"] for row in who["textbook"]["rows"]
                 if row["shape"] == shape and row["regime"] not in ("camera", "typical")]
                for shape in SHAPES]
        share = sum(sum(of) / len(of) for of in hard) / len(SHAPES)
        self.assertEqual({row[0]: row[1] for row in rows}["textbook"], percent(share))

    def check_lengths(self, who, shape, cells):
        (row,) = [row for row in who["rows"] if row["shape"] == shape and row["regime"] == "camera"]
        sizes = [row[of][which] for of in ("t_pixels", "t_extents")
                 for which in ("median", "99", "most")]
        t = row["t_ulps"]
        self.assertEqual(cells[:4], [*(ulps_of(t[which]) for which in ("median", "99", "most")),
                                     percent(t["correctly_rounded"] / t["hits"])])
        self.assertEqual([float(cell.replace("∞", "inf")) for cell in cells[4:]],
                         [float("inf" if size is None else f"{size:.1e}") for size in sizes])

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
        self.report("--count 20")
        for scheme in browser.SCHEMES:
            for width in WIDTHS:
                with self.subTest(width=width, scheme=scheme):
                    self.look(width, scheme)

    def look(self, width, scheme):
        outside, covered, smallest, canvases, unnamed, cut, height = browser.check(
            self, "report.html", width, scheme, ".box, pre", OUT_OF_DRAWING, ON_EACH_OTHER,
            SMALLEST, "document.querySelectorAll('canvas').length",
            UNNAMED, "document.querySelectorAll('.cut').length",
            "document.documentElement.scrollHeight")
        self.assertEqual((outside, covered, unnamed), ([], [], 0))
        if width == WIDTHS[0]:
            self.assertGreater(cut, len(SHAPES))
        self.assertGreaterEqual(smallest, LEAST_LETTER)
        self.assertEqual(canvases, 2 * (2 * len(TIERS) - 1))
        if PICTURES:
            put(os.path.join(PICTURES, f"report-{width}-{scheme}.png"),
                browser.picture("report.html", width, scheme, 0, height))


def picture_of(page, path):
    """The sphere's planes, map and histograms."""
    place = "document.querySelector('%s').getBoundingClientRect().%s"
    top, bottom = map(round, browser.values(page, 1200, "light", place % ("#sphere h2", "top"),
                                            place % ("#sphere .wide", "bottom")))
    put(path, browser.picture(page, 1200, "light", top - 10, bottom + 10))


if sys.argv[1] == "--picture":
    picture_of(*sys.argv[2:])
elif __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
