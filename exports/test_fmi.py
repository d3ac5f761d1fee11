"""Units of FMI 3.0 and 2.0: FMPy validates and simulates them to the end of our own runs."""

import subprocess
import zipfile
from pathlib import Path

import fmpy
import numpy as np
import pytest
from fmpy.fmi2 import FMU2Model
from fmpy.fmi3 import FMU3Model
from fmpy.validation import validate_fmu

from conftest import difference

# no event, constraints, a free frame, a motor, a motor with a condition, events; inputs are in a test of their own
SCENES = [
    "models/double_pendulum.toml",
    "models/slider_crank.toml",
    "models/tumbling_body.toml",
    "models/geared_motor.toml",
    "models/series_motor.toml",
    "models/bouncing_ball.toml",
]

DRIVEN = """title = "A mass on a spring is pushed"
[parameters]
m = "2 kg"
k = "30 N/m"
c = "0.4 N s/m"
[coordinates]
x = "m"
[energies]
kinetic = "m*x'^2/2"
potential = "k*x^2/2"
[inputs]
push = PUSH
[[force]]
along = "x"
is = "push - c*x'"
[outputs]
spring = "-k*x"
power = "push*x'"
acceleration = "x''"
[start]
x = "0.1 m"
[run]
span = "5 s"
"""


# versions of the standard
FMI = ["3", "2"]

# FMPy's CVODE for model exchange, a stiff method of low order; for co-simulation the unit's own steps
TOLERANCES = {"ModelExchange": (1e-9, 5e-6), "CoSimulation": (1e-10, 2e-7)}


def names(own):
    """The columns of a run that a unit has: not the time, and not the work, which a run meters beside the motion."""
    return [name for name in own if name not in ("time", "work")]


def simulate(unit, own, kind, tolerance, **others):
    interval = own["time"][-1] / 100
    return fmpy.simulate_fmu(
        str(unit), fmi_type=kind, solver="CVode", relative_tolerance=tolerance, stop_time=own["time"][-1],
        output_interval=interval, step_size=interval, output=names(own), record_events=False, **others
    )


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("kind", ["ModelExchange", "CoSimulation"])
@pytest.mark.parametrize("fmi", FMI)
def test_a_unit_comes_to_the_end_of_our_own_run(workbench, scene, kind, fmi):
    own = workbench.run(scene)
    unit = workbench.export(scene, "--fmu", "unit.fmu", "--fmi", fmi)
    assert validate_fmu(str(unit)) == [] and fmpy.read_model_description(str(unit)).fmiVersion == f"{fmi}.0"
    tolerance, bound = TOLERANCES[kind]
    found = simulate(unit, own, kind, tolerance)
    assert found.dtype.names[1:] == tuple(names(own))
    largest = max(difference(own, name, found["time"], found[name]) for name in names(own))
    print(f"{scene} FMI {fmi} {kind} at {tolerance:.0e}: {largest:.1e}")
    assert largest < bound


def test_a_smaller_tolerance_comes_nearer(workbench):
    scene = "models/double_pendulum.toml"
    own, unit = workbench.run(scene), workbench.export(scene, "--fmu", "unit.fmu")
    at = [max(difference(own, name, found["time"], found[name]) for name in names(own))
          for found in (simulate(unit, own, "CoSimulation", tolerance) for tolerance in (1e-6, 1e-9))]
    assert at[1] < at[0] / 50


def test_events_that_follow_each_other_within_one_step_of_communication_are_found(workbench):
    # a controller reads the speed every 40 ms; nothing else bounds the step
    scene = "failures/sampled_speed.toml"
    own, unit = workbench.run(scene), workbench.export(scene, "--fmu", "unit.fmu")
    end = own["time"][-1]
    found = fmpy.simulate_fmu(str(unit), fmi_type="CoSimulation", relative_tolerance=1e-9, stop_time=end, step_size=end,
                              output_interval=end, output=names(own))
    assert np.allclose([found[name][-1] for name in names(own)], [own[name][-1] for name in names(own)], rtol=0, atol=1e-8)


@pytest.mark.parametrize("kind", ["ModelExchange", "CoSimulation"])
@pytest.mark.parametrize("fmi", FMI)
def test_parameters_and_inputs_can_be_changed(workbench, kind, fmi):
    pushed = DRIVEN.replace("PUSH", '{ unit = "N", value = "3 N" }').replace('"30 N/m"', '"45 N/m"')
    own = workbench.run(pushed)
    unit = workbench.export(DRIVEN.replace("PUSH", '"N"'), "--fmu", "unit.fmu", "--fmi", fmi)
    assert validate_fmu(str(unit)) == []
    signal = np.array([(0.0, 3.0), (10.0, 3.0)], dtype=[("time", float), ("push", float)])
    tolerance, bound = TOLERANCES[kind]
    found = simulate(unit, own, kind, tolerance, start_values={"k": 45.0}, input=signal)
    assert max(difference(own, name, found["time"], found[name]) for name in names(own)) < bound


