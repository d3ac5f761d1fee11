#!/usr/bin/env python3
"""Milliseconds to reach an error: dalembert beside other tools, on the same scenes, side by side in one run.

    python3 benches/against/compare.py [--rounds 7] [SCENE.toml ...]

needs cargo, and numpy; every tool is optional, and what is missing is said:
pip: heyoka, scipy, scikit-sundae, jax with diffrax, casadi; Debian: g++, libgsl-dev, libboost-dev.
Prints tables, and writes benches/against/results.md and results.json.

What is compared, and how:

* The model is written once: `dalembert derive SCENE.toml --format c|python` prints the right-hand side and its exact
  Jacobian from the recorded laws. heyoka, JAX and CasADi trace the Python, the others call the C (gcc -O3 -march=native).
* Every tool runs over a scan of tolerances. Errors are those achieved at the end, relative to the largest size of each
  component, against a reference in double-double that two methods of ours confirm. Times are interpolated between the two
  runs around an error, logarithmically; a tool that is better than asked at its loosest tolerance counts with that run.
* The tools take turns, several rounds; figures are medians. Each clock runs inside the tool's own process. Setting up
  (recording, compiling, tracing) is counted apart. SciPy and SUNDIALS call the compiled C through ctypes: that and their
  own Python are in their times, as in any use of them from Python.
"""

import argparse
import ctypes
import importlib.util
import json
import math
import pathlib
import platform
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
SCENES = [HERE / name for name in ("synchronous.toml", "six_bars.toml", "six_bars_stiff.toml")]
ERRORS = [1e-6, 1e-9, 1e-12]
TOLERANCES = [10.0**-k for k in range(4, 15)]
FLAGS = ["-O3", "-march=native"]
# a run that takes longer is not repeated, and finer tolerances are left out
PATIENCE = 3e8
OURS = {
    False: ["taylor", "dormand_prince_8", "gragg_bulirsch_stoer"],
    True: ["bader_deuflhard", "rodas_4", "radau_iia:5", "radau_iia:7"],
}
missing = {}


