#!/usr/bin/env python3
"""Chains of n links: dalembert beside Pinocchio, MuJoCo, Drake, CasADi and SymPy, in one run.

    python3 benches/peers/chains.py [plane] [space]

The peers come into target/peers by name (install.py), and so does our own module (`pip install .`, some minutes). What cannot be had is
said. Writes chains.md beside itself and draws book/src/chains.svg (growth.py). With one kind of chain named, the tables of the other stay.

Each link is a rigid body of 1 kg, 0.2 m long, hinged to the one before it: about z alone in a plane, about z and x in turn in space.

* All tools are asked for the accelerations of the same state in turn, then for their derivatives by positions and speeds. Before that they
  are compared with ours: who is off by more than 1e-8 of the largest is named with the difference.
* Times are of one call from Python, the smallest of several rounds: with few links most of it is the way into the tool.
* Pinocchio is asked by aba and computeABADerivatives, MuJoCo by mj_forward, Drake by CalcTimeDerivatives, over AutoDiffXd for derivatives.
  MuJoCo's derivatives are finite differences of a step, and are left out.
* Our derivatives are machine code for short chains. Of longer ones the partial derivatives of each operation are, and the chain rule goes
  through them for sixteen directions at a time.
* SymPy and CasADi write Lagrange's equations of the same chain and solve for the accelerations, as their manuals show. They are left out
  where writing them, or their derivatives, would take more than half a minute.
* The time to the first answer begins with the text, or with the calls that build the chain; each tool was loaded before; it is the
  smallest of five where one takes less than a second.
* Code is counted in bytes of instructions and constants, cosines and sines and SymPy's solve apart. Ours is written at run time; that of
  CasADi and SymPy is their C, by gcc -O3 -march=native, where it takes gcc no more than half a minute. The others write none.
"""

import math
import pathlib
import subprocess
import sys
import time

import growth
import install

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
FOLDER = ROOT / "target" / "peers"
PEERS = ["pin", "mujoco", "drake", "casadi", "sympy"]
if __name__ == "__main__" and pathlib.Path(sys.prefix) != FOLDER / "venv":
    python = install.environment(FOLDER, PEERS)[0]
    subprocess.run([python, "-m", "pip", "install", "--quiet", ROOT], check=True)
    sys.exit(subprocess.run([python, __file__, *sys.argv[1:]]).returncode)

import numpy as np
from chain_tools import TOOLS, WRITING

# relative differences: from the first on they are told, from the second on a tool is left out
AGREES, WRONG = 1e-8, 1e-3
LINKS = (1, 2, 5, 10, 20, 50, 100, 200)
ROUNDS, CALLS, BUILDS = 7, 0.02, 5
# powers of the number of links with which expressions grow
GROWTH = {"accelerations": 3, "derivatives": 4}
HEADS = {"plane": "In a plane, hinges about z", "space": "In space, hinges about z and x in turn"}
CAPTIONS = {
    "accelerations": "Microseconds of the accelerations, by links.",
    "derivatives": "Microseconds of their derivatives by positions and speeds, by links.",
    "first": "Milliseconds from the text, or the calls that build the chain, to the first answer.",
    "code": "Kilobytes of code and constants, by links.",
}


def call_time(call):
    """Seconds of one call: the mean of as many as take some time."""
    count, spent = 1, 0.0
    while spent < CALLS:
        count *= 2
        begin = time.perf_counter()
        for _ in range(count):
            call()
        spent = time.perf_counter() - begin
    return spent / count


def least_times(calls):
    """Microseconds of a call by tool, the smallest of rounds in which the tools take turns."""
    least = dict.fromkeys(calls, math.inf)
    for _ in range(ROUNDS):
        for name, call in calls.items():
            least[name] = min(least[name], call_time(call) * 1e6)
    return least


