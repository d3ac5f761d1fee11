"""Taking turns: every tool at one tolerance, then every tool at the next, several rounds; figures are medians."""

import math
import statistics
import time

import numpy as np

# nanoseconds: a run that takes longer is not repeated, and finer tolerances are left out
PATIENCE = 3e8
# a run is repeated within its turn so often, or until so many nanoseconds are gone
RUNS, TURN = 25, 1e7


def repeated(once):
    """The median time of several runs in a row, and the last state."""
    begin, times = time.perf_counter_ns(), []
    while not times or len(times) < RUNS and time.perf_counter_ns() - begin < TURN:
        took, state = once()
        times.append(took)
    return statistics.median(times), state


def clocked(run):
    """Nanoseconds and value of a call."""
    begin = time.perf_counter_ns()
    value = run()
    return time.perf_counter_ns() - begin, value


def measure(scene, scans, rounds):
    """For each tool its points (tolerance, error, milliseconds), and by tool the tolerances at which it failed.

    A scan is of some tools at some tolerances; each round goes through all scans, so that what is compared was measured
    in one and the same minute.
    """
    times, errors, out = {}, {}, {}
    for _ in range(rounds):
        for name, run, tolerance in turns(scans):
            if (name, tolerance) in out or (name, "slow") in out:
                continue
            took, state = attempt(run, tolerance)
            if len(state) == 0 or not np.all(np.isfinite(state)):
                out[name, tolerance] = True
            else:
                times.setdefault((name, tolerance), []).append(took / 1e6)
                errors[name, tolerance] = scene.error(state)
            if took > PATIENCE:
                out[name, "slow"] = True
    points = {name: [] for runs, _ in scans for name in runs}
    for (name, tolerance), taken in times.items():
        points[name].append((tolerance, errors[name, tolerance], statistics.median(taken)))
    failed = {name: [tolerance for tolerance in tolerances if (name, tolerance) in out] for runs, tolerances in scans for name in runs}
    return points, failed


def turns(scans):
    return [(name, run, tolerance) for runs, tolerances in scans for tolerance in tolerances for name, run in runs.items()]


def attempt(run, tolerance):
    try:
        return run(tolerance)
    except Exception:
        return 0.0, []


def at_error(points, error):
    """Milliseconds to an error, between the runs around it, logarithmically; None where no run is so good.

    A tool that is better than asked at its cheapest run counts with that run.
    """
    good = [(took, reached) for _, reached, took in points if reached <= error]
    if not good:
        return None
    took, reached = min(good)
    worse = [(r, t) for _, r, t in points if r > error and t < took]
    if not worse:
        return took
    near, near_took = min(worse)
    share = math.log(near / error) / math.log(near / max(reached, 1e-18))
    return math.exp(math.log(near_took) + share * math.log(took / near_took))
