#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The pages as a site: site_of_pages.py ROOT OUT

README, CHANGELOG and docs, by mkdocs, with search; sources that a page links are pages, too. OUT
gets `pages` (what mkdocs is given) and `html`. The tree stays as it is. Fails where a link, to a
page or a place in one, leads nowhere, or where no way leads from the first page to another."""
import html.parser
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from pages import verdict  # noqa: E402

FENCE = re.compile(r"(?ms)^(```.*?^```$)")
LINK = re.compile(r"(\]\()([^)#:\s]+)(#[^)\s]*)?\)")
SHOWN_AS_PAGE = {".c", ".cpp", ".css", ".def", ".glsl", ".h", ".html", ".js", ".mjs", ".patch",
                 ".py", ".rs", ".txt", ""}
PARAGRAPH = r"(?!(?:[-*|>#]|\d+\. |\s)).+\n"
ITEM = r"[-*] |\d+\. "
LANGUAGES = {".def": "c", ".h": "c", ".mjs": "js", ".patch": "diff", ".rs": "rust", ".txt": "text"}
SECTIONS = {"derivations": "Derivations", "proofs": "Proofs", "gallery": "The gallery"}

# One font of the system's, no request to anywhere; light or dark as the drawings are, by what the
# reader's system says. Anchors as GitHub makes them.
CONFIGURATION = """\
site_name: surehit
docs_dir: pages
site_dir: html
use_directory_urls: false
theme:
  name: material
  font: false
  features: [navigation.top, navigation.indexes]
  palette:
    - {media: "(prefers-color-scheme: light)", scheme: default}
    - {media: "(prefers-color-scheme: dark)", scheme: slate}
extra_css: [site.css]
plugins: [search]
markdown_extensions:
  - tables
  - pymdownx.betterem
  - sane_lists
  - pymdownx.superfences
  - pymdownx.highlight
  - toc:
      permalink: true
      slugify: !!python/object/apply:pymdownx.slugs.slugify {kwds: {case: lower}}
nav:
"""


# Links that can be read on a dark page.
STYLE = """\
[data-md-color-scheme=slate] { --md-typeset-a-color: #9db2ff; --md-hue: 220 }
.md-typeset h1, .md-typeset h2 { color: var(--md-default-fg-color) }
"""


def title_of(text):
    return re.search(r"(?m)^# (.*)", text)[1].replace("`", "")


def for_mkdocs(text):
    """GitHub's Markdown: remarks are none, and a list needs no empty line before it."""
    parts = FENCE.split(text)
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"(?ms)^<!--.*?-->$", "", parts[i])
        parts[i] = re.sub(rf"(?m)^({PARAGRAPH})(?={ITEM})", r"\1\n", parts[i])
    return "".join(parts)


class Pages:
    """What mkdocs is given: the tree's own places, so that links stay as they are."""

    def __init__(self, root, folder):
        self.root, self.folder = root, folder
        self.made = {}

    def add_all(self):
        for path in [self.root / "README.md", self.root / "CHANGELOG.md",
                     *sorted((self.root / "docs").rglob("*.md"))]:
            self.add_page(path)

    def place(self, path):
        return path.relative_to(self.root)

    def write(self, place, text):
        self.made[place] = text
        path = self.folder / place
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def add_page(self, path):
        parts = FENCE.split(for_mkdocs(path.read_text(encoding="utf-8")))
        for i in range(0, len(parts), 2):
            parts[i] = LINK.sub(lambda link: self.linked(path.parent, link), parts[i])
        self.write(self.place(path), "".join(parts))

    def linked(self, folder, link):
        """The link, to what is there on the site."""
        target = pathlib.Path(os.path.normpath(folder / link[2]))
        to = link[2].rstrip("/")
        if target.is_dir():
            self.add_folder(target)
            to += "/index.md"
        elif target.is_file() and target.suffix != ".md":
            to += self.add_file(target)
        return f"{link[1]}{to}{link[3] or ''})"

    def add_folder(self, path):
        place = self.place(path)
        if place / "index.md" in self.made:
            return
        self.made[place / "index.md"] = ""
        lines = []
        for each in sorted(path.iterdir()):
            if each.is_file() and each.name not in ("meson.build", "package-lock.json"):
                words = title_of(each.read_text(encoding="utf-8")) if each.suffix == ".md" else ""
                lines.append(f"- [{each.name}]({each.name}{self.add_file(each)}) {words}\n")
        self.write(place / "index.md", f"# {place}\n\n{''.join(lines)}")

    def add_file(self, path):
        """What its page's name has more."""
        place = self.place(path)
        if path.suffix not in SHOWN_AS_PAGE:
            if path.suffix != ".md":
                (self.folder / place).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(path, self.folder / place)
            return ""
        page = place.with_name(place.name + ".md")
        if page not in self.made:
            language = LANGUAGES.get(path.suffix, path.suffix.lstrip(".") or "text")
            self.write(page, f"# {place}\n\n~~~~~~~~{language}\n"
                             f"{path.read_text(encoding='utf-8')}\n~~~~~~~~\n")
        return ".md"

    def navigation(self):
        """Lines of YAML. Pages in the order in which the first one names them."""
        first = self.made[pathlib.Path("README.md")]
        pages = [place for place in self.made if self.root / place in
                 (self.root / "docs").glob("*.md")]
        pages.sort(key=lambda place: (first.find(f"({place})") % 10**6, place))

        def entry(place, indent="  "):
            return f"{indent}- {title_of(self.made[place])!r}: {place}\n"
        lines = ["  - surehit: README.md\n", *map(entry, pages)]
        for name, title in SECTIONS.items():
            lines.append(f"  - {title}:\n")
            lines += [entry(place, "    ") for place in sorted(self.made)
                      if place.parent == pathlib.Path("docs") / name and
                      (self.root / place).is_file()]
        return "".join(lines) + entry(pathlib.Path("CHANGELOG.md"))


