"""Warnings are told once, by the filters of the caller and at the caller's line."""

import multiprocessing
import pickle
import subprocess
import sys
import warnings
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path

import pytest

import dalembert
from systems import OSCILLATOR

UNUSED = OSCILLATOR.replace("[parameters]", '[parameters]\nspare = "1 m"')
CALLS = {
    "derive": lambda model: (model.derive(), model.with_values(m=2.0).derive("lagrange").latex),
    "code": lambda model: pickle.loads(pickle.dumps(model.derive())).code("c"),
    "prove": lambda model: model.prove(),
    "linearise": lambda model: model.linearise(),
    "run": lambda model: (model.run(0.1), model.rhs(), model.start),
    "pickle": lambda model: pickle.loads(pickle.dumps(model)),
    "stationary": lambda model: model.stationary({"x": (-1, 1)}),
    "ensemble": lambda model: model.ensemble(2, {"k": {"from": 1, "to": 2}}),
    "reference": lambda model: model.reference(0.1),
    "inverse": lambda model: model.inverse({"x": "(1 m)*t/(1 s)"}, "k", times=[1.0]),
}


def heard(call):
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        call()
    return [(str(one.message), Path(one.filename).name) for one in found]


def test_a_warning_of_a_text_is_told_where_it_is_read_and_not_again():
    [(message, file)] = heard(lambda: dalembert.Model.from_text(UNUSED))
    assert "the parameter `spare` is not used" in message and file == "test_warnings.py"
    with pytest.raises(UserWarning, match="spare"), warnings.catch_warnings():
        warnings.simplefilter("error")
        dalembert.Model.from_text(UNUSED)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        model = dalembert.Model.from_text(UNUSED)
    assert {name: heard(lambda: call(model)) for name, call in CALLS.items()} == {name: [] for name in CALLS}


def test_parts_tell_nothing_again_in_threads_and_in_processes(capfd):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        model = dalembert.Model.from_text(UNUSED)
        own = dalembert.Model.from_text(UNUSED + "[ensemble]\nmembers = 3\n[ensemble.vary]\nstart.x = { values = \"1 2 3 m\" }\n")
    vary = {"k": {"values": [1, 2, 3]}}
    with ThreadPoolExecutor(2) as threads, ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as processes:
        for executor in (threads, processes):
            assert heard(lambda: model.ensemble(3, vary, executor=executor)) == []
            assert heard(lambda: own.ensemble(executor=executor)) == []
    assert capfd.readouterr().err == ""


def test_threads_leave_the_filters_as_they_were():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        model = dalembert.Model.from_text(UNUSED)
    with warnings.catch_warnings():
        warnings.simplefilter("always")
        before = list(warnings.filters)
        with ThreadPoolExecutor(1) as workers, ThreadPoolExecutor(4) as callers:
            calls = [callers.submit(model.ensemble, 3, {"k": {"from": 1, "to": 2}}, executor=workers) for _ in range(8)]
            assert all(len(call.result()) == 3 for call in calls)
        assert warnings.filters == before
        assert len(heard(lambda: dalembert.Model.from_text(UNUSED))) == 1


def test_a_helper_prints_nothing_of_its_own():
    program = f"""
import warnings, dalembert
warnings.simplefilter("ignore")
dalembert.Model.from_text({UNUSED!r}).stationary({{"x": (-1, 1)}})
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stderr == ""


def test_a_warning_of_a_paper_is_told_at_the_line_that_asks():
    paper = UNUSED + "[letters]\n'm' = \"m\"\n[[claim]]\nequation = \"1\"\nkind = \"equation of motion\"\nformula = 'm q = 0'\n"
    found = heard(lambda: dalembert.judge(paper))
    assert any("not read" in message for message, _ in found) and {file for _, file in found} == {"test_warnings.py"}


def test_an_executor_that_was_shut_down_is_told_as_such():
    executor = ThreadPoolExecutor(1)
    executor.shutdown()
    model = dalembert.Model.from_text(OSCILLATOR)
    found = []
    try:
        model.ensemble(3, {"k": {"from": 1, "to": 2}}, executor=executor)
    except ValueError as error:
        found.append(str(error))
    assert found and "`executor` takes no work" in found[0] and "shut down" in found[0]


def test_a_warning_of_what_varies_is_told_by_its_key():
    text = OSCILLATOR + '[frames]\nF = "N free"\n[bodies.top]\nframe = "F"\ncentre = "O"\nmass = "(1 kg)"\ninertia = { principal = ["(1 kg m^2)", "(2 kg m^2)", "(2 kg m^2)"] }\n[run]\nspan = "0.1 s"\n'
    model = dalembert.Model.from_text(text)
    [(message, file)] = heard(lambda: model.ensemble(2, {"F": {"mean": "0 0 0", "deviation": "400 0 0"}}))
    assert message.startswith('`vary["F"]`: 400 rad') and file == "test_warnings.py"
