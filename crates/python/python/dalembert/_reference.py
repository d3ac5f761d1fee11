"""Motions to all digits that two methods share."""

from __future__ import annotations

import json
from dataclasses import dataclass
from decimal import Decimal
from html import escape
from typing import Any

import numpy

from ._columns import TimedColumns, of_unit
from ._html import table

__all__ = ["Reference", "ReferenceEvent"]


@dataclass(frozen=True)
class ReferenceEvent:
    """An event to all digits: its time in seconds, what happened, the regime that holds then (empty at an end), and the state.

    The state has coordinates alone where speeds grow without bound.
    """

    time: Decimal
    what: str
    regime: str
    state: list[Decimal]


class Reference(TimedColumns):
    """A motion to all digits that two methods of different families share, for measuring errors.

    reference["x"] is a column of the numbers of 64 bits nearest to the motion, at the times reference.time in seconds; reference.array has a row for each
    time, its columns as in reference.names: coordinates, then speeds, in SI units. decimals: for each name its numbers with all digits, as
    decimal.Decimal. digits: how many digits both methods share, counted from `sizes`, the largest size of each component along the motion. methods: their
    names. events: those of a law that changes. text: the same for reading, as the program prints it. data: all of it.
    """

    __slots__ = ("data", "decimals", "digits", "events", "methods", "sizes", "text")

    def __init__(self, written: str, text: str) -> None:
        self.data: dict[str, Any] = json.loads(written)
        names, states = self.data["names"], self.data["states"]
        # the decimal digits are rounded once, to the nearest number
        rows = numpy.array([[float(number) for number in row] for row in states])
        super().__init__(numpy.array(self.data["times"], dtype=float), rows, zip(names, self.data["units"]), self.data["title"])
        self.text = text
        self.digits: float = self.data["digits"]
        self.methods: list[str] = self.data["methods"]
        self.sizes: dict[str, float] = dict(zip(names, self.data["sizes"]))
        self.decimals = {name: [Decimal(row[place]) for row in states] for place, name in enumerate(names)}
        self.events = [ReferenceEvent(Decimal(one["time"]), one["what"], one["regime"], list(map(Decimal, one["state"]))) for one in self.data["events"]]

    def _marks(self) -> list[float]:
        return [float(event.time) for event in self.events]

    def __reduce__(self):
        return Reference, (json.dumps(self.data), self.text)

    def __repr__(self) -> str:
        lines = [self.text.rstrip(), f"at t = {self.time[-1]:.9g} s"]
        return "\n".join(lines + [f"  {name:<18} {values[-1]:f} {of_unit(self.units[name])}".rstrip() for name, values in self.decimals.items()])

    def _repr_html_(self) -> str:
        head, *rest = self.text.rstrip().splitlines()
        rows = [[escape(name), escape(of_unit(self.units[name])), f"<code>{values[-1]:f}</code>"] for name, values in self.decimals.items()]
        facts = "<br>".join(map(escape, rest))
        return f"<b>{escape(head or 'a reference')}</b><br>{facts}" + table(["state", "unit", f"at t = {self.time[-1]:.9g} s"], rows)
