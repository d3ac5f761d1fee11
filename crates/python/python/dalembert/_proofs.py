"""Statements with their verdicts, as a list that a notebook shows as a table."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape

from ._html import COLOURS, table
from ._native import Judgement as NativeJudgement

__all__ = ["Judgement", "Judgements"]


@dataclass(frozen=True, repr=False)
class Judgement:
    """A statement about a model with its verdict.

    statement: two principles that are compared, or a quantity and what the equations say of it. verdict: proved, identified, tested, refuted,
    undecided, or "does not apply". sentence: the verdict on its ground, and for which values; grounds: line by line. fails: whether something that must
    hold is refuted, or could not be decided.
    """

    statement: str
    verdict: str
    sentence: str
    grounds: list[str]
    fails: bool

    @classmethod
    def of(cls, found: NativeJudgement) -> Judgement:
        """The same as data."""
        return cls(found.statement, found.verdict, found.sentence, found.grounds, found.fails)

    def __repr__(self) -> str:
        return f"{self.statement}: {self.sentence}"


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
