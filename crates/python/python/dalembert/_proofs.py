"""Statements with their verdicts, as a list that a notebook shows as a table."""

from __future__ import annotations

from html import escape

from ._native import Judgement

__all__ = ["Judgements"]

_COLOURS = {"proved": "#1a7f37", "identified": "#1a7f37", "tested": "#9a6700", "refuted": "#cf222e"}


class Judgements(list[Judgement]):
    """A list of Judgement."""

    @property
    def failed(self) -> list[Judgement]:
        """Those that must hold and are refuted, or could not be decided."""
        return [judgement for judgement in self if judgement.fails]

    def __repr__(self) -> str:
        return "\n".join(map(repr, self))

    def _repr_html_(self) -> str:
        rows = []
        for judgement in self:
            colour = _COLOURS.get(judgement.verdict, "#656d76")
            grounds = "".join(f"<br><small>{escape(line)}</small>" for line in judgement.grounds)
            rows.append(
                f'<tr><td style="text-align:left">{escape(judgement.statement)}</td>'
                f'<td style="text-align:left;color:{colour}"><b>{escape(judgement.verdict)}</b></td>'
                f'<td style="text-align:left">{escape(judgement.sentence)}{grounds}</td></tr>'
            )
        return "<table><tr><th>statement</th><th>verdict</th><th>ground</th></tr>" + "".join(rows) + "</table>"
