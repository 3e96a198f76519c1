# SPDX-License-Identifier: MIT
"""The places of docs/gallery.md and its drawings, made of the record docs/gallery.json."""
import pathlib

import gallery_drawings
from pages import block, filled, table

SHAPES = ["plane", "disc", "sphere", "cylinder", "cone", "box"]
EVENTS = ["touch", "inside", "surface, out", "surface, in", "end"]
MARGINS = ["1e-12", "1e-09", "1e-06", "0.001", "0.01", "1"]
DEFENSIBLE = 1e-9  # of an object's size: below that a wrong decision is nobody's case


def per_cent(count, of):
    return "–" if of == 0 else "0" if count == 0 else f"{100 * count / of:.2g}"


def each(record):
    """(adapter's name, what is said of it, shape, what is said of that)"""
    for name, adapter in record["adapters"].items():
        for shape, found in adapter["shapes"].items():
            yield name, adapter, shape, found


def linked(root, name):
    """To the page of its defect, if it has one."""
    page = {"geometric": "geometric_shapes", "occt": "opencascade"}.get(name, name)
    return f"[{name}](gallery/{page}.md)" if (root / f"docs/gallery/{page}.md").exists() else name


def ordinary_cell(found):
    if not found:
        return ""
    ordinary = found["ordinary"]
    if ordinary["wrong"] == 0:
        return "**0**"
    return f"{ordinary['wrong']:,} · {ordinary['beyond']['0.01']:,} · {ordinary['most']:.2g}"


def ordinary_table(record):
    rows = [[name, adapter["version"].split("+")[0],
             *(ordinary_cell(adapter["shapes"].get(shape)) for shape in SHAPES)]
            for name, adapter in record["adapters"].items()]
    return table(["", "version", *SHAPES], rows, right=range(2, 8))


def in_double(name, adapter):
    return "float" not in [*name.split("-"), *adapter["entry"].split()]


def right_everywhere(record):
    """The sentences that come first."""
    doubles = {name: [found["ordinary"] for found in adapter["shapes"].values()]
               for name, adapter in record["adapters"].items() if in_double(name, adapter)}
    wrong = {name: max(one["most"] for one in of) for name, of in doubles.items()
             if any(one["wrong"] for one in of)}
    others = ", ".join(f"{name} (by {most:.1g} of the object's size at most)"
                       for name, most in wrong.items())
    return (f"**{len(doubles) - len(wrong)} of {len(doubles)} adapters that compute in doubles "
            f"decide every one of {record['count']:,} ordinary rays right, of every shape that "
            f"they have.** The others: {others}.\n")


def controls(record):
    """What the controls are wrong in."""
    said = []
    for points, what in ((False, "a start and a direction"), (True, "two points")):
        of = [found["control"] for adapter in record["adapters"].values()
              for found in adapter["shapes"].values() if adapter["by_points"] == points]
        said.append(f"{sum(one['wrong'] for one in of):,} of {sum(one['valid'] for one in of):,} "
                    f"that are handed over as {what} "
                    f"(by {max((one['most'] for one in of), default=0):.1g} of the size at most)")
    return f"The controls are wrong in {', and in '.join(said)}.\n"


def errors_table(record):
    rows = []
    for name, _, shape, found in each(record):
        of, took = found["ordinary"], found["ordinary"]["nanoseconds"]
        rows.append([name, shape, *("–" if of[key] is None else f"{of[key]:.1g}"
                                    for key in ("t_99", "t_most")),
                     *(f"{took[who]:.0f}" if took.get(who) else ""
                       for who in ("candidate", "textbook", "certain"))])
    return table(["", "shape", "t: 99 %", "t: most", "ns", "ns of textbook", "ns of certain"], rows,
                 right=range(2, 7))


def margins_table(record):
    rows = []
    for name, adapter, shape, found in each(record):
        hard = found["hard"]
        rows.append([name, shape, f"{hard['valid']:,}", per_cent(hard["wrong"], hard["valid"]),
                     *(per_cent(hard["beyond"].get(margin, 0), hard["valid"])
                       for margin in MARGINS),
                     f"{hard['most']:.1g}",
                     per_cent(found["control"]["wrong"], found["control"]["valid"])])
    heads = ["> " + margin.replace("e-0", "e-") for margin in MARGINS]
    return table(["", "shape", "cases", "wrong %", *heads, "most", "control: wrong %"], rows,
                 right=range(2, 12))


def entries_table(record):
    return table(["", "library", "Debian package", "its entry"],
                 [[name, f"{adapter['library']} {adapter['version']}", f"`{adapter['package']}`",
                   f"`{adapter['entry']}`" if adapter["entry"] else "any case"]
                  for name, adapter in record["adapters"].items()], right=())


def said_of(found):
    """Of each convention what it says; bold where the contract says something else."""
    for event in EVENTS:
        one = found["conventions"].get(event)
        yield "–" if not one else one["says"] if one["says"] == one["contract"] \
            else f"**{one['says']}**"


def conventions_table(record):
    rows = [[name, shape, *said_of(found)] for name, _, shape, found in each(record)]
    return table(["", "shape", *EVENTS], rows, right=())


def as_given(entry):
    """What an entry says of answers: under the rest, a case asked again would be made anew."""
    kept = [word for word in entry.split()
            if "miss" in word or word in ("decision", "float", "inside=0")]
    return " ".join(["t_min=0", *kept])


def worst_cases(root, record):
    parts = []
    for name, adapter, shape, found in each(record):
        worst = found["worst"]
        if shape == "plane" or not worst or worst["margin"] <= DEFENSIBLE:
            continue
        entry = f" --entry '{as_given(worst['entry'])}'"
        asked = f"--keep --command '{adapter['command']}'" if adapter["command"] else \
            f"--candidate build/gallery/reference/peers/libraries/libpeer-{name}.so"
        parts.append(f"{linked(root, name.split('-')[0])}, {name}: a {worst['kind']} of a {shape}, "
                     f"by {worst['margin']:.2g} of its size\n\n```text\necho '{worst['case']}' | "
                     f"./run judge --cases - {asked}{entry}\n```\n")
    return parts


def acquitted(record):
    """Those without a decision that no tolerance explains."""
    clean = [f"{name} ({shape})" for name, _, shape, found in each(record)
             if shape != "plane" and
             (not found["worst"] or found["worst"]["margin"] <= DEFENSIBLE)]
    return f"Nothing wrong by more than 10⁻⁹ of the object's size: {', '.join(clean)}.\n"


def outputs(root, record):
    root = pathlib.Path(root)
    page = root / "docs/gallery.md"
    values = {"controls": block(controls(record)), "right": block(right_everywhere(record)),
              "ordinary": block(ordinary_table(record)), "errors": block(errors_table(record)),
              "margins": block(margins_table(record)), "entries": block(entries_table(record)),
              "conventions": block(conventions_table(record)),
              "worst": block(acquitted(record), *worst_cases(root, record))}
    return {page: filled(page.read_text(encoding="utf-8"), values),
            root / "docs/gallery/far.svg": gallery_drawings.far(record),
            root / "docs/gallery/worst.svg": gallery_drawings.worst(record, DEFENSIBLE)}
