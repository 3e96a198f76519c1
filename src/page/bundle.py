# SPDX-License-Identifier: MIT
"""Makes one page of the parts: bundle.py VERSION OUTPUT PAGE PART... Where the page says @name@
that part goes. Sources that import others (worker.js, page.js of main.js) are put behind what they
import, in one scope; WebAssembly becomes gzip in base64."""
import base64
import gzip
import pathlib
import re
import sys

IMPORT = re.compile(r"^import [^;]*? from '(\./|\.\./npm/)([a-z_]+\.js)';\n", re.M | re.S)


def gathered(path, seen):
    """The text of a source behind those that it imports, each once, without imports and exports."""
    if path.name in seen:
        return ""
    seen.add(path.name)
    text = path.read_text()
    before = "".join(gathered(sources[name], seen) for _, name in IMPORT.findall(text))
    rest = IMPORT.sub("", text)
    if re.search(r"^import\b", rest, re.M):
        sys.exit(f"{path}: an import that is not understood")
    return before + re.sub(r"^export ", "", rest, flags=re.M)


def modules(paths):
    for path in paths:
        packed = base64.b64encode(gzip.compress(path.read_bytes(), 9, mtime=0)).decode()
        yield f'<script type="application/wasm+gzip" id="{path.name}">{packed}</script>'


version, output, page, *parts = sys.argv[1:]
sources = {pathlib.Path(part).name: pathlib.Path(part) for part in parts}
made = {"version": version, "page.js": gathered(sources["main.js"], set()),
        "worker.js": gathered(sources["worker.js"], set()),
        "modules": "\n".join(modules(p for p in sources.values() if p.suffix == ".wasm"))}
for name, path in sources.items():
    if path.suffix not in (".js", ".wasm"):
        made[name] = path.read_text()
text = re.sub(r"@([a-z.]+)@", lambda found: made[found[1]], pathlib.Path(page).read_text())
if "</script" in made["page.js"] + made["worker.js"]:
    sys.exit("a source that would end its own element")
pathlib.Path(output).write_text(text)
