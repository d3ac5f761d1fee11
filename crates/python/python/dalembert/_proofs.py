"""Statements with their verdicts, as a list that a notebook shows as a table."""

from __future__ import annotations

from html import escape

from ._html import COLOURS, table
from ._native import Judgement

__all__ = ["Judgements"]


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
            grounds = "".join(f"<br><small>{escape(line)}</small>" for line in judgement.grounds)
            rows.append([escape(judgement.statement), (judgement.verdict, COLOURS.get(judgement.verdict)), escape(judgement.sentence) + grounds])
        return table(["statement", "verdict", "ground"], rows)
