#!/usr/bin/env python3
"""Chains of n links: dalembert beside Pinocchio, MuJoCo, Drake, CasADi and SymPy, in one run.

    python3 benches/peers/chains.py

The peers come into target/peers by name (install.py), and so does our own module (`pip install .`, some minutes). What cannot be had is
said. Writes chains.md beside itself and draws book/src/chains.svg (growth.py).

Each link is a rigid body of 1 kg, 0.2 m long, hinged to the one before it: about z alone in a plane, about z and x in turn in space.
All tools are asked for the accelerations of the same states in turn, and agree to 1e-9. Times are microseconds of one call from Python, the smallest of
several rounds, less that of a call on a system of one link or of none, which is a line of its own: it is the way into the tool. SymPy and
CasADi write Lagrange's equations of the same chain and solve for the accelerations, as their manuals show; they are left out where writing
them would take more than half a minute.
"""

import math
import pathlib
import subprocess
import sys
import time

import growth
import install
from chain_text import ACROSS, ALONG, GRAVITY, LENGTH, MASS, axis, text

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
FOLDER = ROOT / "target" / "peers"
PEERS = ["pin", "mujoco", "drake", "casadi", "sympy"]
if __name__ == "__main__" and pathlib.Path(sys.prefix) != FOLDER / "venv":
    python = install.environment(FOLDER, PEERS)[0]
    subprocess.run([python, "-m", "pip", "install", "--quiet", ROOT], check=True)
    sys.exit(subprocess.run([python, __file__]).returncode)

import numpy as np

LINKS = (2, 5, 10, 20, 50, 100, 200)
# seconds that writing equations may take
WRITING = 30
ROUNDS, CALLS = 7, 0.02


def ours(kind, links):
    import dalembert

    begin = time.perf_counter()
    model = dalembert.Model.from_text(text(kind, links))
    rates = model.rhs()
    rates(0.0, np.zeros(2 * links))
    ready = time.perf_counter() - begin
    state = np.zeros(2 * links)

    def ask(q, v):
        state[:links], state[links:] = q, v
        return rates(0.0, state)[links:]

    return ready, lambda q, v: (lambda: rates(0.0, state)) if ask(q, v) is not None else None, ask


def pinocchio(kind, links):
    import pinocchio as pin

    begin = time.perf_counter()
    model, parent = pin.Model(), 0
    model.gravity.linear = np.array([0.0, -GRAVITY, 0.0])
    inertia = pin.Inertia(MASS, np.array([0.0, -LENGTH / 2, 0.0]), np.diag([ACROSS, ALONG, ACROSS]))
    for link in range(links):
        joint = pin.JointModelRZ() if axis(kind, link) == "z" else pin.JointModelRX()
        place = pin.SE3(np.eye(3), np.array([0.0, -LENGTH if link else 0.0, 0.0]))
        parent = model.addJoint(parent, joint, place, f"q{link + 1}")
        model.appendBodyToJoint(parent, inertia, pin.SE3.Identity())
    data, load = model.createData(), np.zeros(links)
    ready = time.perf_counter() - begin
    return ready, lambda q, v: lambda: pin.aba(model, data, q, v, load), lambda q, v: np.array(pin.aba(model, data, q, v, load))


def mujoco(kind, links):
    import mujoco

    begin = time.perf_counter()
    opened = "".join(
        f'<body pos="0 {-LENGTH if link else 0} 0"><joint type="hinge" axis="{"0 0 1" if axis(kind, link) == "z" else "1 0 0"}"/>'
        f'<inertial pos="0 {-LENGTH / 2} 0" mass="{MASS}" diaginertia="{ACROSS} {ALONG} {ACROSS}"/>'
        for link in range(links)
    )
    xml = f'<mujoco><option gravity="0 {-GRAVITY} 0"/><worldbody>{opened}{"</body>" * links}</worldbody></mujoco>'
    model = mujoco.MjModel.from_xml_string(xml)
    data = mujoco.MjData(model)
    ready = time.perf_counter() - begin

    def ask(q, v):
        data.qpos[:], data.qvel[:] = q, v
        mujoco.mj_forward(model, data)
        return data.qacc.copy()

    return ready, lambda q, v: (ask(q, v), lambda: mujoco.mj_forward(model, data))[1], ask