class Comparison:
    """One kind of chain: by table and row the figures by links, and why rows end."""

    def __init__(self, kind):
        self.kind, self.reasons, self.tables = kind, [], {what: {} for what in CAPTIONS}
        self.ended, self.off = set(), {}
        for name, tool in TOOLS.items():
            try:
                # what a tool loads when it is first used
                self.first(tool, 1)
            except ImportError as error:
                self.end(name, "accelerations", f"not installed, {error}")
        for links, longer in zip(LINKS, [*LINKS[1:], None]):
            self.measure(links, longer)

    def end(self, name, what, reason):
        self.ended |= {(name, what)}
        self.reasons += [f"{name}: {reason}."]

    def first(self, tool, links):
        """A chain in a random state that is the same for all tools, after the first answer."""
        rng = np.random.default_rng(links)
        chain = tool(self.kind, links)
        chain.at(rng.uniform(-1, 1, links), rng.uniform(-1, 1, links))
        chain.accelerations()
        return chain

    def put(self, what, row, links, value):
        self.tables[what].setdefault(row, {})[links] = value

    def limit(self, name, what, took, links, longer):
        """Ends a tool's row where the next chain would take too long."""
        if longer and took * (longer / links) ** GROWTH[what] > WRITING:
            self.end(name, what, f"the {what} of more than {links} links would take longer than {WRITING} s to write")

    def measure(self, links, longer):
        chains, with_slopes = {}, {}
        for name, tool in TOOLS.items():
            if (name, "accelerations") in self.ended:
                continue
            took = math.inf
            for _ in range(BUILDS):
                begin = time.perf_counter()
                chains[name] = self.first(tool, links)
                took = min(took, time.perf_counter() - begin)
                if took > 1:
                    break
            self.put("first", name, links, took * 1e3)
            self.limit(name, "accelerations", took, links, longer)
        for name, chain in chains.items():
            if chain.differentiate and (name, "derivatives") not in self.ended:
                begin = time.perf_counter()
                chain.differentiate()
                chain.slopes()
                self.limit(name, "derivatives", time.perf_counter() - begin, links, longer)
                with_slopes[name] = chain
        right = self.agreeing(links, "accelerations", {name: chain.accelerations() for name, chain in chains.items()})
        self.time(links, "accelerations", {name: chains[name].rates for name in right})
        right = self.agreeing(links, "derivatives", {name: chain.slopes() for name, chain in with_slopes.items()})
        self.time(links, "derivatives", {name: with_slopes[name].jacobian for name in right})
        for name, chain in chains.items():
            for part, size in chain.code().items():
                self.count(name + part, size, links)

    def time(self, links, what, calls):
        for name, micros in least_times(calls).items():
            self.put(what, name, links, micros)

    def count(self, row, size, links):
        if (row, "code") in self.ended:
            return
        counted = size()
        if counted is not None:
            self.put("code", row, links, counted / 1e3)
        else:
            self.end(row, "code", f"gcc takes longer than {WRITING} s for the code of {links} links and more")

    def agreeing(self, links, what, answers):
        """Whose answers are ours; the others are told, and left out from here on."""
        exact, right = answers["dalembert"], []
        for name, answer in answers.items():
            off = np.abs(answer - exact).max() / np.abs(exact).max()
            if not off < WRONG:
                self.end(name, what, f"the {what} of {links} links are off by {off:.0e} of the largest")
                continue
            right.append(name)
            if off > AGREES:
                self.off.setdefault((name, what), []).append(f"{off:.0e} with {links} links")
        return right

    def remarks(self):
        off = [f"{name}: the {what} are off by {', '.join(off)}, of the largest." for (name, what), off in self.off.items()]
        return [*self.reasons, *off]


def number(value):
    """Three digits."""
    return np.format_float_positional(value, precision=3, fractional=False, trim="-")


def table(rows):
    lines = [["tool", *map(str, LINKS)], ["---"] * (len(LINKS) + 1)]
    lines += [[name, *(number(own[n]) if n in own else "-" for n in LINKS)] for name, own in rows.items()]
    return "\n".join("| " + " | ".join(row) + " |" for row in lines)


def section(comparison):
    parts = [part for what, caption in CAPTIONS.items() for part in (caption, table(comparison.tables[what]))]
    return "\n\n".join([f"## {HEADS[comparison.kind]}", *parts, *comparison.remarks()])


def page(sections):
    head = ["# Chains of links beside other tools", f"{install.processor()}, Python {sys.version.split()[0]}, by `python3 benches/peers/chains.py`."]
    return "\n\n".join([*head, *sections]) + "\n"


def main():
    target = HERE / "chains.md"
    kept = {part.split("\n")[0]: "## " + part.strip() for part in target.read_text().split("\n## ")[1:]} if target.exists() else {}
    for kind in sys.argv[1:] or HEADS:
        kept[HEADS[kind]] = section(Comparison(kind))
        target.write_text(page([kept[head] for head in HEADS.values() if head in kept]))
    growth.draw()
    print(target.read_text())


if __name__ == "__main__":
    main()
