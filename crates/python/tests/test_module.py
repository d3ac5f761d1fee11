"""The module as its users meet it: numbers against closed forms and SciPy, messages, ownership of arrays, Ctrl-C."""

import inspect
import os
import pickle
import signal
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import dalembert
from systems import OSCILLATOR

SCENES = Path(__file__).parents[3] / "scenes"


def oscillator():
    return dalembert.Model.from_text(OSCILLATOR)


def test_a_run_has_named_columns_with_units_and_the_closed_form():
    run = oscillator().run(span=10, tolerance=1e-12, samples=50)
    assert run.ok and run.units["x"] == "m" and run.states == ["x", "x'"] and len(run.time) == 51 and set(run) == set(run.names)
    assert np.abs(run["x"] - 0.1 * np.cos(2 * run.time)).max() < 1e-10
    assert run["x"].base is not None and np.shares_memory(run["x"], run.array)
    assert run.invariants["energy_less_work"][1] < 1e-12
    with pytest.raises(KeyError, match="no column is called 'y'; there are x, x'"):
        run["y"]


def test_other_values_make_another_model():
    other = oscillator().with_values({"x": 0.2}, k=9.0)
    run = other.run(span=5, tolerance=1e-12)
    assert np.abs(run["x"] - 0.2 * np.cos(3 * run.time)).max() < 1e-10
    assert oscillator().parameters == {"m": 1.0, "k": 4.0} and other.parameters["k"] == 9.0
    assert np.allclose(other.linearise().eigenvalues.imag.max(), 3.0)
    with pytest.raises(dalembert.ModelError, match="nothing is called `kk`; is `k` meant"):
        oscillator().with_values(kk=1.0)
    with pytest.raises(dalembert.ModelError, match="a finite number is accepted"):
        oscillator().with_values(k=float("nan"))


def test_other_values_stand_in_equations_too_and_models_are_pickled():
    other = pickle.loads(pickle.dumps(oscillator().with_values(k=9.0)))
    assert other.parameters["k"] == 9.0 and "k = 9 N/m" in other.derive().text
    space = {}
    exec(other.derive().code("python"), space)
    assert np.allclose(space["rates"](0.0, np.array([1.0, 0.0])), other.rhs()(0.0, [1.0, 0.0]))
    with pytest.raises(TypeError, match="`k` is '9 N/m'; a number in SI units is accepted"):
        oscillator().with_values(k="9 N/m")
    with pytest.raises(dalembert.ModelError, match="mass"):
        dalembert.Model.from_text(OSCILLATOR.replace('m = "1 kg"', 'm = "-1 kg"'))
    with pytest.raises(ValueError, match="Model.from_file"):
        dalembert.Model.from_text("mine.toml")


def test_constant_steps_are_judged_by_shorter_ones():
    assert not oscillator().run(span=20, method="euler:20").ok
    fine = oscillator().run(span=2, method="runge_kutta_4:1000")
    assert fine.ok and fine.steps


def test_a_motion_from_rest_loses_nothing():
    text = OSCILLATOR.replace("-k*x*N.x", "(1 N/s^4)*t^4*N.x + 0*k*x*N.x").replace('x = "0.1 m"\n', 'x = "0 m"\n')
    for method in ("radau_5", "kvaerno_5", "rodas_4", "taylor", "dormand_prince_8"):
        run = dalembert.Model.from_text(text).run(span=2, method=method)
        assert run.ok and abs(run.last["x'"] - 6.4) < 1e-6, (method, run)


def test_a_spring_passes_through_its_anchor():
    text = OSCILLATOR.replace('on = "block"\nis = "-k*x*N.x"', 'between = ["ground at O", "block"]\nis = "-k*(distance(O, O + x*N.x) - (0.05 m))"')
    model = dalembert.Model.from_text(text).with_values({"x'": -2.0})
    ends = [model.run(span=1.5, method=method, tolerance=1e-11) for method in ("dormand_prince_8", "taylor", "verner_9")]
    assert all(run.ok for run in ends) and np.ptp([run.last["x"] for run in ends]) < 1e-8


def test_the_numbers_of_numpy_are_taken_by_the_builder():
    built = dalembert.Model.builder("b").parameters(m="1 kg").coordinates(x="m").body("b", centre="O + x*N.x", mass="m")
    built = built.start(x="0.5 m").run(span="1 s", tolerance=np.float64(1e-9), samples=np.int64(7)).build()
    assert len(built.run().time) == 8 and built.start[0] == 0.5
    with pytest.raises(ValueError, match="has `m` already"):
        dalembert.Model.builder("b").parameters(m="1 kg").parameters(m="2 kg")


