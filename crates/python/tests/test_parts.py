"""Ensembles in parts: by threads, by processes, by Dask, with workers that are killed."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
import time
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest

import dalembert
from systems import OSCILLATOR

# a stiffer spring at larger deflections, over a time in which a worker can be killed
TEXT = OSCILLATOR.replace("-k*x*N.x", "-k*x*N.x - (1 N/m^3)*x^3*N.x") + '[run]\nspan = "40 s"\n'
VARY = {"k": {"from": 3, "to": 5}, "x'": {"mean": 0, "deviation": 0.1}}


def model() -> dalembert.Model:
    return dalembert.Model.from_text(TEXT)


def same(one, other) -> bool:
    return np.array_equal(one.array, other.array, equal_nan=True) and one.names == other.names and one.stopped == other.stopped


def processes(workers: int = 2) -> ProcessPoolExecutor:
    return ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))


def test_parts_have_the_rows_of_one_run_however_they_are_cut():
    whole = model().ensemble(41, VARY, seed=3)
    with ThreadPoolExecutor(2) as threads:
        for parts in (None, 1, 3, 41, 1000):
            assert same(model().ensemble(41, VARY, seed=3, executor=threads, parts=parts), whole)
    with processes() as workers:
        assert same(model().ensemble(41, VARY, seed=3, executor=workers, parts=5), whole)


def test_what_a_killed_worker_leaves_is_computed_here():
    whole = model().ensemble(3000, VARY)
    with processes() as workers:
        workers.submit(os.getpid).result()

        def kill():
            time.sleep(0.1)
            for process in list(workers._processes.values()):
                os.kill(process.pid, signal.SIGKILL)

        threading.Thread(target=kill).start()
        with pytest.warns(UserWarning, match="a worker ended before its part was done"):
            members = model().ensemble(3000, VARY, executor=workers, parts=50)
    assert same(members, whole) and members.broken_off is None


def test_dask_runs_parts_again_whose_worker_is_killed():
    distributed = pytest.importorskip("distributed")
    whole = model().ensemble(3000, VARY)
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, distributed.Client(cluster) as client:
        pid = next(iter(client.run(os.getpid).values()))
        threading.Timer(0.3, lambda: os.kill(pid, signal.SIGKILL)).start()
        members = model().ensemble(3000, VARY, executor=client.get_executor(), parts=40)
    assert same(members, whole)


class Client:
    """A client of Dask: no executor, but it has one."""

    def submit(self, *_):
        raise AssertionError("nothing is handed to it")

    def get_executor(self):
        raise AssertionError("nobody asks for it")



class Slow(Executor):
    """An executor that never begins."""

    def submit(self, *_) -> Future:
        return Future()


def test_parts_obey_their_time_and_refuse_what_is_no_executor():
    begin = time.monotonic()
    with pytest.raises(TimeoutError, match="ensemble"):
        model().ensemble(10, VARY, executor=Slow(), seconds=0.2)
    assert time.monotonic() - begin < 5
    for other in ("four", Client()):
        with pytest.raises(TypeError, match="an executor of concurrent.futures is accepted"):
            model().ensemble(10, VARY, executor=other)
    with pytest.raises(ValueError, match="`parts`"):
        model().ensemble(10, VARY, executor=Slow(), parts=0)
    with pytest.raises(ValueError, match="`parts` is for an `executor`"):
        model().ensemble(10, VARY, parts=3)
    with ThreadPoolExecutor(1) as threads, pytest.raises(dalembert.ModelError, match="ensemble"):
        model().ensemble(executor=threads)
