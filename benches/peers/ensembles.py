#!/usr/bin/env python3
"""Ensembles of gyrostats: dalembert beside heyoka's batch integrator, JAX and a vectorised C loop, in one run.

    python3 benches/peers/ensembles.py

needs cargo and gcc; numpy, heyoka and jax come into target/peers (install.py), and what is missing is said. Prints a table,
and writes it beside itself as ensembles.md. The sides take turns, three rounds; figures are medians, on one thread. All take the members of
benches/ensembles.rs: a percent of spread in every datum and in every start. The peers' equations are the second form
written out by hand; that all agree is checked on the end of the first member.

Taylor's methods are compared at the error that they reach, not at the tolerance that they are asked for: the largest of any
member in any component at the end, against a run of the same side to 1e-15. Rates are interpolated between the two runs
around an error, logarithmically.
"""

import ctypes
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import install

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FOLDER = ROOT / "target" / "peers"
if __name__ == "__main__" and pathlib.Path(sys.prefix) != FOLDER / "venv":
    sys.exit(subprocess.run([install.environment(FOLDER)[0], __file__]).returncode)

import numpy as np

SPAN, ROUNDS, LANES = 2.0, 3, 8
TOLERANCES, ERRORS = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14], [1e-6, 1e-9, 1e-12]


def data():
    """Parameters of the second form, and the start in its axes."""
    m, c = 1.5, np.array([0.01, -0.02, 0.05])
    a0 = np.array([[0.02, 0.001, -0.002], [0.001, 0.03, 0.0005], [-0.002, 0.0005, 0.025]])
    mr, h, l, axial, across = 0.4, np.array([0, 0.03, 0.04]), np.array([0, 0.6, 0.8]), 3e-4, 2e-4
    full = a0 + across * np.eye(3) + (axial - across) * np.outer(l, l) + mr * (h @ h * np.eye(3) - np.outer(h, h))
    moments, axes = np.linalg.eigh(full)
    for i in range(2):
        axes[:, i] *= np.sign(axes[np.argmax(abs(axes[:, i])), i])
    axes[:, 2] = np.cross(axes[:, 0], axes[:, 1])
    form = np.concatenate([moments, axes.T @ l, [axial], axes.T @ (9.81 * (m * c + mr * h))])
    start = np.concatenate([axes.T @ [1.0, -2, 3], axes.T @ [0.6, 0, 0.8], [0.3, -1.0]])
    return form, start


def members(count, bars):
    form, start = data()
    machine = [30.0, 0.05, 1e-4] if not bars else [30.0, 0.05, 0.01, 0.01, 1.0, 0.01, 0.01, 1.0, 1e-4, 1e-4]
    parameters = np.concatenate([form, machine])
    start = np.concatenate([start, np.zeros(1 + bars if bars else 0)])
    spread = lambda x: np.array([x * (1 + 1e-4 * ((37 * n + 11 * np.arange(len(x))) % 101)) for n in range(1, count + 1)])
    return spread(parameters), spread(start)


def rates(y, p, bars, sin, cos):
    """The second form, for any numbers."""
    moments, l, axial, ge, rest = p[0:3], p[3:6], p[6], p[7:10], p[10:]
    w, v, g, slip, currents = y[0:3], y[3:6], y[6], y[7], y[8:]
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    dot = lambda a, b: a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    s, c = sin(g), cos(g)
    speed = slip + rest[0]
    out = []
    if not bars:
        moment = -rest[1] * s - rest[2] * speed
    else:
        w0, b0, a1, l1, r1, a2, l2, r2, mu, f = rest
        moment = -b0 * s - mu * slip - f * speed
        for n in range(bars + 1):
            t = 2 * np.pi * n / bars - np.pi / 4
            flux = -a1 * s if n == 0 else -a2 * (c * float(np.cos(t)) - s * float(np.sin(t)))
            moment = moment + currents[n] * flux
            r, ind = (r1, l1) if n == 0 else (r2, l2)
            out.append(-(r * currents[n] + flux * slip) / ind)
    x = [moments[i] * w[i] + l[i] * (axial * speed) for i in range(3)]
    gain, weight = cross(x, w), cross(ge, v)
    free = [gain[i] + weight[i] for i in range(3)]
    response = [l[i] / moments[i] for i in range(3)]
    turn = (moment / axial - dot(response, free)) / (1.0 - axial * dot(l, response))
    dw = [free[i] / moments[i] - response[i] * (axial * turn) for i in range(3)]
    return dw + cross(v, w) + [slip, turn] + out


