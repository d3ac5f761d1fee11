"""heyoka: Taylor's method compiled by LLVM, order and step as it chooses them. Compiled once for each tolerance."""

from turns import repeated

SETTINGS = {
    "heyoka": {},
    "heyoka, fast_math": {"fast_math": True},
    "heyoka, fast_math, compact_mode": {"fast_math": True, "compact_mode": True},
}


def runs(scene, tolerances):
    import heyoka

    names = heyoka.make_vars(*[f"y{i}" for i in range(scene.n)])
    rates = scene.model.rates(names, cos=heyoka.cos, sin=heyoka.sin, sqrt=heyoka.sqrt)
    # what does not move is a number, and heyoka wants an expression
    system = [(name, rate + heyoka.expression(0.0)) for name, rate in zip(names, rates)]
    return {name: by_setting(heyoka, scene, system, tolerances, setting) for name, setting in SETTINGS.items()}


def by_setting(heyoka, scene, system, tolerances, setting):
    import time

    made = {tolerance: heyoka.taylor_adaptive(system, list(scene.start), tol=tolerance, **setting) for tolerance in tolerances}

    def once(integrator):
        integrator.time = 0.0
        integrator.state[:] = scene.start
        begin = time.perf_counter_ns()
        outcome = integrator.propagate_until(scene.end)
        took = time.perf_counter_ns() - begin
        return took, integrator.state.copy() if outcome[0] == heyoka.taylor_outcome.time_limit else []

    return lambda tolerance: repeated(lambda: once(made[tolerance]))
