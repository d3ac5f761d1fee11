#!/usr/bin/env python3
"""Breaks every law once and tells what notices: writes snapshots/mutants/, a page for each crate and folder.

Each mutant of mutants.toml is one replacement in one file of a copy of the project, outside of it. The ledger, the laws
and what the file's own crate tests are built there, once for all mutants (together.py), and run; what fails has caught the
mutant. Whole motions run only where nothing else has. The copy stays, so that the next run builds only what differs.

    tests/mutants/run.py              all mutants
    tests/mutants/run.py forms kloss  those whose file or name contains a word: their rows alone are written anew
    tests/mutants/run.py --generate 20 crates/symbolic/src/parse
                                      so many of all that a rule breaks in these files, beside those that were thought of:
                                      what the programs of their subject let pass is told, and written nowhere

It fails where a mutant does not compile, where one survives without a reason, and where one that is said to change
nothing is caught.
"""

import filecmp
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import generated
import together

ROOT = Path(__file__).resolve().parents[2]
TABLES = ROOT / "snapshots" / "mutants"
# crates whose mutants have a page for each folder
BY_FOLDER = ("model", "scenes")
COPY = Path(os.environ.get("MUTANTS", Path(tempfile.gettempdir()) / "dalembert-mutants"))
PARTS = ["Cargo.toml", "Cargo.lock", "crates", "derivations", "papers", "scenes", "tests", "benches", "book", "schema"]
LEDGER = "ledger"
# what else is tested: the house, its pages, and the program
OTHERS = {"allocation", "house", "pages", "scenes"}


def programs_in(tests: Path) -> set[str]:
    """The names of the test programs of a folder."""
    return {path.stem for path in [*tests.glob("*.rs"), *(main.parent for main in tests.glob("*/main.rs"))]}


