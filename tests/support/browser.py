# SPDX-License-Identifier: MIT
"""Pages as a browser shows them, where Chromium is installed: headless, narrow and wide, light and
dark."""

import html
import json
import os
import re
import shutil
import subprocess
import tempfile

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
SCHEMES = ["light", "dark"]
LEAST_CONTRAST = 4.5  # WCAG 2.1, 1.4.3

# What sticks out of the page: nothing may but inside what scrolls by itself.
STICKS_OUT = """[...document.querySelectorAll('body *')].filter(e => {
    const r = e.getBoundingClientRect();
    return r.width > 0 && (r.right > innerWidth + 0.5 || r.left < -0.5) && !e.closest('%s');
}).map(e => e.outerHTML.slice(0, 80))"""

# Around pages: as wide as that, shifted up, and what expressions are in each, once all are there.
FRAMES = """<!doctype html><style>iframe { border:0; width:%dpx; height:%dpx; margin-top:%dpx }
</style><body style="margin:0;overflow:hidden">%s<pre></pre><script>onload = () => {
document.querySelector('pre').textContent = JSON.stringify(
    [...document.querySelectorAll('iframe')].map(f => %s.map(x => f.contentWindow.eval(x))));
}</script>"""


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


def chromium(paths, width, height, top, scheme, expressions, *words):
    """Its standard output."""
    with tempfile.TemporaryDirectory(prefix="browser.", ignore_cleanup_errors=True) as folder:
        around = os.path.join(folder, "around.html")
        frames = "".join(f'<iframe src="file://{os.path.abspath(path)}"></iframe>'
                         for path in paths)
        with open(around, "w", encoding="utf-8") as file:
            file.write(FRAMES % (width, height, -top, frames,
                                 json.dumps(expressions).replace("<", "\\u003c")))
        ended = subprocess.run(
            [CHROMIUM, "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
             "--disable-dev-shm-usage", "--allow-file-access-from-files", "--enable-logging=stderr",
             f"--blink-settings=preferredColorScheme={SCHEMES[::-1].index(scheme)}",
             "--virtual-time-budget=10000", f"--user-data-dir={folder}/profile", *words,
             "file://" + around], capture_output=True, encoding="utf-8", check=True)
    if "CONSOLE" in ended.stderr:
        raise ValueError(ended.stderr)
    return ended.stdout


def values_of(paths, width, scheme, *expressions):
    """What they are on each page, which complains of nothing."""
    said = chromium(paths, width, 800, 0, scheme, expressions, "--dump-dom")
    return json.loads(html.unescape(re.search("<pre>(.*?)</pre>", said, re.S)[1]))


def values(path, *more):
    return values_of([path], *more)[0]


def check(test, path, width, scheme, scrolls, *expressions):
    """The page is as wide as that, in its scheme, and asks for nothing from outside. What the
    expressions are."""
    inner, wide, out, paper, asked, *more = values(
        path, width, scheme, "innerWidth", "document.documentElement.scrollWidth",
        STICKS_OUT % scrolls, "getComputedStyle(document.body).backgroundColor",
        "performance.getEntriesByType('resource').map(e => e.name)", *expressions)
    test.assertEqual((inner, out), (width, []))
    test.assertLessEqual(wide, width)
    test.assertEqual(paper == "rgb(255, 255, 255)", scheme == "light")
    test.assertEqual([name for name in asked if not re.match("(file|data):", name)], [])
    return more


def picture(path, width, scheme, top, bottom):
    """Of that part of the page, as a PNG."""
    with tempfile.TemporaryDirectory() as folder:
        kept = os.path.join(folder, "kept.png")
        chromium([path], width, bottom, top, scheme, [], f"--window-size={width},{bottom - top}",
                 "--screenshot=" + kept)
        with open(kept, "rb") as file:
            return file.read()