@pytest.mark.parametrize("scene", ["models/slider_crank.toml", "models/series_motor.toml", DRIVEN.replace("PUSH", '"N"')])
@pytest.mark.parametrize("fmi", FMI)
def test_directional_derivatives_are_quotients_of_differences(workbench, scene, fmi):
    unit = workbench.export(scene, "--fmu", "unit.fmu", "--fmi", fmi)
    description = fmpy.read_model_description(str(unit))
    folder = fmpy.extract(str(unit))
    model = (FMU3Model if fmi == "3" else FMU2Model)(guid=description.guid, unzipDirectory=folder, instanceName="one",
                                                     modelIdentifier=description.modelExchange.modelIdentifier)
    read, write = (model.getFloat64, model.setFloat64) if fmi == "3" else (model.getReal, model.setReal)
    model.instantiate()
    if fmi == "2":
        model.setupExperiment()
    model.enterInitializationMode()
    model.exitInitializationMode()
    model.enterContinuousTimeMode()
    named = {variable.name: variable for variable in description.modelVariables}
    states = [unknown.variable.derivative for unknown in description.derivatives]
    rates = [unknown.variable.valueReference for unknown in description.derivatives]
    outputs = [unknown.variable.valueReference for unknown in description.outputs]
    given = [variable.valueReference for variable in named.values() if variable.causality in ("parameter", "input")]
    first = np.array(read([state.valueReference for state in states])) + 0.05
    values = np.array(read(given))
    unknowns = rates + outputs

    def at(state, data):
        model.enterEventMode()
        write(given, list(data))
        model.enterContinuousTimeMode()
        model.setContinuousStates((np.ctypeslib.as_ctypes(np.ascontiguousarray(state))), len(state))
        return np.array(read(unknowns))

    for place, known in enumerate([state.valueReference for state in states] + given):
        size = first[place] if place < len(states) else values[place - len(states)]
        step = 1e-5 * max(abs(size), 1e-4)
        sides = []
        for sign in (1, -1):
            state, data = first.copy(), values.copy()
            (state if place < len(states) else data)[place if place < len(states) else place - len(states)] += sign * step
            sides.append(at(state, data))
        at(first, values)
        wanted = (sides[0] - sides[1]) / (2 * step)
        found = np.array(model.getDirectionalDerivative(unknowns, [known], [1.0]))
        assert np.allclose(found, wanted, rtol=1e-5, atol=1e-5 * np.max(np.abs(wanted) + 1e-3)), (known, found, wanted)
    model.terminate()
    model.freeInstance()


def test_a_changed_length_leaves_the_start_on_the_constraints(workbench):
    text = workbench.scene("models/slider_crank.toml").read_text()
    unit = workbench.export(text, "--fmu", "unit.fmu")
    lengths = [variable for variable in fmpy.read_model_description(str(unit)).modelVariables
               if variable.causality == "parameter" and variable.unit == "m"]
    longer = {variable.name: 1.05 * float(variable.start) for variable in lengths[-1:]}
    assert longer, "it has a length"
    found = fmpy.simulate_fmu(str(unit), fmi_type="CoSimulation", stop_time=0.1, relative_tolerance=1e-9, step_size=0.01,
                              output_interval=0.01, start_values=longer, output=["kinetic_energy", "potential_energy"])
    assert np.all(np.isfinite(found["kinetic_energy"])) and len(found) == 11


def test_the_sources_fit_the_headers_of_the_standard_and_have_no_warnings(workbench):
    headers = Path(fmpy.__file__).parent / "c-code"
    scenes = ["models/slider_crank.toml", "models/bouncing_ball.toml", "models/double_pendulum.toml"]
    for scene, fmi in [(scene, fmi) for scene in scenes for fmi in FMI]:
        unit = workbench.export(scene, "--fmu", "unit.fmu", "--fmi", fmi)
        with zipfile.ZipFile(unit) as archive:
            archive.extractall(workbench.folder / "unit")
        sources = workbench.folder / "unit" / "sources"
        for more in ([], ["-include", headers / f"fmi{fmi}Functions.h"], [f"-DFMI{fmi}_FUNCTION_PREFIX=one_"]):
            warned = ["cc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", *map(str, more), f"fmi{fmi}.c"]
            said = subprocess.run(warned, cwd=sources, capture_output=True, text=True)
            assert said.returncode == 0, said.stderr


@pytest.mark.parametrize("fmi", FMI)
def test_an_event_ends_the_run(workbench, fmi):
    falling = """title = "A stone falls"
gravity = "-(9.81 m/s^2)*N.y"
[parameters]
m = "1 kg"
[coordinates]
y = "m"
[bodies.stone]
centre = "O + y*N.y"
mass = "m"
[[event]]
name = "ground"
when = "y"
direction = "down"
end = true
[start]
y = "1 m"
[run]
span = "3 s"
"""
    unit = workbench.export(falling, "--fmu", "unit.fmu", "--fmi", fmi)
    for kind in ["ModelExchange", "CoSimulation"]:
        found = fmpy.simulate_fmu(str(unit), fmi_type=kind, output_interval=0.01, relative_tolerance=1e-9, stop_time=3.0)
        assert abs(found["time"][-1] - np.sqrt(2 / 9.81)) < 0.011, kind


TWO_AT_ONCE = """title = "Two events at one instant set one speed"
[parameters]
m = "1 kg"
[coordinates]
x = "m"
[bodies.b]
centre = "O + x*N.x"
mass = "m"
[[event]]
name = "doubles"
when = "x - (0.5 m)"
direction = "up"
set = { "x'" = "2*x'" }
[[event]]
name = "adds"
when = "2*x - (1 m)"
direction = "up"
set = { "x'" = "x' + (1 m/s)" }
[start]
"x'" = "1 m/s"
[run]
span = "1 s"
"""


@pytest.mark.parametrize("kind", ["ModelExchange", "CoSimulation"])
@pytest.mark.parametrize("fmi", FMI)
def test_events_of_one_instant_follow_each_other(workbench, kind, fmi):
    own = workbench.run(TWO_AT_ONCE)
    # twice the speed, and one more: 3 m/s from x = 0.5 m on
    assert abs(own["x"][-1] - 2.0) < 1e-9
    unit = workbench.export(TWO_AT_ONCE, "--fmu", "unit.fmu", "--fmi", fmi)
    found = simulate(unit, own, kind, 1e-9)
    assert abs(found["x"][-1] - 2.0) < 1e-6 and abs(found["x'"][-1] - 3.0) < 1e-6
