"""Longer computing: papers, steady motions, choices, charts, ensembles, each with its limit of time and Ctrl-C."""

import os
import pickle
import signal
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import dalembert
from systems import OSCILLATOR

ROOT = Path(__file__).parents[3]

PAPER = r"""
title = "A block"
[parameters]
m = "kg"
k = "N/m"
[coordinates]
x = "m"
[bodies.block]
centre = "O + x*N.x"
mass = "m"
[[force]]
on = "block"
is = "-k*x*N.x"
[letters]
'm' = "m"
'k' = "k"
'x' = "x"
[[claim]]
equation = "1"
kind = "equation of motion"
says = "Newton's law"
formula = 'm \ddot{x} + k x = 0'
[[claim]]
equation = "2"
kind = "equation of motion"
formula = 'm \ddot{x} - k x = 0'
"""


def oscillator():
    return dalembert.Model.from_text(OSCILLATOR)


def double_pendulum():
    return dalembert.Model.from_file(ROOT / "scenes" / "models" / "double_pendulum.toml")


def test_a_paper_is_a_list_of_claims_with_verdicts_and_corrections():
    ledger = dalembert.judge(PAPER)
    first, second = ledger
    assert (first.name, first.verdict, first.printed) == ("paper/eq1", "proved", r"m \ddot{x} + k x = 0")
    assert second.verdict == "refuted" and second.correction == r"m \ddot{x} + k x = 0" and second.corrections[0].verdict == "proved"
    assert ledger.failed == [second] and ledger["eq2"] is second and ledger.counts == {"proved": 1, "refuted": 1}
    assert "$m \\ddot{x} + k x = 0$" in ledger._repr_html_() and "2 claims" in repr(ledger) and ledger.broken_off is None
    with pytest.raises(KeyError, match="paper/eq1"):
        ledger["eq9"]


def test_a_paper_of_a_file_meets_its_expectations():
    ledger = dalembert.judge(ROOT / "papers" / "cart_pole.toml")
    assert not ledger.failed and len(ledger) == 8 and ledger.counts["refuted"] == 4
    with pytest.raises(dalembert.ModelError, match="no such file"):
        dalembert.judge("nowhere.toml")
    with pytest.raises(dalembert.ModelError) as raised:
        dalembert.judge(PAPER.replace('"k"', '"kk"'))
    assert raised.value.line is not None


def test_one_unreadable_formula_leaves_the_others_judged():
    with pytest.warns(UserWarning, match="unknown letter `q`"):
        ledger = dalembert.judge(PAPER.replace("+ k x", "+ q x"))
    [unread] = ledger.unread
    assert (unread.name, [claim.name for claim in ledger]) == ("paper/eq1", ["paper/eq2"])
    assert unread.line > 1 and "1 not read" in repr(ledger) and "unknown letter" in ledger._repr_html_()


def test_steady_motions_of_a_double_pendulum_are_four_and_no_other():
    found = double_pendulum().stationary()
    assert found.complete and [motion.stability for motion in found] == ["stable", "unstable", "unstable", "unstable"]
    assert all(motion.by_enclosures for motion in found) and np.allclose(found[3].state, [np.pi, np.pi, 0, 0])
    low, high = found[1].enclosure["b"]
    assert low <= np.pi <= high and "double pendulum" in repr(found).lower() and "<td" in found._repr_html_()
    assert len(pickle.loads(pickle.dumps(found))) == 4
    with pytest.raises(dalembert.ModelError, match="range of aa: .* is `a` meant"):
        double_pendulum().stationary({"aa": (0, 1)})
    with pytest.raises(dalembert.ModelError, match=r'ranges=\{"x": \(-1, 1\)\}'):
        oscillator().stationary()
    assert len(oscillator().stationary({"x": (-1, 1)})) == 1
    for wrong in ({"x": (1, 0)}, {"x": (0, float("nan"))}, {"x": (0, 1, 2)}):
        with pytest.raises(ValueError, match="range of `x`"):
            oscillator().stationary(wrong)


