"""Mutants that nobody wrote: every sign, factor of two, term, index and angle of a file's code, broken once."""

import re
from pathlib import Path

OPERAND = r"-?[\w.:]+(?:\([^()]*\))?(?:\[[^\[\]]*\])?(?:\.\w+(?:\([^()]*\))?)*"
RULES = [
    ("sign", r"(?<=[\w)\]]) \+ (?=[\w(&*-])", " - "),
    ("sign", r"(?<=[\w)\]]) - (?=[\w(&*])", " + "),
    ("sign", r" \+= ", " -= "),
    ("sign", r" -= ", " += "),
    ("factor 2", r"\.half\(\)", ""),
    ("factor 2", r"\b(?:2\.0|0\.5) \* ", ""),
    ("term dropped", rf"(?<=[\w)\]]) [+-] {OPERAND}(?: [*/] {OPERAND})*(?=[,;)\]]|$)", ""),
    ("swapped index", r"\[0\]", "[1]"),
    ("swapped index", r"\[1\]", "[0]"),
    ("swapped index", r"\[i\]\[j\]", "[j][i]"),
    ("exchanged angle", r"\.cos\b", ".sin"),
    ("exchanged angle", r"\.sin\b", ".cos"),
]


def code(line: str) -> bool:
    """Whether a line computes: no comment, no attribute, no bound of a type, nothing that is said."""
    bare = line.strip()
    types = re.match(r"(?:pub |impl|where|use |fn |type |trait |#|//|\w+: [A-Z][\w<>]* \+)", bare)
    return bool(bare) and not types and '"' not in bare and "'static" not in bare


def mutants(file: Path) -> list[tuple[str, str]]:
    """(what is broken where, the text of the whole file with it), line by line; tests are left as they are."""
    text = file.read_text()
    end = text.find("#[cfg(test)]")
    found, start = [], 0
    for number, line in enumerate(text.splitlines(keepends=True), 1):
        if end >= 0 and start >= end:
            break
        for what, pattern, instead in RULES if code(line) else []:
            for place in re.finditer(pattern, line.rstrip("\n")):
                broken = line[: place.start()] + instead + line[place.end() :]
                name = f"line {number}, {what}: `{line.strip()}` -> `{broken.strip()}`"
                found.append((name, text[:start] + broken + text[start + len(line) :]))
        start += len(line)
    return found


def spread(all_of_them: list, most: int) -> list:
    """So many at most, evenly spread: the same ones every time."""
    step = max(1.0, len(all_of_them) / most)
    return [all_of_them[int(step * k)] for k in range(min(most, len(all_of_them)))]
