"""heyoka: Taylor's method compiled by LLVM, order and step as it chooses them. Compiled once for each tolerance."""

import re
import time

from turns import repeated

# how numbers are written in the exported code
NUMBER = r"(?<![\w.\[])\d+\.\d+(?:e-?\d+)?|(?<![\w.\[])\d+e-?\d+"

SETTINGS = {
    "heyoka": {},
    "heyoka, fast_math": {"fast_math": True},
    "heyoka, fast_math, compact_mode": {"fast_math": True, "compact_mode": True},
}


def runs(scene, tolerances):
    import heyoka

    # what it has compiled before is compiled again: it is timed
    if hasattr(heyoka.llvm_state, "set_diskcache_enabled"):
        heyoka.llvm_state.set_diskcache_enabled(False)
    system = traced(heyoka, scene, scene.model.rates)
    return {name: by_setting(heyoka, scene, system, tolerances, setting, float) for name, setting in SETTINGS.items()}


def finer(scene, tolerances):
    """In long double: with the constants as our double-double has them."""
    import heyoka
    import numpy

    lost = [line.split() for line in (scene.folder / "lost.txt").read_text().splitlines()]
    # in the code the sign stands apart
    exact = {number.lstrip("-"): heyoka.expression(abs(numpy.longdouble(float(number)) + float(rest))) for number, rest in lost}
    source = re.sub(NUMBER, lambda found: f"EXACT['{found[0]}']", (scene.folder / "exported.py").read_text())
    names = {"EXACT": exact}
    exec(source, names)
    system = traced(heyoka, scene, names["rates"])
    setting = {"fast_math": True, "fp_type": numpy.longdouble}
    return {"heyoka, long double": by_setting(heyoka, scene, system, tolerances, setting, numpy.longdouble)}


def traced(heyoka, scene, rates):
    names = heyoka.make_vars(*[f"y{i}" for i in range(scene.n)])
    made = rates(names, cos=heyoka.cos, sin=heyoka.sin, sqrt=heyoka.sqrt)
    # what does not move is a number, and heyoka wants an expression
    return [(name, rate + heyoka.expression(0.0)) for name, rate in zip(names, made)]


def by_setting(heyoka, scene, system, tolerances, setting, number):
    start, end = scene.start.astype(number), number(scene.end)
    make = lambda tolerance: heyoka.taylor_adaptive(system, start, tol=number(tolerance), **setting)
    made = {tolerance: make(tolerance) for tolerance in tolerances}

    def once(integrator):
        integrator.time = number(0)
        integrator.state[:] = start
        begin = time.perf_counter_ns()
        outcome = integrator.propagate_until(end)
        took = time.perf_counter_ns() - begin
        return took, integrator.state.copy() if outcome[0] == heyoka.taylor_outcome.time_limit else []

    return lambda tolerance: repeated(lambda: once(made[tolerance]))
