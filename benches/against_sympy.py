#!/usr/bin/env python3
"""Builds and decides the same statements with dalembert, SymPy and python-flint, side by side in one run.

    python3 -m venv /tmp/oracle && /tmp/oracle/bin/pip install sympy python-flint
    /tmp/oracle/bin/python benches/against_sympy.py

Every time is the median of several runs that build the statement and decide it. SymPy gets what serves it best:
its own polynomial ring where the statement is polynomial, no simplification, fractions cross-multiplied by hand.
"""

import json
import pathlib
import statistics
import subprocess
import sys
import time

import sympy
from flint import fmpz_mpoly_ctx, Ordering

ROOT = pathlib.Path(__file__).resolve().parent.parent


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


class Flint:
    """FLINT's multivariate polynomials over the integers."""

    name = "python-flint"

    def symbols(self, names):
        context = fmpz_mpoly_ctx.get(tuple(names.split()), Ordering.lex)
        return context.gens()

    def vanishes(self, polynomial):
        return polynomial == 0


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


def cramer(matrix, right):
    """Numerators and determinant."""
    replaced = lambda i: [row[:i] + [r] + row[i + 1 :] for row, r in zip(matrix, right)]
    return [determinant(replaced(i)) for i in range(len(matrix))], determinant(matrix)


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


class Gyrostat:
    def __init__(self, algebra):
        names = (
            "A11 A12 A13 A22 A23 A33 l1 l2 l3 omega1 omega2 omega3 domega1 domega2 domega3 "
            "e1 e2 e3 nu1 nu2 nu3 Ap dphi ddg Gamma M"
        )
        s = list(algebra.symbols(names))
        self.inertia = [[s[0], s[1], s[2]], [s[1], s[3], s[4]], [s[2], s[4], s[5]]]
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
    body = Gyrostat(algebra)
    first = [dot(row, body.rate) - r for row, r in zip(body.inertia, body.first_right())]
    second = [
        dot(row, body.rate) + l * body.rotor * body.relative - r
        for row, l, r in zip(body.whole, body.axis, body.second_right())
    ]
    rotor = body.rotor * (dot(body.axis, body.rate) + body.relative) - body.moment
    return [b - a - l * rotor for a, b, l in zip(first, second, body.axis)]


def explicit_forms_agree(algebra):
    body = Gyrostat(algebra)
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


STATEMENTS = {
    "a: determinant of the reduced inertia": (reduced_inertia, 21),
    "b: both forms agree": (forms_agree, 11),
    "c: both explicit forms agree": (explicit_forms_agree, 3),
    "d: det(AB) = det A det B, 4 x 4": (product_of_determinants, 3),
}


def median(statement, algebra, runs):
    times = []
    for _ in range(runs):
        sympy.core.cache.clear_cache()
        start = time.perf_counter()
        proved = all(algebra.vanishes(part) for part in statement(algebra))
        times.append(time.perf_counter() - start)
        assert proved, "a true statement was not proved"
    return statistics.median(times)


def main():
    command = ["cargo", "run", "--release", "--quiet", "-p", "dalembert-symbolic", "--example", "timings"]
    ours = json.loads(subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout)
    algebras = [Expressions(), Ring(), Flint()]
    header = ["milliseconds", "dalembert"] + [algebra.name for algebra in algebras]
    print("| " + " | ".join(header) + " |\n" + "|---" * len(header) + "|")
    for name, (statement, runs) in STATEMENTS.items():
        theirs = [median(statement, algebra, runs) for algebra in algebras]
        cells = [f"{1e3 * ours[name]:.3f}"]
        cells += [f"{1e3 * t:.2f} ({t / ours[name]:.0f}x)" for t in theirs]
        print(f"| {name} | " + " | ".join(cells) + " |")
        sys.stdout.flush()


if __name__ == "__main__":
    main()
