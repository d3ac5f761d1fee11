#!/usr/bin/env python3
"""Builds and proves the same statements with dalembert, SymPy and FLINT, side by side in one run.

    python3 benches/peers/proofs.py [--systems]

With `--systems` whole systems alone are measured, and the other figures are kept. It needs cargo, Python 3.10 with venv, and the
network once, for pip: SymPy and python-flint go into a virtual environment in a temporary directory that is removed at the end. Prints
a table and writes benches/peers/proofs.json.

What is compared, and how:

* Every repetition builds its expressions afresh and proves them: dalembert in a fresh thread with an empty expression
  graph (benches/proofs.rs, release build), SymPy with its cache cleared. The programs take turns, several rounds; the
  figures are medians of the time of day.
* SymPy is shown at its best. No simplification; fractions cross-multiplied by hand; every statement once with expanded
  expressions and once in SymPy's own polynomial ring, and the faster counts. Lagrange's equations come from
  sympy.physics.mechanics.LagrangesMethod, on the Lagrangian as written and on the expanded one, and the faster counts;
  the proof reads them into the polynomial ring with a walk of our own, faster than SymPy's conversion and far faster
  than expand. The Lagrangian is doubled, so that all coefficients are integers. The angular velocity in Euler's angles
  and its rate are given to SymPy; dalembert finds them by differentiating the rotation matrix.
* FLINT has polynomials alone: it takes part where the statement is one. Lagrange's equations it takes from SymPy.
* Of whole systems (p) ours is `dalembert prove` from its start to its end: seven principles, those along constraints, what each keeps. SymPy
  forms two principles without constraints and compares numbers (principles.py), for a minute at most.
"""

import json
import math
import os
import pathlib
import platform
import statistics
import subprocess
import sys
import tempfile
import time
import venv

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
INSIDE, ONLY_SYSTEMS = "--inside", "--systems"

if __name__ == "__main__" and INSIDE not in sys.argv:
    with tempfile.TemporaryDirectory() as place:
        venv.create(place, with_pip=True)
        python = str(pathlib.Path(place) / ("Scripts" if os.name == "nt" else "bin") / "python")
        subprocess.run([python, "-m", "pip", "install", "--quiet", "sympy", "python-flint"], check=True)
        sys.exit(subprocess.run([python, __file__, INSIDE, *sys.argv[1:]]).returncode)

import flint
import sympy
from flint import Ordering, fmpz_mpoly_ctx
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

from systems import systems


class Expressions:
    """SymPy's expressions, expanded."""

    name = "SymPy expand"

    def symbols(self, names):
        return sympy.symbols(names)

    def vanishes(self, expression):
        return sympy.expand(expression) == 0


class Ring:
    """SymPy's sparse polynomials over the integers."""

    name = "SymPy ring"

    def symbols(self, names):
        return sympy.ring(names, sympy.ZZ)[1:]

    def vanishes(self, polynomial):
        return polynomial == 0

    def terms(self, polynomial):
        return polynomial.terms()

    def collected(self, terms, like):
        return like.ring.from_dict(terms)


class Flint:
    """FLINT's multivariate polynomials over the integers."""

    name = "FLINT"

    def symbols(self, names):
        context = fmpz_mpoly_ctx.get(tuple(names.split()), Ordering.lex)
        return context.gens()

    def vanishes(self, polynomial):
        return polynomial == 0

    def terms(self, polynomial):
        return polynomial.to_dict().items()

    def collected(self, terms, like):
        return like.context().from_dict(terms)


EXPRESSIONS, RING, FLINT = Expressions(), Ring(), Flint()


def determinant(rows):
    """By the first row."""
    if len(rows) == 1:
        return rows[0][0]
    minors = ([row[:j] + row[j + 1 :] for row in rows[1:]] for j in range(len(rows)))
    return sum((-1) ** j * rows[0][j] * determinant(minor) for j, minor in enumerate(minors))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def applied(matrix, vector):
    return [dot(row, vector) for row in matrix]


def symmetric(s):
    return [[s[0], s[1], s[2]], [s[1], s[3], s[4]], [s[2], s[4], s[5]]]


