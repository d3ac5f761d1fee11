"""A certificate as it is read: every place is looked at before anything is computed."""

import json
from dataclasses import dataclass
from pathlib import Path

FORMAT = 1
BINARY = {"+", "-", "*", "/", "atan2"}
UNARY = {"neg", "cos", "sin", "root"}
DOUBLE = {"exp", "ln", "tanh"}
RELATIONS = {"=", "!=", ">", ">=", "rate"}
PROOFS = {
    *("identity", "combination", "signs", "written_signs", "products", "real_roots", "counterexample"),
    *("example", "no_root", "undefined", "stability", "minimum", "enclosure", "excluded"),
}

MINORS = ("inertia", "leading", "principal")


class Malformed(Exception):
    """The file is no certificate of this format."""


@dataclass(frozen=True)
class Relation:
    """`left` beside `right`: =, !=, >, >=; `rate` says that the rate of `left` is `right`."""

    kind: str
    left: int
    right: int


@dataclass(frozen=True)
class Solve:
    """Letters with the values that equalities of `given` leave them."""

    letters: tuple
    values: tuple
    by: tuple


@dataclass(frozen=True)
class Rewrite:
    """A power of a letter by an equality of `given`."""

    letter: int
    power: int
    by: int


@dataclass(frozen=True)
class Part:
    """A statement with its proof."""

    given: tuple
    steps: tuple
    rates: tuple
    then: tuple
    proof: dict


@dataclass(frozen=True)
class Claim:
    """A claim with its verdict."""

    id: str
    verdict: str
    program: tuple
    parts: tuple
    none: str


def place(value, end, what):
    """A place in a list of `end` entries."""
    if type(value) is not int or not 0 <= value < end:
        raise Malformed(f"{what}: {value!r} is no place below {end}")
    return value


def operation(entry, here):
    """An operation whose operands stand before it."""
    name, *rest = entry
    if name in ("const", "letter") and len(rest) == 1 and isinstance(rest[0], str):
        return (name, rest[0])
    if name == "function" and len(rest) == 2 and isinstance(rest[0], str):
        return (name, rest[0], place(rest[1], here, name))
    if name == "pow" and len(rest) == 2 and type(rest[1]) is int and rest[1] >= 2:
        return (name, place(rest[0], here, name), rest[1])
    if name in UNARY and len(rest) == 1 or name in BINARY | DOUBLE and len(rest) == 2:
        return (name, *(place(each, here, name) for each in rest))
    raise Malformed(f"entry {here} of the program: {entry!r}")


def relation(entry, size):
    """A relation between two entries."""
    if entry["is"] not in RELATIONS:
        raise Malformed(f"relation {entry['is']!r}")
    return Relation(entry["is"], place(entry["left"], size, "left"), place(entry["right"], size, "right"))


def step(entry, program, given):
    """A step; what it names are letters and equalities."""
    size = len(program)

    def letter(value):
        if program[place(value, size, "letter")][0] != "letter":
            raise Malformed(f"entry {value} is no letter")
        return value

    def equality(value):
        if given[place(value, len(given), "by")].kind != "=":
            raise Malformed(f"given {value} is no equality")
        return value

    if entry["step"] == "solve":
        letters = tuple(letter(each) for each in entry["letters"])
        values = tuple(place(each, size, "value") for each in entry["values"])
        if len(letters) != len(values) or len(set(letters)) != len(letters):
            raise Malformed("a step has one value for each of different letters")
        return Solve(letters, values, tuple(equality(each) for each in entry["by"]))
    if entry["step"] == "rewrite" and type(entry["power"]) is int and entry["power"] >= 1:
        return Rewrite(letter(entry["letter"]), entry["power"], equality(entry["by"]))
    raise Malformed(f"step {entry!r}")


def named(proof, size, given):
    """Everything that a proof names is there."""
    entries = [proof[key] for key in ("unknown", "divisor", "root", "scale", "printed") if key in proof]
    for key in ("positive", "equations", "coordinates", "speeds", "accelerations", "coefficients", *MINORS):
        entries += proof.get(key, ())
    entries += [each for pair in proof.get("point", ()) for each in pair]
    relations = []
    for one in proof.get("combinations", ()):
        relations += list(one["multiplier"]) + [by for by, _ in one["cofactors"]]
        entries += [cofactor for _, cofactor in one["cofactors"]] + [each for each in (one["factor"],) if each is not None]
    for one in proof.get("products", ()):
        entries += [one["number"], *one["roots"], *one["squares"]]
        for each in one["of"]:
            # the opposite of the conclusion stands behind the last one
            place(each, given + 1, "proof")
    if "ratio" in proof:
        ratio, square = proof["ratio"]
        entries.append(ratio)
        relations += [square[0]] if square is not None else []
    for each in entries:
        place(each, size, "proof")
    for each in relations:
        place(each, given, "proof")


def part(entry, program):
    """A part of a claim."""
    size = len(program)
    given = tuple(relation(each, size) for each in entry["given"])
    proof = entry["proof"]
    if proof["by"] not in PROOFS:
        raise Malformed(f"proof {proof['by']!r}")
    named(proof, size, len(given))
    for each in proof.get("implied", ()):
        part(each, program)
    rates = tuple((place(letter, size, "rate"), place(rate, size, "rate")) for letter, rate in entry.get("rates", ()))
    if any(program[letter][0] != "letter" for letter, _ in rates):
        raise Malformed("what has a rate is a letter")
    then = tuple(relation(each, size) for each in entry["then"])
    if not then:
        raise Malformed("a part concludes nothing")
    if any(each.kind == "rate" for each in given):
        raise Malformed("a rate is not presupposed")
    return Part(given, tuple(step(each, program, given) for each in entry["steps"]), rates, then, proof)


def claim(entry):
    """A claim of a file."""
    program = []
    try:
        for each in entry.get("program", ()):
            program.append(operation(each, len(program)))
        parts = tuple(part(each, program) for each in entry.get("parts", ()))
        return Claim(entry["id"], entry["verdict"], tuple(program), parts, entry.get("none", ""))
    except (KeyError, TypeError, ValueError, IndexError) as fault:
        raise Malformed(f"{entry.get('id', 'a claim')}: {fault!r}") from fault


def read(path):
    """The key of a paper and the entries of its claims."""
    with Path(path).open(encoding="utf-8") as file:
        content = json.load(file)
    if content.get("format") != FORMAT:
        raise Malformed(f"{path}: format {content.get('format')!r}, and this checker reads {FORMAT}")
    return content["paper"], content["claims"]
