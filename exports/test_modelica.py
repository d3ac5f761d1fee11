"""Flat Modelica models: rumoca reads and simulates them to the end of our own runs."""

import numpy as np
import pytest

from conftest import difference

rumoca = pytest.importorskip("rumoca")

SCENES = [
    "models/double_pendulum.toml",
    "models/slider_crank.toml",
    "models/tumbling_body.toml",
    "models/geared_motor.toml",
    "models/series_motor.toml",
    "models/bouncing_ball.toml",
]


@pytest.mark.parametrize("scene", SCENES)
def test_a_model_comes_to_the_end_of_our_own_run(workbench, scene):
    own = workbench.run(scene)
    path = workbench.export(scene, "--modelica", "Exported.mo")
    assert rumoca.validate(str(path)) == []
    model = rumoca.Session().load(str(path))
    end = own["time"][-1]
    config = rumoca.SimConfig(rtol=1e-10, atol=1e-12)
    found = model.simulate(t=(0.0, end), dt=end / 100, config=config)
    # a prime is no letter of an identifier
    identifiers = {name: name.replace("'", "prime").replace(".", "_") for name in own if name not in ("time", "work")}
    largest = max(difference(own, name, np.asarray(found.time), np.asarray(found[its])) for name, its in identifiers.items())
    print(f"{scene} Modelica: {largest:.1e}")
    assert largest < 2e-6


BETWEEN_WALLS = """title = "A ball between a wall and a floor"
gravity = "-(9.81 m/s^2)*N.y"
[parameters]
m = "1 kg"
[coordinates]
x = "m"
y = "m"
[bodies.ball]
centre = "O + x*N.x + y*N.y"
mass = "m"
[[event]]
name = "floor"
when = "y"
direction = "down"
set = { "y'" = "-0.8*y'", "x'" = "0.9*x'" }
[[event]]
name = "wall"
when = "x - (1 m)"
direction = "up"
set = { "x'" = "-x'" }
[start]
y = "1 m"
"x'" = "1 m/s"
[run]
span = "2 s"
"""


def test_events_that_set_one_speed_share_a_clause(workbench):
    own = workbench.run(BETWEEN_WALLS)
    path = workbench.export(BETWEEN_WALLS, "--modelica", "Exported.mo")
    assert rumoca.validate(str(path)) == []
    found = rumoca.Session().load(str(path)).simulate(t=(0.0, 2.0), dt=0.02, config=rumoca.SimConfig(rtol=1e-10, atol=1e-12))
    for name in ["x", "y"]:
        assert difference(own, name, np.asarray(found.time), np.asarray(found[name])) < 2e-6