# whole motions, minutes of them: asked only of what nothing else notices
RUNS = ["motions", "stability"]
LAWS = sorted(programs_in(ROOT / "tests") - OTHERS - {LEDGER, *RUNS})
PRACTICE = [f"machines::{name}" for name in ("brushed", "conformance", "crossed_windings", "metered", "permanent_magnet")]
# the tests whose subject these files are, as a program or one module of it: the others, and the ledger, are asked only where
# these notice nothing
SUBJECT_OF = {
    "crates/symbolic/src/fraction.rs": ["symbolic"],
    "crates/native/": ["code"],
    "crates/simulation/src/law/jacobian.rs": ["laws::jacobians"],
    "crates/algebra/src/real/": ["numbers::balls", "numbers::real", "algebra"],
    "crates/algebra/src/complex/": ["algebra"],
    "crates/algebra/src/multivariate/": ["expressions::algebra", "expressions::decisions", "algebra"],
    "crates/symbolic/src/prove/": ["expressions::algebra", "expressions::decisions", "symbolic"],
    "crates/symbolic/src/tape/time_parts.rs": ["program::pulses", "expressions::programs", "symbolic"],
    "crates/symbolic/src/tape/": ["expressions::programs", "symbolic"],
    "crates/integrators/src/batch/ensemble.rs": ["runs::ensembles"],
    "crates/integrators/src/events/": ["methods"],
    "crates/simulation/src/references/": ["rough::references"],
    "crates/scenes/src/modes/slowed.rs": ["rough::references"],
    "derivations/studies/src/ensemble/": ["runs::ensembles"],
    "derivations/systems/src/governor/servo.rs": ["motions::governors"],
    "crates/integrators/src/methods/taylor/rounding.rs": ["integrators", "runs::references"],
    "crates/integrators/src/methods/taylor/transition.rs": ["runs::transition"],
    "crates/simulation/src/transition.rs": ["runs::transition"],
    "crates/integrators/src/methods/implicit/bader_deuflhard.rs": ["methods"],
    "crates/integrators/src/methods/explicit/dormand_prince/stiffness.rs": ["program::failures", "methods"],
    "crates/integrators/src/law/step_bounds.rs": ["program::pulses"],
    "crates/simulation/src/law/time_scales.rs": ["program::pulses"],
    "crates/integrators/src/methods/explicit/dormand_prince/": ["integrators", "methods"],
    "crates/integrators/src/law/composition.rs": ["methods"],
    "crates/integrators/src/methods/splitting.rs": ["methods", "runs::splitting"],
    "crates/motor/src/kick.rs": ["runs::splitting"],
    "crates/motor/src/text_motor/": ["machines::text_motors", "machines::conformance"],
    "derivations/studies/src/conformance/": ["machines::conformance"],
    "derivations/systems/src/gyrostat/momenta.rs": ["runs::splitting"],
    "derivations/studies/src/model_reduction/": ["motions::model_reduction"],
    "crates/claims/src/review/": ["verdicts::review"],
    "crates/motor/src/steady_currents.rs": PRACTICE,
    "crates/motor/src/power_balance.rs": PRACTICE,
    "derivations/machines/src/crossed_windings.rs": PRACTICE,
    "derivations/machines/src/permanent_magnet.rs": PRACTICE,
    "derivations/machines/src/brushed.rs": PRACTICE,
    "derivations/studies/src/stationary/stability/": ["stability"],
    "derivations/studies/src/stationary/": ["stability::stationary", "stability"],
    "derivations/studies/src/numerical_stability/": ["stability::numerical_stability"],
    "derivations/studies/src/synchronism/": ["motions::synchronism"],
    "crates/integrators/src/branches/periodic_motions.rs": ["motions::synchronism"],
    "crates/integrators/src/branches/": ["methods"],
    "crates/mechanics/src/constrained/servo.rs": ["systems::servo"],
    "crates/mechanics/src/constrained/massless.rs": ["systems::servo"],
    "crates/mechanics/src/one_step_stability/": ["systems::discrete", "mechanics"],
    "crates/mechanics/src/linear_stability/": ["mechanics"],
    "crates/mechanics/src/steady_rotations/": ["mechanics", "systems::selected"],
    "crates/model/src/elaboration/contact_checks.rs": ["rough"],
    "crates/model/src/elaboration/guides.rs": ["rough"],
    "crates/model/src/elaboration/drives.rs": ["drives"],
    "crates/model/src/elaboration/one_ways.rs": ["drives"],
    "crates/model/src/elaboration/inertialess/": ["drives"],
    "crates/model/src/elaboration/turning_inertias.rs": ["messages"],
    "crates/scenes/src/text/machines.rs": ["drives"],
    "crates/scenes/src/conformance/": ["models"],
    "crates/scenes/src/modes/regimes.rs": ["rough"],
    "crates/scenes/src/start/mod.rs": ["drives", "models"],
    "crates/scenes/src/linearisation/mod.rs": ["drives", "linearisation", "scenes"],
    "crates/model/src/trace/contacts.rs": ["drives", "principles", "model", "exports"],
    "crates/model/src/trace/motion.rs": ["rough", "principles"],
    "crates/model/src/trace/bodies.rs": ["drives", "principles", "model", "exports"],
    "crates/model/src/equations/elimination.rs": ["rough", "principles", "model", "exports"],
    "crates/model/src/elaboration/absent.rs": ["motions::model_reduction"],
    "crates/model/src/elaboration/conditions_of_law.rs": ["motions::model_reduction"],
    "crates/model/src/elaboration/rigid.rs": ["motions::model_reduction"],
    "crates/scenes/src/start/junction.rs": ["motions::model_reduction"],
    "crates/scenes/src/steady_motions/": ["steady_motions"],
    "crates/simulation/src/integral_drift/": ["integral_drift"],
    "crates/model/": ["principles", "model", "exports"],
    "crates/scenes/src/start/leaf.rs": ["linearisation"],
    "crates/scenes/src/start/algebraic.rs": ["drives"],
    "crates/scenes/src/start/": ["models", "messages"],
    "crates/scenes/src/linearisation/": ["linearisation", "scenes"],
    "crates/scenes/src/equilibrium/": ["linearisation"],
    "crates/scenes/src/inverse/": ["linearisation"],
    "crates/scenes/src/modes/unfit.rs": ["drives", "rough"],
    "crates/scenes/src/inductances.rs": ["drives"],
    "crates/scenes/src/regulator/": ["regulator"],
    "crates/scenes/src/ensemble/": ["members"],
    "crates/scenes/src/modes/contacts.rs": ["rough"],
    "crates/scenes/src/modes/touch.rs": ["rough"],
    "crates/scenes/src/modes/touches.rs": ["rough"],
    "crates/scenes/src/modes/combinations.rs": ["rough"],
    "crates/scenes/src/modes/exact.rs": ["rough"],
    "crates/scenes/src/hybrid.rs": ["rough"],
    "crates/scenes/src/modes/expansion/impact_law.rs": ["rough", "scenes"],
    "crates/scenes/src/modes/expansion/impulses.rs": ["rough"],
    "crates/scenes/src/modes/algebraic.rs": ["drives"],
    "crates/scenes/src/modes/expansion/elimination.rs": ["drives"],
    "crates/scenes/src/modes/": ["hybrid::friction", "hybrid::shares", "hybrid"],
    "crates/scenes/src/implicit/": ["solved"],
    "derivations/studies/src/closed_forms/": ["runs::closed_forms"],
    "crates/series/src/batch/": ["recurrences::known"],
    "crates/series/src/small/": ["recurrences::known"],
    "crates/series/src/permuting/": ["recurrences::known"],
    "crates/series/src/stored.rs": ["recurrences::known"],
    "crates/series/src/stages.rs": ["recurrences::known"],
    "crates/series/src/layout.rs": ["recurrences::known"],
    "crates/series/src/sum.rs": ["recurrences::known"],
    "crates/field/src/sincos_f64.rs": ["laws::fields"],
    "crates/field/src/sincos_double_double.rs": ["field"],
    "crates/integrators/src/batch/lockstep.rs": ["runs::ensembles"],
    "crates/motor/src/fixed_angle_laws.rs": ["machines::text_motors"],
    "crates/symbolic/src/parse/": ["expressions::parsing"],
    "crates/symbolic/src/print/": ["expressions::printing"],
    "crates/charts/src/text/": ["charts"],
}
# modules that take longer than all others of their crate's program: asked only of what these do not notice
SLOW = {"principles": ["chains"]}
# quick to build: only what proves and what multiplies big numbers is optimised, and a little all that runs whole motions
OPTIMISED = ["dalembert-algebra", "dalembert-symbolic", "dalembert-series", "dalembert-field"]
# crates whose own tests prove and multiply big numbers too
PROVING = {"model", "scenes"}
# what is built once for all gains nothing by parts, which do not survive a kill
SETTINGS = {"CARGO_PROFILE_DEV_DEBUG": "0", "CARGO_INCREMENTAL": "0", "CARGO_TARGET_DIR": str(COPY / "target")}
# that a law fails is enough: no search for its smallest failure; pages stay behind, and are not compared
RUNNING = {"CARGO_MANIFEST_DIR": str(COPY), "PROPTEST_MAX_SHRINK_ITERS": "0", "INSTA_FORCE_PASS": "1", "INSTA_UPDATE": "no",
           # the bodies of one function side by side need more than a thread has
           "RUST_MIN_STACK": str(1 << 27)}
