"""SymPy's equations of motion beside those of models, and expressions both ways."""

from pathlib import Path

import numpy as np
import pytest

import dalembert

sympy = pytest.importorskip("sympy")
from sympy.physics.mechanics import (  # noqa: E402
    KanesMethod,
    LagrangesMethod,
    Particle,
    Point,
    ReferenceFrame,
    RigidBody,
    dot,
    dynamicsymbols,
    inertia,
)

SCENES = Path(__file__).parents[3] / "scenes" / "models"

PENDULUM = """
gravity = "-g*N.y"
[parameters]
m = "1 kg"
l = "1 m"
g = "9.81 m/s^2"
[coordinates]
theta = "rad"
[points]
P = "O + l*(sin(theta)*N.x - cos(theta)*N.y)"
[bodies.bob]
centre = "P"
mass = "m"
"""

TWO_LINKS = """
gravity = "-g*N.y"
[parameters]
m1 = "kg"
m2 = "kg"
l1 = "m"
l2 = "m"
g = "m/s^2"
[coordinates]
theta1 = "rad"
theta2 = "rad"
[points]
P = "O + l1*(sin(theta1)*N.x - cos(theta1)*N.y)"
Q = "P + l2*(sin(theta2)*N.x - cos(theta2)*N.y)"
[bodies.a]
centre = "P"
mass = "m1"
[bodies.b]
centre = "Q"
mass = "m2"
"""


def pendulum(sign=1, extra=0):
    theta, (m, l, g) = dynamicsymbols("theta"), sympy.symbols("m l g")
    method = LagrangesMethod(m * l**2 * theta.diff() ** 2 / 2 + sign * m * g * l * sympy.cos(theta) + extra * theta.diff() ** 2, [theta])
    method.form_lagranges_equations()
    return method


def two_links(gravity=1, second=1):
    """Kane's equations along relative angular velocities, from SymPy's own example."""
    q1, q2, u1, u2 = dynamicsymbols("q1 q2 u1 u2")
    m1, m2, l1, l2, g = sympy.symbols("m1 m2 l1 l2 g")
    N = ReferenceFrame("N")
    A = N.orientnew("A", "Axis", [q1, N.z])
    B = A.orientnew("B", "Axis", [q2, A.z])
    A.set_ang_vel(N, u1 * N.z)
    B.set_ang_vel(A, u2 * N.z)
    O = Point("O")
    O.set_vel(N, 0)
    P = O.locatenew("P", -l1 * A.y)
    Q = P.locatenew("Q", -l2 * B.y)
    P.v2pt_theory(O, N, A)
    Q.v2pt_theory(P, N, B)
    method = KanesMethod(N, [q1, q2], [u1, u2], kd_eqs=[q1.diff() - u1, q2.diff() - u2])
    method.kanes_equations([Particle("a", P, m1), Particle("b", Q, second * m2)], [(P, -m1 * g * gravity * N.y), (Q, -m2 * g * N.y)])
    return method


RELATIVE = {"q1": "theta1", "q2": "theta2 - theta1"}
DISC = {"q1": "heading", "q2": "-lean", "q3": "spin"}


def rolling_disc():
    """SymPy's own example by Kane's method: speeds along the axes of the leaning frame, no coordinates of the contact."""
    q1, q2, q3, u1, u2, u3 = dynamicsymbols("q1 q2 q3 u1 u2 u3")
    r, m, g = sympy.symbols("r m g")
    N = ReferenceFrame("N")
    Y = N.orientnew("Y", "Axis", [q1, N.z])
    L = Y.orientnew("L", "Axis", [q2, Y.x])
    R = L.orientnew("R", "Axis", [q3, L.y])
    by_rates = R.ang_vel_in(N)
    R.set_ang_vel(N, u1 * L.x + u2 * L.y + u3 * L.z)
    C = Point("C")
    C.set_vel(N, 0)
    centre = C.locatenew("centre", r * L.z)
    centre.v2pt_theory(C, N, R)
    disc = RigidBody("disc", centre, R, m, (inertia(L, m / 4 * r**2, m / 2 * r**2, m / 4 * r**2), centre))
    kinematics = [dot(R.ang_vel_in(N) - by_rates, axis) for axis in L]
    method = KanesMethod(N, q_ind=[q1, q2, q3], u_ind=[u1, u2, u3], kd_eqs=kinematics)
    method.kanes_equations([disc], [(centre, -m * g * Y.z)])
    return method


