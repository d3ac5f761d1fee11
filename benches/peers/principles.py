"""Systems of many bodies by two principles in SymPy: Lagrange's equations and Kane's, shown to be equal by numbers.

    python3 benches/peers/principles.py SYSTEM

answers by the seconds until both are formed and agree at three random points. Nothing is simplified, and constraints are left out: that is
less than `dalembert prove` judges, which compares seven principles, those along constraints among them, and proves what each keeps.
"""

import random
import sys
import time

import sympy
from sympy.physics.mechanics import (
    KanesMethod,
    Lagrangian,
    LagrangesMethod,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

from chain_text import ACROSS, ALONG, GRAVITY, LENGTH, MASS, axis

POINTS = 3


class System:
    """Bodies over a frame at rest, each with its weight."""

    def __init__(self, names, down, gravity):
        self.q = list(dynamicsymbols(names))
        self.u = list(dynamicsymbols(" ".join(f"u_{name}" for name in names.split())))
        self.ground, self.origin = ReferenceFrame("N"), Point("O")
        self.origin.set_vel(self.ground, 0)
        self.bodies, self.loads, self.points = [], [], 0
        self.down = getattr(self.ground, down) * gravity

    def turned(self, frame, angle, about):
        return frame.orientnew(f"F{angle}", "Axis", [angle, getattr(frame, about)])

    def point(self, base, way):
        self.points += 1
        found = base.locatenew(f"P{self.points}", way)
        found.set_vel(self.ground, base.vel(self.ground) + way.dt(self.ground))
        return found

    def body(self, frame, centre, mass, principal, xz=0):
        tensor = inertia(frame, *principal, 0, 0, xz)
        self.bodies.append(RigidBody(f"B{len(self.bodies)}", centre, frame, mass, (tensor, centre)))
        self.bodies[-1].potential_energy = -mass * self.down.dot(centre.pos_from(self.origin))
        self.loads.append((centre, mass * self.down))

    def lagrange(self):
        method = LagrangesMethod(Lagrangian(self.ground, *self.bodies), self.q)
        return list(method.form_lagranges_equations())

    def kane(self):
        rates = [u - q.diff() for q, u in zip(self.q, self.u)]
        speeds = dict(zip(self.u, [q.diff() for q in self.q]))
        method = KanesMethod(self.ground, self.q, self.u, kd_eqs=rates)
        applied, inertial = method.kanes_equations(self.bodies, self.loads)
        return [-(a + b).subs(speeds).doit() for a, b in zip(applied, inertial)]

    def agree(self):
        """Whether both sides have equal values where all letters are random."""
        one, other = self.lagrange(), self.kane()
        rates = [q.diff() for q in self.q]
        letters = sympy.symbols(f"a:{3 * len(self.q)}")
        given = dict(zip([rate.diff() for rate in rates] + rates + self.q, letters))
        value = sympy.lambdify(letters, [side.xreplace(given) for side in (*one, *other)], "math", cse=True)
        drawn = random.Random(1)
        for _ in range(POINTS):
            found = value(*(drawn.uniform(-1, 1) for _ in letters))
            sides = list(zip(found[: len(one)], found[len(one) :]))
            if any(abs(a - b) > 1e-9 * (1 + abs(a)) for a, b in sides):
                return False
        return True


def chain(links):
    system = System(" ".join(f"q{k}" for k in range(links)), "y", -GRAVITY)
    frame, joint = system.ground, system.origin
    for link, angle in enumerate(system.q):
        frame = system.turned(frame, angle, axis("space", link))
        system.body(frame, system.point(joint, -LENGTH / 2 * frame.y), MASS, (ACROSS, ALONG, ACROSS))
        joint = system.point(joint, -LENGTH * frame.y)
    return system


def bicycle():
    """The four bodies of scenes/foreign/bicycle.toml."""
    system = System("x y yaw lean pitch steer rear front", "z", GRAVITY)
    x, y, yaw, lean, pitch, steer, rear, front = system.q
    w, c, tilt, r_rear, r_front = 1.02, 0.08, sympy.pi / 10, 0.3, 0.35
    heading = system.turned(system.ground, yaw, "z")
    leaning = system.turned(heading, lean, "x")
    wheel = system.turned(leaning, rear, "y")
    rider = system.turned(leaning, pitch, "y")
    head = rider.orientnew("S", "Axis", [tilt, rider.y])
    steered = system.turned(head, steer, "z")
    fork = steered.orientnew("H", "Axis", [-tilt, steered.y])
    front_wheel = system.turned(fork, front, "y")
    hub = system.point(system.origin, x * system.ground.x + y * system.ground.y - r_rear * leaning.z)
    steering = system.point(hub, (w + c) * rider.x + r_rear * rider.z)
    front_hub = system.point(steering, -c * fork.x - r_front * fork.z)
    system.body(wheel, hub, 2.0, (0.0603, 0.12, 0.0603))
    system.body(rider, system.point(hub, 0.3 * rider.x + (r_rear - 0.9) * rider.z), 85.0, (9.2, 11.0, 2.8), 2.4)
    system.body(fork, system.point(steering, (0.9 - w - c) * fork.x - 0.7 * fork.z), 4.0, (0.05892, 0.06, 0.00708), -0.00756)
    system.body(front_wheel, front_hub, 3.0, (0.1405, 0.28, 0.1405))
    return system


def andrews():
    """The seven bodies of scenes/foreign/andrews_mechanism.toml, without its spring."""
    system = System("beta Theta gamma Phi delta Omega epsilon", "y", 0)
    beta, theta, gamma, phi, delta, omega, epsilon = system.q
    ground, turned = system.ground, system.turned
    k1 = turned(ground, beta, "z")
    k2, k3, k5, k7 = turned(k1, theta, "z"), turned(ground, gamma, "z"), turned(ground, delta, "z"), turned(ground, epsilon, "z")
    k4, k6 = turned(k5, phi, "z"), turned(k7, omega, "z")
    a = system.point(system.origin, -0.06934 * ground.x - 0.00227 * ground.y)
    b = system.point(system.origin, -0.03635 * ground.x + 0.03273 * ground.y)
    places = [
        (k1, system.origin, 0.00092 * k1.x, 0.04325, 2.194e-6),
        (k2, system.origin, 0.007 * k1.x - 0.0115 * k2.x, 0.00365, 4.410e-7),
        (k3, b, 0.01043 * k3.x - 0.01874 * k3.y, 0.02373, 5.255e-6),
        (k4, a, 0.04 * k5.x - (0.02 - 0.01421) * k4.y, 0.00706, 5.667e-7),
        (k5, a, 0.02308 * k5.x + 0.00916 * k5.y, 0.07050, 1.169e-5),
        (k6, a, -0.04 * k7.y + (0.02 - 0.01421) * k6.x, 0.00706, 5.667e-7),
        (k7, a, -0.00449 * k7.x - 0.01228 * k7.y, 0.05498, 1.912e-5),
    ]
    for frame, base, way, mass, moment in places:
        system.body(frame, system.point(base, way), mass, (moment, moment, moment))
    return system


SYSTEMS = {"bicycle": bicycle, "andrews_mechanism": andrews} | {f"chain {links}": lambda links=links: chain(links) for links in (5, 20, 50)}

if __name__ == "__main__":
    begin = time.perf_counter()
    if not SYSTEMS[sys.argv[1]]().agree():
        sys.exit("both principles differ")
    print(time.perf_counter() - begin)
