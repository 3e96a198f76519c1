#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Does docs/gallery.json still say what the judge says? test_gallery.py ROOT SUREHIT BUILD

Each adapter is asked the ordinary cases again, and its worst ones."""
import json
import os
import pathlib
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import gallery  # noqa: E402
import gallery_page  # noqa: E402
from pages import verdict  # noqa: E402

KEPT = ["valid", "wrong", "beyond", "hits"]
BY_MAKER = ["embree-float"]  # its reciprocals are the processor's estimate and a step


def is_wrong_again(judge, adapter, worst):
    with tempfile.NamedTemporaryFile("w", dir=judge.folder) as file:
        file.write(worst["case"] + "\n")
        file.flush()
        return judge.ask("--cases", file.name, *adapter.subject,
                         "--entry", gallery_page.as_given(worst["entry"]))["rows"][0]["wrong"] == 1


def faults_of(judge, adapter, said):
    if said["entry"] != adapter.entry:
        yield f"{adapter.name}: another entry: {adapter.entry}"
    for shape, found in said["shapes"].items():
        again = gallery.rounded(gallery.ordinary_of(adapter.ordinary(judge, shape)))
        for key in ["valid"] if adapter.name in BY_MAKER else KEPT:
            if again[key] != found["ordinary"][key]:
                yield f"{adapter.name}, {shape}: {key}: {again[key]}, not {found['ordinary'][key]}"
        asked = found["worst"] if adapter.name not in BY_MAKER else None
        if asked and not is_wrong_again(judge, adapter, asked):
            yield f"{adapter.name}, {shape}: right now: {found['worst']['case']}"


def main():
    root, surehit, build = (pathlib.Path(path).resolve() for path in sys.argv[1:4])
    record = json.loads((root / "docs/gallery.json").read_text(encoding="utf-8"))["adapters"]
    built = {adapter.name: adapter for adapter in gallery.adapters(root, build)}
    npms = {name for name, found in record.items() if found["package"] == "npm"}
    if not npms & built.keys():  # whose registry may be out of reach
        print("not asked, for npm has not put them here:", *sorted(npms))
        record = {name: found for name, found in record.items() if name not in npms}
    faults = [f"{name}: not in the record, or not built" for name in built.keys() ^ record.keys()]
    with tempfile.TemporaryDirectory(prefix="gallery.") as folder:
        judge = gallery.Judge(surehit, folder)
        for name in sorted(built.keys() & record.keys()):
            faults += faults_of(judge, built[name], record[name])
    return verdict(faults)


if __name__ == "__main__":
    sys.exit(main())
