"""An ensemble in parts, by the workers of an executor of `concurrent.futures`."""

from __future__ import annotations

import os
import threading
import time
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future, wait
from typing import TYPE_CHECKING, Any

import numpy

from ._apart import apart
from ._arguments import LONGEST, seconds_of, shown, whole
from ._warnings import warn, without

if TYPE_CHECKING:
    from ._model import Model

__all__ = ["in_parts"]

# the last part of the time, in which what the workers found is gathered
_GATHERING = 0.5


def _ranges(members: int, parts: int) -> list[tuple[int, int]]:
    """Members side by side, from one to another, as many in each part or one fewer."""
    ends = [part * members // parts for part in range(parts + 1)]
    return [(first + 1, last) for first, last in zip(ends, ends[1:])]


def _part(model: Model, members: tuple[int, int], threads: int, seconds: float) -> dict[str, Any]:
    """A part, where a worker runs it."""
    if threading.current_thread() is not threading.main_thread():
        return model._native.ensemble(members, threads, seconds)
    # a process that works for another, which has heard the warnings
    with without(model._told):
        return model._native.ensemble(members, threads, seconds)


def in_parts(model: Model, executor: Executor, parts: int | None, threads: int, seconds: float | None) -> dict[str, Any]:
    """The rows of all members, in their order."""
    with without(model._told):
        return _in_parts(model, executor, parts, threads, seconds_of(seconds))


def _in_parts(model: Model, executor: Executor, parts: int | None, threads: int, seconds: float | None) -> dict[str, Any]:
    parts = None if parts is None else whole("parts", parts)
    # a client of Dask has `submit` too, whose futures are of another kind
    if not callable(getattr(executor, "submit", None)) or callable(getattr(executor, "get_executor", None)):
        raise TypeError(f"`executor` is {shown(executor)}; an executor of concurrent.futures is accepted, such as ProcessPoolExecutor() or client.get_executor() of Dask")
    end = time.monotonic() + (LONGEST if seconds is None else seconds)
    members = model._native.ensemble_members()
    ranges = _ranges(members, min(members, parts or 4 * (os.cpu_count() or 1)))
    left = lambda: max(end - time.monotonic(), 0.01)  # noqa: E731
    futures: list[Future] = []
    found: dict[tuple[int, int], dict[str, Any]] = {}
    undone: list[tuple[int, int]] = []
    died: BaseException | None = None
    try:
        for own in ranges:
            try:
                futures.append(executor.submit(_part, model, own, threads, left()))
            except RuntimeError as error:
                if not futures and not isinstance(error, BrokenExecutor):
                    raise ValueError(f"`executor` takes no work ({error}); one that was not shut down is accepted") from error
                # a pool whose worker died takes no more
                died = error
                break
        for own, future in zip(ranges, futures):
            done, _ = wait([future], timeout=left() + _GATHERING)
            if not done:
                break
            error = CancelledError("the part was cancelled") if future.cancelled() else future.exception()
            if error is None:
                found[own] = future.result()
            elif isinstance(error, (ValueError, TypeError)):
                # the model itself, wherever it runs
                raise error
            else:
                died = error
    finally:
        for future in futures:
            future.cancel()
    undone = [own for own in ranges if own not in found]
    if died is not None and undone and left() > _GATHERING:
        warn(f"a worker ended before its part was done ({died!r}): {len(undone)} of {len(ranges)} parts are computed here")
        for own in undone:
            if left() <= _GATHERING:
                break
            found[own] = apart("ensemble", (model, own, None), None if seconds is None else left())
    return _joined(found, ranges, members)


def _joined(found: dict[tuple[int, int], dict[str, Any]], ranges: list[tuple[int, int]], members: int) -> dict[str, Any]:
    """The rows of parts up to the first that lacks some: a row is found by its place."""
    rows: list[numpy.ndarray] = []
    stopped: list[str | None] = []
    columns: list[tuple[str, str]] = []
    for own in ranges:
        if own not in found:
            break
        told = found[own]
        columns = told["columns"]
        rows.append(told["rows"])
        stopped += told["stopped"]
        if len(told["stopped"]) < told["members"]:
            break
    if not rows:
        raise TimeoutError("ensemble: broken off before a part was done; more time is given by `seconds`")
    return {"members": members, "columns": columns, "rows": numpy.concatenate(rows), "stopped": stopped}
