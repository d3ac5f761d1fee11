"""Optimal regulators."""

from __future__ import annotations

import json
from html import escape
from typing import Any

import numpy

from ._columns import TimedColumns, of_unit
from ._html import table

__all__ = ["ClosedLoop", "Regulator"]


def _complex(values: list[list[float]]) -> numpy.ndarray:
    return numpy.array([complex(*value) for value in values])


def _shown(value: complex) -> str:
    return f"{value.real:.6g}" if value.imag == 0 else f"{value.real:.6g} {'-' if value.imag < 0 else '+'} {abs(value.imag):.6g} i"


def _matrix(head: list[str], side: list[str], matrix: numpy.ndarray) -> str:
    rows = [[f"<b>{escape(name)}</b>"] + [f"{value:.9g}" for value in row] for name, row in zip(side, matrix)]
    return table(["", *head], rows)


class ClosedLoop(TimedColumns):
    """The run of a closed loop: coordinates, speeds, inputs, and the cost so far.

    run["x"] is a column, run.time the times in seconds, as of the run of a model. stopped: why the run ended early; None where it did not. events:
    (time, what, what holds then) of each.
    """

    __slots__ = ("events", "stopped")

    def __init__(self, told: dict[str, Any], columns: list[tuple[str, str]], title: str) -> None:
        run = told["run"]
        rows = numpy.column_stack([numpy.array(run[name], dtype=float).reshape(len(run["times"]), -1) for name in ("states", "inputs", "costs")])
        super().__init__(numpy.array(run["times"], dtype=float), rows, columns, title)
        self.stopped: str | None = told["stopped"]
        self.events: list[tuple[float, str, str | None]] = [(event["time"], event["what"], event["then"]) for event in told["events"]]

    @property
    def ok(self) -> bool:
        """Whether the run reached its end, and every column has a value at every time; constants of the motion are not looked at."""
        return self.stopped is None and bool(numpy.isfinite(self.array).all())

    def _marks(self) -> list[float]:
        return [time for time, *_ in self.events]


class Regulator:
    """The optimal regulator u = u0 - K (x - x0) of a model, and the run of its closed loop on the nonlinear model.

    states, inputs: names of the n states and the m inputs of the linear equations. K, m by n, and P, n by n, of the least cost x^T P x: those at the
    start where the criterion has a horizon. eigenvalues, eigenvalues_closed: of A, and of A - B K (None with a horizon), in 1/s. controllable: whether
    the inputs reach every variation; controllability says it in a sentence. cost_by_riccati, cost_of_run: the least cost of the linear equations, and
    that of the run with what is left at its end. run: the motion of the closed loop, a ClosedLoop with columns of coordinates, speeds, inputs and the cost so far;
    events: (time, what, what holds then) of each; stopped: why the run ended early, None where it did not. All numbers are in SI units. text: the same for
    reading, as the program prints it. data: all of it, as the program writes it in JSON.
    """

    __slots__ = ("data", "run", "text", "title")

    def __init__(self, written: str, text: str, title: str) -> None:
        self.data: dict[str, Any] = json.loads(written)
        self.text = text
        self.title = title
        names = self.data["columns"] + self.inputs + ["cost"]
        self.run = ClosedLoop(self.data, list(zip(names, self.data["units"] + ["1"])), title)

    @property
    def states(self) -> list[str]:
        """Names of the states on which the gains act."""
        return self.data["states"]

    @property
    def inputs(self) -> list[str]:
        """Names of the inputs."""
        return self.data["inputs"]

    @property
    def K(self) -> numpy.ndarray:
        """The gains, a row for each input, a column for each state."""
        return numpy.array(self.data["gains"], dtype=float)

    @property
    def P(self) -> numpy.ndarray:
        """The matrix of the least cost x^T P x, by states."""
        return numpy.array(self.data["riccati"], dtype=float)

    @property
    def eigenvalues(self) -> numpy.ndarray:
        """Eigenvalues of A, in 1/s."""
        return _complex(self.data["eigenvalues"])

    @property
    def eigenvalues_closed(self) -> numpy.ndarray | None:
        """Eigenvalues of A - B K, in 1/s; None with a horizon."""
        closed = self.data["eigenvalues_closed"]
        return None if closed is None else _complex(closed)

    @property
    def controllable(self) -> bool:
        """Whether the inputs reach every variation."""
        return self.data["controllable"]

    @property
    def controllability(self) -> str:
        """The variations that the inputs reach, in a sentence."""
        return self.data["controllability"]

    @property
    def cost_by_riccati(self) -> float:
        """The least cost of the linear equations, x^T P x of the displaced start."""
        return self.data["cost_by_riccati"]

    @property
    def cost_of_run(self) -> float:
        """The cost of the run, with that of the deviation at its end."""
        return self.data["cost_of_run"]

    @property
    def stopped(self) -> str | None:
        """Why the run ended early; None where it did not."""
        return self.run.stopped

    @property
    def events(self) -> list[tuple[float, str, str | None]]:
        """Events of the run: time, what happened, what holds then."""
        return self.run.events

    def __reduce__(self):
        return Regulator, (json.dumps(self.data), self.text, self.title)

    def __repr__(self) -> str:
        return self.text.rstrip()

    def _repr_html_(self) -> str:
        number = lambda value: "" if value is None else f"{value:.9g}"  # noqa: E731
        listed = lambda values: ", ".join(map(_shown, values))  # noqa: E731
        facts = [
            ("inputs", ", ".join(self.inputs)),
            ("controllability", self.controllability),
            ("eigenvalues", listed(self.eigenvalues)),
            ("of the closed loop", listed(self.eigenvalues_closed) if self.eigenvalues_closed is not None else ""),
            ("cost by Riccati", number(self.cost_by_riccati)),
            ("cost of the run", number(self.cost_of_run)),
            ("stopped", self.stopped or ""),
        ]
        if len(self.run.time):
            facts.append(("end", f"t = {self.run.time[-1]:.9g} s: " + ", ".join(f"{name} = {value:.6g} {of_unit(self.run.units[name])}".rstrip() for name, value in self.run.last.items())))
        rows = [[escape(name), escape(value)] for name, value in facts if value]
        head = f"<b>{escape(self.title or 'a regulator')}</b>"
        return head + table(["", ""], rows) + "gains K" + _matrix(self.states, self.inputs, self.K) + "P of the least cost" + _matrix(self.states, self.states, self.P)
