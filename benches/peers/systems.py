"""Whole systems: `dalembert prove` beside two principles in SymPy (principles.py)."""

import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

from chain_text import text as chain_text

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# whole systems by their names in principles.py, each with its scene, or the links of a chain
SYSTEMS = {
    "chain 5": ("a chain of 5 links in space", 5),
    "andrews_mechanism": ("Andrews' mechanism, seven bodies", None),
    "bicycle": ("a bicycle", None),
    "chain 20": ("a chain of 20 links in space", 20),
    "chain 50": ("a chain of 50 links in space", 50),
}
LIMIT = 60


# a process counts the memory of the one that began it, so a small one begins the program: it answers by kilobytes
SMALL = "import os, sys; pid = os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ); print(os.wait4(pid, 0)[2].ru_maxrss, file=sys.stderr)"


def proved(path):
    """Seconds and megabytes of `dalembert prove`, and the rung of each row."""
    command = [ROOT / "target" / "release" / "dalembert", "prove", path, "--format", "json", "--quiet"]
    small = [sys.executable, "-I", "-S", "-c", SMALL]
    begin = time.perf_counter()
    done = subprocess.run(command, capture_output=True, text=True)
    seconds = time.perf_counter() - begin
    kilobytes = int(subprocess.run([*small, *command], capture_output=True, text=True).stderr)
    # a mistaken derivation is judged too, and refuted
    held = [row for row in json.loads(done.stdout) if row["verdict"] != "does not apply" and "mistake" not in row]
    rungs = [row["verdict"] for row in held]
    return seconds, kilobytes / 1024, ", ".join(f"{rungs.count(rung)} {rung}" for rung in dict.fromkeys(rungs))


def by_sympy(name):
    """Seconds of two principles in SymPy; more than a minute is too long."""
    command = [sys.executable, pathlib.Path(__file__).with_name("principles.py"), name]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return f"more than {LIMIT} s"
    return float(done.stdout)


def systems(rounds):
    """Of each its task with our rungs and memory, our seconds and SymPy's."""
    subprocess.run(["cargo", "build", "--release", "--quiet", "-p", "dalembert-cli"], cwd=ROOT, check=True)
    for name, (says, links) in SYSTEMS.items():
        with tempfile.TemporaryDirectory() as folder:
            path = ROOT / "scenes" / "foreign" / f"{name}.toml"
            if links:
                path = pathlib.Path(folder) / "chain.toml"
                path.write_text(chain_text("space", links))
            runs = [proved(path) for _ in range(rounds)]
        seconds, megabytes = (statistics.median(run[part] for run in runs) for part in (0, 1))
        yield f"p: all of {says}: {runs[0][2]}; {megabytes:.0f} MB", seconds, by_sympy(name)
