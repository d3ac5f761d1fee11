"""Forces along a motion, regulators, regimes at the start, references: numbers against closed forms, messages, time and Ctrl-C."""

import os
import pickle
import re
import signal
import threading
import time
from decimal import Decimal, getcontext
from pathlib import Path

import numpy as np
import pytest

import dalembert
from systems import OSCILLATOR

ROOT = Path(__file__).parents[3]
MODELS = ROOT / "scenes" / "models"
DRIVEN = OSCILLATOR + '[inputs]\nu = "N"\n[[force]]\non = "block"\nis = "u*N.x"\n'
REGULATED = DRIVEN.replace('x = "0.1 m"', 'x = "0 m"') + '[regulator]\ninputs = ["u"]\ncost = "(x/(1 m))^2 + (u/(1 N))^2"\ndisplaced = { x = "0.1 m" }\n'


def driven():
    return dalembert.Model.from_text(DRIVEN)


def cart_pole():
    return dalembert.Model.from_file(MODELS / "cart_pole.toml")


def test_forces_along_a_motion_are_arrays_with_the_closed_form():
    forces = driven().inverse({"x": "(0.1 m)*sin(t*(3 rad/s))"}, "u", span=2, samples=40)
    assert forces.unknowns == ["u"] and forces.units["u"] == "N" and forces.units["x''"] == "m/s^2" and len(forces.time) == 41
    assert np.abs(forces["u"] - (4 - 9) * 0.1 * np.sin(3 * forces.time)).max() < 1e-14
    assert "u" in repr(forces) and "<td" in forces._repr_html_() and np.array_equal(pickle.loads(pickle.dumps(forces)).array, forces.array)
    assert np.array_equal(forces[["x", "u"]], forces.array[:, [0, 3]]) and forces.names == ["x", "x'", "x''", "u"]
    softer = driven().with_values(k=1.0).inverse({"x": "(0.1 m)*sin(t*(3 rad/s))"}, ["u", "u"], times=[0.5, 0.75])
    assert np.abs(softer["u"] - (1 - 9) * 0.1 * np.sin(3 * softer["time"])).max() < 1e-14 and softer.unknowns == ["u"]


def test_forces_that_are_found_drive_the_system_along_the_motion():
    crank = dalembert.Model.from_file(MODELS / "slider_crank.toml")
    forces = crank.inverse({"theta": "0.3*sin(t*(5 rad/s))"}, "T", samples=4)
    assert forces.multipliers == ["lambda1 pin along R.x", "lambda2 pin along R.y"] and np.isfinite(forces.array).all()
    with pytest.raises(dalembert.ModelError, match="2 of 3 equations") as raised:
        crank.inverse({"theta": "0.3*sin(t*(5 rad/s))"})
    assert "`unknowns`" in raised.value.remedy and "--" not in raised.value.remedy


def test_motions_that_are_none_are_refused_with_what_is_accepted():
    with pytest.raises(dalembert.ModelError, match="no coordinate has this name") as raised:
        driven().inverse({"y": "(0.1 m)"}, "u")
    assert raised.value.file == "motions" and "a motion for each of: x" in raised.value.remedy
    with pytest.raises(dalembert.ModelError, match=r'motions=\{"theta": "0.5\*sin'):
        dalembert.Model.from_file(MODELS / "slider_crank.toml").inverse({"theta": "phi"}, "T")
    with pytest.raises(dalembert.ModelError, match="an unknown must be one"):
        driven().inverse({"x": "(0.1 m)"}, "v")
    for wrong in ({}, "x = 2", {"x": 0.1}, {"x": " "}, None):
        with pytest.raises(TypeError, match="`motions`"):
            driven().inverse(wrong, "u")
    for wrong in ([], [1, 0], [0, float("nan")], [[0, 1]], ["a"]):
        with pytest.raises(ValueError, match="`times`"):
            driven().inverse({"x": "(0.1 m)"}, "u", times=wrong)
    for name, wrong in (("span", 0), ("span", float("inf")), ("samples", 0), ("samples", 2.5), ("samples", 1_000_001), ("samples", "ten")):
        with pytest.raises(ValueError, match=f"`{name}`"):
            driven().inverse({"x": "(0.1 m)"}, "u", **{name: wrong})


def test_a_regulator_has_the_gains_of_riccatis_equation():
    found = dalembert.Model.from_text(REGULATED).regulate()
    # m = 1, k = 4: P of -k^2 P... has K = (sqrt(k^2 + 1) - k, sqrt(2 K1)) in closed form
    first = np.sqrt(17) - 4
    assert np.allclose(found.K, [[first, np.sqrt(2 * first)]], atol=1e-9) and found.states == ["x", "x'"] and found.inputs == ["u"]
    assert np.allclose(found.P[1], found.K[0], atol=1e-9) and np.allclose(found.P, found.P.T) and found.controllable
    assert np.allclose(np.sort(found.eigenvalues.imag), [-2, 2]) and (found.eigenvalues_closed.real < 0).all()
    assert found.cost_by_riccati == pytest.approx(0.01 * found.P[0, 0]) and found.cost_of_run == pytest.approx(found.cost_by_riccati, rel=1e-6)
    assert found.run["x"][0] == 0.1 and found.run.names == ["x", "x'", "u", "cost"] and found.run.units["u"] == "N" and found.stopped is None
    assert np.allclose(found.run["u"], -found.run[["x", "x'"]] @ found.K[0], atol=1e-12)
    assert "<td" in found._repr_html_() and "cost by Riccati" in repr(found) and np.array_equal(pickle.loads(pickle.dumps(found)).K, found.K)


