"""Warnings, each told once, at the line that calls the package."""

from __future__ import annotations

import re
import sys
import threading
import warnings
from collections.abc import Iterator
from contextlib import contextmanager

from ._native import NativeModel

__all__ = ["known", "read_again", "warn", "without_known"]

# those of texts that are read again, told where they were read first
known: set[str] = set()
# the filters of Python belong to a process, and not to a thread
_LOCK = threading.Lock()


def warn(message: str) -> None:
    """Warns at the innermost line that belongs to no module of the package."""
    frame, level = sys._getframe(1), 2
    while frame is not None and frame.f_globals.get("__name__", "").partition(".")[0] == __package__:
        frame, level = frame.f_back, level + 1
    warnings.warn(message, stacklevel=level)


def read_again(text: str, name: str) -> NativeModel:
    """A model of a text that was read before, without the warnings that were told then."""
    with _LOCK, warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        model = NativeModel.from_text(text, name)
    known.update(str(one.message) for one in heard)
    return model


@contextmanager
def without_known() -> Iterator[None]:
    """A part of a program, threads that it waits for too, in which the known warnings are not told again."""
    with warnings.catch_warnings():
        for message in known:
            warnings.filterwarnings("ignore", message=re.escape(message))
        yield