def cramer(matrix, right):
    """Numerators and determinant."""
    replaced = lambda i: [row[:i] + [r] + row[i + 1 :] for row, r in zip(matrix, right)]
    return [determinant(replaced(i)) for i in range(len(matrix))], determinant(matrix)


# a to d and g: polynomials that vanish


def reduced_inertia(algebra):
    names = "A1s A2s A3s l1 l2 l3 Ap"
    *symbols, rotor = algebra.symbols(names)
    a, l = symbols[:3], symbols[3:]
    matrix = [[(a[i] if i == j else 0) - rotor * l[i] * l[j] for j in range(3)] for i in range(3)]
    # A1* A2* A3* D, already multiplied out: polynomials have no fractions.
    d = a[0] * a[1] * a[2] - rotor * (
        l[0] ** 2 * a[1] * a[2] + l[1] ** 2 * a[0] * a[2] + l[2] ** 2 * a[0] * a[1]
    )
    return [determinant(matrix) - d]


class Forms:
    def __init__(self, algebra):
        names = (
            "A11 A12 A13 A22 A23 A33 l1 l2 l3 omega1 omega2 omega3 domega1 domega2 domega3 "
            "e1 e2 e3 nu1 nu2 nu3 Ap dphi ddg Gamma M"
        )
        s = list(algebra.symbols(names))
        self.inertia = symmetric(s[:6])
        self.axis, self.speed, self.rate = s[6:9], s[9:12], s[12:15]
        self.rotor, self.rotor_speed, self.relative, gamma, self.moment = s[21:]
        self.weight = [gamma * x for x in cross(s[15:18], s[18:21])]
        self.whole = [
            [self.inertia[i][j] + self.rotor * self.axis[i] * self.axis[j] for j in range(3)] for i in range(3)
        ]

    def first_right(self):
        spin = self.rotor * (dot(self.speed, self.axis) + self.rotor_speed)
        momentum = [dot(row, self.speed) + l * spin for row, l in zip(self.inertia, self.axis)]
        return [x + w - l * self.moment for x, w, l in zip(cross(momentum, self.speed), self.weight, self.axis)]

    def second_right(self):
        spin = self.rotor * self.rotor_speed
        momentum = [dot(row, self.speed) + l * spin for row, l in zip(self.whole, self.axis)]
        return [x + w for x, w in zip(cross(momentum, self.speed), self.weight)]


def forms_agree(algebra):
    body = Forms(algebra)
    first = [dot(row, body.rate) - r for row, r in zip(body.inertia, body.first_right())]
    second = [
        dot(row, body.rate) + l * body.rotor * body.relative - r
        for row, l, r in zip(body.whole, body.axis, body.second_right())
    ]
    rotor = body.rotor * (dot(body.axis, body.rate) + body.relative) - body.moment
    return [b - a - l * rotor for a, b, l in zip(first, second, body.axis)]


def explicit_forms_agree(algebra):
    body = Forms(algebra)
    column = [body.rotor * l for l in body.axis]
    matrix = [row + [c] for row, c in zip(body.whole, column)] + [column + [body.rotor]]
    first, first_determinant = cramer(body.inertia, body.first_right())
    second, second_determinant = cramer(matrix, body.second_right() + [body.moment])
    return [a * second_determinant - b * first_determinant for a, b in zip(first, second)]


def product_of_determinants(algebra):
    names = " ".join(f"{m}{i}{j}" for m in "ab" for i in range(1, 5) for j in range(1, 5))
    s = list(algebra.symbols(names))
    a, b = ([s[k + 4 * i : k + 4 * i + 4] for i in range(4)] for k in (0, 16))
    product = [[dot(row, [b[k][j] for k in range(4)]) for j in range(4)] for row in a]
    return [determinant(product) - determinant(a) * determinant(b)]


def dense_squares(algebra):
    x, y, z, t = algebra.symbols("x y z t")
    power = (1 + x + y + z + t) ** 14
    return [(power + 1) * (power - 1) - (power * power - 1)]