class Server:
    """A program that answers each line by nanoseconds and a state."""

    def __init__(self, command):
        self.process = subprocess.Popen(command, cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def read(self):
        return [float(word) for word in self.process.stdout.readline().split()]

    def ask(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()
        return self.read()

    def run(self, method):
        def run(tolerance):
            answer = self.ask(f"{method} {tolerance!r}")
            return answer[0], answer[1:]

        return run


def optional(name, make):
    """A tool's runs by name; nothing where it is not installed or does not work here."""
    try:
        begin = time.perf_counter()
        runs = make()
        return runs, time.perf_counter() - begin
    except ImportError as error:
        missing[name] = f"not installed: {error}"
    except Exception as error:
        missing[name] = f"failed: {type(error).__name__}: {error}"
    return {}, 0.0


def heyoka_runs(model, start, end):
    import heyoka

    names = heyoka.make_vars(*[f"y{i}" for i in range(len(start))])
    rates = model.rates(names, cos=heyoka.cos, sin=heyoka.sin, sqrt=heyoka.sqrt)
    system = list(zip(names, rates))
    made = {tolerance: heyoka.taylor_adaptive(system, list(start), tol=tolerance) for tolerance in TOLERANCES}

    def run(tolerance):
        integrator = made[tolerance]
        integrator.time = 0.0
        integrator.state[:] = start
        begin = time.perf_counter_ns()
        integrator.propagate_until(end)
        return time.perf_counter_ns() - begin, integrator.state.copy()

    return {"heyoka": run}


def scipy_runs(library, start, end, stiff):
    from scipy.integrate import solve_ivp

    def run_by(method):
        options = {"jac": library.jacobian} if method in ("Radau", "BDF") else {}

        def run(tolerance):
            begin = time.perf_counter_ns()
            out = solve_ivp(library.rates, (0.0, end), start, method=method, rtol=max(tolerance, 3e-14), atol=tolerance, **options)
            return time.perf_counter_ns() - begin, out.y[:, -1] if out.success else []

        return run

    return {f"SciPy {method}": run_by(method) for method in (["Radau", "BDF"] if stiff else ["DOP853"])}


def sundials_runs(library, start, end, stiff):
    from sksundae.cvode import CVODE

    def rates(t, y, dy):
        library.code.rates(y.ctypes.data, dy.ctypes.data)

    def jacobian(t, y, dy, matrix):
        library.code.jacobian(y.ctypes.data, library.room.ctypes.data)
        matrix[:] = library.room

    def run_by(method):
        def run(tolerance):
            options = {"jacfn": jacobian} if method == "BDF" else {}
            solver = CVODE(rates, method=method, rtol=tolerance, atol=tolerance, max_num_steps=10**6, **options)
            begin = time.perf_counter_ns()
            out = solver.solve(np.array([0.0, end]), np.array(start))
            return time.perf_counter_ns() - begin, out.y[-1] if out.success else []

        return run

    return {f"CVODE {method}": run_by(method) for method in (["BDF"] if stiff else ["Adams", "BDF"])}


def diffrax_runs(model, start, end, stiff):
    import jax

    jax.config.update("jax_enable_x64", True)
    import diffrax
    import jax.numpy as jnp

    def law(t, y, _):
        return jnp.stack(model.rates(y, cos=jnp.cos, sin=jnp.sin, sqrt=jnp.sqrt))

    def run_by(solver):
        @jax.jit
        def solve(tolerance, y):
            control = diffrax.PIDController(rtol=tolerance, atol=tolerance)
            out = diffrax.diffeqsolve(
                diffrax.ODETerm(law), solver, 0.0, end, None, y, stepsize_controller=control, max_steps=10**6, throw=False
            )
            return out.ys[-1], out.result == diffrax.RESULTS.successful

        first = jnp.array(start)
        solve(1e-4, first)[0].block_until_ready()

        def run(tolerance):
            begin = time.perf_counter_ns()
            state, reached = solve(tolerance, first)
            state.block_until_ready()
            return time.perf_counter_ns() - begin, np.asarray(state) if reached else []

        return run

    solvers = {"Kvaerno5": diffrax.Kvaerno5()} if stiff else {"Dopri8": diffrax.Dopri8()}
    return {f"diffrax {name}": run_by(solver) for name, solver in solvers.items()}


class Library:
    """The exported C as a shared library, for tools that call back."""

    def __init__(self, folder, n):
        subprocess.run(["gcc", *FLAGS, "-shared", "-fPIC", "-o", f"{folder}/rates.so", "-x", "c", f"{folder}/rates.h", "-lm"], check=True)
        self.code = ctypes.CDLL(f"{folder}/rates.so")
        for function in (self.code.rates, self.code.jacobian):
            function.argtypes = [ctypes.c_void_p, ctypes.c_void_p]
        self.n, self.room = n, np.zeros((n, n))

    def rates(self, t, y):
        y, out = np.ascontiguousarray(y), np.empty(self.n)
        self.code.rates(y.ctypes.data, out.ctypes.data)
        return out

    def jacobian(self, t, y):
        y, out = np.ascontiguousarray(y), np.empty((self.n, self.n))
        self.code.jacobian(y.ctypes.data, out.ctypes.data)
        return out


def casadi_object(model, n, folder):
    """CasADi's own Jacobian of the same model, as its C."""
    import casadi

    y = casadi.SX.sym("y", n)
    rates = casadi.vertcat(*model.rates(casadi.vertsplit(y), cos=casadi.cos, sin=casadi.sin, sqrt=casadi.sqrt))
    function = casadi.Function("casadi_jacobian", [y], [casadi.densify(casadi.jacobian(rates, y))])
    generator = casadi.CodeGenerator("casadi_jacobian.c")
    generator.add(function)
    generator.generate(f"{folder}/")
    subprocess.run(["gcc", *FLAGS, "-c", "-o", f"{folder}/casadi.o", f"{folder}/casadi_jacobian.c"], check=True)
    return {"casadi": f"{folder}/casadi.o"}


def compiled_peers(folder, start, end, stiff, extra):
    """The driver in C++, with the libraries that are there."""
    definitions, libraries, names = [], [], []
    has = lambda header: subprocess.run(["g++", "-E", "-x", "c++", "-"], input=f"#include <{header}>", capture_output=True, text=True).returncode == 0
    if has("gsl/gsl_odeiv2.h"):
        definitions, libraries = definitions + ["-DGSL"], libraries + ["-lgsl", "-lgslcblas"]
        names += ["gsl_bsimp", "gsl_msbdf"] if stiff else ["gsl_rk8pd"]
    else:
        missing["GSL"] = "not installed: libgsl-dev"
    if has("boost/numeric/odeint.hpp"):
        definitions += ["-DODEINT"]
        names += ["odeint_rosenbrock4"] if stiff else ["odeint_dopri5", "odeint_fehlberg78", "odeint_bulirsch_stoer"]
    else:
        missing["Boost odeint"] = "not installed: libboost-dev"
    if extra:
        definitions += ["-DCASADI"]
    sources = [str(HERE / "peers.cpp"), *extra.values()]
    subprocess.run(["g++", *FLAGS, *definitions, f"-I{folder}", "-o", f"{folder}/peers", *sources, *libraries], check=True)
    server = Server([f"{folder}/peers", repr(end), *map(repr, start)])
    return server, {name.replace("_", " ", 1): server.run(name) for name in names}


def at_error(points, error):
    """Time at an error, between the runs around it; None where no run is so good."""
    good = sorted((p for p in points if p[0] <= error), key=lambda p: p[1])
    if not good:
        return None
    best = good[0]
    worse = [p for p in points if p[0] > error and p[1] < best[1]]
    if not worse:
        return best[1]
    near = min(worse, key=lambda p: p[0])
    share = math.log(near[0] / error) / math.log(near[0] / max(best[0], 1e-18))
    return math.exp(math.log(near[1]) + share * math.log(best[1] / near[1]))


def measure(runs, exact, sizes, rounds):
    """For each tool its points (error, milliseconds), the tools taking turns."""
    times, errors, left = {}, {}, {}
    for turn in range(rounds):
        for name, run in runs.items():
            for tolerance in TOLERANCES:
                if (name, tolerance) in left or left.get(name, 0.0) > tolerance:
                    continue
                try:
                    took, state = run(tolerance)
                except Exception:
                    took, state = math.inf, []
                if len(state) == 0 or not np.all(np.isfinite(state)):
                    left[name, tolerance] = "failed"
                    left[name] = max(left.get(name, 0.0), tolerance if took > PATIENCE else 0.0)
                    continue
                times.setdefault((name, tolerance), []).append(took / 1e6)
                errors[name, tolerance] = float(np.max(np.abs(np.asarray(state) - exact) / sizes))
                if took > PATIENCE:
                    left[name, tolerance], left[name] = "slow", max(left.get(name, 0.0), tolerance)
    return {name: [(errors[key], statistics.median(times[key])) for key in times if key[0] == name] for name in runs}


def compare(scene, rounds):
    """One scene: times to reach the errors, evaluations, set-up times."""
    with tempfile.TemporaryDirectory() as folder:
        stiff = "stiff" in scene.stem
        program = ["cargo", "run", "--release", "--quiet", "--", "derive", str(scene), "--form", "second"]
        for language, name in (("c", "rates.h"), ("python", "exported_model.py")):
            text = subprocess.run([*program, "--format", language], cwd=ROOT, capture_output=True, text=True, check=True).stdout
            (pathlib.Path(folder) / name).write_text(text)
        specification = importlib.util.spec_from_file_location("exported_model", f"{folder}/exported_model.py")
        model = importlib.util.module_from_spec(specification)
        specification.loader.exec_module(model)
        ours = Server(["cargo", "bench", "--quiet", "--bench", "against", "--", str(scene)])
        digits, exact, sizes, start = ours.read()[0], *(np.array(ours.read()) for _ in range(3))
        end, n = 2.0, len(start)
        runs = {f"dalembert {name}": ours.run(name) for name in OURS[stiff]}
        setup = {"dalembert": ours.ask("setup")[0] / 1e9}
        extra, setup["CasADi"] = optional("CasADi", lambda: casadi_object(model, n, folder))
        begin = time.perf_counter()
        peers, found = compiled_peers(folder, start.tolist(), end, stiff, extra)
        setup["C++ driver"] = time.perf_counter() - begin
        library = Library(folder, n)
        parts = {
            "heyoka": lambda: heyoka_runs(model, start, end),
            "SciPy": lambda: scipy_runs(library, start, end, stiff),
            "SUNDIALS": lambda: sundials_runs(library, start, end, stiff),
            "diffrax": lambda: diffrax_runs(model, start, end, stiff),
        }
        runs |= found
        for name, make in parts.items():
            made, setup[name] = optional(name, make)
            runs |= made
        points = measure(runs, exact, sizes, rounds)
        ask = {"our rates": (ours, "rates"), "our Jacobian": (ours, "jacobian"), "num-dual Jacobian": (ours, "num-dual"),
               "exported C, rates": (peers, "rates"), "exported C, Jacobian": (peers, "jacobian")}
        if extra:
            ask["CasADi's C, Jacobian"] = (peers, "casadi")
        samples = {name: [] for name in ask}
        for _ in range(rounds):
            for name, (server, what) in ask.items():
                samples[name].append(server.ask(what)[0])
        evaluations = {name: statistics.median(values) for name, values in samples.items()}
        return {"scene": scene.stem, "states": n, "digits of the reference": digits, "points": points,
                "milliseconds": {name: [at_error(p, error) for error in ERRORS] for name, p in points.items()},
                "nanoseconds": evaluations, "setup": {name: took for name, took in setup.items() if took}}


def table(result):
    """The scene as Markdown."""
    own = [row for name, row in result["milliseconds"].items() if name.startswith("dalembert")]
    best = [min((row[k] for row in own if row[k]), default=None) for k in range(len(ERRORS))]
    cell = lambda value, ours: "-" if value is None else f"{value:.3f} ({value / ours:.2f})" if ours else f"{value:.3f}"
    lines = [f"## {result['scene']}, {result['states']} states", "",
             "Milliseconds to reach the error, and in brackets the ratio to our best.", "",
             "| tool | " + " | ".join(f"{error:.0e}" for error in ERRORS) + " |", "|---|" + "---|" * len(ERRORS)]
    for name, row in result["milliseconds"].items():
        lines.append(f"| {name} | " + " | ".join(cell(value, ours) for value, ours in zip(row, best)) + " |")
    rates = result["nanoseconds"]["our rates"]
    lines += ["", "| evaluation | ns | in our rates |", "|---|---|---|"]
    lines += [f"| {name} | {value:.0f} | {value / rates:.1f} |" for name, value in result["nanoseconds"].items()]
    lines += ["", "Set up once: " + ", ".join(f"{name} {took:.3g} s" for name, took in result["setup"].items()) + "."]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("scenes", nargs="*", type=pathlib.Path, default=SCENES)
    asked = parser.parse_args()
    results = [compare(scene.resolve(), asked.rounds) for scene in asked.scenes]
    text = "# Beside other tools\n\n" + f"{platform.machine()}, Python {platform.python_version()}, {asked.rounds} rounds.\n\n"
    text += "\n".join(table(result) for result in results)
    text += "".join(f"\n{name}: {reason}.\n" for name, reason in missing.items())
    print(text)
    (HERE / "results.md").write_text(text)
    (HERE / "results.json").write_text(json.dumps({"results": results, "missing": missing}, indent=1) + "\n")


if __name__ == "__main__":
    sys.exit(main())
