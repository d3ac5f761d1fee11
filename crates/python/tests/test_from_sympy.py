"""Expressions of SymPy as texts of the language of models, and equations of a model as objects of SymPy."""

import pickle

import numpy as np
import pytest

import dalembert

sympy = pytest.importorskip("sympy")
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols  # noqa: E402

x, y = dynamicsymbols("x y")
a, b, c = sympy.symbols("a b c")

SPRING = """
[parameters]
m_1 = "1 kg"
k = "1 N/m"
[coordinates]
x = "m"
[bodies.b]
centre = "O + x*N.x"
mass = "m_1"
[[force]]
on = "b"
is = "-k*x*N.x"
"""

SERVO = """
[parameters]
m = "1 kg"
F = "5 N"
kp = "40 N/m"
kd = "3 N s/m"
[coordinates]
x = "m"
[bodies.a]
centre = "O + x*N.x"
mass = "m"
[inputs]
target = { unit = "m", value = "table(t, (0 s), 0, (0.5 s), (0.3 m), (1.5 s), (-0.2 m), (2 s), 0)" }
u = { unit = "N", value = "max(-F, min(F, kp*(target - x) - kd*x'))" }
[[force]]
on = "a"
is = "u*N.x"
"""


def value(text, at):
    """The number that the language gives an expression of x without units."""
    model = dalembert.Model.from_text(
        f"""
        [coordinates]
        x = "1"
        [energies]
        kinetic = "(1 J s^2)*x'^2/2"
        [[force]]
        along = "x"
        is = "(1 J)*({text})"
        """
    )
    return model.rhs()(0.0, [at, 0.0])[1]


@pytest.mark.parametrize(
    "one, other", [(sympy.Symbol("m_{1}"), sympy.Symbol("m_1")), (sympy.Symbol("m", positive=True), sympy.Symbol("m")), (sympy.Symbol("x"), x)]
)
def test_two_symbols_never_become_one_letter(one, other):
    with pytest.raises(ValueError, match="are two symbols, and both would be the letter .* `names` gives each symbol its meaning") as raised:
        dalembert.from_sympy(one + other)
    assert all(sympy.srepr(symbol) in str(raised.value) or str(symbol) in str(raised.value) for symbol in (one, other))
    with pytest.raises(ValueError, match="two symbols"):
        dalembert.from_sympy(one + other, {one: sympy.Symbol(str(other)).name.replace("(t)", "")})
    assert sorted(dalembert.from_sympy(one + other, {one: "p", other: "q"})) == sorted("p + q")


def test_two_masses_of_a_method_are_not_taken_for_one():
    one, other, k = sympy.symbols("m_{1} m_1 k")
    method = LagrangesMethod((one + other) * x.diff() ** 2 / 2 - k * x**2 / 2, [x])
    method.form_lagranges_equations()
    model = dalembert.Model.from_text(SPRING)
    with pytest.raises(dalembert.ModelError, match=r"Symbol\('m_1'\) and Symbol\('m_\{1\}'\) are two symbols"):
        model.check(method)
    assert model.check(method, {one: "m_1/3", other: "2*m_1/3"}).same
    assert model.check(method, {one: "m_1", other: "m_1"}).same is False


@pytest.mark.parametrize("name", ["a+b", "x*y", "1a", "if", "", "pi", "N", "x'"])
def test_a_symbol_whose_name_is_no_letter_needs_a_meaning(name):
    symbol = sympy.Symbol(name)
    with pytest.raises(ValueError, match="has a name that no letter of the language has"):
        dalembert.from_sympy(2 * symbol)
    assert dalembert.from_sympy(2 * symbol, {symbol: "p"}) == "2*p"


def test_names_that_mean_nothing_are_refused():
    for wrong in ({"zz": "p"}, {a: "p"}):
        with pytest.raises(ValueError, match="hold no (zz|a); they hold x"):
            dalembert.from_sympy(x, wrong)
    for wrong in ({x: 3}, {x: " "}, {3: "p"}, {x.diff(): "v"}, [x]):
        with pytest.raises(TypeError, match="is accepted"):
            dalembert.from_sympy(x, wrong)
    for wrong in (None, "x", [x], x > y, sympy.Matrix([x])):
        with pytest.raises(TypeError, match="a scalar expression of SymPy is accepted"):
            dalembert.from_sympy(wrong)


