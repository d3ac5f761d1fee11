"""Linear equations about a point."""

from __future__ import annotations

from dataclasses import dataclass

import numpy

from ._native import LinearEquations as NativeLinearEquations

__all__ = ["LinearEquations"]


@dataclass(frozen=True, repr=False, eq=False)
class LinearEquations:
    """The linear equations x' = A x + B w, y = C x + D w about a point of a model, in SI units.

    A, B, C, D: the matrices. eigenvalues: of A, in 1/s. stability: their verdict in a sentence. states, inputs, outputs: names of the components of x
    (independent variations of coordinates, then of speeds), of w and of y. point: coordinates and speeds of the point by their names.
    """

    A: numpy.ndarray
    B: numpy.ndarray
    C: numpy.ndarray
    D: numpy.ndarray
    eigenvalues: numpy.ndarray
    stability: str
    states: list[str]
    inputs: list[str]
    outputs: list[str]
    point: dict[str, float]

    @classmethod
    def of(cls, found: NativeLinearEquations) -> LinearEquations:
        """The same as data."""
        return cls(**{name: getattr(found, name) for name in cls.__dataclass_fields__})

    def __repr__(self) -> str:
        x, w, y = (", ".join(names) for names in (self.states, self.inputs, self.outputs))
        return f"x' = A x + B w, y = C x + D w with x = ({x}), w = ({w}), y = ({y}); {self.stability}"
