"""A run: named columns with units, and what is to be known of it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from html import escape
from types import SimpleNamespace
from typing import Any

import numpy

from ._native import NativeTrajectory

__all__ = ["Trajectory"]


# all that a run knows, as plain data
_KEPT = ("time", "rows", "names", "units", "method", "tolerance", "states", "stopped", "theory", "diagnosis", "failures", "lost", "undefined", "invariants", "events", "work", "steps", "checks")


def _restored(kept: dict[str, Any], title: str) -> Trajectory:
    return Trajectory(SimpleNamespace(**kept), title)


class Trajectory:
    """A run of a model.

    run["x"] is a column, run["time"] or run.time the times, run[["x", "y"]] some columns side by side; run.array has a row for each time,
    its columns as in run.names. `run.ok` says whether the run reached its end and nothing was found wrong with its numbers; `run.stopped`, `run.lost` and
    `run.undefined` say why not.
    """

    __slots__ = ("_native", "_places", "title")

    def __init__(self, native: NativeTrajectory | SimpleNamespace, title: str) -> None:
        self._native = native
        native.time.setflags(write=False)
        native.rows.setflags(write=False)
        self._places = {name: place for place, name in enumerate(native.names)}
        self.title = title

    @property
    def time(self) -> numpy.ndarray:
        """Times in seconds."""
        return self._native.time

    @property
    def array(self) -> numpy.ndarray:
        """A row for each time: states, outputs, energies; not copied."""
        return self._native.rows

    @property
    def names(self) -> list[str]:
        """Names of the columns."""
        return self._native.names

    @property
    def units(self) -> dict[str, str]:
        """Units of the columns."""
        return dict(zip(self._native.names, self._native.units))

    def __getitem__(self, name: str | list[str]) -> numpy.ndarray:
        if isinstance(name, list):
            return numpy.column_stack([self[one] for one in name])
        if name == "time" and name not in self._places:
            return self.time
        if name not in self._places:
            raise KeyError(f"no column is called {name!r}; there are {', '.join(self.names)}")
        return self.array[:, self._places[name]]

    def __contains__(self, name: str) -> bool:
        return name == "time" or name in self._places

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def items(self) -> list[tuple[str, numpy.ndarray]]:
        """Names and columns."""
        return [(name, self[name]) for name in self.names]

    def keys(self) -> list[str]:
        """Names of the columns: dict(run) has them all."""
        return self.names

    def __len__(self) -> int:
        return len(self.names)

    @property
    def states(self) -> list[str]:
        """Names of the columns that are the state."""
        return self.names[: self._native.states]

    @property
    def last(self) -> dict[str, float]:
        """The last row by its names."""
        return dict(zip(self.names, map(float, self.array[-1])))

    @property
    def ok(self) -> bool:
        """Whether the run reached its end, and nothing says that its numbers are not the motion.

        Signs against it: the energy is lost (`lost`), shorter steps of a constant length go elsewhere (`steps`), an event was
        missed (`failures`), a state has no value.
        """
        follows = self._native.steps is None or self._native.steps[1]
        misses = any(name == "missed event" for name, *_ in self.failures)
        return self.stopped is None and self.lost is None and follows and not misses and not self._native.undefined

    @property
    def stopped(self) -> str | None:
        """Why the run stopped before its end; None where it did not."""
        return self._native.stopped

    @property
    def lost(self) -> str | None:
        """The quantity that the motion keeps and the run has lost, such as the energy behind a singular place; None where nothing is."""
        if self._native.lost is None:
            return None
        name, at, size = self._native.lost
        return f"{name} is lost at t = {at:.9g} s, where its change passed a hundredth of {size:.2g}; numbers from there on are no motion"

    @property
    def steps(self) -> str | None:
        """The verdict of shorter steps on a run with constant ones."""
        return None if self._native.steps is None else self._native.steps[0]

    @property
    def undefined(self) -> list[str]:
        """Columns without a value at some time, such as an output that divides by zero there."""
        missing = [name for name in self.names if not numpy.isfinite(self[name]).all()]
        return missing + [name for name in self._native.undefined if name not in missing]

    @property
    def checks(self) -> dict[str, numpy.ndarray]:
        """Quantities that should stay zero: the change of what is kept, and the largest residual of the constraints, at each sample."""
        return self._native.checks

    @property
    def invariants(self) -> dict[str, tuple[float, float]]:
        """Quantities that are kept along the run: first value, and largest change."""
        return self._native.invariants

    @property
    def events(self) -> list[tuple[float, str, str | None]]:
        """Events: time, what happened, what holds then."""
        return self._native.events

    @property
    def theory(self) -> list[str]:
        """Sentences of theory on the run."""
        return self._native.theory

    @property
    def diagnosis(self) -> str | None:
        """The end that a run came to early, where it is known."""
        return self._native.diagnosis

    @property
    def failures(self) -> list[tuple[str, float, str, str]]:
        """Failures by their standard names: name, time, evidence, remedy."""
        return self._native.failures

    @property
    def work(self) -> dict[str, int]:
        """Counts of evaluations, Jacobians, factorisations, steps."""
        return self._native.work

    def to_dataframe(self) -> Any:
        """A pandas DataFrame, indexed by time; pandas must be installed."""
        import pandas

        return pandas.DataFrame(self.array, index=pandas.Index(self.time, name="time"), columns=self.names)

    def plot(self, *names: str | Iterable[str], figure: Any = None) -> Any:
        """Draws columns over time, one picture for each unit; without names all of them. Gives the figure of matplotlib."""
        from ._plot import plot

        flat = [one for name in names for one in ([name] if isinstance(name, str) else name)]
        return plot(self, flat or self._usual(), figure)

    def phase(self, abscissa: str, ordinate: str, axes: Any = None) -> Any:
        """Draws one column over another: run.phase("theta", "theta'"). Gives the axes of matplotlib."""
        from ._plot import phase

        return phase(self, abscissa, ordinate, axes)

    def _usual(self) -> list[str]:
        energies = {"kinetic_energy", "potential_energy"}
        chosen = [name for name in self.names if name not in energies]
        return chosen + [name for name in self.names if name in energies and numpy.ptp(self[name]) > 0]

    def _facts(self) -> list[tuple[str, str]]:
        facts = [("method", f"{self._native.method}, tolerance {self._native.tolerance:g}")]
        facts += [("theory", sentence) for sentence in self.theory]
        end = f"t = {self.time[-1]:.9g} s"
        if self.stopped is None:
            facts.append(("reached", end if self.diagnosis is None else f"{end}: {self.diagnosis}"))
        else:
            facts.append(("stopped", f"{self.stopped}; the last good state is at {end}"))
            if self.diagnosis is not None:
                facts.append(("diagnosis", self.diagnosis))
        for name, time, evidence, remedy in self.failures:
            facts += [("failure", f"{name} at t = {time:.9g} s: {evidence}"), ("remedy", remedy)]
        if self.lost is not None:
            facts.append(("lost", self.lost))
        if self.steps is not None:
            facts.append(("steps", self.steps))
        facts += [(name, f"at most {numpy.abs(values).max():.1e}") for name, values in self.checks.items() if name.startswith("residual") and len(values)]
        if self.undefined:
            facts.append(("undefined", ", ".join(self.undefined)))
        facts += [(name, f"{first:.9g}, kept to {change:.1e}") for name, (first, change) in self.invariants.items()]
        return facts

    def __reduce__(self):
        return _restored, ({name: getattr(self._native, name) for name in _KEPT}, self.title)

    def __repr__(self) -> str:
        lines = [self.title or "a run"] + [f"  {name:<18} {value}" for name, value in self._facts()]
        lines += [f"  {name:<18} {value:.9g} {_unit(self.units[name])}".rstrip() for name, value in self.last.items()]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        rows = [(name, value) for name, value in self._facts()]
        rows += [(name, f"{value:.9g} {_unit(self.units[name])}") for name, value in self.last.items()]
        cells = "".join(
            f'<tr><td style="text-align:left">{escape(name)}</td><td style="text-align:left">{escape(value)}</td></tr>'
            for name, value in rows
        )
        return f"<b>{escape(self.title or 'a run')}</b><table>{cells}</table>"


def _unit(unit: str) -> str:
    return "" if unit == "1" else unit