# e and f: the gyrostat in Euler's angles


class Gyrostat:
    """The bodies' data or, with `whole`, the tensor of all masses and the weight as data of their own."""

    names = "A11 A12 A13 A22 A23 A33 c1 c2 c3 l1 l2 l3 Ap M m0 mr h1 h2 h3 Bp g"

    def __init__(self, symbols, whole):
        s = list(symbols)
        self.whole, self.inertia, self.centre, self.axis = whole, symmetric(s[:6]), s[6:9], s[9:12]
        self.axial, self.moment, self.mass0, self.mass, *self.place, self.transverse, self.gravity = s[12:]

    def weight(self):
        if self.whole:
            return self.centre
        return [self.gravity * (self.mass0 * c + self.mass * h) for c, h in zip(self.centre, self.place)]

    def tensor(self):
        if self.whole:
            return self.inertia
        steiner = self.mass * dot(self.place, self.place) + self.transverse
        across = self.axial - self.transverse
        return [
            [
                self.inertia[i][j]
                + (steiner if i == j else 0)
                - self.mass * self.place[i] * self.place[j]
                + across * self.axis[i] * self.axis[j]
                for j in range(3)
            ]
            for i in range(3)
        ]

    def twice_lagrangian(self, w, rotor_speed, vertical):
        own = dot(w, applied(self.inertia, w))
        if self.whole:
            energy = own + 2 * self.axial * rotor_speed * dot(w, self.axis) + self.axial * rotor_speed**2
        else:
            centre_velocity = cross(w, self.place)
            spin = [x + rotor_speed * l for x, l in zip(w, self.axis)]
            along = dot(spin, self.axis)
            across = [x - along * l for x, l in zip(spin, self.axis)]
            energy = own + self.mass * dot(centre_velocity, centre_velocity)
            energy += self.axial * along**2 + self.transverse * dot(across, across)
        return energy + 2 * dot(vertical, self.weight())

    def second_form(self, w, rate, vertical, rotor_speed, rotor_rate):
        tensor = self.tensor()
        momentum = [x + self.axial * rotor_speed * l for x, l in zip(applied(tensor, w), self.axis)]
        gain = [x + y for x, y in zip(cross(momentum, w), cross(self.weight(), vertical))]
        left = [x + self.axial * rotor_rate * l for x, l in zip(applied(tensor, rate), self.axis)]
        rotor = self.axial * (dot(self.axis, rate) + rotor_rate) - self.moment
        return [x - y for x, y in zip(left, gain)] + [rotor]


def lagrange(whole, expanded):
    """Twice Lagrange's equations, and the angles."""
    body = Gyrostat(sympy.symbols(Gyrostat.names), whole)
    angles = dynamicsymbols("psi theta phi rho")
    psi, theta, phi, rotor_speed = dynamicsymbols("psi theta phi rho", 1)
    (S, C), (s, c) = ((sympy.sin(x), sympy.cos(x)) for x in angles[1:3])
    w = [psi * S * s + theta * c, psi * S * c - theta * s, psi * C + phi]
    lagrangian = body.twice_lagrangian(w, rotor_speed, [S * s, S * c, C])
    equations = LagrangesMethod(sympy.expand(lagrangian) if expanded else lagrangian, angles).form_lagranges_equations()
    equations = list(equations)
    equations[3] -= 2 * body.moment
    return equations, angles


def read(expression, known):
    """An expression without fractions in another algebra; what was met before is not computed again."""
    value = known.get(expression)
    if value is not None:
        return value
    if expression.is_Integer:
        return int(expression)
    if expression.is_Add or expression.is_Mul:
        first, *rest = (read(each, known) for each in expression.args)
        for each in rest:
            first = first + each if expression.is_Add else first * each
        value = first
    else:
        value = read(expression.base, known) ** int(expression.exp)
    known[expression] = value
    return value


