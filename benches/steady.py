#!/usr/bin/env python3
"""Problems of others: all steady motions with their stability, the steps that tell it, and the smallest model that keeps a tolerance.

    cargo build --release && python3 benches/steady.py          # with GNU time

Of each model `stationary` searches the ranges below, `numerical-stability` gives numerical eigenvalues at each motion and the longest step
with which the Runge-Kutta method of order 4 tells its stability, and `choose` keeps 1e-4 in the scene's outputs. Times and the largest memory
are those of one run of each command. Writes steady.md beside itself.
"""

import json
import os
import pathlib
import platform
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "target" / "release" / "dalembert"
TOLERANCE = "1e-4"
SECONDS = "20"
METHOD = "Runge-Kutta 4"

# the ranges in which steady motions are sought, in SI units; a circle needs none
RANGES = {
    "andrews_mechanism": [],
    "bicycle": ["lean=-0.02..0.02", "steer=-0.02..0.02", "pitch=-0.01..0.01", "rear'=-15"],
    "cartesian_pendulum": ["x=-2..2", "y=-2..2"],
    "triple_pendulum": [f"{axis}{rod}=-1.6..1.6" for rod in range(1, 4) for axis in "xy"],
    "five_links": [f"{axis}{rod}=-5.5..5.5" for rod in range(1, 6) for axis in "xy"],
    "modelica_dc_machine": ["theta'=-1000..1000", "motor.q'=-1000..1000"],
    "stalled_motor": ["theta=-1..1", "motor.q'=-20..20"],
    "pushed_cart_pole": [],
    "three_zeros": ["y=-200..200"],
    "pleiades": [f"{axis}{star}=-4..4" for star in range(1, 8) for axis in "xy"],
}


def run(*words):
    """The output of a command as JSON, else its first line; seconds, and the largest memory in MB."""
    with tempfile.NamedTemporaryFile("r") as measured:
        # GNU time, since the memory of a process counts that of the one that starts it
        command = ["time", "--quiet", "--format", "%e %M", "--output", measured.name, PROGRAM, *words]
        done = subprocess.run([*command, "--format", "json", "--quiet", "--seconds", SECONDS], capture_output=True, text=True)
        seconds, kilobytes = measured.read().split()[-2:]
    told, why = done.stdout, done.stderr
    found = json.loads(told) if told.startswith("{") else (why or told).strip().splitlines()[0]
    return found, float(seconds), int(kilobytes) / 1024


def cases(found):
    """The motions of every combination of conditions, and whether none is missing."""
    return found["cases"] if "cases" in found else [found]


def steady(found):
    """Motions with their verdicts, and completeness."""
    if isinstance(found, str):
        return found.split(": ", 2)[-1]
    motions = [motion for case in cases(found) for motion in case["motions"]]
    families = [family for case in cases(found) for family in case["families"]]
    verdicts = [motion["stability"] for motion in motions]
    counted = ", ".join(f"{verdicts.count(verdict)} {verdict}" for verdict in sorted(set(verdicts)))
    undecided = sum(len(case["undecided"]) for case in cases(found))
    share = max(case["undecided_part"] for case in cases(found))
    whole = "none missing" if undecided == 0 else f"{undecided} boxes undecided, {share:.1e} of the range"
    beside = f", {len(families)} families" if families else ""
    boxes = sum(case["boxes"] for case in cases(found))
    return f"{len(motions)}{f' ({counted})' if motions else ''}{beside}; {whole}; {boxes} boxes"


def steps(found):
    """At each motion the largest real part of numerical eigenvalues, and the longest step at which the method is correct."""
    if isinstance(found, str):
        return found.split(": ", 2)[-1]
    told = []
    for motion in (motion for case in cases(found) for motion in case["motions"]):
        largest = max((value[0] for value in motion["eigenvalues"]), default=0.0)
        method = next(one for one in motion["methods"] if one["method"] == METHOD)
        first = method["stretches"][0]
        correct = "never" if first["says"] != "correct" else "always" if first["to"] is None else f"{first['to']:.4g} s"
        told.append(f"{largest:.3g}/s: {correct}")
    return "; ".join(f"{told.count(one)} x {one}" if told.count(one) > 1 else one for one in dict.fromkeys(told)) or "no motion"


def smallest(found):
    """The model that was taken, what it saves and what deciding cost."""
    if isinstance(found, str):
        return found.split(": ", 2)[-1]
    taken = next((model for model in found["models"] if model["model"] == found["taken"]), None)
    if taken is None:
        return "nothing keeps the tolerance"
    promised, price = taken["run"]["promised"], found["deciding"]["own_runs"]
    return f"{found['taken']}: {found['saved']:.2f} times less work, error up to {promised:.1e}, deciding {price:.1f} runs"


def table(title, about, name, found):
    """A table of one command for every model."""
    head = [f"## {title}", "", about, "", f"| model | {name} | s | MB |", "| --- | --- | --- | --- |"]
    rows = [f"| {model} | {told} | {seconds:.2f} | {memory:.0f} |" for model, (told, seconds, memory) in found.items()]
    return [*head, *rows, ""]


def main():
    commands = {"stationary": steady, "numerical-stability": steps, "choose": smallest}
    found = {command: {} for command in commands}
    for model, ranges in RANGES.items():
        path = f"scenes/foreign/{model}.toml"
        asked = [word for one in ranges for word in ("--range", one)]
        for command, told in commands.items():
            words = ["--tol", TOLERANCE] if command == "choose" else asked
            answer, seconds, memory = run(command, path, *words)
            found[command][model] = (told(answer), seconds, memory)
            print(model, command, *found[command][model], flush=True)
    lines = [
        "# Problems of others: steady motions, steps that tell their stability, smaller models",
        "",
        f"{platform.machine()}, {os.cpu_count()} cores, one run of each command of at most {SECONDS} s. How it was measured: steady.py.",
        "",
        *table(
            "Steady motions",
            "`stationary` with the ranges of steady.py. None is missing where no box is undecided.",
            "motions (by stability); boxes",
            found["stationary"],
        ),
        *table(
            "Steps",
            f"`numerical-stability`: at each motion the largest real part of the numerical eigenvalues, and the longest step with which {METHOD} tells "
            "a stable motion stable and an unstable one unstable.",
            "largest real part: longest step",
            found["numerical-stability"],
        ),
        *table("Smaller models", f"`choose --tol {TOLERANCE}`.", "model", found["choose"]),
    ]
    (pathlib.Path(__file__).parent / "steady.md").write_text("\n".join(lines))


if __name__ == "__main__":
    os.chdir(ROOT)
    main()