class Page(html.parser.HTMLParser):
    """Its anchors; what it shows and links, and of that what stands in its text, or in the list of
    all pages."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.text, self.listed = set(), [], set(), set()
        self.inside = []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if tag in ("article", "nav"):
            self.inside.append(f"{tag} {values.get('class')}")
        self.anchors |= {values[key] for key in ("id", "name") if values.get(key)}
        target = values.get("href" if tag in ("a", "link") else "src")
        if not target or urllib.parse.urlsplit(target).scheme or target.startswith("//"):
            return
        self.links.append(urllib.parse.unquote(target))
        if any(words.startswith("article") for words in self.inside):
            self.text.add(self.links[-1])
        if any("md-nav--primary" in words for words in self.inside):
            self.listed.add(self.links[-1])

    def handle_endtag(self, tag):
        if tag in ("article", "nav") and self.inside:
            self.inside.pop()


def target_of(page, link):
    path, _, anchor = link.partition("#")
    return (pathlib.Path(os.path.normpath(page.parent / path)) if path else page), anchor


def broken(pages):
    for path, page in pages.items():
        for link in page.links:
            target, anchor = target_of(path, link)
            if target.is_dir():
                target /= "index.html"
            if not target.is_file():
                yield f"{path}: {link} is nowhere"
            elif anchor and target in pages and anchor not in pages[target].anchors:
                yield f"{path}: {link}: no such place"


def orphans(html_folder, pages, navigated):
    """Pages to which no text leads from the first one, or that its list of pages leaves out."""
    first = html_folder / "index.html"
    ahead, reached = [first], {first}
    while ahead:
        path = ahead.pop()
        for link in pages[path].text:
            target = target_of(path, link)[0]
            if target in pages and target not in reached:
                reached.add(target)
                ahead.append(target)
    yield from (f"{path}: no text leads here" for path in pages.keys() - reached)
    listed = {target_of(first, link)[0] for link in pages[first].listed}
    yield from (f"{path}: not in the list of pages" for path in navigated - listed)


def unfound(html_folder, pages):
    """Pages that the search doesn't know."""
    index = json.loads((html_folder / "search/search_index.json").read_text(encoding="utf-8"))
    known = {target_of(html_folder / "index.html", entry["location"] or "index.html")[0]
             for entry in index["docs"] if entry["text"] or entry["title"]}
    yield from (f"{path}: not to be found by the search" for path in pages.keys() - known)


def faults_of(folder):
    html_folder = folder / "html"
    pages = {path: Page(path) for path in html_folder.rglob("*.html") if path.name != "404.html"}
    own = re.findall(r": (\S+\.md)$", (folder / "mkdocs.yml").read_text(encoding="utf-8"), re.M)
    navigated = {html_folder / pathlib.Path(place).with_suffix(".html") for place in own
                 if place != "README.md"}
    if len(navigated) < 10 or sum(len(page.links) for page in pages.values()) < 1000:
        return [f"only {len(navigated)} pages, or hardly a link"]
    return sorted([*broken(pages), *orphans(html_folder, pages, navigated),
                   *unfound(html_folder, pages)])


def build(root, folder):
    shutil.rmtree(folder, ignore_errors=True)
    pages = Pages(root, folder / "pages")
    pages.add_all()
    pages.write(pathlib.Path("site.css"), STYLE)
    (folder / "mkdocs.yml").write_text(CONFIGURATION + pages.navigation(), encoding="utf-8")
    done = subprocess.run(["mkdocs", "build", "--quiet", "-f", folder / "mkdocs.yml"], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return [done.stdout] if done.returncode != 0 else faults_of(folder)


if __name__ == "__main__":
    sys.exit(verdict(build(*(pathlib.Path(word).resolve() for word in sys.argv[1:]))))
