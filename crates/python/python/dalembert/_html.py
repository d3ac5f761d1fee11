"""Tables for notebooks."""

from __future__ import annotations

from html import escape
from typing import Any

__all__ = ["COLOURS", "formula", "table"]

COLOURS = {
    "proved": "#1a7f37",
    "enclosed": "#1a7f37",
    "identified": "#1a7f37",
    "tested": "#9a6700",
    "undecided": "#9a6700",
    "undefined": "#9a6700",
    "refuted": "#cf222e",
}


def formula(latex: str) -> str:
    """A formula that a notebook typesets."""
    return f"${escape(latex)}$"


def table(head: list[str], rows: list[list[Any]]) -> str:
    """A table of cells that are HTML already; a pair is a word with its colour."""
    lines = ["<table><tr>" + "".join(f'<th style="text-align:left">{escape(name)}</th>' for name in head) + "</tr>"]
    for row in rows:
        cells = []
        for cell in row:
            if isinstance(cell, tuple):
                word, colour = cell
                cells.append(f'<td style="text-align:left;color:{colour or "#656d76"}"><b>{escape(word)}</b></td>')
            else:
                cells.append(f'<td style="text-align:left">{cell}</td>')
        lines.append("<tr>" + "".join(cells) + "</tr>")
    return "".join(lines) + "</table>"
