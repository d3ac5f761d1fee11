"""Parts of the package; use the names of `dalembert`."""

from collections.abc import Callable
from os import PathLike
from types import SimpleNamespace
from typing import Any

import numpy
from numpy.typing import ArrayLike, NDArray

METHODS: list[str]
PRINCIPLES: list[str]
VERSION: str

def judge_paper(path: str, text: str | None, seconds: float, tell: Callable[[Any], None]) -> dict[str, Any]:
    """Judges the claims of a paper."""

def end_process_after(seconds: float) -> None:
    """Ends every run of this process after so many seconds."""

class ModelError(ValueError):
    """A model that cannot be read, or that cannot do what is asked of it."""

    file: str
    line: int | None
    column: int | None
    title: str
    label: str
    remedy: str | None
    issues: list[dict[str, Any]]

class Equations:
    """Equations of motion of a model by a principle. A notebook shows them typeset."""

    @property
    def principle(self) -> str: ...
    @property
    def text(self) -> str: ...
    @property
    def latex(self) -> str: ...
    @property
    def sympy(self) -> str: ...
    @property
    def sympy_expressions(self) -> SimpleNamespace: ...
    def code(self, language: str) -> str: ...
    def _repr_latex_(self) -> str | None: ...

class Judgement:
    """A statement about a model with its verdict."""

    @property
    def statement(self) -> str: ...
    @property
    def verdict(self) -> str: ...
    @property
    def sentence(self) -> str: ...
    @property
    def grounds(self) -> list[str]: ...
    @property
    def fails(self) -> bool: ...

class LinearEquations:
    """The linear equations x' = A x + B w, y = C x + D w about a point of a model."""

    @property
    def A(self) -> NDArray[numpy.float64]: ...
    @property
    def B(self) -> NDArray[numpy.float64]: ...
    @property
    def C(self) -> NDArray[numpy.float64]: ...
    @property
    def D(self) -> NDArray[numpy.float64]: ...
    @property
    def eigenvalues(self) -> NDArray[numpy.complex128]: ...
    @property
    def stability(self) -> str: ...
    @property
    def states(self) -> list[str]: ...
    @property
    def inputs(self) -> list[str]: ...
    @property
    def outputs(self) -> list[str]: ...
    @property
    def point(self) -> dict[str, float]: ...

class RightHandSide:
    """The right-hand side of the equations of motion: f(t, y) gives y'."""

    @property
    def states(self) -> list[str]: ...
    @property
    def code_size(self) -> int | None: ...
    @property
    def address(self) -> int: ...
    def __call__(self, t: float, y: ArrayLike) -> NDArray[numpy.float64]: ...

class JacobianMatrix:
    """The derivatives of the right-hand side with respect to the state: J(t, y)."""

    @property
    def states(self) -> list[str]: ...
    @property
    def code_size(self) -> int | None: ...
    @property
    def address(self) -> int: ...
    def __call__(self, t: float, y: ArrayLike) -> NDArray[numpy.float64]: ...

class NativeModel:
    @staticmethod
    def from_text(text: str, name: str) -> NativeModel: ...
    @staticmethod
    def from_file(path: str | PathLike[str]) -> NativeModel: ...
    title: str
    text: str
    name: str
    parameters: list[tuple[str, float | None, str]]
    states: list[tuple[str, str]]
    positions: int
    inputs: list[str]
    values: list[tuple[str, float]]
    def start(self) -> list[float]: ...
    def with_values(self, values: list[tuple[str, float]]) -> NativeModel: ...
    def derive(self, principle: str | None) -> Equations: ...
    def prove(self) -> list[Judgement]: ...
    def check(
        self,
        letters: list[tuple[str, str]],
        speeds: list[str],
        accelerations: list[str],
        multipliers: list[str],
        abbreviations: list[tuple[str, str]],
        kinematics: list[str],
        constraints: list[str],
        equations: list[tuple[str, str]],
    ) -> dict[str, Any]: ...
    def stationary(self, ranges: list[tuple[str, float, float]], boxes: int, seconds: float) -> tuple[str, str]: ...
    def choose(self, tolerance: float, outputs: list[str]) -> tuple[str, str, str]: ...
    def chart(self, seconds: float) -> tuple[str, str, tuple[str, str]]: ...
    def ensemble_members(self) -> int: ...
    def ensemble(self, members: tuple[int, int] | None, threads: int | None, seconds: float) -> dict[str, Any]: ...
    def inverse(self, motions: list[tuple[str, str]], unknowns: list[str], times: list[float]) -> dict[str, Any]: ...
    def regulate(self, seconds: float) -> tuple[str, str]: ...
    def regimes(self) -> tuple[str, str]: ...
    def reference(self, span: float | None, seconds: float) -> tuple[str, str]: ...
    def linearise(self, equilibrium: bool, inputs: list[str]) -> LinearEquations: ...
    def rhs(self) -> RightHandSide: ...
    def jacobian(self) -> JacobianMatrix: ...
    def run(
        self,
        span: float | None,
        method: str | None,
        tolerance: float | None,
        samples: int | None,
        seconds: float,
    ) -> NativeTrajectory: ...

class NativeTrajectory:
    time: NDArray[numpy.float64]
    rows: NDArray[numpy.float64]
    names: list[str]
    units: list[str]
    method: str
    tolerance: float
    states: int
    stopped: str | None
    theory: list[str]
    diagnosis: str | None
    failures: list[tuple[str, float, str, str]]
    lost: tuple[str, float, float] | None
    undefined: list[str]
    invariants: dict[str, tuple[float, float]]
    events: list[tuple[float, str, str | None]]
    work: dict[str, int]
    steps: tuple[str, bool] | None
    checks: dict[str, NDArray[numpy.float64]]
