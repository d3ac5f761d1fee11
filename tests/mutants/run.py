#!/usr/bin/env python3
"""Breaks every law once and tells what notices: writes snapshots/mutants/, a page for each crate and folder.

Each mutant of mutants.toml is one replacement in one file of a copy of the project, outside of it. The ledger, the laws
and what the file's own crate tests are built there and run; what fails has caught the mutant. Whole motions run only where
nothing else has. Half a minute of a core each, two hours for all; the copy stays, so that the next run builds only what
differs.

    tests/mutants/run.py              all mutants
    tests/mutants/run.py forms kloss  those whose file or name contains a word: their rows alone are written anew
    tests/mutants/run.py --generate 20 crates/symbolic/src/parse
                                      so many of all that a rule breaks in these files, beside those that were thought of:
                                      what the programs of their subject let pass is told, and written nowhere

It fails where a mutant does not compile, where one survives without a reason, and where one that is said to change
nothing is caught.
"""

import filecmp
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
from collections import Counter
from pathlib import Path

import generated

ROOT = Path(__file__).resolve().parents[2]
TABLES = ROOT / "snapshots" / "mutants"
COPY = Path(os.environ.get("MUTANTS", Path(tempfile.gettempdir()) / "dalembert-mutants"))
PARTS = ["Cargo.toml", "Cargo.lock", "crates", "derivations", "scenes", "tests", "benches"]
LEDGER = "ledger"
# what else is tested: the house, its pages, what choices cost, and the program
OTHERS = {"allocation", "atlas", "contributing", "house", "motor_pages", "mutants", "pages", "rough_scenes", "scene_messages", "scenes", "units"}


def programs_in(tests: Path) -> set[str]:
    """The names of the test programs of a folder."""
    return {path.stem for path in [*tests.glob("*.rs"), *(main.parent for main in tests.glob("*/main.rs"))]}


# whole motions, minutes of them: asked only of what nothing else notices
RUNS = ["failures", "friction", "governors", "ladder", "mechanism_scenes", "phantom", "stabilisation", "stability", "stationary", "synchronism"]
LAWS = sorted(programs_in(ROOT / "tests") - OTHERS - {LEDGER, *RUNS})
# the programs whose subject these files are: the others, and the ledger, are asked only where these notice nothing
SUBJECT_OF = {
    "crates/symbolic/src/polynomials/": ["jacobians"],
    "crates/integrators/src/ensemble.rs": ["ensembles"],
    "derivations/ensemble/": ["ensembles"],
    "crates/integrators/src/transition.rs": ["transition"],
    "derivations/scene/transition.rs": ["transition"],
    "crates/integrators/src/bader_deuflhard.rs": ["methods"],
    "crates/integrators/src/linearised.rs": ["methods"],
    "crates/integrators/src/composition.rs": ["methods"],
    "crates/integrators/src/splitting.rs": ["methods", "splitting"],
    "derivations/machines/kick.rs": ["splitting"],
    "derivations/machines/text/": ["text_motors", "conformance"],
    "derivations/conformance/": ["conformance"],
    "derivations/systems/gyrostat/momenta.rs": ["splitting"],
    "derivations/ladder/": ["ladder"],
    "crates/claims/src/review/": ["review"],
    "derivations/machines/resting.rs": ["machines", "conformance"],
    "derivations/machines/metered.rs": ["machines", "conformance"],
    "derivations/machines/crossed_windings.rs": ["machines", "conformance"],
    "derivations/machines/permanent_magnet.rs": ["machines", "conformance"],
    "derivations/machines/brushed.rs": ["machines", "conformance"],
    "derivations/stationary/stability/": ["stability"],
    "derivations/phantom/": ["phantom"],
    "derivations/synchronism/": ["synchronism"],
    "crates/integrators/src/branches/repeating.rs": ["synchronism"],
    "crates/integrators/src/branches/": ["methods"],
    "crates/mechanics/src/discrete/": ["discrete", "mechanics"],
    "crates/mechanics/src/first_approximation/": ["mechanics"],
    "crates/mechanics/src/uniform/selected/": ["selected"],
    "crates/symbolic/src/recurrence/small/": ["series"],
    "crates/symbolic/src/parse/": ["parsing"],
    "crates/symbolic/src/print/": ["printing"],
    "crates/charts/src/text/": ["charts"],
}
# quick to build: only what proves and what multiplies big numbers is optimised, and a little all that runs whole motions
OPTIMISED = ["dalembert-symbolic", "dalembert-field"]
SETTINGS = {"CARGO_PROFILE_DEV_DEBUG": "0", "CARGO_TARGET_DIR": str(COPY / "target")}
# that a law fails is enough: no search for its smallest failure; pages stay behind, and are not compared
RUNNING = {"CARGO_MANIFEST_DIR": str(COPY), "PROPTEST_MAX_SHRINK_ITERS": "0", "INSTA_FORCE_PASS": "1", "INSTA_UPDATE": "no"}
# what a program took of the project itself, in seconds: ten times as long, and it does not end
TOOK: dict[str, float] = {}
# told of a program that does not come to its tests, by a panic or by an endless loop
STOPPED = ("stops", "does not end")


