"""Work in a process of its own: it ends at its time and at Ctrl-C, wherever it is.

Exact computing has no steps between which it could look at a clock. A process can be ended at any moment, and its limit of time is no limit
of what other threads do here.
"""

from __future__ import annotations

import os
import pickle
import struct
import subprocess
import sys
import threading
import time
import warnings
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from ._arguments import LONGEST, seconds_of
from ._warnings import known, warn

__all__ = ["apart"]

# modules are looked for where this process finds them, this package too
_PROGRAM = """
import pickle, struct, sys
source = sys.stdin.buffer
sys.path[:] = pickle.loads(source.read(*struct.unpack("<Q", source.read(8))))
from dalembert._apart import _work
_work()
"""
_HEAD = struct.Struct("<cQ")
# a process that ends by itself is given so many seconds beyond its time
_GRACE = 1.5


def apart(
    task: str, arguments: tuple, seconds: float | None, told: Callable[[Any], None] | None = None, reworded: Callable[[str], str] = str
) -> Any:
    """The value of a function `_tasks.task(left, tell, *arguments)` in another process.

    `told` hears what the function tells before its end; warnings are told in the words of `reworded`. Raises TimeoutError after `seconds`, and KeyboardInterrupt at Ctrl-C; the other
    process has ended then.
    """
    seconds = seconds_of(seconds)
    if not sys.executable:
        raise RuntimeError("this Python is part of another program, and no other process of it can be begun; the program `dalembert` does the same")
    given = b"".join(struct.pack("<Q", len(part)) + part for part in map(pickle.dumps, (sys.path, (task, seconds, arguments))))
    # it hears of Ctrl-C from here alone
    process = subprocess.Popen([sys.executable, "-c", _PROGRAM], stdin=subprocess.PIPE, stdout=subprocess.PIPE, start_new_session=True)
    source, sink = process.stdout, process.stdin
    assert source is not None and sink is not None
    late = threading.Event()

    def end() -> None:
        late.set()
        process.kill()

    timer = None if seconds is None else threading.Timer(seconds + _GRACE, end)
    if timer is not None:
        timer.daemon = True
        timer.start()
    try:
        # a process that ended at once takes nothing, and its end is told below
        with suppress(BrokenPipeError):
            sink.write(given)
            sink.flush()
        while True:
            head = source.read(_HEAD.size)
            if len(head) < _HEAD.size:
                if late.is_set():
                    raise TimeoutError(f"{task}: broken off after {seconds:g} s; more time is given by `seconds`")
                raise RuntimeError(f"{task}: its process ended with the code {process.wait()}")
            kind, size = _HEAD.unpack(head)
            body = source.read(size)
            if len(body) < size:
                continue
            value = pickle.loads(body)
            if kind == b"t" and told is not None:
                told(value)
            elif kind == b"w":
                warn(reworded(value))
            elif kind == b"e":
                raise value
            elif kind == b"v":
                return value
    finally:
        if timer is not None:
            timer.cancel()
        process.kill()
        for pipe in (sink, source):
            with suppress(OSError):
                pipe.close()
        process.wait()


def _work() -> None:
    """The other process: reads what is asked from its input, and ends with it."""
    begin = time.monotonic()
    source, sink = sys.stdin.buffer, sys.stdout.buffer
    # what is printed by others must not come between the answers
    sys.stdout = sys.stderr
    (size,) = struct.unpack("<Q", source.read(8))
    task, seconds, arguments = pickle.loads(source.read(size))

    def answer(kind: bytes, value: Any) -> None:
        body = pickle.dumps(value, protocol=pickle.HIGHEST_PROTOCOL)
        sink.write(_HEAD.pack(kind, len(body)) + body)
        sink.flush()

    def watch() -> None:
        source.read()
        os._exit(1)

    # whoever asked may be gone
    threading.Thread(target=watch, daemon=True).start()
    from dalembert import _tasks

    # the caller has heard those of texts that are read again here, and has filters of its own for the others
    warnings.simplefilter("always")
    warnings.showwarning = lambda message, *_: None if str(message) in known else answer(b"w", str(message))
    # importing took a part of the time
    left = LONGEST if seconds is None else max(begin + seconds - time.monotonic(), 0.01)
    try:
        value = getattr(_tasks, task)(left, lambda told: answer(b"t", told), *arguments)
    except BaseException as error:
        try:
            answer(b"e", error)
        except Exception:
            # what is no class of a module cannot be handed over
            answer(b"e", RuntimeError(f"{task}: {type(error).__name__}: {error}"))
    else:
        answer(b"v", value)
    # threads that still compute are of no use to anybody
    sink.close()
    os._exit(0)
