"""Regimes of contacts and conditions that are consistent at a start."""

from __future__ import annotations

import json
from dataclasses import dataclass
from html import escape
from typing import Any

from ._columns import of_unit
from ._html import table

__all__ = ["Margin", "Regime", "Regimes"]


@dataclass(frozen=True)
class Margin:
    """A condition that a regime must meet, and by how much it does.

    of: the contact, or the condition of the text. condition: what is asked, such as a positive normal force. value: the margin, in `unit`.
    """

    of: str
    condition: str
    value: float | None
    unit: str


@dataclass(frozen=True)
class Regime:
    """A consistent regime.

    name: the state of each contact and condition. margins: the conditions of the regime. reactions_determined: whether the motion determines the
    reactions; else the margins are of one possible choice.
    """

    name: str
    margins: list[Margin]
    reactions_determined: bool


class Regimes(list[Regime]):
    """Every regime that is consistent at the start of a model, a list of Regime.

    verdict: "one motion", "no motion", "several motions", "infinitely many motions", or why it is not decided. determined: whether there is one motion.
    critical_friction: the factor of all coefficients of friction up to which the reactions of sliding contacts are unique, and the regime that becomes
    singular there; None where there is none. text: the same for reading, as the program prints it. data: all of it, as the program writes it in JSON.
    """

    def __init__(self, written: str, text: str) -> None:
        self.data: dict[str, Any] = json.loads(written)
        self.text = text
        super().__init__(_regime(told) for told in self.data["regimes"])

    @property
    def title(self) -> str:
        """The title of the model."""
        return self.data["title"]

    @property
    def verdict(self) -> str:
        """The number of motions from the start, in words."""
        return self.data["verdict"]

    @property
    def determined(self) -> bool:
        """Whether there is one motion from the start."""
        return self.data["determined"]

    @property
    def critical_friction(self) -> tuple[float, str] | None:
        """The factor of friction at which reactions become singular, and the regime in which they do."""
        found = self.data["critical_friction"]
        return None if found is None else (found["factor"], found["regime"])

    def __reduce__(self):
        return Regimes, (json.dumps(self.data), self.text)

    def __repr__(self) -> str:
        return self.text.rstrip()

    def _repr_html_(self) -> str:
        rows = []
        for regime in self:
            note = "" if regime.reactions_determined else "<br><small>possible reactions: the motion does not determine them</small>"
            for place, margin in enumerate(regime.margins or [Margin("", "", None, "1")]):
                value = "" if margin.value is None else f"{margin.value:.6g} {of_unit(margin.unit)}".rstrip()
                rows.append([escape(regime.name) + note if place == 0 else "", escape(margin.of), escape(margin.condition), escape(value)])
        head = f"<b>{escape(self.title or 'regimes at the start')}</b><br>{escape(self.verdict)}"
        if self.critical_friction is not None:
            factor, where = self.critical_friction
            head += f"<br><small>reactions of sliding contacts become singular at {factor:.6g} times this friction: {escape(where)}</small>"
        return head + (table(["regime", "contact", "condition", "margin"], rows) if rows else "")


def _regime(told: dict[str, Any]) -> Regime:
    margins = [Margin(one["contact"], one["condition"], one["margin"], one["unit"]) for one in told["margins"]]
    return Regime(told["regime"], margins, told["reactions_determined"])
