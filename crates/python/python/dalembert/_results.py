"""Results of longer computing: steady motions, choices of models, charts, ensembles."""

from __future__ import annotations

import json
from base64 import b64encode
from dataclasses import dataclass, field
from html import escape
from typing import Any

import numpy

from ._columns import Columns, needed_pandas, of_unit
from ._html import table

__all__ = ["Chart", "Ensemble", "ModelChoice", "SteadyMotion", "SteadyMotions"]

_STABILITY = {"stable": "#1a7f37", "asymptotically stable": "#1a7f37", "unstable": "#cf222e"}


def _picture(svg: str) -> str:
    """An SVG that touches nothing else on a page."""
    return f'<img src="data:image/svg+xml;base64,{b64encode(svg.encode()).decode()}" style="max-width:100%">'


@dataclass(frozen=True)
class SteadyMotion:
    """A steady motion: an equilibrium, or a motion along which cyclic coordinates alone move, each at a constant speed.

    enclosure: for each unknown the interval that holds it, and no other steady motion. state: coordinates, then speeds, in SI units. stability:
    "stable", "asymptotically stable", "unstable", "not decided" or "not known"; by_enclosures says whether that is shown by enclosures or found in
    rounded numbers; reason has the ground in a sentence. eigenvalues: of the linear equations, in 1/s, where they were needed. where: the
    conditions of the law under which it was sought.
    """

    enclosure: dict[str, tuple[float, float]]
    state: numpy.ndarray
    stability: str
    by_enclosures: bool
    reason: str
    eigenvalues: numpy.ndarray | None
    where: list[str]


class SteadyMotions(list[SteadyMotion]):
    """All steady motions that were found, a list of SteadyMotion.

    complete: whether no other exists in the ranges. families, regions: families of steady motions, and regions that are not decided, as dictionaries.
    text: the same for reading, as the program prints it. data: all of it, as the program writes it in JSON.
    """

    def __init__(self, written: str, text: str) -> None:
        self.data = json.loads(written)
        self.text = text
        parts = self.data.get("cases", [self.data])
        super().__init__(_steady(motion, part.get("where", [])) for part in parts for motion in part["motions"])
        self.complete: bool = all(part["complete"] for part in parts)
        self.families: list[dict[str, Any]] = [family for part in parts for family in part["families"]]
        self.regions: list[dict[str, Any]] = [region for part in parts for region in part["regions"]]

    def __reduce__(self):
        return SteadyMotions, (json.dumps(self.data), self.text)

    def __repr__(self) -> str:
        return self.text.rstrip()

    def _repr_html_(self) -> str:
        rows = []
        for place, motion in enumerate(self, 1):
            values = "<br>".join(escape(f"{name} = {(low + high) / 2:.9g}") for name, (low, high) in motion.enclosure.items())
            where = "".join(f"<br><small>where {escape(one)}</small>" for one in motion.where)
            rows.append([str(place), values + where, (motion.stability, _STABILITY.get(motion.stability)), escape(motion.reason)])
        families = f" and {len(self.families)} families" if self.families else ""
        end = "there is no other in these ranges" if self.complete else f"others may lie in {len(self.regions)} regions that are not decided"
        head = f"<b>{escape(self.data['title'])}</b><br>{len(self)} steady motions{families}; {end}"
        return head + table(["", "motion", "stability", "ground"], rows)


def _steady(told: dict[str, Any], where: list[str]) -> SteadyMotion:
    eigenvalues = told["eigenvalues"]
    return SteadyMotion(
        enclosure={name: (low, high) for name, (low, high) in told["enclosure"].items()},
        state=numpy.array(told["state"], dtype=float),
        stability=told["stability"],
        by_enclosures=told["enclosed"],
        reason=told["reason"],
        eigenvalues=None if eigenvalues is None else numpy.array([complex(*value) for value in eigenvalues]),
        where=where,
    )


@dataclass(frozen=True)
class ModelChoice:
    """The smallest model that meets a tolerance, with its receipt.

    taken: the name of the model; None where none meets it. tolerance, outputs: as they were asked for. models: every model that was looked at,
    dictionaries with its name, what it drops, its estimate and the run that meets the tolerance. text: the receipt for reading. svg: error against
    the cost of every model. data: all of it, as the program writes it in JSON.
    """

    data: dict[str, Any] = field(repr=False)
    text: str
    svg: str = field(repr=False)

    @property
    def taken(self) -> str | None:
        """The name of the model that was taken."""
        return self.data["taken"]

    @property
    def tolerance(self) -> float:
        """The largest error allowed, relative to the size of each output."""
        return self.data["tolerance"]

    @property
    def outputs(self) -> list[str]:
        """The quantities that matter."""
        return self.data["outputs"]

    @property
    def models(self) -> list[dict[str, Any]]:
        """Every model that was looked at."""
        return self.data["models"]

    @property
    def run(self) -> dict[str, Any] | None:
        """The run of the model that was taken: method, tolerance, evaluations, promised and measured error."""
        return next((model["run"] for model in self.models if model["model"] == self.taken), None)

    def __repr__(self) -> str:
        return self.text.rstrip()

    def _repr_html_(self) -> str:
        rows = []
        for model in self.models:
            run = model["run"] or {}
            name = f"<b>{escape(model['model'])}</b>" if model["model"] == self.taken else escape(model["model"])
            number = lambda value: "" if value is None else f"{value:.1e}"  # noqa: E731
            cells = [name, str(model["states"]), escape(model["verdict"]), str(run.get("evaluations", "")), number(run.get("promised")), number(run.get("measured"))]
            rows.append(cells)
        head = f"<b>{escape(self.data['title'])}</b><br>to {self.tolerance:.0e} in {escape(', '.join(self.outputs))}: {escape(self.taken or 'no model meets this')}"
        return head + table(["model", "states", "verdict", "evaluations", "promised error", "measured error"], rows) + _picture(self.svg)


