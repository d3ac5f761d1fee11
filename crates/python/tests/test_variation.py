"""Numbers that vary in an ensemble, as a call gives them."""

import numpy as np
import pytest

import dalembert
from systems import OSCILLATOR

QUASI = """
[parameters]
m = "1 kg"
[coordinates]
x = "m"
[speeds]
v = "2*x'"
[bodies.a]
centre = "O + x*N.x"
mass = "m"
[start]
v = "1 m/s"
[run]
span = "1 s"
"""

COIL = """
[coordinates]
a = "rad"
[[drive]]
name = "w"
turns = "a"
inertia = "(1e-3 kg m^2)"
[[drive.winding]]
inductance = "(2 mH)"
resistance = "(0.5 ohm)"
supply = "(0 V)"
motional = "(0.05 V s)"
[run]
span = "0.01 s"
"""

TOP = """
[coordinates]
z = "m"
[frames]
F = "N free"
[bodies.stone]
frame = "F"
centre = "O + z*N.z"
mass = "(1 kg)"
inertia = { principal = ["(1 kg m^2)", "(2 kg m^2)", "(2.5 kg m^2)"] }
[run]
span = "0.1 s"
"""

TABLES = [
    '[ensemble]\nmembers = 2\n[ensemble.vary]\nstart.x = { from = "0 m", to = "1 m" }\n',
    "[ 'ensemble' ]\nmembers = 2 # ]\nseed = 7\n[ensemble . vary.start]\nx = { from = \"0 m\",\n to = \"1 m\" }\n[run]\nspan = \"10 s\"",
    '[outputs]\n"[ensemble]" = """\n2*x"""\n[ensemble]\nmembers = 2\nvary = { start = { x = { values = "0 1 m" } } }\n',
]


def oscillator(more=""):
    return dalembert.Model.from_text(OSCILLATOR + more)


def start(model, members, vary):
    """The column of the first number that varies."""
    return model.ensemble(members, vary).array[:, 0]


@pytest.mark.parametrize("table", TABLES)
def test_a_call_replaces_the_table_of_the_text(table):
    members = oscillator(table).ensemble(3, {"k": {"values": [3, 4, 5]}})
    assert len(members) == 3 and np.array_equal(members["parameters.k"], [3, 4, 5]) and "start.x" not in members
    assert np.allclose(members["x"], 0.1 * np.cos(10 * np.sqrt([3, 4, 5])), atol=1e-6)


def test_a_replaced_table_leaves_every_other_line_at_its_place():
    text = 'ensemble = { members = 3,\n vary = {} }\ny = """\n[ensemble]\n"""\n[a]\nensemble = 3\n[ensemble.vary]\nb = 1\n[c]\n'
    from dalembert._tables import without_table

    assert without_table(text, "ensemble") == '\n\ny = """\n[ensemble]\n"""\n[a]\nensemble = 3\n\n\n[c]\n'


def test_faults_of_a_call_are_told_by_its_keys():
    faults = {
        "from": ({"k": {"from": 2, "to": 1}}, r'`vary\["k"\]`: `to` is less than `from`'),
        "key": ({"k": {"form": 2, "to": 1}}, r'`vary\["k"\]`: unknown key `form`'),
        "name": ({"kk": {"from": 1, "to": 2}}, r'`vary\["kk"\]`: unknown key `kk`.*known here: x.*; parameters: m, k'),
        "unit": ({"k": {"from": "1 m", "to": "2 m"}}, r'`vary\["k"\]`: .*this is m, but must be kg s\^-2'),
        "count": ({"k": {"values": [1, 2]}}, r'`vary\["k"\]`: .*2 numbers where 3 are needed'),
    }
    for vary, words in faults.values():
        with pytest.raises(dalembert.ModelError, match=words) as raised:
            oscillator().ensemble(3, vary)
        assert raised.value.line is None and all(issue["line"] is None for issue in raised.value.issues)
        assert "-->" not in str(raised.value)


