#!/usr/bin/env python3
"""Draws the tables of chains.md: growth with the links of a chain, one panel for each table, both axes logarithmic.

    python3 benches/peers/growth.py

writes book/src/chains.svg; chains.py calls it. A tool has one colour in all panels and stops where its table does. Rows of derivatives
beside others of the same tool are dashed.
"""

import math
import pathlib
from xml.sax.saxutils import escape

HERE = pathlib.Path(__file__).resolve().parent
PICTURE = HERE.parent.parent / "book" / "src" / "chains.svg"
# distinct for most readers with weak colour vision (Okabe and Ito)
COLOURS = ["#000000", "#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"]
WIDTH, HEIGHT, LEFT, TOP, GAP, ROW = 390, 250, 64, 78, 110, 318
# links at the left and at the right edge
LEAST, MOST = 0.9, 220
STYLE = "text { font: 13px sans-serif; fill: #222 } .small { font-size: 11px; fill: #555 }"


def tables(text):
    """Of each table by links: where it stands, its caption, and by row its points."""
    kind, caption, found, rows = "", "", [], []
    for line in [*text.splitlines(), ""]:
        if line.startswith("## "):
            kind = line.removeprefix("## ")
        elif line.startswith("| "):
            rows.append([cell.strip() for cell in line.strip("|").split("|")])
        elif rows:
            links = [int(cell) for cell in rows[0][1:]]
            points = {row[0]: [(n, float(cell)) for n, cell in zip(links, row[1:]) if cell != "-"] for row in rows[2:]}
            found.append((kind, caption.rstrip("."), points))
            rows = []
        elif line:
            caption = line
    return found


def decades(values):
    low, high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    return range(low, max(high, low + 1) + 1)


def tool(row):
    return row.split(",")[0]


def is_dashed(row):
    return row.endswith(", derivatives")


def panel(left, top, title, axis, points, colours):
    across = lambda n: left + WIDTH * math.log(n / LEAST) / math.log(MOST / LEAST)
    marks = decades([value for own in points.values() for _, value in own])
    up = lambda value: top + HEIGHT * (1 - (math.log10(value) - marks[0]) / (marks[-1] - marks[0]))
    if any(is_dashed(name) for name in points):
        axis += "; dashed: of derivatives"
    parts = [f'<text x="{left}" y="{top - 26}" font-weight="bold">{escape(title)}</text>', f'<text class="small" x="{left}" y="{top - 9}">{escape(axis)}</text>']
    for mark in marks:
        y = up(10.0**mark)
        label = f"{10.0**mark:g}"
        parts.append(f'<line x1="{left}" x2="{left + WIDTH}" y1="{y:.1f}" y2="{y:.1f}" stroke="#ddd"/>')
        parts.append(f'<text class="small" x="{left - 6}" y="{y + 4:.1f}" text-anchor="end">{label}</text>')
    for n in (1, 2, 5, 10, 20, 50, 100, 200):
        parts.append(f'<text class="small" x="{across(n):.1f}" y="{top + HEIGHT + 17}" text-anchor="middle">{n}</text>')
    for name, own in points.items():
        line = " ".join(f"{across(n):.1f},{up(value):.1f}" for n, value in own)
        colour, dashes = colours[tool(name)], ' stroke-dasharray="5 4"' if is_dashed(name) else ""
        parts.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2"{dashes}/>')
        parts += [f'<circle cx="{across(n):.1f}" cy="{up(value):.1f}" r="2.6" fill="{colour}"/>' for n, value in own]
    return parts


def picture(found):
    names = list(dict.fromkeys(tool(name) for _, _, points in found for name in points))
    colours = dict(zip(names, COLOURS))
    kinds = list(dict.fromkeys(kind for kind, _, _ in found))
    captions = list(dict.fromkeys(caption for _, caption, _ in found))
    width = LEFT + len(kinds) * (WIDTH + GAP) - GAP + 70
    parts, x = [], LEFT
    for name, colour in colours.items():
        parts.append(f'<line x1="{x}" x2="{x + 22}" y1="20" y2="20" stroke="{colour}" stroke-width="3"/>')
        parts.append(f'<text x="{x + 28}" y="24">{escape(name)}</text>')
        x += 60 + 8 * len(name)
    for kind, caption, points in found:
        left, top = LEFT + kinds.index(kind) * (WIDTH + GAP), TOP + captions.index(caption) * ROW
        parts += panel(left, top, kind, caption, points, colours)
    height = TOP + len(captions) * ROW - 30
    head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}">'
    return "\n".join([head, f"<style>{STYLE}</style>", f'<rect width="{width}" height="{height}" fill="white"/>', *parts, "</svg>", ""])


def draw():
    PICTURE.write_text(picture(tables((HERE / "chains.md").read_text())))


if __name__ == "__main__":
    draw()