def disc_on_angles():
    """The published mistake: rolling is put into the kinetic energy, and Lagrange's equations are written for the angles alone."""
    psi, lean, phi = dynamicsymbols("heading lean spin")
    r, m, g = sympy.symbols("r m g")
    turn = phi.diff() - psi.diff() * sympy.sin(lean)
    kinetic = m * r**2 / 2 * (sympy.Rational(5, 4) * lean.diff() ** 2 + sympy.Rational(3, 2) * turn**2 + psi.diff() ** 2 * sympy.cos(lean) ** 2 / 4)
    method = LagrangesMethod(kinetic - m * g * r * sympy.cos(lean), [psi, lean, phi])
    method.form_lagranges_equations()
    return method


def test_a_pendulum_is_the_same_and_a_wrong_sign_is_told_with_its_term():
    model = dalembert.Model.from_text(PENDULUM)
    check = model.check(pendulum())
    assert check.verdict == "proved" and check.same and not check.failed
    wrong = dalembert.check(pendulum(-1), model)
    assert wrong.same is False and wrong.verdict == "refuted"
    [equation] = wrong.failed
    [term] = equation.terms
    assert term["of"] is None and term["theirs"][0] == "-g*l*m*sin(theta)" and term["ours"][0] == "g*l*m*sin(theta)"
    assert term["difference"][0] == "-2*g*l*m*sin(theta)"
    assert set(equation.point) >= {"g", "l", "m", "theta''"}
    assert "sin" in wrong._repr_html_() and "-2*g*l*m*sin(theta)" in repr(wrong)
    with pytest.raises(TypeError, match="same"):
        bool(wrong)


def test_a_number_in_the_place_of_a_letter_is_told():
    theta, (m, l) = dynamicsymbols("theta"), sympy.symbols("m l")
    method = LagrangesMethod(m * l**2 * theta.diff() ** 2 / 2 + m * 9.81 * l * sympy.cos(theta), [theta])
    method.form_lagranges_equations()
    check = dalembert.Model.from_text(PENDULUM).check(method)
    assert check.same is False and "no letter of SymPy stands for g of the model" in check.sentence


def test_a_wrong_coefficient_of_an_acceleration_is_told():
    wrong = dalembert.Model.from_text(PENDULUM).check(pendulum(extra=sympy.Symbol("m") * sympy.Symbol("l") ** 2))
    [term] = wrong.equations[0].terms
    assert term["of"] == "theta''" and term["difference"][0] in ("2*l^2*m", "2*m*l^2")


def test_two_links_along_relative_speeds_are_the_same_and_a_wrong_weight_is_told_where_it_acts():
    model = dalembert.Model.from_text(TWO_LINKS)
    check = model.check(two_links(), RELATIVE)
    assert check.verdict == "proved", check
    wrong = model.check(two_links(gravity=-1), {dynamicsymbols("q1"): "theta1", "q2": "theta2 - theta1"})
    [equation] = wrong.failed
    assert equation.name == "equation 1 (u1)"
    [term] = equation.terms
    assert term["of"] is None and term["difference"][0] == "-2*g*l1*m1*sin(theta1)"
    assert len(model.check(two_links(second=2), RELATIVE).failed) == 2


def test_a_rolling_disc_by_kane_is_the_same_though_it_leaves_out_the_contact():
    check = dalembert.Model.from_file(SCENES / "rolling_disc.toml").check(rolling_disc(), DISC)
    assert check.verdict == "proved", check


def test_the_published_rolling_disc_on_angles_alone_is_wrong_in_two_equations():
    check = dalembert.Model.from_file(SCENES / "rolling_disc.toml").check(disc_on_angles())
    assert check.verdict == "refuted" and [one.name for one in check.failed] == ["equation 1 (heading)", "equation 3 (spin)"], check
    assert [term["of"] for one in check.failed for term in one.terms] == [None, None]