def test_plain_numbers_are_in_si_units_whatever_varies():
    assert np.array_equal(start(dalembert.Model.from_text(QUASI), 2, {"v": {"values": [1, 2]}}), [1, 2])
    assert np.array_equal(start(dalembert.Model.from_text(COIL), 2, {"w.i": {"values": [1, 2]}}), [1, 2])
    turned = dalembert.Model.from_text(TOP).ensemble(2, {"F": {"values": [[0, 0, 0], [0.1, 0.2, 0.3]]}})
    assert np.array_equal(turned.array[:, :3], [[0, 0, 0], [0.1, 0.2, 0.3]])


def test_numbers_with_units_and_arrays_are_taken():
    for values in (["3 N/m", "4 N/m"], "3 4 N/m", (3, 4.0), np.array([3.0, 4.0]), np.float32([3, 4]), iter([3, 4]), ["3", 4]):
        assert np.array_equal(start(oscillator(), 2, {"k": {"values": values}}), [3, 4])
    assert np.array_equal(start(oscillator(), 2, {"k": {"values": ["3 N/mm", "4 N/mm"]}}), [3000, 4000])
    assert len(oscillator("[run]\nspan = \"0.1 s\"").ensemble(100_000, {"k": {"values": np.linspace(1, 2, 100_000)}})) == 100_000


@pytest.mark.parametrize(
    "vary", [[1], {"k": [1, 2, 3]}, {"k": 3}, {1: {"from": 1, "to": 2}}, {"k": {1: 2}}, {"k": {"from": None, "to": 1}}, {"k": {"values": {}}}, {"k": {"values": [[[1]]]}}]
)
def test_what_is_no_distribution_is_told(vary):
    with pytest.raises(TypeError, match=r"`vary.*accepted"):
        oscillator().ensemble(3, vary)


@pytest.mark.parametrize("values", [[], [1, float("nan")], [float("inf")], [10**400], ["1 N/m", "2 N/mm"], ["one N/m"], [1, "2 N/mm"]])
def test_numbers_that_are_none_are_told(values):
    with pytest.raises(ValueError, match=r'`vary\["k"\]\["values"\]`.*accepted'):
        oscillator().ensemble(3, {"k": {"values": values}})


def test_counts_of_an_ensemble_are_whole_numbers():
    vary = {"k": {"from": 1, "to": 2}}
    for wrong in ({"members": 0}, {"members": 2.5}, {"members": True}, {"seed": -1}, {"seed": 2**32}, {"threads": 0}, {"threads": -2}, {"threads": 10**9}, {"seconds": 0}):
        [name] = wrong
        with pytest.raises(ValueError, match=f"`{name}` is .*accepted"):
            oscillator().ensemble(**{"members": 3, "vary": vary, **wrong})
    with pytest.raises(ValueError, match="`seed` is accepted with"):
        oscillator(TABLES[0]).ensemble(seed=3)


def test_each_column_has_a_name_of_its_own():
    text = OSCILLATOR.replace('x = "m"', 'time = "m"').replace("x*N.x", "time*N.x").replace('x = "0.1 m"', 'time = "0.1 m"') + '[outputs]\nsteps = "2*time"\n'
    members = dalembert.Model.from_text(text).ensemble(2, {"k": {"values": [3, 4]}})
    assert len(set(members.keys())) == len(members.keys()) == members.array.shape[1]
    assert np.allclose(members["time"], 0.1 * np.cos(10 * np.sqrt([3, 4])), atol=1e-6) and np.allclose(members["steps"], 2 * members["time"])
    assert np.array_equal(members["run.time"], [10, 10]) and (members["run.steps"] > 1).all() and members.units["run.time"] == "s"


def test_a_coordinate_keeps_its_name_beside_the_energy_of_a_run():
    text = OSCILLATOR.replace('x = "m"', 'kinetic_energy = "m"').replace("x*N.x", "kinetic_energy*N.x").replace('x = "0.1 m"', 'kinetic_energy = "0.1 m"')
    run = dalembert.Model.from_text(text).run(1, samples=3)
    assert len(set(run.names)) == len(run.names) and run.units["kinetic_energy"] == "m" and run.units["run.kinetic_energy"] == "J"
    assert run["kinetic_energy"][0] == 0.1 and np.allclose(run["run.kinetic_energy"], run["kinetic_energy'"] ** 2 / 2)
