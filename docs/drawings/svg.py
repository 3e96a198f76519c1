# SPDX-License-Identifier: MIT
"""A drawing of lines, curves and labels in SVG, light or dark as its reader is."""
import html
import math

STYLE = """
    svg { font: italic 17px Georgia, "DejaVu Serif", serif; color: #1f2328; --paper: #ffffff;
          --body: #dfe7f1; --ray: #0a58ca; --mark: #b3400a; --faint: #5a6370; --good: #14692d }
    @media (prefers-color-scheme: dark) {
        svg { color: #e6edf3; --paper: #0d1117; --body: #22304a; --ray: #6cb0ff; --mark: #ffa657;
              --faint: #8d98a5; --good: #56d364 }
    }
    .paper { fill: var(--paper) }
    .body { fill: var(--body); stroke: currentColor; stroke-width: 1.5; stroke-linejoin: round }
    .fill { fill: var(--body) }
    .edge { fill: none; stroke: currentColor; stroke-width: 1.5 }
    .faint { fill: none; stroke: var(--faint); stroke-width: 1.2; stroke-dasharray: 5 4 }
    .thin { fill: none; stroke: var(--faint); stroke-width: 1.2 }
    .ray { fill: none; stroke: var(--ray); stroke-width: 2.2 }
    .within { fill: none; stroke: var(--ray); stroke-width: 2.2; stroke-dasharray: 2 5 }
    .mark { fill: none; stroke: var(--mark); stroke-width: 2.2 }
    .bar { fill: none; stroke: var(--mark); stroke-width: 6 }
    .good { fill: none; stroke: var(--good); stroke-width: 2.2 }
    .head { stroke: none }
    .head.ray, .dot.ray { fill: var(--ray); stroke: none }
    .head.mark, .dot.mark { fill: var(--mark); stroke: none }
    .head.good { fill: var(--good) }
    .head.edge, .dot.edge { fill: currentColor; stroke: none }
    .head.thin { fill: var(--faint) }
    text { fill: currentColor; paint-order: stroke; stroke: var(--paper); stroke-width: 4px;
           stroke-linejoin: round }
    text.on { stroke: var(--body) }
    text.ray { fill: var(--ray); stroke: var(--paper); stroke-width: 4px }
    text.mark { fill: var(--mark); stroke: var(--paper); stroke-width: 4px }
    text.good { fill: var(--good); stroke: var(--paper); stroke-width: 4px }
    text.faint { fill: var(--faint); stroke: var(--paper); stroke-width: 4px }
    .upright { font: normal 14px "DejaVu Sans", Verdana, sans-serif }
"""


def add(p, q, times=1.0):
    """p + times q"""
    return (p[0] + times * q[0], p[1] + times * q[1])


def sub(p, q):
    return add(p, q, -1)


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1]


def unit(p):
    return (p[0] / math.hypot(*p), p[1] / math.hypot(*p))


TILT = 0.2  # how round a circle across the axis looks


def arc_places(x, y, r, first, last):
    angles = [math.radians(first + (last - first) * i / 40) for i in range(41)]
    return [(x + r * math.cos(a), y + TILT * r * math.sin(a)) for a in angles]


class Drawing:
    """Places are in units of the drawing: x to the right, y upwards, the origin at `origin`."""

    def __init__(self, size, origin, scale, title, about):
        self.size, self.origin, self.scale = size, origin, scale
        self.title, self.about, self.parts = title, about, []

    def at(self, place):
        return (self.origin[0] + self.scale * place[0], self.origin[1] - self.scale * place[1])

    def put(self, name, kind, **values):
        words = " ".join(f'{key.replace("_", "-")}="{value}"' for key, value in values.items())
        self.parts.append(f'<{name} class="{kind}" {words}/>')

    def path(self, places, kind, closed=False):
        text = " L".join("%.1f %.1f" % self.at(place) for place in places)
        self.put("path", kind, d=f"M{text}" + ("Z" if closed else ""))

    def line(self, start, end, kind):
        self.path([start, end], kind)

    def arrow(self, start, end, kind):
        """With its head at the end, in the line's colour."""
        way = unit(sub(self.at(end), self.at(start)))
        tip, back = self.at(end), add(self.at(end), way, -11)
        across = (-way[1] * 4.5, way[0] * 4.5)
        self.line(start, add(end, (way[0], -way[1]), -8 / self.scale), kind)
        corners = " ".join("%.1f,%.1f" % p for p in (tip, add(back, across), sub(back, across)))
        self.put("polygon", f"head {kind}", points=corners)

    def dot(self, place, kind="edge"):
        x, y = self.at(place)
        self.put("circle", f"dot {kind}", cx=f"{x:.1f}", cy=f"{y:.1f}", r=4)

    def ellipse(self, centre, rx, ry, kind):
        x, y = self.at(centre)
        self.put("ellipse", kind, cx=f"{x:.1f}", cy=f"{y:.1f}", rx=f"{self.scale * rx:.1f}",
                 ry=f"{self.scale * ry:.1f}")

    def arc(self, centre, rx, ry, first, last, kind):
        """From angle to angle, in degrees, anticlockwise."""
        angles = [math.radians(first + (last - first) * i / 40) for i in range(41)]
        self.path([add(centre, (rx * math.cos(a), ry * math.sin(a))) for a in angles], kind)

    def corner(self, place, one, other, size):
        """The mark of a right angle between two ways."""
        u, v = unit(one), unit(other)
        self.path([add(place, u, size), add(add(place, u, size), v, size), add(place, v, size)],
                  "thin")

    def text(self, place, words, by=(0, 0), kind="", anchor="middle"):
        """`by`: pixels to the right and upwards."""
        x, y = self.at(place)
        self.parts.append(f'<text class="{kind}" x="{x + by[0]:.1f}" y="{y - by[1]:.1f}" '
                          f'text-anchor="{anchor}">{html.escape(words)}</text>')

    def box(self, centre, size, kind):
        x, y = self.at(centre)
        self.put("rect", kind, x=f"{x - size[0] / 2:.1f}", y=f"{y - size[1] / 2:.1f}",
                 width=size[0], height=size[1], rx=6)

    def svg(self):
        width, height = self.size
        return "\n".join([
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
            f'width="{width}" height="{height}" role="img" aria-labelledby="title desc">',
            f'<title id="title">{html.escape(self.title)}</title>',
            f'<desc id="desc">{html.escape(self.about)}</desc>', f"<style>{STYLE}</style>",
            f'<rect class="paper" width="{width}" height="{height}"/>', *self.parts, "</svg>", ""])