def test_multipliers_and_dependent_speeds_are_compared_on_the_constraints():
    x, y, u, v = dynamicsymbols("x y u v")
    m, g, l = sympy.symbols("m g l")
    model = dalembert.Model.from_text(
        """
        gravity = "-g*N.y"
        [parameters]
        m = "kg"
        g = "m/s^2"
        l = "m"
        [coordinates]
        x = "m"
        y = "m"
        [bodies.b]
        centre = "O + x*N.x + y*N.y"
        mass = "m"
        [[constraint]]
        zero = "x^2 + y^2 - l^2"
        [start]
        x = "1 m"
        """
    )
    for sign, verdict in ((1, "proved"), (-1, "refuted")):
        energy = m * (x.diff() ** 2 + y.diff() ** 2) / 2 - sign * m * g * y
        lagrange = LagrangesMethod(energy, [x, y], hol_coneqs=[x**2 + y**2 - l**2])
        lagrange.form_lagranges_equations()
        check = model.check(lagrange)
        assert check.verdict == verdict
        told = [(one.name, term["of"], term["difference"][0]) for one in check.failed for term in one.terms]
        assert told == ([] if sign == 1 else [("equation 2 (y)", None, "-2*g*m")])
        N, O = ReferenceFrame("N"), Point("O")
        O.set_vel(N, 0)
        P = O.locatenew("P", x * N.x + y * N.y)
        P.set_vel(N, u * N.x + v * N.y)
        kane = KanesMethod(
            N,
            q_ind=[x],
            q_dependent=[y],
            configuration_constraints=[x**2 + y**2 - l**2],
            u_ind=[u],
            u_dependent=[v],
            velocity_constraints=[x * u + y * v],
            kd_eqs=[x.diff() - u, y.diff() - v],
        )
        kane.kanes_equations([Particle("b", P, m)], [(P, -sign * m * g * N.y)])
        assert model.check(kane).verdict == verdict


def test_letters_without_a_partner_and_coordinates_that_say_too_little_are_refused():
    model = dalembert.Model.from_text(TWO_LINKS)
    with pytest.raises(dalembert.ModelError, match="called q1, q2; SymPy has .*; the model has theta1, theta2, m1") as raised:
        model.check(two_links())
    assert raised.value.line is None and "`names`" in raised.value.remedy and raised.value.issues[0]["title"] == raised.value.title
    with pytest.raises(dalembert.ModelError, match="do not determine"):
        model.check(two_links(), {"q1": "theta1", "q2": "theta1"})
    with pytest.raises(dalembert.ModelError, match="theta3"):
        model.check(two_links(), {"q1": "theta1", "q2": "theta3"})
    with pytest.raises(dalembert.ModelError, match="hold no zeta"):
        model.check(two_links(), {**RELATIVE, "zeta": "theta1"})
    with pytest.raises(TypeError, match="LagrangesMethod"):
        model.check(3)
    q = dynamicsymbols("theta")
    with pytest.raises(ValueError, match="form"):
        model.check(LagrangesMethod(q.diff() ** 2, [q]))


def test_equations_of_fewer_degrees_of_freedom_are_not_the_same():
    one = dalembert.Model.from_text(TWO_LINKS + '[[constraint]]\nzero = "theta1 - theta2"\n')
    assert one.check(two_links(), RELATIVE).same is False


def test_expressions_go_both_ways():
    equations = dalembert.Model.from_text(PENDULUM).derive("lagrange").sympy_expressions
    m, l = equations.letters["m"], equations.letters["l"]
    assert equations.mass_matrix == sympy.Matrix([[m * l**2]]) and equations.values[l] == 1.0
    q1, q2 = dynamicsymbols("q1 q2")
    a, b = sympy.symbols("a b")
    texts = {
        -(q1.diff() ** 2) * sympy.sin(q1) / a: "-theta'^2*sin(theta)/a",
        sympy.sqrt(b) / (a * b**2): "1/(a*b^(3/2))",
        a - (b - q2.diff().diff()) * 2: "a - 2*b + 2*q2''",
        sympy.Rational(2, 3) * a * sympy.exp(-b): "2*a*exp(-b)/3",
        sympy.tan(q1) + sympy.Abs(a): "tan(theta) + abs(a)",
        0.1 * a: "0.1*a",
    }
    for expression, text in texts.items():
        written = dalembert.from_sympy(expression, {q1: "theta"} if expression.has(q1) else {})
        values = {"theta": 0.3, "theta'": 0.7}
        plain = {q1.diff(): 0.7, q1: 0.3, q2.diff().diff(): 0.9, a: 1.3, b: 0.6}
        scope = {name: getattr(np, name) for name in ("sin", "tan", "exp", "sqrt")} | {"abs": abs}
        code = written.replace("theta'", "0.7").replace("theta", "0.3").replace("q2''", "0.9").replace("^", "**")
        assert np.isclose(eval(code, scope | {"a": 1.3, "b": 0.6}), float(expression.subs(plain))), (written, text, values)
    assert dalembert.from_sympy(q1.diff() ** 2, {"q1": "theta"}) == "theta'^2"
    with pytest.raises(ValueError, match="cannot be written"):
        dalembert.from_sympy(sympy.gamma(a))


