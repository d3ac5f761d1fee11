"""Whipple's bicycle by Kane's method of SymPy beside the same bicycle as text: equations of 264,000 operations."""

import pytest

import dalembert

sympy = pytest.importorskip("sympy")
from sympy.physics.mechanics import KanesMethod, Point, ReferenceFrame, RigidBody, dynamicsymbols, inertia  # noqa: E402

# z up; f and b are the wheels in front and behind, w their radii, tilt the angle of the steering axis
BICYCLE = """
gravity = "-g*N.z"
coordinates = { x = "m", y = "m", yaw = "rad", lean = "rad", pitch = "rad", steer = "rad", behind = "rad", front = "rad" }
[parameters]
g = "m/s^2"
tilt = "rad"
w_f = "m"
w_b = "m"
offset = "m"
fork = "m"
frame = "m"
fork_x = "m"
fork_z = "m"
frame_x = "m"
frame_z = "m"
m_b = "kg"
m_f = "kg"
m_frame = "kg"
m_fork = "kg"
B1 = "kg m^2"
B2 = "kg m^2"
F1 = "kg m^2"
F2 = "kg m^2"
R1 = "kg m^2"
R2 = "kg m^2"
R3 = "kg m^2"
R31 = "kg m^2"
K1 = "kg m^2"
K2 = "kg m^2"
K3 = "kg m^2"
K31 = "kg m^2"
[frames]
Y = "N turned yaw about z"
L = "Y turned lean about x"
R = "L turned pitch + tilt about y"
R0 = "R turned -tilt about y"
B = "R turned behind about y"
K = "R turned steer about x"
K0 = "K turned -tilt about y"
F = "K turned front about y"
[points]
P = "O + x*N.x + y*N.y"
C_b = "P + w_b*L.z"
S = "C_b + frame*R.z"
C_f = "S + fork*K.x + offset*K.z"
Q = "C_f + w_f*unit((K.y . Y.z)*K.y - Y.z)"
[bodies]
wheel_b = { frame = "B", centre = "C_b", mass = "m_b", inertia = { axes = "R", principal = ["B1", "B2", "B1"] } }
wheel_f = { frame = "F", centre = "C_f", mass = "m_f", inertia = { axes = "K", principal = ["F1", "F2", "F1"] } }
rider = { frame = "R", centre = "C_b - frame_x*R.x + frame_z*R.z", mass = "m_frame", inertia = { axes = "R0", xx = "R1", yy = "R2", zz = "R3", xz = "R31" } }
handle = { frame = "K", centre = "S - fork_x*K.x + fork_z*K.z", mass = "m_fork", inertia = { axes = "K0", xx = "K1", yy = "K2", zz = "K3", xz = "K31" } }
[[constraint]]
name = "front contact"
zero = "(Q - O) . N.z"
[[constraint]]
name = "rolling"
zero = ["velocity(wheel_b at P) . N.x", "velocity(wheel_b at P) . N.y", "velocity(wheel_f at Q) . N.x", "velocity(wheel_f at Q) . N.y"]
"""


def bicycle():
    yaw, lean, pitch, steer = dynamicsymbols("yaw lean pitch steer")
    u1, u2, u3, u4, u5, u6 = dynamicsymbols("u1 u2 u3 u4 u5 u6")
    letters = {name: sympy.Symbol(name) for name in dalembert.Model.from_text(BICYCLE).parameters}
    g, tilt, w_f, w_b = (letters[name] for name in ("g", "tilt", "w_f", "w_b"))
    N, B, F = ReferenceFrame("N"), ReferenceFrame("B"), ReferenceFrame("F")
    Y = N.orientnew("Y", "Axis", [yaw, N.z])
    L = Y.orientnew("L", "Axis", [lean, Y.x])
    R = L.orientnew("R", "Axis", [pitch + tilt, L.y])
    K = R.orientnew("K", "Axis", [steer, R.x])
    R0, K0 = R.orientnew("R0", "Axis", [-tilt, R.y]), K.orientnew("K0", "Axis", [-tilt, K.y])
    for frame, parent, speed, axis in [(Y, N, u1, Y.z), (L, Y, u2, L.x), (B, R, u3, R.y), (R, L, u4, R.y), (K, R, u5, K.x), (F, K, u6, K.y)]:
        frame.set_ang_vel(parent, speed * axis)
    P = Point("P")
    C_b = P.locatenew("C_b", w_b * L.z)
    S = C_b.locatenew("S", letters["frame"] * R.z)
    C_r = C_b.locatenew("C_r", -letters["frame_x"] * R.x + letters["frame_z"] * R.z)
    C_k = S.locatenew("C_k", -letters["fork_x"] * K.x + letters["fork_z"] * K.z)
    C_f = S.locatenew("C_f", letters["fork"] * K.x + letters["offset"] * K.z)
    Q = C_f.locatenew("Q", w_f * (K.y.dot(Y.z) * K.y - Y.z).normalize())
    P.set_vel(N, 0)
    for point, known, frame in [(C_b, P, B), (S, C_b, R), (C_r, C_b, R), (C_k, S, K), (C_f, S, K), (Q, C_f, F)]:
        point.v2pt_theory(known, N, frame)
    moments = [
        (C_b, B, "m_b", inertia(R, *(letters[name] for name in ("B1", "B2", "B1")))),
        (C_f, F, "m_f", inertia(K, *(letters[name] for name in ("F1", "F2", "F1")))),
        (C_r, R, "m_frame", inertia(R0, *(letters[name] for name in ("R1", "R2", "R3")), 0, 0, letters["R31"])),
        (C_k, K, "m_fork", inertia(K0, *(letters[name] for name in ("K1", "K2", "K3")), 0, 0, letters["K31"])),
    ]
    bodies = [RigidBody(mass, centre, frame, letters[mass], (tensor, centre)) for centre, frame, mass, tensor in moments]
    method = KanesMethod(
        N,
        q_ind=[yaw, lean, steer],
        q_dependent=[pitch],
        configuration_constraints=[Q.pos_from(P).dot(Y.z)],
        u_ind=[u2, u3, u5],
        u_dependent=[u1, u4, u6],
        velocity_constraints=[Q.vel(N).dot(axis) for axis in (Y.x, Y.y, Y.z)],
        kd_eqs=[rate.diff() - speed for rate, speed in [(yaw, u1), (lean, u2), (pitch, u4), (steer, u5)]],
        constraint_solver="CRAMER",
    )
    method.kanes_equations(bodies, [(body.masscenter, -body.mass * g * Y.z) for body in bodies])
    return method, {u3: "behind'", u6: "front'"}


def test_a_bicycle_by_kane_is_the_same():
    method, names = bicycle()
    found = dalembert.Model.from_text(BICYCLE).check(method, names)
    assert found.same is True and found.verdict == "identified", found
    # the equations of motion are equal at random points of prime fields, the constraints at the latest
    assert [one.verdict for one in found.equations[4:]] == ["identified"] * 6, found
    assert {one.verdict for one in found.equations[:4]} <= {"proved", "identified"}, found
    # divisors of thousands of characters stay in `requires`
    assert len(repr(found)) < 5000
