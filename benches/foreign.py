#!/usr/bin/env python3
"""The problems of scenes/foreign: the digits of each reference, and the fastest method to an error.

    cargo build --release && python3 benches/foreign.py [--rounds 3]

Every method runs over a scan of tolerances by `dalembert chart`, in several rounds; a time is the median of its rounds, and that to reach an error is
interpolated between the two runs around it, logarithmically. Writes foreign.md beside itself.
"""

import argparse
import json
import math
import pathlib
import platform
import statistics
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "target" / "release" / "dalembert"
ERRORS = (1e-6, 1e-9, 1e-12)


def chart(path):
    """What the program says of a scene; none where it has no chart."""
    done = subprocess.run([PROGRAM, "chart", path, "--format", "json", "--quiet"], capture_output=True, text=True)
    return json.loads(done.stdout) if done.stdout else None


def median_runs(charts):
    """Runs of each method with the median of their times: formulation and method, then tolerance, to time and error."""
    times = {}
    for one in charts:
        for run in one["runs"]:
            if run["failure"] is None and run["seconds"] is not None and run["error"] is not None:
                key = (f"{run['method']}|{run['formulation']}", run["tolerance"])
                times.setdefault(key, ([], run["error"]))[0].append(run["seconds"])
    methods = {}
    for (method, _), (seconds, error) in times.items():
        methods.setdefault(method, []).append((statistics.median(seconds), max(error, 1e-17)))
    return methods


def to_reach(points, error):
    """Seconds to reach an error; of a method that is better than asked at once, those of its loosest run."""
    points = sorted(points)
    best = None
    for before, after in zip([None, *points], points):
        if after[1] > error:
            continue
        if before is None or before[1] <= error:
            time = after[0]
        else:
            part = math.log(error / before[1]) / math.log(after[1] / before[1])
            time = math.exp(math.log(before[0]) + part * math.log(after[0] / before[0]))
        best = time if best is None else min(best, time)
    return best


def cell(methods, error):
    reached = {name: to_reach(points, error) for name, points in methods.items()}
    reached = {name: time for name, time in reached.items() if time is not None}
    if not reached:
        return "-"
    name = min(reached, key=reached.get)
    method, formulation = name.split("|")
    way = {"stabilised": ", stabilised", "projected": ", projected", "Gear": ", Gear-Gupta-Leimkuhler"}
    short = next((add for word, add in way.items() if word in formulation), "")
    return f"{method}{short}: {reached[name] * 1e6:.0f}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=3)
    rounds = parser.parse_args().rounds
    rows = []
    for path in sorted((ROOT / "scenes" / "foreign").glob("*.toml")):
        charts = [found for found in (chart(path) for _ in range(rounds)) if found]
        # without a reference there is nothing to measure by
        if charts and charts[0]["reference"]["digits"] > 20:
            methods = median_runs(charts)
            rows.append([path.stem, f"{charts[0]['reference']['digits']}", *(cell(methods, error) for error in ERRORS)])
    head = ["scene", "digits of the reference", *(f"fastest to {error:.0e}, us" for error in ERRORS)]
    lines = [head, ["---"] * len(head), *rows]
    text = f"# Problems of others\n\n{platform.machine()}, one core, {rounds} rounds. How it was measured: foreign.py.\n\n"
    text += "\n".join("| " + " | ".join(row) + " |" for row in lines) + "\n"
    (ROOT / "benches" / "foreign.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
