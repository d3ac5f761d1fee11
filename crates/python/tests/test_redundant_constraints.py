"""Constraints that stand twice in equations of SymPy."""

import pytest

import dalembert

sympy = pytest.importorskip("sympy")
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols  # noqa: E402

PENDULUM = """
gravity = "-g*N.y"
[parameters]
m = "kg"
l = "m"
g = "m/s^2"
[coordinates]
x = "m"
y = "m"
[bodies.bob]
centre = "O + x*N.x + y*N.y"
mass = "m"
[[constraint]]
zero = "x^2 + y^2 - l^2"
"""


@pytest.mark.parametrize("again", [[], [2], [3, 5]])
def test_a_constraint_that_stands_twice_takes_one_degree_of_freedom(again):
    x, y = dynamicsymbols("x y")
    m, l, g = sympy.symbols("m l g")
    length = x**2 + y**2 - l**2
    kinetic = m * (x.diff() ** 2 + y.diff() ** 2) / 2
    method = LagrangesMethod(kinetic - m * g * y, [x, y], hol_coneqs=[length] + [factor * length for factor in again])
    method.form_lagranges_equations()
    found = dalembert.Model.from_text(PENDULUM).check(method)
    assert found.same is True, found