def heyoka_side(bars, tolerance):
    import heyoka as hy

    count = 512
    parameters, start = members(count, bars)
    y = hy.make_vars(*[f"y{i}" for i in range(start.shape[1])])
    p = [hy.par[i] for i in range(parameters.shape[1])]
    system = list(zip(y, rates(y, p, bars, hy.sin, hy.cos)))
    ta = hy.taylor_adaptive_batch(system, np.zeros((len(y), LANES)), tol=tolerance, pars=np.ones((len(p), LANES)))

    def run():
        ends = np.empty((count, len(y)))
        for first in range(0, count, LANES):
            ta.set_time([0.0] * LANES)
            ta.state[:] = start[first : first + LANES].T
            ta.pars[:] = parameters[first : first + LANES].T
            ta.propagate_until([SPAN] * LANES)
            ends[first : first + LANES] = ta.state.T
        return ends

    return count, run


C = """
#include <math.h>
typedef double v __attribute__((vector_size(64)));
v _ZGVeN8v_sin(v); v _ZGVeN8v_cos(v);
static inline __attribute__((always_inline)) void rates(const v *y, const v *p, v *dy) {
%s
}
void run(v *y, const v *p, double step, int steps) {
    v k1[%d], k2[%d], k3[%d], k4[%d], s[%d];
    for (int n = 0; n < steps; n++) {
        rates(y, p, k1);
        for (int i = 0; i < %d; i++) s[i] = y[i] + step / 2 * k1[i];
        rates(s, p, k2);
        for (int i = 0; i < %d; i++) s[i] = y[i] + step / 2 * k2[i];
        rates(s, p, k3);
        for (int i = 0; i < %d; i++) s[i] = y[i] + step * k3[i];
        rates(s, p, k4);
        for (int i = 0; i < %d; i++) y[i] += step / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
}
"""


class Text:
    """An expression as C; each operation is a constant of its own."""

    lines = []

    def __init__(self, text):
        self.text = text

    @classmethod
    def new(cls, text):
        cls.lines.append(f"    const v t{len(cls.lines)} = {text};")
        return cls(f"t{len(cls.lines) - 1}")

    def __neg__(self):
        return Text.new(f"-{self.text}")


def operation(sign):
    text = lambda x: x.text if isinstance(x, Text) else repr(float(x))
    return (lambda a, b: Text.new(f"{text(a)} {sign} {text(b)}")), (lambda a, b: Text.new(f"{text(b)} {sign} {text(a)}"))


for name, sign in [("add", "+"), ("sub", "-"), ("mul", "*"), ("truediv", "/")]:
    there, back = operation(sign)
    setattr(Text, f"__{name}__", there)
    setattr(Text, f"__r{name}__", back)


def c_side(bars, folder):
    steps = 20_000
    parameters, start = members(LANES, bars)
    n = start.shape[1]
    Text.lines = []
    y, p = [Text(f"y[{i}]") for i in range(n)], [Text(f"p[{i}]") for i in range(parameters.shape[1])]
    call = lambda f: lambda x: Text.new(f"_ZGVeN8v_{f}({x.text})")
    out = rates(y, p, bars, call("sin"), call("cos"))
    body = Text.lines + [f"    dy[{i}] = {each.text};" for i, each in enumerate(out)]
    source = pathlib.Path(folder) / f"loop{bars}.c"
    source.write_text(C % (("\n".join(body),) + (n,) * 9))
    library = source.with_suffix(".so")
    flags = ["-O3", "-march=native", "-ffast-math", "-mprefer-vector-width=512", "-shared", "-fPIC"]
    subprocess.run(["gcc", *flags, str(source), "-o", str(library), "-lmvec", "-lm"], check=True)
    code = ctypes.CDLL(str(library))

    def aligned(rows):
        room = np.zeros(rows.size + 8)
        offset = (-room.ctypes.data // 8) % 8
        part = room[offset : offset + rows.size].reshape(rows.shape)
        part[:] = rows
        return part

    constants = aligned(np.ascontiguousarray(parameters.T))

    def run():
        state = aligned(np.ascontiguousarray(start.T))
        pointer = lambda x: ctypes.c_void_p(x.ctypes.data)
        code.run(pointer(state), pointer(constants), ctypes.c_double(SPAN / steps), steps)
        return state.T

    return steps * LANES, run


def jax_side(bars):
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", True)
    count, steps = 512, 2_000
    parameters, start = members(count, bars)
    law = lambda y, p: jnp.stack(rates(y, p, bars, jnp.sin, jnp.cos))
    h = SPAN / steps

    def step(y, p):
        k1 = law(y, p)
        k2 = law(y + h / 2 * k1, p)
        k3 = law(y + h / 2 * k2, p)
        return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + law(y + h * k3, p))

    one = lambda y, p: jax.lax.fori_loop(0, steps, lambda _, y: step(y, p), y)
    compiled = jax.jit(jax.vmap(one))
    return count * steps, lambda: np.array(compiled(start, parameters))


