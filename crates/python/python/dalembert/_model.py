"""A model and all that is done with it."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, Literal

import numpy

from ._apart import apart
from ._arguments import LONGEST, mapping, names, number, seconds_of, shown, span_of, whole
from ._builder import ModelBuilder
from ._equations import Equations
from ._forces import Forces
from ._linear import LinearEquations
from ._native import JacobianMatrix, ModelError, NativeModel, RightHandSide
from ._parts import in_parts
from ._proofs import Judgement, Judgements
from ._reference import Reference
from ._regimes import Regimes
from ._regulator import Regulator
from ._results import Chart, Ensemble, ModelChoice, SteadyMotions
from ._trajectory import Trajectory
from ._variation import Variation
from ._warnings import heard, known, warn, without

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from numpy.typing import ArrayLike

    from ._check import Check

__all__ = ["Model"]


# of the processor, at most: more are no faster
_MOST_THREADS = 1024
# of a search, at most
_MOST_BOXES = 1_000_000_000
# instants of a run or of forces, at most: as many as the command takes
_MOST_INSTANTS = 1_000_000


def _instants(span: float, samples: int, times: ArrayLike | None) -> list[float]:
    """Instants from 0 to a span, or those that are given."""
    if times is not None:
        try:
            given = numpy.atleast_1d(numpy.asarray(times, dtype=float))
        except (TypeError, ValueError):
            given = numpy.empty(0)
        if given.ndim != 1 or not 1 <= len(given) <= _MOST_INSTANTS or not numpy.isfinite(given).all() or not (numpy.diff(given) > 0).all():
            raise ValueError(f"`times` is {shown(times)}; from one to {_MOST_INSTANTS} finite times in seconds that rise are accepted")
        return given.tolist()
    span = span_of(span)
    count = whole("samples", samples, _MOST_INSTANTS)
    return [span * place / count for place in range(count + 1)]


def _restored(text: str, name: str, values: list[tuple[str, float]]) -> Model:
    native, told = heard(lambda: NativeModel.from_text(text, name))
    known.update(told)
    return Model(native.with_values(values) if values else native, told)


def _read(read: Callable[[], NativeModel]) -> tuple[NativeModel, frozenset[str]]:
    """A model that is read first, whose warnings are told."""
    native, told = heard(read)
    for message in sorted(told):
        warn(message)
    return native, told


class Model:
    """A mechanical or electromechanical system: read from a text or a file, or built.

    Model.from_text, Model.from_file and Model.builder make one. A model does not change: with_values gives another.
    """

    __slots__ = ("_native", "_told")

    def __init__(self, native: NativeModel, told: frozenset[str] = frozenset()) -> None:
        if not isinstance(native, NativeModel):
            raise TypeError("a model is made by Model.from_text(text), Model.from_file(path) or Model.builder(title)")
        # with the warnings of its text, told where it was read
        self._native, self._told = native, told

    @classmethod
    def from_text(cls, text: str, name: str = "<text>") -> Model:
        """Reads a model from a text in TOML; messages call it by `name`."""
        if not isinstance(text, str):
            raise TypeError(f"a text is a str; this is {type(text).__name__}")
        try:
            text.encode()
        except UnicodeEncodeError as error:
            raise ValueError(f"the text has half a letter at its place {error.start + 1}, {text[error.start]!r}; letters of Unicode are accepted") from None
        if not isinstance(name, str):
            raise TypeError(f"`name` is {shown(name)}; a text is accepted, which messages show as the name of the file")
        if "\n" not in text and text.strip().endswith(".toml"):
            raise ValueError(f"{text!r} is the name of a file and no text of a model; Model.from_file reads files")
        return cls(*_read(lambda: NativeModel.from_text(text, name)))

    @classmethod
    def from_file(cls, path: str | os.PathLike[str]) -> Model:
        """Reads a model from a file."""
        try:
            file = os.fsdecode(path)
        except TypeError:
            raise TypeError(f"`path` is {shown(path)}; the name of a file is accepted") from None
        try:
            file.encode()
        except UnicodeEncodeError:
            raise ValueError(f"`path` is {shown(path)}; a name in Unicode is accepted") from None
        return cls(*_read(lambda: NativeModel.from_file(file)))

    @staticmethod
    def builder(title: str = "a model") -> ModelBuilder:
        """Begins a model that is built call by call; `help(ModelBuilder)` shows one."""
        return ModelBuilder(title)

    @property
    def title(self) -> str:
        """The title of the text."""
        return self._native.title

    @property
    def text(self) -> str:
        """The text as it was read, whatever values `with_values` has put in the place of its own."""
        return self._native.text

    @property
    def parameters(self) -> dict[str, float | None]:
        """Parameters in SI units; None of one that is a letter without a value."""
        return {name: value for name, value, _ in self._native.parameters}

    @property
    def states(self) -> list[str]:
        """Names of the state: coordinates, then speeds. `theta'` is the rate of `theta`."""
        return [name for name, _ in self._native.states]

    @property
    def units(self) -> dict[str, str]:
        """Units of parameters and states, in which their numbers are."""
        known = [(name, unit) for name, _, unit in self._native.parameters]
        return dict(known + self._native.states)

    @property
    def start(self) -> numpy.ndarray:
        """The state at time zero, completed so that constraints hold."""
        return numpy.array(self._native.start())

    def with_values(self, values: dict[str, float] | None = None, **more: float) -> Model:
        """The same system with other numbers, in SI units, of parameters and of the start.

        model.with_values(m=2.0, x=0.1), and for names that are none in Python model.with_values({"x'": 1.0}).
        """
        given = {**mapping("values", values, "{'x': 0.1}"), **more}
        return Model(self._native.with_values([(name, number(name, value)) for name, value in given.items()]), self._told)

    def derive(self, principle: str | None = None) -> Equations:
        """Equations of motion by a principle of dalembert.PRINCIPLES.

        Without one by virtual power; of a model with an energy in [energies] by Lagrange's, with [speeds] by Hamel's. A notebook shows them typeset; .text, .latex, .sympy and .code("python") have them in other notations.
        """
        if principle is not None and not isinstance(principle, str):
            raise TypeError(f"`principle` is {shown(principle)}; a name of dalembert.PRINCIPLES is accepted")
        with without(self._told):
            found = self._native.derive(principle)
        return Equations(self, found.principle, found.text, found)

    def prove(self) -> Judgements:
        """Whether all principles give the same equations, and what these keep: a list of statements with their verdicts."""
        with without(self._told):
            return Judgements(map(Judgement.of, self._native.prove()))

    def check(self, method: Any, names: Mapping[Any, str] | None = None, *, seconds: float | None = 300.0) -> Check:
        """Whether the equations of motion of a KanesMethod or a LagrangesMethod of SymPy are those of this model: as `dalembert.check`."""
        from ._check import check

        return check(method, self, names, seconds=seconds)

    def stationary(
        self,
        ranges: Mapping[str, tuple[float, float] | float] | None = None,
        *,
        boxes: int = 200_000,
        seconds: float | None = 300.0,
    ) -> SteadyMotions:
        """All steady motions in ranges of coordinates and of speeds of cyclic ones, each with its stability, and whether there are others.

        ranges: {"x": (-1, 1), "psi'": 2.0} in SI units: an interval, or one value. Angles are sought on the whole circle without one.
        boxes: so many are looked at, at most. seconds: the search ends then with what is decided; None for no limit. Ctrl-C breaks it off.
        """
        asked = []
        for name, range_ in mapping("ranges", ranges, "{'x': (-1, 1)}").items():
            ends = tuple(range_) if isinstance(range_, (tuple, list, numpy.ndarray)) and numpy.ndim(range_) else (range_, range_)
            if len(ends) != 2:
                raise ValueError(f"the range of `{name}` is {shown(range_)}; a number, or a pair of numbers is accepted")
            low, high = (number(name, end) for end in ends)
            if not low <= high < float("inf") or low == float("-inf"):
                raise ValueError(f"the range of `{name}` is {shown(range_)}; two finite numbers that rise are accepted")
            asked.append((name, low, high))
        return SteadyMotions(*apart("stationary", (self, asked, whole("boxes", boxes, _MOST_BOXES)), seconds))

    def choose(self, tolerance: float = 1e-6, outputs: Iterable[str] = (), *, seconds: float | None = 300.0) -> ModelChoice:
        """The smallest model of this system that meets a tolerance in the outputs that matter, and the method that runs it the cheapest.

        tolerance: the largest error allowed, relative to the size of each output. outputs: names of columns of a run; without them the `outputs` of
        [run], or all columns. seconds: nothing is chosen then, and ModelError says so; None for no limit. Ctrl-C breaks it off.
        """
        tolerance = number("tolerance", tolerance)
        if not 0 < tolerance < 1:
            raise ValueError(f"`tolerance` is {tolerance}; a number above 0 and below 1 is accepted")
        written, text, svg = apart("choose", (self, tolerance, names("outputs", outputs, "names of columns")), seconds)
        return ModelChoice(json.loads(written), text, svg)

    def chart(self, *, seconds: float | None = 60.0) -> Chart:
        """Speed against accuracy: every method at every tolerance beside a reference in double-double.

        seconds: a third is for the reference, a third for the runs, a part of the rest for taking times; what does not fit is left out. None for no
        limit. Ctrl-C breaks it off.
        """
        written, text, (svg, svg_time) = apart("chart", (self,), seconds)
        return Chart(json.loads(written), text, svg, svg_time)

    def ensemble(
        self,
        members: int | None = None,
        vary: Mapping[str, Mapping[str, Any]] | None = None,
        *,
        seed: int | None = None,
        threads: int | None = None,
        seconds: float | None = 300.0,
        executor: Executor | None = None,
        parts: int | None = None,
    ) -> Ensemble:
        """Runs many members of this system, whose parameters and starts vary.

        `members` and `vary` stand in the place of the table [ensemble] of the text, which says both where they are left out. vary: for each parameter, and
        each coordinate and speed of the start, its distribution: {"m": {"from": 0.9, "to": 1.1}, "x'": {"mean": 0, "deviation": 0.1},
        "k": {"values": ["1 N/mm", "2 N/mm"]}}. Numbers without a unit are in SI units; the numbers of one list have one unit.
        The numbers of a member depend on `seed` (1 without it), its number and the name of the datum alone. threads: as many as there are processors without
        it; the numbers do not depend on them. seconds: members that have not run by then are left out; None for no limit. Ctrl-C breaks it off.
        executor: any of `concurrent.futures`, or of Dask (`client.get_executor()`), whose workers run parts of the members, by one thread each where
        `threads` is not given; parts: their number, by default four for each processor here. The numbers are those of one run here. What a worker that
        was killed leaves undone is computed here.
        """
        threads = None if threads is None else whole("threads", threads, _MOST_THREADS)
        if executor is None and parts is not None:
            raise ValueError("`parts` is for an `executor`, whose workers run them")
        model, variation = self, None
        if members is not None or vary is not None:
            variation = Variation(self, members, vary, 1 if seed is None else seed)
        elif seed is not None:
            raise ValueError("`seed` is accepted with `members` and `vary`; the table [ensemble] of a text has its own")
        try:
            if variation is not None or executor is not None:
                text = self.text if variation is None else variation.text
                model = _restored(text, self._native.name, self._native.values)
            if executor is None:
                reworded = str if variation is None else variation.warned
                return Ensemble(apart("ensemble", (model, None, threads), seconds, reworded=reworded), self.title)
            return Ensemble(in_parts(model, executor, parts, threads or 1, seconds), self.title)
        except ModelError as error:
            if variation is None:
                raise
            raise variation.told(error) from None

    def run(
        self,
        span: float | None = None,
        *,
        method: str | None = None,
        tolerance: float | None = None,
        samples: int | None = None,
        seconds: float | None = 300.0,
    ) -> Trajectory:
        """Runs the model from its start over `span` seconds.

        What is left out, the table [run] of the text says; without one 10 s, dormand_prince_8, tolerance 1e-8, 200 samples.
        method: one of dalembert.METHODS, such as "taylor", "radau_5" or "implicit_midpoint:1000" with its number of steps.
        seconds: after so long the run is stopped, and what there is is kept; None for no limit. Ctrl-C breaks it off.
        """
        kept = None if samples is None else whole("samples", samples, _MOST_INSTANTS)
        span = None if span is None else span_of(span)
        tolerance = None if tolerance is None else number("tolerance", tolerance)
        if method is not None and not isinstance(method, str):
            raise TypeError(f"`method` is {shown(method)}; a name of dalembert.METHODS is accepted")
        return Trajectory(self._native.run(span, method, tolerance, kept, seconds_of(seconds) or LONGEST), self.title)

    def inverse(
        self,
        motions: Mapping[str, str],
        unknowns: Iterable[str] = (),
        *,
        span: float = 1.0,
        samples: int = 10,
        times: ArrayLike | None = None,
        seconds: float | None = 300.0,
    ) -> Forces:
        """The forces under which this system moves as prescribed (inverse dynamics).

        motions: for each coordinate that the constraints leave open an expression of the time `t` and of parameters, {"theta": "0.5*sin(t*(2 rad/s))"}; a
        free frame by turns, {"F": "w*t about z, then (10 deg) about x"}; a current, {"motor.i_f": "(2 A)"}, where the motion leaves it open.
        unknowns: parameters and inputs that are sought, such as a force; the forces must be linear in them. The instants are `samples` + 1 from 0 to
        `span` in seconds, or `times`, which rise. seconds: TimeoutError then; None for no limit. Ctrl-C breaks it off.

            >>> forces = model.inverse({"theta": "0.5*sin(t*(2 rad/s))"}, "T", span=3.0, samples=300)
            >>> forces["T"], forces["theta''"], forces.time
        """
        if not isinstance(motions, Mapping) or not motions or not all(isinstance(part, str) and part.strip() for pair in motions.items() for part in pair):
            raise TypeError(f"`motions` is {shown(motions)}; a dictionary of expressions is accepted, {{name: expression}}, such as {{'x': '(0.1 m)*sin(t*(2 rad/s))'}}")
        sought = names("unknowns", unknowns, "names of parameters and inputs")
        arguments = (self, list(motions.items()), sought, _instants(span, samples, times))
        return Forces(apart("inverse", arguments, seconds), self.title)

    def regulate(self, *, seconds: float | None = 300.0) -> Regulator:
        """The optimal regulator of the table [regulator] of the text, and the run of its closed loop on the nonlinear model.

        The span of the run is that of [run], 10 s without one, or the horizon of the criterion. seconds: the run is stopped then, and TimeoutError
        is raised where there is no regulator yet; None for no limit. Ctrl-C breaks it off.

            >>> regulator = model.regulate()
            >>> regulator.K, regulator.eigenvalues_closed, regulator.run["x"]
        """
        return Regulator(*apart("regulate", (self,), seconds), self.title)

    def regimes(self, *, seconds: float | None = 300.0) -> Regimes:
        """Every regime of contacts and conditions that is consistent at the start: one motion, none, several or infinitely many.

        seconds: TimeoutError then; None for no limit. Ctrl-C breaks it off.

            >>> regimes = model.regimes()
            >>> regimes.verdict, [regime.name for regime in regimes]
        """
        return Regimes(*apart("regimes", (self,), seconds))

    def reference(self, span: float | None = None, *, seconds: float | None = 300.0) -> Reference:
        """The motion over `span` seconds to all digits that two methods of different families share, 20 or more.

        It is told at eight instants up to its end. Without `span` that of the table [run] of the text, or 10 s. A motion that is known to fewer digits raises ModelError with the reason. seconds: the
        methods have so much time together; None for no limit. Ctrl-C breaks it off.

            >>> reference = model.reference(span=2.0)
            >>> reference.digits, reference["theta"], reference.decimals["theta"][-1]
        """
        return Reference(*apart("reference", (self, None if span is None else span_of(span)), seconds))

    def linearise(self, about: Literal["start", "equilibrium"] = "start", inputs: Iterable[str] = ()) -> LinearEquations:
        """Linear equations x' = A x + B w about the start, or about an equilibrium near it (about="equilibrium").

        inputs: parameters that are inputs w, beside the table [inputs] of the text.
        """
        if about not in ("start", "equilibrium"):
            raise ValueError(f'`about` is {shown(about)}; "start" and "equilibrium" are accepted')
        sought = names("inputs", inputs, "names of parameters")
        with without(self._told):
            return LinearEquations.of(self._native.linearise(about == "equilibrium", sought))

    def rhs(self) -> RightHandSide:
        """The right-hand side f(t, y) of y' = f(t, y) as machine code, for solve_ivp and the like; y as in `states`.

        Rates that the law does not determine, as at a singular position such as a radius of zero, or that hold a division by zero, are returned as not a
        number or as infinite, without an exception: numpy.isfinite(f(t, y)).all() is false there, and `run` stops there, or refuses such a start, with the reason.
        """
        return self._native.rhs()

    def jacobian(self) -> JacobianMatrix:
        """The derivatives of the right-hand side with respect to the state, J(t, y), exact: for the `jac` of solve_ivp."""
        return self._native.jacobian()

    def __reduce__(self):
        return _restored, (self._native.text, self._native.name, self._native.values)

    def __repr__(self) -> str:
        return f"<Model {self.title or self._native.name!r}: {', '.join(self.states)}>"
