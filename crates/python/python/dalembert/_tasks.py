"""Functions that `_apart` calls in a process of its own; the first arguments are the seconds that are left, and how to tell what is found before
the end.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ._model import Model

__all__ = ["check"]

Tell = Callable[[Any], None]


def check(seconds: float, tell: Tell, model: Model, equations: dict[str, Any]) -> dict[str, Any]:
    """Equations of motion of another program beside those of a model."""
    return model._native.check(**equations)
