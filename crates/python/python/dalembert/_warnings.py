"""Warnings, each told once, at the line that calls the package."""

from __future__ import annotations

import re
import sys
import threading
import warnings
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TypeVar

__all__ = ["heard", "known", "warn", "without"]

Value = TypeVar("Value")

# those of texts that were read again in this process, told where they were read first
known: set[str] = set()


class _Filters:
    """The filters of Python belong to a process, and not to a thread: whoever changes them for a while does it one at a time, and the last restores them."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.users = 0
        self.saved = warnings.catch_warnings()

    def begin(self, messages: Iterable[str]) -> None:
        with self.lock:
            if self.users == 0:
                self.saved = warnings.catch_warnings()
                self.saved.__enter__()
            self.users += 1
            for message in messages:
                warnings.filterwarnings("ignore", message=re.escape(message))

    def end(self) -> None:
        with self.lock:
            self.users -= 1
            if self.users == 0:
                self.saved.__exit__(None, None, None)


_FILTERS = _Filters()


def warn(message: str) -> None:
    """Warns at the innermost line that belongs to no module of the package."""
    frame, level = sys._getframe(1), 2
    while frame is not None and frame.f_globals.get("__name__", "").partition(".")[0] == __package__:
        frame, level = frame.f_back, level + 1
    warnings.warn(message, stacklevel=level)


def heard(call: Callable[[], Value]) -> tuple[Value, frozenset[str]]:
    """The value of a call, and its warnings, which are not told."""
    with _FILTERS.lock, warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        value = call()
    return value, frozenset(str(one.message) for one in found)


@contextmanager
def without(messages: Iterable[str]) -> Iterator[None]:
    """A part of a program, threads that it waits for too, in which some warnings are not told again."""
    _FILTERS.begin(messages)
    try:
        yield
    finally:
        _FILTERS.end()