def chain(links):
    """A chain of points on massless links by Kane's method, and the same as a model."""
    text = ['gravity = "-g*N.y"', "[parameters]", 'g = "m/s^2"'] + [f'm{k} = "kg"\nl{k} = "m"' for k in range(links)]
    text += ["[coordinates]"] + [f'q{k} = "rad"' for k in range(links)] + ["[points]"]
    text += [f'P{k} = "{f"P{k - 1}" if k else "O"} + l{k}*(sin(q{k})*N.x - cos(q{k})*N.y)"' for k in range(links)]
    text += [f'[bodies.b{k}]\ncentre = "P{k}"\nmass = "m{k}"' for k in range(links)]
    q, u = dynamicsymbols(f"q0:{links}"), dynamicsymbols(f"u0:{links}")
    m, l, g = sympy.symbols(f"m0:{links}"), sympy.symbols(f"l0:{links}"), sympy.Symbol("g")
    N, point = ReferenceFrame("N"), Point("O")
    point.set_vel(N, 0)
    particles, loads = [], []
    for k in range(links):
        frame = N.orientnew(f"A{k}", "Axis", [q[k], N.z])
        frame.set_ang_vel(N, u[k] * N.z)
        end = point.locatenew(f"P{k}", -l[k] * frame.y)
        end.v2pt_theory(point, N, frame)
        particles.append(Particle(f"p{k}", end, m[k]))
        loads.append((end, -m[k] * g * N.y))
        point = end
    method = KanesMethod(N, q, u, kd_eqs=[one.diff() - speed for one, speed in zip(q, u)])
    method.kanes_equations(particles, loads)
    return dalembert.Model.from_text("\n".join(text)), method


def test_a_chain_of_six_links_is_proved():
    model, method = chain(6)
    check = model.check(method)
    assert check.verdict == "proved" and len(check.equations) == 6
    assert all("the same speed" in one.sentence for one in check.equations)


def test_long_equations_are_taken_in_parts(monkeypatch):
    monkeypatch.setattr("dalembert._check._LONG", 5)
    monkeypatch.setattr("dalembert._check._LONGEST_TEXT", 12)
    model = dalembert.Model.from_text(TWO_LINKS)
    assert model.check(two_links(), RELATIVE).verdict == "proved"
    assert len(model.check(two_links(second=2), RELATIVE).failed) == 2


def test_a_check_ends_at_its_time():
    with pytest.raises(ValueError, match="seconds"):
        dalembert.Model.from_text(PENDULUM).check(pendulum(), seconds=-1)


ROLLING_WHEEL = """
[parameters]
m = "kg"
J = "kg m^2"
R = "m"
[coordinates]
x = "m"
phi = "rad"
[bodies.wheel]
turns = "phi"
centre = "O + x*N.x"
mass = "m"
inertia = "J"
[inputs]
F = "N"
[[force]]
on = "wheel"
is = "F*N.x"
[[constraint]]
zero = "x' - R*phi'"
"""


def test_a_speed_whose_angle_is_left_out_has_its_meaning_in_the_names():
    x, v, w = dynamicsymbols("x v w")
    m, J, R, F = sympy.symbols("m J R F")
    N, wheel, centre = ReferenceFrame("N"), ReferenceFrame("W"), Point("C")
    wheel.set_ang_vel(N, w * N.z)
    centre.set_vel(N, v * N.x)
    body = RigidBody("wheel", centre, wheel, m, (inertia(N, 0, 0, J), centre))
    method = KanesMethod(N, q_ind=[x], u_ind=[v], u_dependent=[w], velocity_constraints=[v - R * w], kd_eqs=[x.diff() - v])
    method.kanes_equations([body], [(centre, F * N.x)])
    model = dalembert.Model.from_text(ROLLING_WHEEL)
    assert model.check(method, {w: "phi'"}).verdict == "proved"
    assert model.check(method, {w: "-phi'"}).same is False
    with pytest.raises(dalembert.ModelError, match="determine 1 of 2 speeds"):
        model.check(method)
