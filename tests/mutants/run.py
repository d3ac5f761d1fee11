#!/usr/bin/env python3
"""Breaks every law once and tells what notices: writes snapshots/mutants.md.

Each mutant of mutants.toml is one replacement in one file of a copy of the project, outside of it. The ledger and the
laws are built there and run; what fails has caught the mutant. Takes about a quarter of an hour on two cores.

    tests/mutants/run.py              all mutants, and the table
    tests/mutants/run.py forms kloss  those whose file or name contains a word: told, not written
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PARTS = ["Cargo.toml", "Cargo.lock", "crates", "derivations", "scenes", "tests", "benches"]
LEDGER, LAWS = "ledger", ["fields", "one_source", "gyrostats", "counterexamples", "motors"]
# quick to build: only what proves and what multiplies big numbers is optimised
OPTIMISED = ["dalembert-symbolic", "dalembert-field"]
MINUTES = 60


def prepare(copy: Path) -> None:
    """A copy whose files keep their times, so that a second run builds only what differs."""
    for part in PARTS:
        source, target = ROOT / part, copy / part
        if source.is_dir():
            shutil.rmtree(target, ignore_errors=True)
            shutil.copytree(source, target)
        else:
            shutil.copy2(source, target)


def build(copy: Path) -> dict[str, Path] | None:
    """The test programs by name; None where the copy does not compile."""
    command = ["cargo", "test", "--quiet", "--package", "dalembert", "--no-run", "--message-format=json"]
    command += [argument for test in [LEDGER, *LAWS] for argument in ["--test", test]]
    command += [argument for crate in OPTIMISED for argument in ["--config", f"profile.dev.package.{crate}.opt-level=2"]]
    settings = {"CARGO_PROFILE_DEV_OPT_LEVEL": "0", "CARGO_PROFILE_DEV_DEBUG": "0", "CARGO_TARGET_DIR": str(copy / "target")}
    done = subprocess.run(command, cwd=copy, env=os.environ | settings, capture_output=True, text=True)
    if done.returncode != 0:
        return None
    found = re.findall(r'"executable":"([^"]+/deps/([a-z_]+)-[0-9a-f]+)"', done.stdout)
    return {name: Path(path) for path, name in found}


def failures(program: Path, copy: Path) -> list[str]:
    """The names of the tests that fail, in their order; the program's where it does not come to its tests."""
    command = [program, "--test-threads=2"]
    try:
        done = subprocess.run(command, cwd=copy, env=os.environ | {"CARGO_MANIFEST_DIR": str(copy)},
                              capture_output=True, text=True, timeout=2 * MINUTES)
    except subprocess.TimeoutExpired:
        return ["does not end"]
    names = re.findall(r"^test (\S.*?)\s+\.\.\. FAILED$", done.stdout, re.MULTILINE)
    return names or (["stops"] if done.returncode != 0 else [])


def examine(copy: Path) -> tuple[list[str], list[str]]:
    """The claims and the laws that fail."""
    programs = build(copy)
    if programs is None:
        sys.exit("it does not compile: mend mutants.toml")
    claims = [name.removeprefix("konosevich2022/") for name in failures(programs[LEDGER], copy)]
    laws = [f"{test}: {name}" for test in LAWS for name in failures(programs[test], copy)]
    return claims, laws


def first_three(names: list[str]) -> str:
    shown = ", ".join(name.replace("_", " ") for name in names[:3])
    return f"{len(names)}: {shown}" + (", ..." if len(names) > 3 else "") if names else "-"


def main() -> None:
    words = sys.argv[1:]
    table = tomllib.loads((Path(__file__).parent / "mutants.toml").read_text())
    chosen = [(file, name, old, new) for file, mutants in table.items() for name, (old, new) in mutants.items()
              if not words or any(word in f"{file} {name}" for word in words)]
    copy = Path(os.environ.get("MUTANTS", Path(tempfile.gettempdir()) / "dalembert-mutants"))
    copy.mkdir(parents=True, exist_ok=True)
    prepare(copy)
    if any(examine(copy)):
        sys.exit("something fails without any mutant")

    rows, survivors, place = [], 0, None
    for file, name, old, new in chosen:
        path = copy / file
        sound = path.read_text()
        if sound.count(old) != 1:
            sys.exit(f"{file}: `{old}` stands there {sound.count(old)} times")
        path.write_text(sound.replace(old, new))
        claims, laws = examine(copy)
        path.write_text(sound)
        survivors += not claims and not laws
        verdict = "caught" if claims or laws else "SURVIVED"
        print(f"{verdict:9} {file}: {name}\n    claims {first_three(claims)}\n    laws {first_three(laws)}", flush=True)
        if file != place:
            rows += ["", f"## {file}", "", "| broken | claims that fail | laws that fail |", "|---|---|---|"]
            place = file
        shown = name if claims or laws else f"{name} **SURVIVED**"
        rows.append(f"| {shown} | {first_three(claims)} | {first_three(laws)} |")
    print(f"{len(chosen)} mutants, {survivors} survived")
    if not words:
        head = ["# What notices a broken law", "",
                f"{len(chosen)} mutants, {len(chosen) - survivors} caught, {survivors} survived. Each breaks one law by a sign, a",
                "factor, a term or an index (`tests/mutants/mutants.toml`); beside it the number of claims of the ledger and of",
                "laws in `tests/` that fail, and the first three. Written by `tests/mutants/run.py`."]
        (ROOT / "snapshots" / "mutants.md").write_text("\n".join(head + rows) + "\n")


if __name__ == "__main__":
    main()