class Outcome:
    """What became of one mutant."""

    def __init__(self, name: str, reason: str, claims: list[str], laws: list[str], compiles: bool) -> None:
        self.name, self.reason, self.claims, self.laws, self.compiles = name, reason, claims, laws, compiles

    def caught(self) -> bool:
        return bool(self.claims or self.laws)

    def verdict(self) -> str:
        if not self.compiles:
            return "DOES NOT COMPILE"
        if self.caught():
            return "SAID TO CHANGE NOTHING" if self.reason else "caught"
        return "equivalent" if self.reason else "SURVIVED"

    def right(self) -> bool:
        return self.verdict() in ("caught", "equivalent")


def prepare() -> None:
    """The project into its copy. Only what differs is written, so that cargo sees by the times what is new."""
    wanted = [ROOT / part for part in PARTS]
    wanted += [path for part in wanted if part.is_dir() for path in part.rglob("*")]
    wanted = {COPY / path.relative_to(ROOT): path for path in wanted if path.is_file()}
    for part in PARTS:
        for path in (COPY / part).rglob("*"):
            if path.is_file() and path not in wanted:
                path.unlink()
    for target, source in wanted.items():
        if not target.exists() or not filecmp.cmp(source, target, shallow=False):
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, target)


def crates_of(files: list[str]) -> list[str]:
    """The crates in which these files lie, without the project's own."""
    return sorted({Path(file).parts[1] for file in files if file.startswith("crates/")})


def laws_of(crates: list[str]) -> list[str]:
    """The laws, and the programs that test these crates alone."""
    return [*LAWS, *(test for crate in crates for test in sorted(programs_in(ROOT / "crates" / crate / "tests")))]


def build(tests: list[str], crates: list[str]) -> dict[str, Path] | None:
    """These test programs by name, of the project and of these crates; None where the copy does not compile. What a crate
    tests within itself goes by the crate's name."""
    own = {test for crate in crates for test in programs_in(ROOT / "crates" / crate / "tests")} | set(crates)
    packages = [*(f"-{crate}" for crate in crates), *([""] if set(tests) - own else [])]
    command = ["cargo", "test", "--quiet", "--no-run", "--message-format=json"]
    command += [argument for name in packages for argument in ["--package", f"dalembert{name}"]]
    command += [argument for test in tests for argument in (["--lib"] if test in crates else ["--test", test])]
    # what a crate tests alone is small
    optimised = OPTIMISED if "" in packages else []
    command += [argument for crate in optimised for argument in ["--config", f"profile.dev.package.{crate}.opt-level=2"]]
    level = {"CARGO_PROFILE_DEV_OPT_LEVEL": "1" if set(tests) & set(RUNS) else "0"}
    done = subprocess.run(command, cwd=COPY, env=os.environ | SETTINGS | level, capture_output=True, text=True)
    if done.returncode != 0:
        return None
    found = re.findall(r'"executable":"([^"]+/deps/([a-z_]+)-[0-9a-f]+)"', done.stdout)
    return {name: Path(path) for path, name in found}


