"""The right-hand side and its Jacobian as functions of C."""

import ctypes
import gc
import threading
from pathlib import Path

import numpy as np
import pytest

import dalembert

MODELS = Path(__file__).parents[3] / "scenes" / "models"
NUMBERS = ctypes.POINTER(ctypes.c_double)
SIGNATURE = ctypes.CFUNCTYPE(None, ctypes.c_double, NUMBERS, NUMBERS)


def called(address, t, y, count):
    y, values = np.array(y, dtype=float), np.full(count, np.nan)
    SIGNATURE(address)(t, y.ctypes.data_as(NUMBERS), values.ctypes.data_as(NUMBERS))
    return values


def test_c_has_the_values_of_python_while_the_object_lives():
    model = dalembert.Model.from_file(MODELS / "double_pendulum.toml")
    f, jacobian = model.rhs(), model.jacobian()
    y, n = model.start + 0.1, len(model.states)
    del model
    gc.collect()
    assert f.address == f.address and f.address != jacobian.address
    assert np.array_equal(called(f.address, 0.3, y, n), f(0.3, y))
    assert np.array_equal(called(jacobian.address, 0.3, y, n * n).reshape(n, n), jacobian(0.3, y))


def test_state_and_rates_may_share_memory():
    model = dalembert.Model.from_file(MODELS / "double_pendulum.toml")
    f, y = model.rhs(), model.start + 0.1
    shared = y.copy()
    at = shared.ctypes.data_as(NUMBERS)
    SIGNATURE(f.address)(0.0, at, at)
    assert np.array_equal(shared, f(0.0, y))


def test_threads_call_it_at_once():
    model = dalembert.Model.from_file(MODELS / "double_pendulum.toml")
    f, y = model.rhs(), model.start
    expected, wrong = f(0.0, y), []

    def work():
        for _ in range(2000):
            if not np.array_equal(called(f.address, 0.0, y, len(y)), expected):
                wrong.append(1)

    threads = [threading.Thread(target=work) for _ in range(4)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    assert not wrong


def test_numba_calls_it_in_compiled_code():
    numba = pytest.importorskip("numba")
    model = dalembert.Model.from_file(MODELS / "double_pendulum.toml")
    f, y = model.rhs(), model.start
    rates = ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p)(f.address)

    @numba.njit
    def euler(y, step, count):
        y, dy = y.copy(), np.empty_like(y)
        for k in range(count):
            rates(k * step, y.ctypes, dy.ctypes)
            y += step * dy
        return y

    by_python = y.copy()
    for _ in range(100):
        by_python += 1e-3 * f(0.0, by_python)
    assert np.allclose(euler(y, 1e-3, 100), by_python, rtol=1e-12)
