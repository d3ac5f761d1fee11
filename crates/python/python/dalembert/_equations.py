"""Equations of motion in every notation."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

from ._arguments import shown
from ._native import Equations as NativeEquations
from ._warnings import without

if TYPE_CHECKING:
    from ._model import Model

__all__ = ["Equations"]


class Equations:
    """Equations of motion of a model by a principle. A notebook shows them typeset.

    principle: its name. text: for reading, the matrix form M q'' + h = Q and its letters with their units. Other notations are written when they are
    asked for, and raise ModelError where the equations are too long for them.

        >>> equations = model.derive("lagrange")
        >>> equations.latex, equations.code("c")
    """

    __slots__ = ("_model", "_written", "principle", "text")

    def __init__(self, model: Model, principle: str, text: str, written: NativeEquations | None = None) -> None:
        self._model, self.principle, self.text, self._written = model, principle, text, written

    def _asked(self, ask: Callable[[NativeEquations], Any]) -> Any:
        """Another notation, for which the text is read again; after these were pickled, the equations are derived again."""
        with without(self._model._told):
            if self._written is None:
                self._written = self._model._native.derive(self.principle)
            return ask(self._written)

    @property
    def latex(self) -> str:
        """LaTeX, an `align` for each group."""
        return self._asked(lambda written: written.latex)

    @property
    def sympy(self) -> str:
        """A Python program over SymPy's symbols."""
        return self._asked(lambda written: written.sympy)

    @property
    def sympy_expressions(self) -> SimpleNamespace:
        """The same as objects of SymPy, which must be installed.

        q, mass_matrix, inertia, forces and equations, with constraints their jacobian, bias, constraints and multipliers; `letters` by their names,
        `values` of parameters. A condition within another one is Step(x), 1 where x > 0 and else 0.
        """
        return self._asked(lambda written: written.sympy_expressions)

    def code(self, language: str) -> str:
        """Straight-line code: language "c", "python" or "rust"."""
        if not isinstance(language, str):
            raise TypeError(f'`language` is {shown(language)}; "c", "python" and "rust" are accepted')
        return self._asked(lambda written: written.code(language))

    def _repr_latex_(self) -> str | None:
        return self._asked(lambda written: written._repr_latex_())

    def __reduce__(self):
        return Equations, (self._model, self.principle, self.text)

    def __repr__(self) -> str:
        return self.text
