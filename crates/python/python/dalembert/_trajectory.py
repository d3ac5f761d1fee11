"""A run: named columns with units, and what is to be known of it."""

from __future__ import annotations

from html import escape
from types import SimpleNamespace
from typing import Any

import numpy

from ._columns import TimedColumns, of_unit
from ._native import NativeTrajectory

__all__ = ["Trajectory"]


# all that a run knows, as plain data
_KEPT = ("time", "rows", "names", "units", "method", "tolerance", "states", "stopped", "theory", "diagnosis", "failures", "lost", "undefined", "invariants", "events", "work", "steps", "checks")


def _restored(kept: dict[str, Any], title: str) -> Trajectory:
    return Trajectory(SimpleNamespace(**kept), title)


class Trajectory(TimedColumns):
    """A run of a model.

    run["x"] is a column, run.time the times in seconds (run["time"] too, where no coordinate has this name), run[["x", "y"]] some columns side by side; run.array has a row for each
    time, its columns as in run.names: states, outputs, energies; run.units has their units. `run.ok` says whether the run reached its end and
    nothing was found wrong with its numbers; `run.stopped`, `run.lost` and `run.undefined` say why not.
    """

    __slots__ = ("_native",)

    def __init__(self, native: NativeTrajectory | SimpleNamespace, title: str) -> None:
        super().__init__(native.time, native.rows, zip(native.names, native.units), title)
        self._native = native

    @property
    def states(self) -> list[str]:
        """Names of the columns that are the state."""
        return self.names[: self._native.states]

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

    def _usual(self) -> list[str]:
        energies = {"kinetic_energy", "potential_energy"}
        chosen = [name for name in self.names if name not in energies]
        return chosen + [name for name in self.names if name in energies and numpy.ptp(self[name]) > 0]

    def _marks(self) -> list[float]:
        return [time for time, *_ in self.events[1:]]

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
        facts += [(name, f"{first:.9g}, changed by at most {change:.1e}") for name, (first, change) in self.invariants.items()]
        return facts

    def __reduce__(self):
        return _restored, ({name: getattr(self._native, name) for name in _KEPT}, self.title)

    def __repr__(self) -> str:
        lines = [self.title or "a run"] + [f"  {name:<18} {value}" for name, value in self._facts()]
        lines += [f"  {name:<18} {value:.9g} {of_unit(self.units[name])}".rstrip() for name, value in self.last.items()]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        rows = [(name, value) for name, value in self._facts()]
        rows += [(name, f"{value:.9g} {of_unit(self.units[name])}") for name, value in self.last.items()]
        cells = "".join(
            f'<tr><td style="text-align:left">{escape(name)}</td><td style="text-align:left">{escape(value)}</td></tr>'
            for name, value in rows
        )
        return f"<b>{escape(self.title or 'a run')}</b><table>{cells}</table>"