def failures(test: str, programs: dict[str, Path]) -> list[str]:
    """The names of the tests that fail, in their order; the program's where it does not come to its tests."""
    command = [programs[test], "--test-threads=2"]
    seconds = 10 * TOOK[test] + 30 if test in TOOK else None
    begin = time.monotonic()
    try:
        done = subprocess.run(command, cwd=COPY, env=os.environ | RUNNING, capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return [f"{test} {STOPPED[1]}"]
    TOOK.setdefault(test, time.monotonic() - begin)
    names = re.findall(r"^test (\S.*?)\s+\.\.\. FAILED$", done.stdout, re.MULTILINE)
    return names or ([f"{test} {STOPPED[0]}"] if done.returncode != 0 else [])


def near(file: str) -> list[str]:
    """The programs whose subject a file is, where that is said."""
    return next((programs for start, programs in SUBJECT_OF.items() if file.startswith(start)), [])


def examine_by(tests: list[str], name: str, reason: str, crates: list[str]) -> Outcome:
    """Builds and runs the copy as it stands, with these tests alone."""
    programs = build(tests, crates)
    laws = failing_laws(tests, programs) if programs else []
    return Outcome(name, reason, [], laws, compiles=programs is not None)


def examine(name: str, reason: str, crates: list[str]) -> Outcome:
    """Builds and runs the copy as it stands, with the tests of these crates."""
    programs = build([LEDGER, *laws_of(crates)], crates)
    if programs is None:
        return Outcome(name, reason, [], [], compiles=False)
    claims = [claim.removeprefix("konosevich2022/") for claim in failures(LEDGER, programs)]
    outcome = Outcome(name, reason, claims, failing_laws(laws_of(crates), programs), compiles=True)
    if name and not outcome.caught() and (runs := build(RUNS, [])):
        outcome.laws = failing_laws(RUNS, runs)
    return outcome


def failing_laws(tests: list[str], programs: dict[str, Path]) -> list[str]:
    """In words."""
    return [law.split("::")[-1].replace("_", " ") for test in tests for law in failures(test, programs)]


def examine_mutant(file: str, name: str, old: str, new: str, reason: str = "", alone: bool = False) -> Outcome:
    """Alone: by nothing but the programs whose subject the file is, where that is said."""
    path = COPY / file
    sound = path.read_text()
    path.write_text(sound.replace(old, new))
    try:
        if near(file):
            outcome = examine_by(near(file), name, reason, crates_of([file]))
            if alone or outcome.caught() or not outcome.compiles:
                return outcome
        return examine(name, reason, crates_of([file]))
    finally:
        path.write_text(sound)


def examine_generated(most: int, words: list[str]) -> None:
    """Breaks files by rule, and tells what nothing notices."""
    known = [path.relative_to(ROOT) for part in ("crates", "derivations") for path in sorted((ROOT / part).rglob("*.rs"))]
    files = [str(path) for path in known if "tests" not in path.parts and any(word in str(path) for word in words)]
    every = [(file, *mutant) for file in files for mutant in generated.mutants(COPY / file)]
    chosen = generated.spread(every, most)
    print(f"{len(chosen)} of {len(every)} mutants of {len(files)} files", flush=True)
    verdicts: Counter[str] = Counter()
    for number, (file, name, text) in enumerate(chosen, 1):
        outcome = examine_mutant(file, name, (COPY / file).read_text(), text, alone=True)
        verdicts[outcome.verdict()] += 1
        print(f"{number:3}/{len(chosen)} {outcome.verdict():17} {file}: {name}", flush=True)
    print(", ".join(f"{count} {verdict}" for verdict, count in verdicts.most_common()))


def rows(outcomes: dict[str, list[Outcome]]) -> dict[tuple[str, str], str]:
    """Beside each mutant how many catch it, and of these the one that catches the fewest others."""
    every = [(file, outcome) for file, of_file in outcomes.items() for outcome in of_file]
    often = Counter(name for _, outcome in every for name in outcome.claims + outcome.laws)
    found = {}
    for file, outcome in every:
        said = f"{outcome.verdict()}: {outcome.reason} | |"
        if outcome.verdict() == "caught":
            one = min(outcome.claims + outcome.laws, key=lambda name: (name.endswith(STOPPED), often[name]))
            said = f"{len(outcome.claims)} | {len(outcome.laws)} | {one}"
        found[file, outcome.name] = f"| {outcome.name} | {said} |"
    return found


def known_rows() -> dict[tuple[str, str], str]:
    """The rows of the tables as they stand."""
    found, file = {}, ""
    for line in "".join(page.read_text() for page in sorted(TABLES.glob("*.md"))).splitlines():
        if line.startswith("## "):
            file = line.removeprefix("## ")
        elif file and line.startswith("| ") and not line.startswith("| broken |"):
            found[file, line.split(" | ")[0].removeprefix("| ")] = line
    return found


def table(listed: list[tuple[str, str]], rows: dict[tuple[str, str], str]) -> str:
    """A page for review, of the mutants that are listed."""
    shown = [(file, rows[file, name]) for file, name in listed if (file, name) in rows]
    verdicts = Counter(("caught" if row.split(" | ")[1].isdigit() else row.split(" | ")[1].split(":")[0]) for _, row in shown)
    lines = [
        "# What notices a broken law", "",
        f"{len(shown)} mutants: " + ", ".join(f"{count} {verdict}" for verdict, count in verdicts.most_common()) + ".", "",
        "Each breaks one law by a sign, a factor, a term or an index (`tests/mutants/mutants.toml`). Beside it stand how many",
        "claims of the ledger then fail and how many laws of `tests/` or of the file's own crate, and of these the one that",
        "notices the fewest other mutants. Laws that run whole motions are asked only where nothing else notices; of a file that",
        "is the subject of some programs, these are asked first and others only then. Written by `tests/mutants/run.py`.",
    ]
    for file in dict.fromkeys(file for file, _ in shown):
        lines += ["", f"## {file}", "", "| broken | claims | laws | one of them |", "|---|---|---|---|"]
        lines += [row for of_file, row in shown if of_file == file]
    return "\n".join(lines) + "\n"


def write_tables(listed: list[tuple[str, str]], rows: dict[tuple[str, str], str]) -> None:
    """A page for the mutants of each crate, and of each folder of the derivations."""
    TABLES.mkdir(exist_ok=True)
    for folder in dict.fromkeys(Path(file).parts[:2] for file, _ in listed):
        of_folder = [(file, name) for file, name in listed if Path(file).parts[:2] == folder]
        (TABLES / f"{folder[1]}.md").write_text(table(of_folder, rows))


def main() -> None:
    words = sys.argv[1:]
    if words[:1] == ["--generate"]:
        prepare()
        return examine_generated(int(words[1]), words[2:])
    mutants = tomllib.loads((Path(__file__).parent / "mutants.toml").read_text())
    chosen = [(file, name, *texts) for file, of_file in mutants.items() for name, texts in of_file.items()
              if not words or any(word in f"{file} {name}" for word in words)]
    prepare()
    for file, name, old, *_ in chosen:
        if (count := (COPY / file).read_text().count(old)) != 1:
            sys.exit(f"{file}: {name}: `{old}` stands there {count} times, not once")
    begin = time.monotonic()
    if all(near(file) for file, *_ in chosen):
        few = sorted({test for file, *_ in chosen for test in near(file)})
        sound = examine_by(few, "", "", crates_of([file for file, *_ in chosen]))
    else:
        sound = examine("", "", crates_of([file for file, *_ in chosen]))
    if not sound.compiles or sound.caught():
        sys.exit(f"without any mutant: {sound.verdict()}: {sound.claims + sound.laws}")
    print(f"the project itself: {time.monotonic() - begin:.0f} s", flush=True)

    begin = time.monotonic()
    outcomes: dict[str, list[Outcome]] = {}
    for number, (file, name, *texts) in enumerate(chosen, 1):
        outcome = examine_mutant(file, name, *texts)
        outcomes.setdefault(file, []).append(outcome)
        tally = f"{len(outcome.claims)} claims, {len(outcome.laws)} laws"
        print(f"{number:3}/{len(chosen)} {time.monotonic() - begin:5.0f} s  {outcome.verdict():10} {file}: {name}: {tally}", flush=True)
        if words:
            print("".join(f"        {catcher}\n" for catcher in outcome.claims + outcome.laws), end="", flush=True)
    listed = [(file, name) for file, of_file in mutants.items() for name in of_file]
    write_tables(listed, known_rows() | rows(outcomes))
    wrong = [f"{file}: {outcome.name}: {outcome.verdict()}" for file, of_file in outcomes.items()
             for outcome in of_file if not outcome.right()]
    sys.exit("\n".join(wrong) or None)


if __name__ == "__main__":
    main()