def test_other_values_are_those_of_the_results():
    soft = oscillator().with_values(k=-4.0)
    assert [motion.stability for motion in soft.stationary({"x": (-1, 1)})] == ["unstable"]
    ends = oscillator().with_values(k=9.0).ensemble(3, {"x": {"values": [0.1, 0.2, 0.3]}})["x"]
    assert np.allclose(ends, np.array([0.1, 0.2, 0.3]) * np.cos(30), atol=1e-6)


def test_the_smallest_model_is_chosen_with_its_receipt():
    choice = oscillator().choose(1e-6, "x")
    assert choice.taken == choice.models[0]["model"] and choice.outputs == ["x"] and choice.run["promised"] < 1e-6
    assert choice.svg.startswith("<svg") and "data:image/svg+xml" in choice._repr_html_() and "1e-6" in repr(choice)
    with pytest.raises(dalembert.ModelError, match="unknown output `y`; known: x"):
        oscillator().choose(1e-6, ["y"])
    with pytest.raises(ValueError, match="tolerance"):
        oscillator().choose(2.0)


def test_a_chart_has_every_run_as_arrays_and_its_pictures():
    chart = oscillator().chart(seconds=20)
    assert len(chart) == len(chart["error"]) > 20 and np.nanmin(chart["error"]) < 1e-12 and chart.digits > 25
    assert "Taylor" in chart["method"] and (chart["evaluations"] > 0).all() and list(chart.advice) == [1e-3, 1e-6, 1e-9]
    assert chart.svg.startswith("<svg") and chart.svg_time.startswith("<svg") and chart._repr_html_().count("<img") == 2
    with pytest.raises(KeyError, match="there are formulation"):
        chart["errors"]
    with pytest.raises(dalembert.ModelError, match="more time is given by `seconds`"):
        double_pendulum().chart(seconds=0.001)


def test_an_ensemble_is_an_array_that_depends_on_no_thread():
    vary = {"k": {"from": 3, "to": 5}, "x'": {"mean": 0, "deviation": 0.1}}
    one, two = (oscillator().ensemble(40, vary, threads=threads, seed=5) for threads in (1, 2))
    assert np.array_equal(one.array, two.array, equal_nan=True) and len(one) == 40 and one.reached.all()
    k, v = one["parameters.k"], one["start.x'"]
    w = np.sqrt(k)
    assert np.abs(one["x"] - (0.1 * np.cos(10 * w) + v / w * np.sin(10 * w))).max() < 1e-6
    assert one.units["x'"] == "m/s" and "parameters.k" in one and "40 members" in repr(one) and "<td" in one._repr_html_()
    with pytest.raises(ValueError, match="together"):
        oscillator().ensemble(3)
    with pytest.raises(dalembert.ModelError, match="ensemble"):
        oscillator().ensemble()


def test_what_is_not_done_in_time_is_told():
    members = double_pendulum().ensemble(seconds=1.5)
    assert 0 < len(members) < 10_000 and "have not run" in members.broken_off
    for wrong in (0, -1, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="`seconds`"):
            oscillator().stationary({"x": 0.0}, seconds=wrong)


def test_ctrl_c_breaks_off_and_other_threads_work_meanwhile():
    signal.signal(signal.SIGINT, signal.default_int_handler)
    counted = [0]
    over = threading.Event()

    def count():
        while not over.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    pendulum = double_pendulum()
    for call in (lambda: pendulum.ensemble(), lambda: pendulum.chart(seconds=None), lambda: pendulum.choose(1e-13, seconds=None)):
        threading.Timer(0.4, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        begin = time.monotonic()
        with pytest.raises(KeyboardInterrupt):
            call()
            time.sleep(1)
        assert time.monotonic() - begin < 3
    over.set()
    thread.join()
    assert counted[0] > 100