def drake(kind, links):
    from pydrake.math import RigidTransform
    from pydrake.multibody.plant import MultibodyPlant
    from pydrake.multibody.tree import RevoluteJoint, SpatialInertia, UnitInertia

    begin = time.perf_counter()
    plant = MultibodyPlant(0.0)
    plant.mutable_gravity_field().set_gravity_vector([0.0, -GRAVITY, 0.0])
    # about the joint, per unit of mass: Steiner's part is added to the moments about the centre
    about = UnitInertia(ACROSS / MASS + (LENGTH / 2) ** 2, ALONG / MASS, ACROSS / MASS + (LENGTH / 2) ** 2)
    inertia, parent = SpatialInertia(MASS, [0.0, -LENGTH / 2, 0.0], about), plant.world_body()
    for link in range(links):
        body = plant.AddRigidBody(f"b{link}", inertia)
        place = RigidTransform([0.0, -LENGTH if link else 0.0, 0.0])
        about_axis = [0.0, 0.0, 1.0] if axis(kind, link) == "z" else [1.0, 0.0, 0.0]
        plant.AddJoint(RevoluteJoint(f"q{link}", plant.AddFrame(fixed(place, parent)), body.body_frame(), about_axis))
        parent = body
    plant.Finalize()
    context = plant.CreateDefaultContext()
    rates = plant.AllocateTimeDerivatives()
    ready = time.perf_counter() - begin

    def ask(q, v):
        plant.SetPositionsAndVelocities(context, np.concatenate([q, v]))
        plant.CalcTimeDerivatives(context, rates)
        return rates.CopyToVector()[links:]

    def timed(q, v):
        state = np.concatenate([q, v])
        # what is known of a state is kept until another is set
        return lambda: (plant.SetPositionsAndVelocities(context, state), plant.CalcTimeDerivatives(context, rates))

    return ready, timed, ask


def fixed(place, parent):
    from pydrake.multibody.tree import FixedOffsetFrame

    return FixedOffsetFrame(f"at {parent.name()}", parent.body_frame(), place)