# what a program took of the project itself, in seconds: ten times as long, and it does not end
TOOK: dict[str, float] = {}
# told of a program that does not come to its tests, by a panic or by an endless loop
STOPPED = ("stops", "does not end")


@dataclass(frozen=True)
class Mutant:
    """One file of the project, broken in one place; the reason why nothing can notice it, if there is one."""

    file: str
    name: str
    text: str
    reason: str = ""


@dataclass
class Outcome:
    """What became of one mutant."""

    name: str
    reason: str
    claims: list[str] = field(default_factory=list)
    laws: list[str] = field(default_factory=list)
    compiles: bool = True

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


def prepare_together(mutants: list[Mutant]) -> list[int]:
    """As many of these as compile together into the copy; which they are, by their numbers from 1."""
    left_out: set[int] = set()
    while True:
        held: dict[str, list[int]] = {}
        for file in dict.fromkeys(mutant.file for mutant in mutants):
            numbered = [(number, mutant.text) for number, mutant in enumerate(mutants, 1)
                        if mutant.file == file and number not in left_out]
            text, held[file] = together.joined((ROOT / file).read_text(), numbered)
            if (COPY / file).read_text() != text:
                (COPY / file).write_text(text)
        wrong: set[int] = set()
        for file, line in errors([mutant.file for mutant in mutants]):
            number = together.holds((COPY / file).read_text(), line)
            wrong |= {number} if number else set(held.get(file, []))
        if not wrong:
            return sorted(number for of_file in held.values() for number in of_file)
        left_out |= wrong