def test_the_callables_serve_scipy():
    model = dalembert.Model.from_file(SCENES / "models" / "double_pendulum.toml")
    f, jacobian, start = model.rhs(), model.jacobian(), model.start
    assert f.states == jacobian.states == model.states
    step = 1e-6
    differences = [(f(0.0, start + step * e) - f(0.0, start - step * e)) / (2 * step) for e in np.eye(len(start))]
    assert np.abs(np.array(differences).T - jacobian(0.0, start)).max() < 1e-6
    ours = model.run(span=2, method="taylor", tolerance=1e-12, samples=10)
    for method, more in [("DOP853", {}), ("Radau", {"jac": jacobian})]:
        found = solve_ivp(f, (0, 2), start, method=method, t_eval=ours.time, rtol=1e-9, atol=1e-11, **more)
        assert np.abs(found.y.T - ours.array[:, : len(start)]).max() < 1e-5


def test_callables_tell_the_size_of_their_code():
    model = dalembert.Model.from_file(SCENES / "models" / "double_pendulum.toml")
    assert 0 < oscillator().rhs().code_size < model.rhs().code_size < model.jacobian().code_size < 100_000


def test_callables_show_their_arguments():
    model = oscillator()
    assert [str(inspect.signature(one)) for one in (model.rhs(), model.jacobian())] == ["(t, y)", "(t, y)"]


def test_a_jacobian_at_rest_has_the_derivatives_of_drag():
    model = dalembert.Model.from_text(
        """
        gravity = "-(10 m/s^2)*N.y"
        [coordinates]
        y = "m"
        [bodies.b]
        centre = "O + y*N.y"
        mass = "1 kg"
        [[force]]
        on = "b"
        is = "-(0.1 kg/m)*norm(velocity(b))*velocity(b)"
        """
    )
    assert np.allclose(model.jacobian()(0.0, [0.0, 0.0]), [[0.0, 1.0], [0.0, 0.0]], atol=1e-8)
    run = solve_ivp(model.rhs(), (0, 5), model.start, jac=model.jacobian(), method="Radau", rtol=1e-9, atol=1e-9)
    assert abs(run.y[1, -1] + 10 * np.tanh(5)) < 1e-6



def test_rates_at_a_singular_position_are_not_a_number():
    model = dalembert.Model.from_text(
        """
        [coordinates]
        r = "m"
        q = "rad"
        [bodies.b]
        centre = "O + r*(cos(q)*N.x + sin(q)*N.y)"
        mass = "1 kg"
        [start]
        r = "1 m"
        """
    )
    assert np.isfinite(model.rhs()(0.0, model.start)).all() and not np.isfinite(model.rhs()(0.0, [0.0, 0.0, 1.0, 1.0])).all()
    with pytest.raises(dalembert.ModelError, match="is not determined at the start"):
        model.with_values(r=0.0).run(span=1)


def test_states_of_any_kind_are_taken_and_others_refused():
    f = oscillator().rhs()
    expected = f(0.0, np.array([0.5, 0.25]))
    for state in ([0.5, 0.25], (0.5, 0.25), np.array([0.5, 9, 0.25, 9])[::2], np.array([0.5, 0.25], dtype=np.float32)):
        assert np.array_equal(f(0.0, state), expected)
    for state in ([1.0], [1.0, 2.0, 3.0], [[1.0, 2.0]], 1.0):
        with pytest.raises(dalembert.ModelError, match="an array of 2 numbers"):
            f(0.0, state)


def test_equations_stand_in_every_notation():
    equations = oscillator().derive("lagrange")
    assert "M[x, x] = m" in repr(equations) and r"\begin{align*}" in equations._repr_latex_()
    space = {}
    exec(equations.code("python"), space)
    assert callable(space["accelerations"]) and "sympy" in equations.sympy
    assert oscillator().derive("Kane").principle == "virtual-power"
    with pytest.raises(dalembert.ModelError, match="is `lagrange` meant"):
        oscillator().derive("lagrang")


def test_statements_are_proved_and_shown_as_a_table():
    judgements = oscillator().prove()
    assert judgements[0].verdict == "proved" and not judgements.failed
    assert "<td" in judgements._repr_html_() and "proved" in repr(judgements)


def test_a_fault_has_its_place_and_its_remedy():
    with pytest.raises(dalembert.ModelError) as raised:
        dalembert.Model.from_text(OSCILLATOR.replace("-k*x", "-k*y"), "mine.toml")
    error = raised.value
    assert (error.file, error.line, error.column) == ("mine.toml", 13, 10)
    assert "y" in error.title and error.issues[0]["remedy"] == error.remedy and "mine.toml:13" in str(error)
    for call in (lambda: oscillator().run(span=-1), lambda: oscillator().run(method="dopri"), lambda: oscillator().run(samples=0)):
        with pytest.raises(ValueError, match="accepted|Known"):
            call()
    with pytest.raises(dalembert.ModelError, match="no such file"):
        dalembert.Model.from_file("nowhere.toml")


