"""A model and all that is done with it."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, Literal

import numpy

from ._builder import ModelBuilder
from ._native import Equations, JacobianMatrix, LinearEquations, NativeModel, RightHandSide
from ._proofs import Judgements
from ._trajectory import Trajectory

if TYPE_CHECKING:
    from ._check import Check

__all__ = ["Model"]


# seconds, of a run without a limit
_LONGEST = 1e9


def _number(name: str, value: float) -> float:
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"`{name}` is {value!r}; a number in SI units is accepted") from None


def _restored(text: str, name: str, values: list[tuple[str, float]]) -> Model:
    native = NativeModel.from_text(text, name)
    return Model(native.with_values(values) if values else native)


class Model:
    """A mechanical or electromechanical system: read from a text or a file, or built.

    Model.from_text, Model.from_file and Model.builder make one. A model does not change: with_values gives another.
    """

    __slots__ = ("_native",)

    def __init__(self, native: NativeModel) -> None:
        if not isinstance(native, NativeModel):
            raise TypeError("a model is made by Model.from_text(text), Model.from_file(path) or Model.builder(title)")
        self._native = native

    @classmethod
    def from_text(cls, text: str, name: str = "<text>") -> Model:
        """Reads a model from a text in TOML; messages call it by `name`."""
        if not isinstance(text, str):
            raise TypeError(f"a text is a str; this is {type(text).__name__}")
        if "\n" not in text and text.strip().endswith(".toml"):
            raise ValueError(f"{text!r} is the name of a file and no text of a model; Model.from_file reads files")
        return cls(NativeModel.from_text(text, name))

    @classmethod
    def from_file(cls, path: str | os.PathLike[str]) -> Model:
        """Reads a model from a file."""
        return cls(NativeModel.from_file(os.fspath(path)))

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
        given = {**(values or {}), **more}
        return Model(self._native.with_values([(name, _number(name, value)) for name, value in given.items()]))

    def derive(self, principle: str | None = None) -> Equations:
        """Equations of motion by a principle of dalembert.PRINCIPLES.

        Without one by virtual power; of a model with an energy in [energies] by Lagrange's, with [speeds] by Hamel's. A notebook shows them typeset; .text, .latex, .sympy and .code("python") have them in other notations.
        """
        return self._native.derive(principle)

    def prove(self) -> Judgements:
        """Whether all principles give the same equations, and what these keep: a list of statements with their verdicts."""
        return Judgements(self._native.prove())

    def check(self, method: Any, names: Mapping[Any, str] | None = None, *, seconds: float | None = 300.0) -> Check:
        """Whether the equations of motion of a KanesMethod or a LagrangesMethod of SymPy are those of this model: as `dalembert.check`."""
        from ._check import check

        return check(method, self, names, seconds=seconds)

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
        if samples is not None and (isinstance(samples, bool) or int(samples) != samples or samples < 1):
            raise ValueError(f"`samples` is {samples!r}; a whole number from 1 on is accepted")
        span = None if span is None else _number("span", span)
        tolerance = None if tolerance is None else _number("tolerance", tolerance)
        if method is not None and not isinstance(method, str):
            raise TypeError(f"`method` is {method!r}; a name of dalembert.METHODS is accepted")
        limit = _LONGEST if seconds is None else min(_number("seconds", seconds), _LONGEST)
        return Trajectory(self._native.run(span, method, tolerance, samples and int(samples), limit), self.title)

    def linearise(self, about: Literal["start", "equilibrium"] = "start", inputs: Iterable[str] = ()) -> LinearEquations:
        """Linear equations x' = A x + B w about the start, or about an equilibrium near it (about="equilibrium").

        inputs: parameters that are inputs w, beside the table [inputs] of the text.
        """
        if about not in ("start", "equilibrium"):
            raise ValueError(f'`about` is {about!r}; "start" and "equilibrium" are accepted')
        names = [inputs] if isinstance(inputs, str) else list(inputs)
        return self._native.linearise(about == "equilibrium", names)

    def rhs(self) -> RightHandSide:
        """The right-hand side f(t, y) of y' = f(t, y) as machine code, for solve_ivp and the like; y as in `states`."""
        return self._native.rhs()

    def jacobian(self) -> JacobianMatrix:
        """The derivatives of the right-hand side by the state, J(t, y), exact: for the `jac` of solve_ivp."""
        return self._native.jacobian()

    def __reduce__(self):
        return _restored, (self._native.text, self._native.name, self._native.values)

    def __repr__(self) -> str:
        return f"<Model {self.title or self._native.name!r}: {', '.join(self.states)}>"