def test_powers_have_the_values_of_sympy_wherever_these_are_real():
    z = sympy.Symbol("x")
    for exponent, places in [(2.0, (-2.0, 0.0, 2.0)), (3.0, (-2.0, 0.0)), (1.5, (0.0, 2.0)), (0.1, (0.0, 2.0)), (2, (-2.0,)), (sympy.Rational(1, 3), (2.0,)), (0.45, (2.0,)), (0.9485864, (2.0,)), (sympy.Rational(100, 3), (2.0,)), (1.001, (2.0,))]:
        for place in places:
            assert np.isclose(value(dalembert.from_sympy(z**exponent), place), float((z**exponent).subs(z, place))), (exponent, place)
    assert dalembert.from_sympy(z**-2.0) == "1/x^2"
    with pytest.raises(ValueError, match="exponents from -64 to 64"):
        dalembert.from_sympy(z**sympy.Rational(131, 2))


def test_the_least_of_three_is_nested():
    assert dalembert.from_sympy(sympy.Min(a, b, c)) == "min(a, min(b, c))"
    assert dalembert.from_sympy(sympy.Max(a, b, c, x)) == "max(a, max(b, max(c, x)))"


def test_pieces_with_simple_conditions_are_translated_and_others_refused():
    z = sympy.Symbol("x")
    pieces = sympy.Piecewise((-z, z < -1), (z**2, z <= 1), (3, True))
    assert dalembert.from_sympy(pieces) == "if(x < -1, -x, if(x <= 1, x^2, 3))"
    assert dalembert.from_sympy(sympy.Piecewise((-1, x < 0), (1, x >= 0))) == "if(x < 0, -1, 1)"
    assert dalembert.from_sympy(sympy.Piecewise((1, a < a), (2, z < 0), (3, b >= b), (4, True))) == "if(x < 0, 2, 3)"
    for wrong in (sympy.Piecewise((1, sympy.Eq(x, 0)), (2, True)), sympy.Piecewise((1, (x > 0) & (x < 1)), (2, True)), sympy.Piecewise((1, x < 0))):
        with pytest.raises(ValueError, match="cannot be written"):
            dalembert.from_sympy(wrong)


def test_what_the_language_does_not_have_is_refused():
    for wrong in (x.diff(dynamicsymbols._t, 3), sympy.oo, sympy.nan, sympy.I * a, sympy.Heaviside(x), sympy.Function("f")(a)):
        with pytest.raises(ValueError, match="cannot be written in the language"):
            dalembert.from_sympy(wrong)


def test_a_method_with_pieces_is_refused_in_words():
    m, k = sympy.symbols("m_1 k")
    method = LagrangesMethod(m * x.diff() ** 2 / 2 - sympy.Piecewise((k * x**2 / 2, x > 0), (0, True)), [x])
    method.form_lagranges_equations()
    with pytest.raises(dalembert.ModelError, match="not compared"):
        dalembert.Model.from_text(SPRING).check(method)


def test_a_saturated_controller_becomes_objects_of_sympy():
    found = dalembert.Model.from_text(SERVO).derive().sympy_expressions
    q, time = found.q[0], dynamicsymbols._t
    force = sympy.lambdify([time, q.diff(time), q, *found.values], found.forces[0])
    for at in (0.2, 1.0, 1.7, 3.0):
        target = np.interp(at, [0, 0.5, 1.5, 2], [0, 0.3, -0.2, 0])
        expected = np.clip(40 * (target - 0.1) - 3 * 0.3, -5, 5)
        assert np.isclose(force(at, 0.3, 0.1, *found.values.values()), expected)
        exact = found.forces[0].subs(found.values).subs(q.diff(time), 0.3).subs(q, 0.1).subs(time, at)
        assert np.isclose(float(exact), expected)
    assert pickle.loads(pickle.dumps(found.forces)) == found.forces