def energies(kind, links, q, v, cos, sin):
    """Kinetic and potential energy of the chain, over the numbers of any tool."""
    turn, spin, velocity, height = np.eye(3), np.zeros(3), np.zeros(3), 0
    kinetic = potential = 0
    for link in range(links):
        c, s = cos(q[link]), sin(q[link])
        own = [[c, -s, 0], [s, c, 0], [0, 0, 1]] if axis(kind, link) == "z" else [[1, 0, 0], [0, c, -s], [0, s, c]]
        product = lambda a, b: [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
        into = lambda vector: [sum(own[k][i] * vector[k] for k in range(3)) for i in range(3)]
        turn = product(turn, own)
        # in the axes of the link
        spin, velocity = into(spin), into(velocity)
        spin[2 if axis(kind, link) == "z" else 0] += v[link]
        moved = lambda length: [velocity[0] + spin[2] * length, velocity[1], velocity[2] - spin[0] * length]
        centre = moved(LENGTH / 2)
        kinetic += MASS / 2 * sum(one * one for one in centre)
        kinetic += (ACROSS * spin[0] * spin[0] + ALONG * spin[1] * spin[1] + ACROSS * spin[2] * spin[2]) / 2
        potential += MASS * GRAVITY * (height - LENGTH / 2 * turn[1][1])
        velocity, height = moved(LENGTH), height - LENGTH * turn[1][1]
    return kinetic, potential


def casadi(kind, links):
    import casadi as ca

    begin = time.perf_counter()
    q, v = ca.SX.sym("q", links), ca.SX.sym("v", links)
    kinetic, potential = energies(kind, links, ca.vertsplit(q), ca.vertsplit(v), ca.cos, ca.sin)
    momentum = ca.gradient(kinetic, v)
    right = ca.gradient(kinetic - potential, q) - ca.jtimes(momentum, q, v)
    rates = ca.Function("rates", [q, v], [ca.solve(ca.jacobian(momentum, v), right)])
    ready = time.perf_counter() - begin
    buffer, evaluate = rates.buffer()
    found = np.zeros(links)

    def prepared(q, v):
        held = [np.array(q), np.array(v)]
        buffer.set_arg(0, memoryview(held[0]))
        buffer.set_arg(1, memoryview(held[1]))
        buffer.set_res(0, memoryview(found))
        evaluate()
        return held

    def timed(q, v):
        # what the call reads and writes lives as long as the call
        held = prepared(q, v), buffer
        return lambda: (evaluate(), held)[0]

    return ready, timed, lambda q, v: (prepared(q, v), found.copy())[1]


def sympy(kind, links):
    import sympy as sp
    from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

    begin = time.perf_counter()
    q = dynamicsymbols(f"q:{links}")
    v = [one.diff() for one in q]
    kinetic, potential = energies(kind, links, q, v, sp.cos, sp.sin)
    method = LagrangesMethod(kinetic - potential, q)
    method.form_lagranges_equations()
    letters = sp.symbols(f"a:{links} b:{links}")
    given = dict(zip([*v, *q], [*letters[links:], *letters[:links]]))
    mass, forcing = (method.mass_matrix.subs(given), method.forcing.subs(given))
    terms = sp.lambdify(letters, [mass, forcing], modules="numpy", cse=True)

    def ask(q, v):
        mass, forcing = terms(*q, *v)
        return np.linalg.solve(np.array(mass, float), np.array(forcing, float)[:, 0])

    ready = time.perf_counter() - begin
    return ready, lambda q, v: lambda: ask(q, v), ask


SIDES = {"dalembert": ours, "Pinocchio aba": pinocchio, "MuJoCo mj_forward": mujoco, "Drake": drake, "CasADi": casadi, "SymPy": sympy}


def call_time(call):
    """Seconds of one call: the smallest of some rounds."""
    count, spent = 1, 0.0
    while spent < CALLS:
        count *= 2
        begin = time.perf_counter()
        for _ in range(count):
            call()
        spent = time.perf_counter() - begin
    return spent / count


def compare(kind):
    """Rows by tool: seconds until the first answer and microseconds of a call, by links; and the way into each tool."""
    found, given_up, said = {name: {} for name in SIDES}, {}, set()
    for links in (1, *LINKS):
        rng = np.random.default_rng(links)
        q, v = rng.uniform(-1, 1, links), rng.uniform(-1, 1, links)
        calls, answers = {}, {}
        for name, side in SIDES.items():
            if name in given_up:
                continue
            try:
                ready, timed, ask = side(kind, links)
            except ImportError as error:
                given_up[name] = f"not installed: {error}"
                continue
            answers[name], calls[name] = ask(q, v), timed(q, v)
            found[name][links] = [ready, math.inf]
            # the next chain takes some eight times as long
            if ready * 8 > WRITING:
                given_up[name] = f"longer chains would take more than {WRITING} s to write"
        for name, answer in answers.items():
            off = np.abs(answer - answers["dalembert"]).max() / np.abs(answers["dalembert"]).max()
            if off > 1e-9 and name not in said:
                said.add(name)
                print(f"{kind}, {links} links: {name} is off by {off:.1e}", file=sys.stderr)
        for _ in range(ROUNDS):
            for name, call in calls.items():
                found[name][links][1] = min(found[name][links][1], call_time(call) * 1e6)
    return found, given_up


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(row) + " |" for row in lines)


def page(results):
    head = ["tool", *(str(links) for links in LINKS)]
    parts = ["# Chains of links beside other tools", f"{install.processor()}, Python {sys.version.split()[0]}, by `python3 benches/peers/chains.py`."]
    for kind, (found, given_up) in results.items():
        shown = {name: own for name, own in found.items() if own}
        ways = {name: own[1][1] for name, own in shown.items()}
        times = [[name, *(f"{max(own[n][1] - ways[name], 0):.2f}" if n in own else "-" for n in LINKS)] for name, own in shown.items()]
        ready = [[name, *(f"{own[n][0]:.3f}" if n in own else "-" for n in LINKS)] for name, own in shown.items()]
        parts += [f"## In {'a plane' if kind == 'plane' else 'space'}, hinges {'about z' if kind == 'plane' else 'about z and x in turn'}"]
        parts += ["Microseconds of the accelerations, by links; less the call on one link.", table(head, times)]
        parts += ["Seconds from the text, or the calls that build the chain, to the first answer.", table(head, ready)]
        parts += ["The call on one link, us: " + ", ".join(f"{name} {way:.2f}" for name, way in ways.items()) + "."]
        parts += [f"{name}: {reason}." for name, reason in given_up.items()]
    return "\n\n".join(parts) + "\n"


if __name__ == "__main__":
    (HERE / "chains.md").write_text(page({kind: compare(kind) for kind in ("plane", "space")}))
    growth.draw()
    print((HERE / "chains.md").read_text())