def test_a_regulator_acts_on_the_nonlinear_model_or_is_refused_at_its_place():
    found = cart_pole().regulate()
    assert found.run["theta"][0] == pytest.approx(np.radians(5)) and abs(found.run.last["theta"]) < 1e-4 and found.K.shape == (1, 4)
    heavier = cart_pole().with_values(m=0.2).regulate()
    assert not np.allclose(heavier.K, found.K)
    with pytest.raises(dalembert.ModelError, match="regulator"):
        dalembert.Model.from_text(OSCILLATOR).regulate()
    with pytest.raises(dalembert.ModelError) as raised:
        dalembert.Model.from_text(REGULATED.replace("is = \"u*N.x\"", "is = \"0*u*N.x\"")).regulate()
    assert raised.value.remedy


def test_regimes_are_counted_with_their_margins():
    regimes = dalembert.Model.from_file(ROOT / "scenes" / "friction" / "painleve.toml").regimes()
    assert regimes.verdict == "no motion" and not regimes.determined and len(regimes) == 0 and "no motion" in repr(regimes)
    resting = dalembert.Model.from_text(
        OSCILLATOR.replace("[start]", '[[contact]]\nname = "floor"\nof = "block at O + x*N.x"\nthrough = "O"\nnormal = "N.x"\n[start]')
    )
    apart = resting.regimes()
    assert apart.determined and apart.verdict == "one motion" and len(apart) == 1
    [touching] = resting.with_values(x=0.0).regimes()
    assert touching.margins and touching.margins[0].of == "contact `floor`"
    found = resting.with_values(x=0.0).regimes()
    assert "<td" in found._repr_html_() and pickle.loads(pickle.dumps(found))[0] == found[0]
    with pytest.raises(dalembert.ModelError, match="this system has one regime"):
        dalembert.Model.from_text(OSCILLATOR).regimes()


def test_a_reference_has_the_digits_of_the_closed_form():
    reference = dalembert.Model.from_text(OSCILLATOR).reference(span=2.0)
    assert reference.digits > 25 and reference.time[0] < reference.time[-1] == 2.0 and reference.names == ["x", "x'"]
    assert np.abs(reference["x"] - 0.1 * np.cos(2 * reference.time)).max() < 1e-16 and len(set(reference.methods)) == 2
    # cos 4 to 35 digits; the start is the number of 64 bits nearest to 0.1
    exact = Decimal("-0.65364362086361191463916818309775038") * Decimal(0.1)
    assert abs(reference.decimals["x"][-1] - exact) < Decimal("1e-25")
    assert "<code>" in reference._repr_html_() and str(reference.decimals["x"][-1]) in repr(reference)
    assert np.array_equal(pickle.loads(pickle.dumps(reference)).array, reference.array)
    run = dalembert.Model.from_text(OSCILLATOR).run(span=2.0, samples=8, tolerance=1e-10)
    assert np.abs(run["x"][1:] - np.interp(run.time[1:], reference.time, reference["x"])).max() < 1e-8


def test_events_of_a_reference_have_all_digits():
    reference = dalembert.Model.from_file(MODELS / "bouncing_ball.toml").reference(span=0.6)
    getcontext().prec = 40
    [bounce] = reference.events
    assert abs(bounce.time - (Decimal(2) / Decimal(9.81)).sqrt()) < Decimal("1e-22") and bounce.what
    for wrong in (0, -1, float("inf"), float("nan")):
        with pytest.raises(ValueError, match="`span`"):
            driven().reference(span=wrong)


def test_these_calls_end_at_their_time_and_at_ctrl_c():
    signal.signal(signal.SIGINT, signal.default_int_handler)
    pendulum = dalembert.Model.from_file(MODELS / "double_pendulum.toml")
    begin = time.monotonic()
    with pytest.raises((dalembert.ModelError, TimeoutError)):
        pendulum.reference(span=1e4, seconds=1)
    assert time.monotonic() - begin < 5
    threading.Timer(0.4, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        pendulum.reference(span=1e4, seconds=None)
        time.sleep(1)
    assert time.monotonic() - begin < 3
    for call in (cart_pole().regulate, cart_pole().regimes, cart_pole().reference):
        with pytest.raises(ValueError, match="`seconds`"):
            call(seconds=0)


def test_every_command_has_a_call_or_a_reason():
    commands = re.search(r"pub enum Command \{(.*?)\n\}", (ROOT / "crates/commands/src/arguments.rs").read_text(), re.S).group(1)
    names = [re.sub(r"(?<!^)(?=[A-Z])", "-", name).lower() for name in re.findall(r"^    ([A-Z]\w+)[({ ]", commands, re.M)]
    page = (ROOT / "book/src/python.md").read_text()
    table = page[page.index("| command without a call |") :].split("\n\n")[0]
    without = re.findall(r"`([a-z-]+)`", "".join(line.split("|")[1] for line in table.splitlines()[2:]))
    called = [name for name in names if hasattr(dalembert.Model, name) or hasattr(dalembert, name)]
    assert len(names) > 20 and sorted(called + without) == sorted(names)
