"""Conditions within conditions, for SymPy. This module imports SymPy, and is imported where SymPy is needed."""

from __future__ import annotations

import ast
from typing import Any

import numpy
from sympy import Function, Piecewise, S, sympify

__all__ = ["Step", "unfolded"]


class Step(Function):
    """Step(x) is 1 where x > 0, and 0 elsewhere; its derivative is 0.

    It stands in the place of a Piecewise within the condition of another one: SymPy folds such conditions into a case for each combination of
    them, which does not end for some saturated controllers.
    """

    nargs = 1
    is_real = True

    @classmethod
    def eval(cls, value: Any) -> Any:
        """The number of a number."""
        if value.is_comparable:
            return S.One if value > 0 else S.Zero
        return None

    def fdiff(self, argindex: int = 1) -> Any:
        """The derivative, zero wherever there is one."""
        return S.Zero

    @staticmethod
    def _imp_(value: Any) -> Any:
        """The numbers of `lambdify`."""
        return numpy.where(numpy.greater(value, 0), 1.0, 0.0)


def _step(piecewise: Any) -> Any:
    """A condition of a program of equations, 1 or 0, as a Step."""
    (_, condition), _ = piecewise.args
    return Step(condition.gts - condition.lts)


def _pieces(*pieces: tuple[Any, Any]) -> Any:
    """A Piecewise whose conditions hold steps, and no Piecewise."""
    return Piecewise(*((value, sympify(condition).replace(lambda part: isinstance(part, Piecewise), _step)) for value, condition in pieces))


class _Calls(ast.NodeTransformer):
    def visit_Call(self, node: ast.Call) -> ast.Call:
        self.generic_visit(node)
        if isinstance(node.func, ast.Name) and node.func.id == "Piecewise":
            node.func.id = _pieces.__name__
        return node


def unfolded(program: str) -> dict[str, Any]:
    """The names of a program of equations after it has run."""
    space: dict[str, Any] = {_pieces.__name__: _pieces}
    exec(compile(ast.fix_missing_locations(_Calls().visit(ast.parse(program))), "<equations of motion>", "exec"), space)
    return space