def test_letters_without_values_are_derived_and_do_not_run():
    letters = dalembert.Model.from_text(OSCILLATOR.replace('k = "4 N/m"', 'k = "N/m"'))
    assert letters.parameters["k"] is None and letters.prove()[0].verdict == "proved"
    with pytest.raises(dalembert.ModelError, match="`k` has no value"):
        letters.run()
    assert letters.with_values(k=4.0).run(span=1).ok


def test_a_built_model_is_the_written_one():
    built = (
        dalembert.Model.builder("A block on a spring")
        .parameters(m="1 kg", k="4 N/m")
        .coordinates(x="m")
        .body("block", centre="O + x*N.x", mass="m")
        .force(on="block", is_="-k*x*N.x")
        .start({"x": "0.1 m", "x'": "0.3 m/s"})
        .output("twice", "2*x")
        .build()
    )
    run = built.run(span=3, tolerance=1e-12)
    assert np.abs(run["twice"] - 2 * (0.1 * np.cos(2 * run.time) + 0.15 * np.sin(2 * run.time))).max() < 1e-10
    assert repr(built.derive().text) == repr(oscillator().derive().text)
    with pytest.raises(TypeError, match="is no value of a model"):
        dalembert.Model.builder().parameters(m=object()).build()


def test_events_end_a_law_and_are_told():
    ball = dalembert.Model.from_file(SCENES / "models" / "bouncing_ball.toml")
    run = ball.run()
    assert len(run.events) > 2 and run.ok
    with pytest.raises(dalembert.ModelError, match="changes at events"):
        ball.rhs()


def test_a_run_that_fails_says_why():
    text = OSCILLATOR.replace("-k*x*N.x", "(1 N s)/(t - (0.5 s))*N.x")
    run = dalembert.Model.from_text(text).run(span=1)
    assert not run.ok and run.stopped and run.time[-1] < 0.5 and "stopped" in repr(run)


def test_a_long_run_lets_others_work_and_obeys_its_time_and_ctrl_c():
    model = dalembert.Model.from_file(SCENES / "models" / "double_pendulum.toml")
    counted = [0]
    over = threading.Event()

    def count():
        while not over.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    run = model.run(span=1e7, seconds=0.5, samples=10)
    over.set()
    thread.join()
    assert counted[0] > 50 and run.stopped and not run.ok
    # a program that runs in the background begins deaf to it
    signal.signal(signal.SIGINT, signal.default_int_handler)
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        model.run(span=1e7, seconds=60)
    assert time.monotonic() - begin < 5


def test_every_name_has_help_and_every_stub_stands_for_something():
    stubs = (Path(dalembert.__file__).parent / "_native.pyi").read_text()
    from dalembert import _native

    for name in dir(_native):
        if not name.startswith("_"):
            assert name in stubs, name
    for name in dalembert.__all__:
        assert getattr(dalembert, name).__doc__, name
    for member in dir(dalembert.Model):
        if not member.startswith("_"):
            assert getattr(dalembert.Model, member).__doc__, member


def test_the_page_of_the_book_runs_as_it_is_written():
    pytest.importorskip("sympy")
    page = (Path(__file__).parents[3] / "book" / "src" / "python.md").read_text()
    blocks = [part.split("```")[0] for part in page.split("```python")[1:]]
    assert len(blocks) >= 3
    exec("\n".join(blocks), {})


def test_pictures_are_drawn():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    run = oscillator().run(span=2)
    assert len(run.plot().axes) >= 2 and run.phase("x", "x'").get_xlabel() == "x [m]"


def test_a_run_is_pickled_with_all_that_it_knows():
    run = oscillator().run(span=2, samples=5)
    again = pickle.loads(pickle.dumps(run))
    assert np.array_equal(again.array, run.array) and repr(again) == repr(run) and again.ok
    assert np.array_equal(run[["x", "x'"]], run.array[:, :2]) and run["time"] is run.time


def test_values_with_which_no_body_can_exist_are_refused_at_once():
    with pytest.raises(dalembert.ModelError, match="mass"):
        oscillator().with_values(m=-1.0)


def test_arguments_of_another_kind_are_told():
    for call in (
        lambda: dalembert.Model.from_text(None),
        lambda: oscillator().run(1, method=3),
        lambda: oscillator().run(1, tolerance="1e-8"),
    ):
        with pytest.raises(TypeError, match="is"):
            call()