def errors(files: list[str]) -> set[tuple[str, int]]:
    """In which lines of which files the copy does not compile. A body breaks no crate above its own: those of these files are asked."""
    packages = [word for crate in crates_of(files) for word in ("--package", f"dalembert-{crate}")]
    command = ["cargo", "check", "--quiet", "--keep-going", "--message-format=json", "--lib", *packages]
    done = subprocess.run(command, cwd=COPY, env=os.environ | SETTINGS, capture_output=True, text=True)
    said = [json.loads(line).get("message", {}) for line in done.stdout.splitlines() if line.startswith("{")]
    spans = [span for message in said if message.get("level") == "error" for span in message["spans"]]
    return {(span["file_name"], span["line_start"]) for span in spans if span["is_primary"]}


def crates_of(files: list[str]) -> list[str]:
    """The crates in which these files lie."""
    return sorted({Path(file).parts[1] for file in files})


def folder_of(crate: str) -> Path:
    """Where a crate lies."""
    return next(folder for part in ("crates", "derivations") if (folder := ROOT / part / crate).is_dir())


def crates_with(crates: list[str], tests: list[str]) -> list[str]:
    """These crates, and those whose own tests are among these."""
    wanted = {program_of(test) for test in tests}
    folders = [path for part in ("crates", "derivations") for path in sorted((ROOT / part).iterdir()) if path.is_dir()]
    return sorted({*crates, *(path.name for path in folders if wanted & (programs_in(path / "tests") | {path.name}))})


def laws_of(crates: list[str]) -> list[str]:
    """The laws, and the programs that test these crates alone, with their slow modules."""
    own = [test for crate in crates for test in sorted(programs_in(folder_of(crate) / "tests"))]
    return [*LAWS, *own, *(f"{test}::{module}" for test in own for module in SLOW.get(test, []))]


def build(tests: list[str], crates: list[str]) -> dict[str, Path] | None:
    """These test programs by name, of the project and of these crates; None where the copy does not compile. What a crate
    tests within itself goes by the crate's name."""
    own = {test for crate in crates for test in programs_in(folder_of(crate) / "tests")}
    within = [f"dalembert-{test}" for test in tests if test in crates]
    beside = [test for test in tests if test not in crates]
    packages = [*(f"dalembert-{crate}" for crate in crates), *(["dalembert-derivations"] if set(beside) - own else [])]
    level = {"CARGO_PROFILE_DEV_OPT_LEVEL": "1" if set(tests) & set(RUNS) else "0"}
    found: dict[str, Path] = {}
    for of_packages, chosen in [(within, ["--lib"]), (packages, [word for test in beside for word in ("--test", test)])]:
        if not of_packages or not chosen:
            continue
        command = ["cargo", "test", "--quiet", "--no-run", "--message-format=json", *chosen]
        command += [word for name in of_packages for word in ("--package", name)]
        # what a crate tests alone is small, unless it proves
        proves = "dalembert-derivations" in of_packages or PROVING & set(crates)
        optimised = OPTIMISED if proves else []
        command += [word for crate in optimised for word in ("--config", f"profile.dev.package.{crate}.opt-level=2")]
        done = subprocess.run(command, cwd=COPY, env=os.environ | SETTINGS | level, capture_output=True, text=True)
        if done.returncode != 0:
            return None
        every = re.findall(r'"executable":"([^"]+/deps/([a-z_]+)-[0-9a-f]+)"', done.stdout)
        found |= {name.removeprefix("dalembert_"): Path(path) for path, name in every}
    return found


