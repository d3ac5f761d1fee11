"""Functions that `_apart` calls in a process of its own; the first arguments are the seconds that are left, and how to tell what is found before
the end.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ._model import Model
from ._native import end_process_after, judge_paper

__all__ = ["chart", "check", "choose", "ensemble", "inverse", "judge", "reference", "regimes", "regulate", "stationary"]

Tell = Callable[[Any], None]


def check(seconds: float, tell: Tell, model: Model, equations: dict[str, Any]) -> dict[str, Any]:
    """Equations of motion of another program beside those of a model."""
    return model._native.check(**equations)


def judge(seconds: float, tell: Tell, path: str, text: str | None) -> dict[str, Any]:
    """The claims of a paper."""
    return judge_paper(path, text, seconds, tell)


def stationary(seconds: float, tell: Tell, model: Model, ranges: list[tuple[str, float, float]], boxes: int) -> tuple[str, str]:
    """Steady motions of a model."""
    return model._native.stationary(ranges, boxes, seconds)


def choose(seconds: float, tell: Tell, model: Model, tolerance: float, outputs: list[str]) -> tuple[str, str, str]:
    """The smallest model that meets a tolerance."""
    end_process_after(seconds)
    return model._native.choose(tolerance, outputs)


def chart(seconds: float, tell: Tell, model: Model) -> tuple[str, str, tuple[str, str]]:
    """Speed against accuracy."""
    end_process_after(seconds)
    return model._native.chart(seconds)


def ensemble(seconds: float, tell: Tell, model: Model, members: tuple[int, int] | None, threads: int | None) -> dict[str, Any]:
    """Members of an ensemble, from one to another."""
    return model._native.ensemble(members, threads, seconds)


def inverse(seconds: float, tell: Tell, model: Model, motions: list[tuple[str, str]], unknowns: list[str], times: list[float]) -> dict[str, Any]:
    """Forces along a prescribed motion."""
    return model._native.inverse(motions, unknowns, times)


def regulate(seconds: float, tell: Tell, model: Model) -> tuple[str, str]:
    """The optimal regulator of a model."""
    return model._native.regulate(seconds)


def regimes(seconds: float, tell: Tell, model: Model) -> tuple[str, str]:
    """The consistent regimes at the start of a model."""
    return model._native.regimes()


def reference(seconds: float, tell: Tell, model: Model, span: float | None) -> tuple[str, str]:
    """The motion to all digits that two methods share."""
    return model._native.reference(span, seconds)