def timed(work):
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def ours():
    """Our rates, errors and the end of the first member, by what was run."""
    command = ["cargo", "bench", "--quiet", "--bench", "ensembles"]
    text = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    rates, errors, ends = {}, {}, {}
    for line in text.splitlines()[1:]:
        words = line.split()
        states = int(words[0])
        if words[1] == "RK4":
            rates[states, "rk4"] = float(words[5])
        elif words[2] == "ends":
            ends[states, words[1]] = [float(word.strip("[],")) for word in words[4:]]
        else:
            key = (states, words[1], float(words[3]))
            rates[key], errors[key] = float(words[4]), float(words[7])
    return rates, errors, ends


def off(ends, exact):
    return np.max(abs(ends - exact) / np.maximum(1, abs(exact)))


def at_error(pairs, wanted):
    """The rate at an error, from pairs (error, rate); a side that is better than asked at its loosest counts with that."""
    pairs = sorted(pairs, reverse=True)
    if pairs[0][0] <= wanted:
        return pairs[0][1]
    for (e0, r0), (e1, r1) in zip(pairs, pairs[1:]):
        if e1 <= wanted < e0:
            share = math.log(e0 / wanted) / math.log(e0 / e1)
            return math.exp(math.log(r0) * (1 - share) + math.log(r1) * share)
    return math.nan


def sides_of(folder):
    sides = {}
    for states, bars in [(8, 0), (15, 6)]:
        makers = {}
        for tolerance in TOLERANCES + [1e-15]:
            makers[states, "heyoka", tolerance] = lambda bars=bars, tolerance=tolerance: heyoka_side(bars, tolerance)
        makers[states, "C"] = lambda bars=bars: c_side(bars, folder)
        makers[states, "JAX"] = lambda bars=bars: jax_side(bars)
        for key, make in makers.items():
            try:
                sides[key] = make()
            except (ImportError, OSError) as error:
                print(*key, "is not here:", error)
    return sides


def main():
    # one core for everybody, what they start included
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    with tempfile.TemporaryDirectory() as folder:
        sides = sides_of(folder)
        ends = {key: run() for key, (_, run) in sides.items()}
        _, errors, own_ends = ours()
        for key, end in ends.items():
            # the constant steps of JAX are longer
            allowed = 1e-6 if key[1] == "JAX" else max(1e-7, 1e3 * key[-1]) if key[1] == "heyoka" else 1e-7
            assert off(end[0], np.array(own_ends[key[0], "second"])) < allowed, (key, end[0])
        found, own = {key: [] for key in sides if key[-1] != 1e-15}, {}
        for _ in range(ROUNDS):
            for key, value in ours()[0].items():
                own.setdefault(key, []).append(value)
            for key in found:
                count, run = sides[key]
                found[key].append(count / timed(run))
        mine, theirs = ({key: statistics.median(values) for key, values in each.items()} for each in (own, found))
        rows = []
        for states in (8, 15):
            exact = ends.get((states, "heyoka", 1e-15))
            if exact is not None:
                peer = [(off(ends[states, "heyoka", t], exact), theirs[states, "heyoka", t]) for t in TOLERANCES]
                for wanted in ERRORS:
                    rate = max(
                        at_error([(errors[states, form, t], mine[states, form, t]) for t in TOLERANCES], wanted)
                        for form in ("first", "second")
                    )
                    rows.append((states, f"trajectories to the error {wanted:.0e}, heyoka", rate, at_error(peer, wanted)))
                for (error, rate), t in zip(peer, TOLERANCES):
                    form = max(("first", "second"), key=lambda form: mine[states, form, t])
                    what = f"trajectories at tolerance {t:.0e}, heyoka; errors {errors[states, form, t]:.0e}, {error:.0e}"
                    rows.append((states, what, mine[states, form, t], rate))
            for name in ("C", "JAX"):
                if (states, name) in theirs:
                    rows.append((states, f"RK4 steps x systems, {name}", mine[states, "rk4"], theirs[states, name]))
    lines = ["| states | what, beside whom | dalembert, 1/s | peer, 1/s | ratio |", "|---|---|---|---|---|"]
    lines += [f"| {n} | {what} | {own:.3g} | {peer:.3g} | {own / peer:.2f} |" for n, what, own, peer in rows]
    print("\n".join(lines))
    head = f"# Ensembles beside others\n\n{install.processor()}, one thread, {ROUNDS} rounds, by `python3 benches/peers/ensembles.py`.\n\n"
    pathlib.Path(__file__).with_suffix(".md").write_text(head + "\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