def reduced(algebra, polynomial, rules):
    """Squares of generators replaced."""
    for generator, square in rules:
        while True:
            parts = {}
            for exponents, coefficient in algebra.terms(polynomial):
                times, rest = divmod(exponents[generator], 2)
                key = exponents[:generator] + (rest,) + exponents[generator + 1 :]
                parts.setdefault(times, {})[key] = coefficient
            if max(parts, default=0) == 0:
                break
            polynomial = sum(algebra.collected(part, square) * square**times for times, part in parts.items())
    return polynomial


def second_form_reached(algebra, equations, angles, whole):
    """Whether they are W^T times the second form, modulo sin^2 = 1 - cos^2 and |l| = 1."""
    time_ = dynamicsymbols._t
    rates = [x.diff(time_) for x in angles]
    leaves = [f(x) for x in angles[1:3] for f in (sympy.sin, sympy.cos)] + rates + [x.diff(time_) for x in rates]
    names = "S C s c psi theta phi rho dpsi dtheta dphi drho " + Gyrostat.names
    generators = algebra.symbols(names)
    known = dict(zip(leaves + list(sympy.symbols(Gyrostat.names)), generators))
    derived = [read(each, known) for each in equations]
    S, C, s, c, psi, theta, phi, rho, dpsi, dtheta, dphi, drho, *data = generators
    body = Gyrostat(data, whole)
    w = [psi * S * s + theta * c, psi * S * c - theta * s, psi * C + phi]
    rate = [
        dpsi * S * s + psi * (theta * C * s + phi * S * c) + dtheta * c - theta * phi * s,
        dpsi * S * c + psi * (theta * C * c - phi * S * s) - dtheta * s - theta * phi * c,
        dpsi * C - psi * theta * S + dphi,
    ]
    x, y, z, rotor = body.second_form(w, rate, [S * s, S * c, C], rho, drho)
    wanted = [x * S * s + y * S * c + z * C, x * c - y * s, z, rotor]
    l = body.axis
    rules = [(0, 1 - C**2), (2, 1 - c**2)]
    if not whole:
        rules.append((names.split().index("l3"), 1 - l[0] ** 2 - l[1] ** 2))
    gaps = (reduced(algebra, a - 2 * b, rules) for a, b in zip(derived, wanted))
    return all(algebra.vanishes(gap) for gap in gaps)


# the clock


def fresh():
    sympy.core.cache.clear_cache()


def timed(run):
    fresh()
    start = time.perf_counter()
    result = run()
    return time.perf_counter() - start, result


def proof_of(statement, algebra):
    """A program that times one proof."""

    def once():
        seconds, proved = timed(lambda: all(algebra.vanishes(part) for part in statement(algebra)))
        assert proved, "a true statement was not proved"
        return [seconds]

    return once


def derivation_of(whole, expanded):
    """A program that times the derivation, and the proof in SymPy's ring and in FLINT's."""

    def once():
        deriving, (equations, angles) = timed(lambda: lagrange(whole, expanded))
        seconds = [deriving]
        for algebra in (RING, FLINT):
            proving, proved = timed(lambda: second_form_reached(algebra, equations, angles, whole))
            assert proved, "a true statement was not proved"
            seconds.append(proving)
        return seconds

    return once


