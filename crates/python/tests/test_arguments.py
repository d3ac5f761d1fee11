"""Arguments of every call: numbers and names of any kind are taken, all else is refused in words."""

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest

import dalembert
from systems import OSCILLATOR

REGULATED = (
    OSCILLATOR.replace("-k*x*N.x", "(u - k*x)*N.x").replace('x = "0.1 m"', 'x = "0 m"')
    + '[inputs]\nu = "N"\n[regulator]\ncost = "(x/(1 m))^2 + (u/(1 N))^2"\ndisplaced = { x = "0.1 m" }\n'
)


def oscillator():
    return dalembert.Model.from_text(OSCILLATOR)


REFUSED = {
    "a range in a list": (TypeError, lambda model: model.stationary([("x", (0, 1))])),
    "a range of a text": (TypeError, lambda model: model.stationary({"x": "a"})),
    "a limit of time in words": (TypeError, lambda model: model.chart(seconds="5")),
    "values in a list": (TypeError, lambda model: model.with_values([1])),
    "values of a number": (TypeError, lambda model: model.with_values({1: 2})),
    "a truth value": (TypeError, lambda model: model.with_values(m=True)),
    "a complex value": (TypeError, lambda model: model.with_values(m=1 + 2j)),
    "an array for a number": (TypeError, lambda model: model.with_values(m=[1.0, 2.0])),
    "a file of a number": (TypeError, lambda model: dalembert.Model.from_file(3)),
    "a name of nothing": (TypeError, lambda model: dalembert.Model.from_text(OSCILLATOR, name=None)),
    "a principle of a number": (TypeError, lambda model: model.derive(1)),
    "a language of nothing": (TypeError, lambda model: model.derive().code(None)),
    "outputs of nothing": (TypeError, lambda model: model.choose(1e-3, None)),
    "outputs of numbers": (TypeError, lambda model: model.choose(1e-3, [1])),
    "inputs of a number": (TypeError, lambda model: model.linearise(inputs=3)),
    "unknowns of numbers": (TypeError, lambda model: model.inverse({"x": "(1 m)"}, [1])),
    "names in a list": (TypeError, lambda model: dalembert.from_sympy(1, [1])),
    "a paper of nothing": (TypeError, lambda model: dalembert.judge(None)),
    "an empty paper": (ValueError, lambda model: dalembert.judge("")),
    "a table of a list": (TypeError, lambda model: dalembert.Model.builder().parameters([1])),
    "a title of bytes": (TypeError, lambda model: dalembert.Model.builder(b"a")),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_of_another_kind_is_told_with_what_is_accepted(case):
    if "names" in case:
        pytest.importorskip("sympy")
    kind, call = REFUSED[case]
    with pytest.raises(kind, match="is accepted|are accepted|is a text|is a str"):
        call(oscillator())


@pytest.mark.parametrize("seconds", [0, -1, float("nan"), float("inf")])
def test_one_rule_holds_for_the_time_of_every_call(seconds):
    model = oscillator()
    for call in (model.run, model.chart, model.reference, model.regimes, model.regulate, lambda **time: model.stationary({"x": 0}, **time)):
        with pytest.raises(ValueError, match="`seconds` is .*; a positive time in seconds is accepted, and None for no limit"):
            call(seconds=seconds)


def test_a_number_of_many_digits_is_told_in_short():
    for large in (10**400, 10**5000):
        with pytest.raises(ValueError, match="`m` is .*up to 1.7e308 is accepted") as raised:
            oscillator().with_values(m=large)
        assert len(str(raised.value)) < 200


def test_numbers_of_numpy_and_names_of_files_of_every_kind_are_taken(tmp_path):
    model = oscillator().with_values(m=np.float32(2), k=np.array(8.0))
    assert model.run(np.int64(1), samples=np.int32(4), seconds=np.float64(60)).ok
    assert len(model.stationary({"x": np.array([-1.0, 1.0])})) == 1
    path = tmp_path / "näme.toml"
    path.write_text(OSCILLATOR)
    for name in (path, str(path), str(path).encode()):
        assert dalembert.Model.from_file(name).states == ["x", "x'"]
    papers = Path(__file__).parents[3] / "papers"
    assert len(dalembert.judge(str(papers / "cart_pole.toml").encode())) == 8


def test_a_claim_that_is_not_there_is_told_so():
    ledger = dalembert.judge(Path(__file__).parents[3] / "papers" / "cart_pole.toml")
    with pytest.raises(KeyError, match="no claim is called 'eq99'; there are cart_pole/"):
        ledger["eq99"]


def test_results_are_data_that_is_pickled_and_a_function_says_that_it_is_not():
    model = oscillator()
    for found in (model.derive("lagrange"), model.prove(), model.linearise("equilibrium")):
        again = pickle.loads(pickle.dumps(found))
        assert type(again) is type(found) and repr(again) == repr(found) and repr(copy.deepcopy(found)) == repr(found)
    again = pickle.loads(pickle.dumps(model.derive("lagrange")))
    assert again.latex == model.derive("lagrange").latex and again.principle == "lagrange"
    assert np.array_equal(pickle.loads(pickle.dumps(model.linearise())).A, model.linearise().A)
    assert pickle.loads(pickle.dumps(model.prove())) == model.prove()
    for function in (model.rhs(), model.jacobian()):
        with pytest.raises(TypeError, match="is not pickled; its model is"):
            pickle.dumps(function)


def test_the_run_of_a_regulator_says_whether_it_is_whole():
    regulator = dalembert.Model.from_text(REGULATED).regulate()
    assert regulator.run.ok and regulator.run.stopped is None and regulator.run.events == regulator.events
    assert pickle.loads(pickle.dumps(regulator)).run.ok and pickle.loads(pickle.dumps(regulator.run)).ok


def test_a_text_of_any_letters_is_built():
    built = dalembert.Model.builder('a "quoted" \\ title\n\x00\x7f\x1b é').coordinates(x="m").start({"x": np.float32(0)})
    assert "\\u0000\\u007f\\u001b é" in built.text and "x = 0.0" in built.text
    assert "samples = [1, 2]" in dalembert.Model.builder().run(samples=np.array([1, 2])).text
    for value in (object(), None, 10**5000, {1, 2}):
        with pytest.raises(TypeError, match="is no value of a model"):
            dalembert.Model.builder().run(samples=value).text


def test_columns_are_asked_for_in_every_way():
    run = oscillator().run(1, samples=4)
    assert run[[]].shape == (5, 0) and np.array_equal(run[np.str_("x")], run["x"])
    assert "time" in run and [1] not in run and 3 not in run
    for wrong in (3, None, ("x", "x'"), ["x", 3]):
        with pytest.raises(KeyError, match="no column is called .*; there are x"):
            run[wrong]


def test_pictures_take_the_time_as_a_column_and_refuse_what_is_none():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    run = oscillator().run(1, samples=4)
    assert run.phase("time", "x").get_xlabel() == "time [s]" and len(run.plot("time").axes) == 1
    for wrong in (lambda: run.plot(3), lambda: run.plot(None), lambda: run.plot("x", figure=3), lambda: run.phase("x", "x'", axes=3)):
        with pytest.raises(TypeError, match="accepted"):
            wrong()


def test_numbers_beyond_every_size_and_half_letters_are_refused():
    for call in (lambda: oscillator().run(1, samples=10**30), lambda: oscillator().stationary({"x": (-1, 1)}, boxes=10**30)):
        with pytest.raises(ValueError, match="a whole number from 1 to"):
            call()
    with pytest.raises(ValueError, match="half a letter at its place 3"):
        dalembert.Model.from_text("# \ud800")