def program_of(test: str) -> str:
    """The program that holds a test: a module is told by the program's name and its own."""
    return test.split("::")[0]


def near(file: str) -> list[str]:
    """The tests whose subject a file is, where that is said."""
    return next((programs for start, programs in SUBJECT_OF.items() if file.startswith(start)), [])


def failures(test: str, programs: dict[str, Path], number: int) -> list[str]:
    """The names of the tests that fail with a mutant, in their order; the program's where it does not come to its tests."""
    program, *modules = test.split("::")
    command = [programs[program], "--test-threads=2", *(f"{module}::" for module in modules)]
    if not modules:
        command += [word for module in SLOW.get(program, []) for word in ("--skip", f"{module}::")]
    seconds = 10 * TOOK[test] + 30 if test in TOOK else None
    running = os.environ | RUNNING | {together.VARIABLE: str(number)}
    begin = time.monotonic()
    try:
        done = subprocess.run(command, cwd=COPY, env=running, capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return [f"{test} {STOPPED[1]}"]
    if number == 0:
        TOOK[test] = time.monotonic() - begin
    names = re.findall(r"^test (\S.*?)\s+\.\.\. FAILED$", done.stdout, re.MULTILINE)
    return names or ([f"{test} {STOPPED[0]}"] if done.returncode != 0 else [])


class Examined:
    """The copy as it stands, and what its tests say of each mutant in it. Programs are built when they are first asked."""

    def __init__(self, mutants: list[Mutant], sound: bool) -> None:
        """Sound: it holds no mutant unless one is chosen."""
        self.near = sorted({test for mutant in mutants for test in near(mutant.file)})
        self.sound, self.crates = sound, crates_with(crates_of([mutant.file for mutant in mutants]), self.near)
        self.programs: dict[str, Path] = {}
        self.known: set[str] = set()

    def has(self, tests: list[str]) -> bool:
        """Whether the programs of these tests compile. Each test is run once without any mutant."""
        wanted = [test for test in tests if test not in self.known]
        for slow in (False, True):
            some = [test for test in wanted if (program_of(test) in RUNS) == slow]
            missing = sorted({program_of(test) for test in some} - set(self.programs))
            programs = build(missing, self.crates) if missing else {}
            if programs is None:
                return False
            self.programs |= programs
            for test in some if self.sound else []:
                if failed := failures(test, self.programs, 0):
                    sys.exit(f"without any mutant: {failed}")
            self.known |= set(some)
        return True

    def outcome(self, mutant: Mutant, number: int, alone: bool = False) -> Outcome:
        """Alone: by nothing but the programs whose subject the file is, where that is said."""
        outcome = Outcome(mutant.name, mutant.reason)
        of_subject, others = near(mutant.file), [LEDGER, *laws_of(crates_of([mutant.file]))]
        stages = [(of_subject, self.near), (others, [LEDGER, *laws_of(self.crates)]), (RUNS, RUNS)]
        for tests, with_them in stages[:1] if alone else stages:
            if not self.has(with_them if tests else []):
                outcome.compiles = False
                break
            for test in tests:
                failed = failures(test, self.programs, number)
                if test == LEDGER:
                    outcome.claims += [claim.removeprefix("konosevich2022/") for claim in failed]
                else:
                    outcome.laws += [law.split("::")[-1].replace("_", " ") for law in failed]
            if outcome.caught():
                break
        return outcome


def examined(mutants: list[Mutant], alone: bool = False) -> Iterator[tuple[Mutant, Outcome]]:
    """Each mutant with what became of it: first those that are built together, then the others one by one."""
    prepare()
    held = prepare_together(mutants)
    copy = Examined([mutants[number - 1] for number in held], sound=True)
    # all the others are built for what is left by those whose subject it is
    left = []
    for number in held:
        outcome = copy.outcome(mutants[number - 1], number, alone=True)
        if outcome.caught() or alone and near(mutants[number - 1].file):
            yield mutants[number - 1], outcome
        else:
            left.append(number)
    for number in left:
        yield mutants[number - 1], copy.outcome(mutants[number - 1], number)
    prepare()
    for number, mutant in enumerate(mutants, 1):
        if number not in held:
            (COPY / mutant.file).write_text(mutant.text)
            yield mutant, Examined([mutant], sound=False).outcome(mutant, number, alone and bool(near(mutant.file)))
            shutil.copyfile(ROOT / mutant.file, COPY / mutant.file)


def examine_generated(most: int, words: list[str]) -> None:
    """Breaks files by rule, and tells what nothing notices."""
    known = [path.relative_to(ROOT) for part in ("crates", "derivations") for path in sorted((ROOT / part).rglob("*.rs"))]
    files = [str(path) for path in known if "tests" not in path.parts and any(word in str(path) for word in words)]
    every = [Mutant(file, *mutant) for file in files for mutant in generated.mutants(ROOT / file)]
    chosen = generated.spread(every, most)
    print(f"{len(chosen)} of {len(every)} mutants of {len(files)} files", flush=True)
    verdicts: Counter[str] = Counter()
    for number, (mutant, outcome) in enumerate(examined(chosen, alone=True), 1):
        verdicts[outcome.verdict()] += 1
        print(f"{number:3}/{len(chosen)} {outcome.verdict():17} {mutant.file}: {mutant.name}", flush=True)
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
    """A page for the mutants of each crate, and of each study."""
    TABLES.mkdir(exist_ok=True)
    for page in dict.fromkeys(page_of(file) for file, _ in listed):
        (TABLES / f"{page}.md").write_text(table([(file, name) for file, name in listed if page_of(file) == page], rows))


def page_of(file: str) -> str:
    """The page on which the mutants of a file stand: its crate's, its study's, or its folder's in a crate with many."""
    parts = Path(file).parts
    if parts[1] == "studies":
        return Path(parts[3]).stem
    return f"{parts[1]}_{parts[3]}" if parts[1] in BY_FOLDER and len(parts) > 4 else parts[1]


def listed(words: list[str]) -> tuple[list[tuple[str, str]], list[Mutant]]:
    """All mutants of the list by file and name, and those whose file or name contains a word."""
    mutants = tomllib.loads((Path(__file__).parent / "mutants.toml").read_text())
    every, chosen = [], []
    for file, of_file in mutants.items():
        sound = (ROOT / file).read_text()
        for name, (old, new, *reason) in of_file.items():
            every.append((file, name))
            if words and not any(word in f"{file} {name}" for word in words):
                continue
            if (count := sound.count(old)) != 1:
                sys.exit(f"{file}: {name}: `{old}` stands there {count} times, not once")
            chosen.append(Mutant(file, name, sound.replace(old, new), *reason))
    return every, chosen


def main() -> None:
    words = sys.argv[1:]
    if words[:1] == ["--generate"]:
        return examine_generated(int(words[1]), words[2:])
    every, chosen = listed(words)
    begin = time.monotonic()
    outcomes: dict[str, list[Outcome]] = {}
    for number, (mutant, outcome) in enumerate(examined(chosen), 1):
        outcomes.setdefault(mutant.file, []).append(outcome)
        tally = f"{len(outcome.claims)} claims, {len(outcome.laws)} laws"
        print(f"{number:3}/{len(chosen)} {time.monotonic() - begin:5.0f} s  {outcome.verdict():10} {mutant.file}: {mutant.name}: {tally}", flush=True)
        if words:
            print("".join(f"        {catcher}\n" for catcher in outcome.claims + outcome.laws), end="", flush=True)
    write_tables(every, known_rows() | rows(outcomes))
    wrong = [f"{file}: {outcome.name}: {outcome.verdict()}" for file, of_file in outcomes.items()
             for outcome in of_file if not outcome.right()]
    sys.exit("\n".join(wrong) or None)


if __name__ == "__main__":
    main()