class Ours:
    """The bench of the workbench, which answers one letter after the other."""

    def __init__(self):
        command = ["cargo", "bench", "--quiet", "--bench", "proofs", "--", "--answer"]
        self.process = subprocess.Popen(command, cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def once(self, letter):
        self.process.stdin.write(letter + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())


POLYNOMIALS = {
    "a": ("det A~ = A1* A2* A3* D", reduced_inertia, 7),
    "b": ("both forms agree: full tensors, everything free", forms_agree, 5),
    "c": ("w' of both forms, rational functions", explicit_forms_agree, 1),
    "d": ("det AB = det A det B, 4 x 4", product_of_determinants, 1),
}
DERIVED = {
    "e": ("from the bodies' data", False),
    "f": ("with A*, l, Ge free", True),
}
DENSE = ("g", "(F + 1)(F - 1) = F^2 - 1, F = (1 + x + y + z + t)^14", dense_squares)
NO_DERIVATION = "polynomials only: no functions of time, no derivatives"
ROUNDS = 5
OURS_A_ROUND = 9
SLOW = 1.0


def measured(ours, letter, programs, repeats=1):
    """Medians over rounds in which all take turns. What takes longer than SLOW has fewer rounds."""
    times = {name: [] for name in ["dalembert", *programs]}
    for _ in range(ROUNDS):
        times["dalembert"] += [ours.once(letter) for _ in range(OURS_A_ROUND)]
        for name, program in programs.items():
            if len(times[name]) < 3 or sum(times[name][0]) < SLOW:
                times[name] += [program() for _ in range(repeats)]
    return {name: [statistics.median(part) for part in zip(*runs)] for name, runs in times.items()}


def rows(ours):
    """Task, our seconds, SymPy's by program, FLINT's or why it has none."""
    for letter, (says, statement, repeats) in POLYNOMIALS.items():
        algebras = [EXPRESSIONS, RING, FLINT]
        found = measured(ours, letter, {each.name: proof_of(statement, each) for each in algebras}, repeats)
        yield f"{letter}: {says}", found["dalembert"][0], {a.name: found[a.name][0] for a in algebras[:2]}, found["FLINT"][0]
    for letter, (says, whole) in DERIVED.items():
        programs = {"as written": derivation_of(whole, False), "expanded first": derivation_of(whole, True)}
        found = measured(ours, letter, programs)
        theirs = lambda part: {f"SymPy {name}": found[name][part] for name in programs}
        yield f"{letter}1: Lagrange's equations in Euler's angles {says}", found["dalembert"][0], theirs(0), NO_DERIVATION
        best = min(found[name][2] for name in programs)
        yield f"{letter}2: they are W^T times the second form", found["dalembert"][1], theirs(1), best
    letter, says, statement = DENSE
    found = measured(ours, letter, {each.name: proof_of(statement, each) for each in (RING, FLINT)})
    yield f"{letter}: {says}", found["dalembert"][0], {RING.name: found[RING.name][0]}, found["FLINT"][0]


def shown(seconds):
    return f"{1e3 * seconds:.{max(0, 2 - math.floor(math.log10(1e3 * seconds)))}f}"


def main():
    versions = {
        "python": platform.python_version(),
        "sympy": sympy.__version__,
        "python-flint": flint.__version__,
        "flint": flint.__FLINT_VERSION__,
        "rustc": subprocess.run(["rustc", "--version"], capture_output=True, text=True).stdout.split()[1],
    }
    print(", ".join(f"{name} {version}" for name, version in versions.items()))
    print("\n| milliseconds | dalembert | SymPy, its best | | FLINT | |\n|---|---|---|---|---|---|", flush=True)
    stored = ROOT / "benches" / "peers" / "proofs.json"
    tasks = []
    if ONLY_SYSTEMS in sys.argv:
        tasks = [task for task in json.loads(stored.read_text())["tasks"] if not task["task"].startswith("p: ")]
    for task, seconds, sympys, flints in [] if tasks else rows(Ours()):
        how, best = min(sympys.items(), key=lambda item: item[1])
        beside = [f"{shown(best)} ({how})", f"{best / seconds:.0f}x"]
        numeric = not isinstance(flints, str)
        beside += [shown(flints), f"{flints / seconds:.1f}x"] if numeric else ["none", ""]
        print(f"| {task} | {shown(seconds)} | " + " | ".join(beside) + " |", flush=True)
        tasks.append({"task": task, "dalembert": seconds, "sympy": best, "sympy_by": sympys, "flint": flints})
    for task, seconds, theirs in systems(ROUNDS):
        beside = [theirs, ""] if isinstance(theirs, str) else [shown(theirs), f"{theirs / seconds:.0f}x"]
        print(f"| {task} | {shown(seconds)} | " + " | ".join(beside) + " | none | |", flush=True)
        tasks.append({"task": task, "dalembert": seconds, "sympy": theirs, "flint": NO_DERIVATION})
    report = {"unit": "seconds, medians", "versions": versions, "tasks": tasks}
    stored.write_text(json.dumps(report, indent=2) + "\n")


if __name__ == "__main__":
    main()