@dataclass(frozen=True)
class Chart:
    """Speed against accuracy: every method at every tolerance beside a reference.

    chart["error"] is a column, a number for each run: error, evaluations, seconds, tolerance (not a number where there is none); chart["method"],
    ["formulation"], ["model"] and ["failure"] are texts. advice: the fastest at some errors, in sentences. text: tables for reading. svg: error
    against evaluations; svg_time: against time. data: all of it, as the program writes it in JSON.
    """

    data: dict[str, Any] = field(repr=False)
    text: str
    svg: str = field(repr=False)
    svg_time: str = field(repr=False)

    names = ("formulation", "model", "method", "tolerance", "evaluations", "seconds", "error", "failure")

    @property
    def advice(self) -> dict[float, str]:
        """By errors, the fastest method and what the next one costs."""
        return {one["error"]: one["says"] for one in self.data["advice"]}

    @property
    def digits(self) -> float:
        """The digits to which two methods agree on the reference."""
        return self.data["reference"]["digits"]

    def __getitem__(self, name: str) -> numpy.ndarray:
        if name not in self.names:
            raise KeyError(f"no column is called {name!r}; there are {', '.join(self.names)}")
        values = [run[name] for run in self.data["runs"]]
        if name in ("formulation", "model", "method", "failure"):
            return numpy.array([value or "" for value in values])
        return numpy.array([numpy.nan if value is None else value for value in values], dtype=float)

    def __len__(self) -> int:
        return len(self.data["runs"])

    def __repr__(self) -> str:
        return self.text.rstrip()

    def _repr_html_(self) -> str:
        advice = "".join(f"<li>{escape(said)}</li>" for said in self.advice.values())
        return f"<b>{escape(self.data['title'])}</b><ul>{advice}</ul>" + _picture(self.svg) + _picture(self.svg_time)


class Ensemble(Columns):
    """The ends of the members of an ensemble.

    ensemble["x"] is a column, a number for each member; `array` has a row for each member, its columns as in `names`: the numbers that vary, `time` of
    the end, `steps`, the last state, outputs and the drift of the energy. Where the model has a coordinate or an output called `time` or `steps`, these
    names are its own, and those of the run are `run.time` and `run.steps`. A number that a member does not have is not a number. stopped: why a member
    stopped before its end, None where it did not; reached: the same as truth values. broken_off: why members are missing; None where all are there.
    """

    __slots__ = ("broken_off", "stopped")

    def __init__(self, told: dict[str, Any], title: str) -> None:
        super().__init__(told["rows"], told["columns"], title)
        self.stopped: list[str | None] = told["stopped"]
        missing = told["members"] - len(self.stopped)
        self.broken_off = f"{missing} of {told['members']} members have not run: the time was over" if missing else None

    @property
    def reached(self) -> numpy.ndarray:
        """Whether each member reached its end."""
        return numpy.array([why is None for why in self.stopped])

    def __len__(self) -> int:
        return len(self.stopped)

    def to_dataframe(self) -> Any:
        """A pandas DataFrame with a row for each member, counted from one; pandas must be installed."""
        pandas = needed_pandas()
        frame = pandas.DataFrame(self.array, index=pandas.RangeIndex(1, len(self) + 1, name="member"), columns=self.names)
        frame["stopped"] = self.stopped
        return frame

    def _facts(self) -> list[str]:
        reached = int(self.reached.sum())
        facts = [f"{len(self)} members: {reached} reached the end, {len(self) - reached} did not"]
        return facts + ([self.broken_off] if self.broken_off else [])

    def _rows(self) -> list[list[str]]:
        rows = []
        for name in self.names:
            values = self[name][numpy.isfinite(self[name])]
            if len(values):
                rows.append([name, of_unit(self.units[name])] + [f"{value:.6g}" for value in (values.min(), values.mean(), values.max(), values.std())])
        return rows

    def __repr__(self) -> str:
        lines = [self.title or "an ensemble", *self._facts()]
        lines += [f"  {name:<18} from {low} to {high}, mean {mean}, deviation {deviation} {unit}".rstrip() for name, unit, low, mean, high, deviation in self._rows()]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        facts = "<br>".join(map(escape, self._facts()))
        rows = [[escape(cell) for cell in row] for row in self._rows()]
        return f"<b>{escape(self.title or 'an ensemble')}</b><br>{facts}" + table(["column", "unit", "least", "mean", "largest", "deviation"], rows)
