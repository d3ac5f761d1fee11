"""Forces under which a system moves as prescribed."""

from __future__ import annotations

from html import escape
from typing import Any

from ._columns import TimedColumns, of_unit
from ._html import table

__all__ = ["Forces"]


class Forces(TimedColumns):
    """Forces along a prescribed motion.

    forces["T"] is a column, a number for each instant of forces.time in seconds; forces.array has a row for each instant, its columns as in
    forces.names: coordinates, speeds, accelerations (`theta''` is that of `theta`), unknowns, multipliers of constraints, in the units of
    forces.units. unknowns: the names of the forces that were sought. multipliers: names of those of constraints.
    """

    __slots__ = ("multipliers", "unknowns")

    def __init__(self, told: dict[str, Any], title: str) -> None:
        rows, columns = told["rows"], told["columns"]
        super().__init__(rows[:, 0], rows[:, 1:], columns[1:], title)
        self.unknowns: list[str] = told["unknowns"]
        self.multipliers: list[str] = told["multipliers"]

    def _usual(self) -> list[str]:
        return self.unknowns or self.multipliers or self.names

    def _rows(self) -> list[list[str]]:
        rows = []
        for name in self.names:
            values = self[name]
            rows.append([name, of_unit(self.units[name])] + [f"{value:.6g}" for value in (values.min(), values.max(), values[-1])])
        return rows

    def _head(self) -> str:
        return f"{len(self.time)} instants from t = {self.time[0]:.9g} s to {self.time[-1]:.9g} s"

    def __repr__(self) -> str:
        lines = [self.title or "forces along a motion", f"  {self._head()}"]
        lines += [f"  {name:<18} from {low} to {high}, at the end {last} {unit}".rstrip() for name, unit, low, high, last in self._rows()]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        rows = [[escape(cell) for cell in row] for row in self._rows()]
        return f"<b>{escape(self.title or 'forces along a motion')}</b><br>{escape(self._head())}" + table(["column", "unit", "least", "largest", "at the end"], rows)
