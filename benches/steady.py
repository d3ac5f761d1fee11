#!/usr/bin/env python3
"""The models of scenes/foreign: their steady motions with what is proved of them, and the smallest model that keeps a tolerance.

    cargo build --release && python3 benches/steady.py

Of each model `stationary` searches the ranges below, `choose` keeps 1e-4 in the scene's outputs. Times and the largest memory are those of
one run of each command. Writes steady.md beside itself.
"""

import json
import os
import pathlib
import platform
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "target" / "release" / "dalembert"
TOLERANCE = "1e-4"
SECONDS = "60"

# the ranges in which steady motions are sought, in SI units; a circle needs none
RANGES = {
    "andrews_mechanism": [],
    "bicycle": ["lean=-0.02..0.02", "steer=-0.02..0.02", "pitch=-0.01..0.01", "rear'=-15"],
    "cartesian_pendulum": ["x=-2..2", "y=-2..2"],
    "five_links": [],
    "lossy_gear": [],
    "modelica_dc_machine": ["theta'=-1000..1000", "motor.q'=-1000..1000"],
    "pleiades": [],
    "pushed_cart_pole": [],
    "stalled_motor": ["theta=-1..1", "motor.q'=-20..20"],
    "three_zeros": [],
    "triple_pendulum": [f"{name}{number}=-1.6..1.6" for number in (1, 2, 3) for name in "xy"],
    "wheelset": [],
}


def run(*words):
    """The output of a command as JSON, else its first line; seconds, and the largest memory in MB."""
    begin = time.monotonic()
    process = subprocess.Popen([PROGRAM, *words, "--seconds", SECONDS], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    output, errors = process.stdout.read(), process.stderr.read()
    _, _, usage = os.wait4(process.pid, 0)
    found = json.loads(output) if output.startswith("{") else (errors or output).strip().splitlines()[0]
    return found, time.monotonic() - begin, usage.ru_maxrss / 1024


def steady(found):
    """Motions, completeness and verdicts in words."""
    if isinstance(found, str):
        return found.split(": ", 2)[-1]
    verdicts = [motion["stability"] for motion in found["motions"]]
    counted = ", ".join(f"{verdicts.count(verdict)} {verdict}" for verdict in sorted(set(verdicts)))
    whole = "none missing" if found["complete"] else f"{len(found['undecided'])} boxes undecided"
    families = f", {len(found['families'])} families" if found["families"] else ""
    return f"{len(verdicts)} ({counted}){families}; {whole}, {found['boxes']} boxes"


def smallest(found):
    """The model that was taken, what it saves and what deciding cost."""
    if isinstance(found, str):
        return found.split(": ", 2)[-1]
    taken = next((model for model in found["models"] if model["model"] == found["taken"]), None)
    if taken is None:
        return "nothing keeps the tolerance"
    promised, price = taken["run"]["promised"], found["deciding"]["own_runs"]
    return f"{found['taken']}: {found['saved']:.2f} times less work, promised {promised:.1e}, deciding {price:.1f} runs"


def main():
    lines = [
        "# Steady motions and smaller models of problems of others",
        "",
        f"{platform.machine()}, one run of each command. How it was measured: steady.py.",
        "",
        "| model | steady motions | s | MB | smallest model to 1e-4 | s | MB |",
        "| --- | --- | --- | --- | --- | --- | --- |",
    ]
    for name, ranges in RANGES.items():
        path = f"scenes/foreign/{name}.toml"
        asked = [word for one in ranges for word in ("--range", one)]
        motions, seconds, memory = run("stationary", path, *asked, "--format", "json", "--quiet")
        model, spent, used = run("choose", path, "--tol", TOLERANCE, "--format", "json", "--quiet")
        lines.append(f"| {name} | {steady(motions)} | {seconds:.2f} | {memory:.0f} | {smallest(model)} | {spent:.2f} | {used:.0f} |")
        print(lines[-1], flush=True)
    (pathlib.Path(__file__).parent / "steady.md").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    os.chdir(ROOT)
    main()
