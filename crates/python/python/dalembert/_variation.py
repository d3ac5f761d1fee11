"""The numbers that vary in an ensemble, as the table [ensemble] of a text."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from ._arguments import mapping, number, shown, whole
from ._builder import in_toml, key_in_toml
from ._native import ModelError
from ._refusals import of_issues
from ._tables import without_table

if TYPE_CHECKING:
    from ._model import Model

__all__ = ["Variation"]

# as the language has them
_MOST_MEMBERS = 100_000_000
_LARGEST_SEED = 2**32 - 1
_EXAMPLE = '{"m": {"from": 0.9, "to": 1.1}}'
_QUANTITY = re.compile(r"\s*([+-]?(?:\d[\d_]*\.?[\d_]*|\.\d+)(?:[eE][+-]?\d+)?)(?:\s+(\S.*?))?\s*")
_PLACE = re.compile(r".*?:(\d+):\d+: ")
_CURRENT = re.compile(r"[^.]+\.i(_\w+)?")


class Variation:
    """The numbers that vary in an ensemble of a model, and the number of its members; numbers without units are in SI units.

    text: the text of the model with the table [ensemble] in the place of its own. Raises TypeError and ValueError for what cannot vary so.
    """

    def __init__(self, model: Model, members: Any, vary: Any, seed: Any) -> None:
        self._vary = mapping("vary", vary, _EXAMPLE)
        if members is None or not self._vary:
            raise ValueError("`members`, their number, and `vary`, what varies, are accepted together")
        own = without_table(model.text, "ensemble")
        own += "" if own.endswith("\n") else "\n"
        head = ["[ensemble]", f"members = {whole('members', members, _MOST_MEMBERS)}", f"seed = {whole('seed', seed, _LARGEST_SEED, 0)}", "[ensemble.vary]"]
        self._parameters = list(model.parameters)
        # the last line of the text itself, and that at which the first variable stands, from 1
        self._end = own.count("\n")
        self._first = self._end + len(head) + 1
        units = _units(model, self._vary)
        self.text = own + "\n".join([*head, *(self._line(name, one, units.get(name, "1")) for name, one in self._vary.items())]) + "\n"

    def _line(self, name: str, distribution: Any, unit: str) -> str:
        keys = mapping(f'vary["{name}"]', distribution, '{"from": 0.9, "to": 1.1}, {"mean": 0, "deviation": 0.1} or {"values": [1, 2, 3]}')
        rows = {key: _written(f'vary["{name}"]["{key}"]', value, unit) for key, value in keys.items()}
        table = "parameters" if name in self._parameters else "start"
        return f"{table}.{key_in_toml(name)} = {in_toml(rows)}"

    def told(self, error: ModelError) -> ModelError:
        """A fault of this text in the words of the call: the table [ensemble] has no lines that a user has."""
        issues = getattr(error, "issues", [])
        if not any(self._is_of_call(issue) for issue in issues):
            return error
        return of_issues([self._told(issue) if self._is_of_call(issue) else issue for issue in issues])

    def warned(self, message: str) -> str:
        """A warning about this text in the words of the call."""
        found = _PLACE.match(message)
        name = None if found is None else self._name_at(int(found[1]))
        return message if name is None else f'`vary["{name}"]`: {message[found.end() :]}'

    def _name_at(self, line: int) -> str | None:
        """The name that varies by a line of the text."""
        names = list(self._vary)
        return names[line - self._first] if 0 <= line - self._first < len(names) else None

    def _is_of_call(self, issue: dict[str, Any]) -> bool:
        return issue["line"] is not None and issue["line"] > self._end

    def _told(self, issue: dict[str, Any]) -> dict[str, Any]:
        name = self._name_at(issue["line"])
        where = "" if name is None else f'`vary["{name}"]`: '
        remedy = issue["remedy"]
        if issue["title"] == f"unknown key `{name}`" and self._parameters:
            remedy = f"{remedy}; parameters: {', '.join(self._parameters)}"
        label = "" if issue["label"] == "here" else issue["label"]
        return {**issue, "line": None, "column": None, "title": where + issue["title"], "label": label, "remedy": remedy}


def _units(model: Model, vary: dict[str, Any]) -> dict[str, str]:
    """Units of what may vary: of free frames, currents and quasi-velocities too."""
    units = model.units
    units.update({name[: -len(".q0")]: "rad" for name in model.states if name.endswith(".q0")})
    others = [name for name in vary if name not in units]
    units.update({name: "A" for name in others if _CURRENT.fullmatch(name)})
    if any(name not in units for name in others):
        # columns of a run have the units of quasi-velocities; what does not run has no ensemble, which says why
        try:
            run = model._native.run(1e-6, None, None, 1, 10.0)
            units = {**dict(zip(run.names, run.units)), **units}
        except ModelError:
            pass
    return units


def _written(name: str, value: Any, unit: str) -> str:
    """Numbers as a text of the language: one, a row, or rows."""
    if isinstance(value, str):
        return value
    if isinstance(value, (Mapping, bytes)):
        raise TypeError(f"`{name}` is {shown(value)}; a number, a text with a unit, or a list of these is accepted")
    listed = list(value) if _is_listed(value) else [value]
    rows = [list(row) for row in listed] if listed and all(map(_is_listed, listed)) else [listed]
    found = [[_quantity(name, one, unit) for one in row] for row in rows]
    units = {unit for row in found for _, unit in row}
    if not units:
        raise ValueError(f"`{name}` is {shown(value)}; one number or more are accepted")
    if len(units) > 1:
        raise ValueError(f"`{name}` is {shown(value)}, numbers in {' and in '.join(sorted(units))}; numbers in one unit are accepted")
    (common,) = units
    return "; ".join(" ".join(text for text, _ in row) for row in found) + ("" if common == "1" else f" {common}")


def _is_listed(value: Any) -> bool:
    return isinstance(value, Iterable) and not isinstance(value, (str, bytes, Mapping)) and getattr(value, "ndim", 1) > 0


def _quantity(name: str, value: Any, unit: str) -> tuple[str, str]:
    """A number as a text, and its unit."""
    if isinstance(value, str):
        found = _QUANTITY.fullmatch(value)
        if found is None:
            raise ValueError(f"`{name}` has {shown(value)}; a number with its unit is accepted, such as '2 {unit}'")
        return found[1], found[2] or unit
    one = number(name, value)
    if not math.isfinite(one):
        raise ValueError(f"`{name}` has {one}; finite numbers are accepted")
    return repr(one), unit
