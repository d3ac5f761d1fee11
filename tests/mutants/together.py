"""Many mutants in one build: each function holds its sound body and its broken ones, and a variable says which runs.

A build takes minutes and the tests of a law seconds, so that most mutants need no build of their own. One does where what
it breaks is no part of a function's body: a constant, a type, what a macro writes, or a function that must be known to the
compiler, or returns what only the compiler can name.
"""

import re
from pathlib import Path

# the number of the mutant that runs; 0 or nothing: none
VARIABLE = "BROKEN"
CHOICE = """
fn broken_here() -> usize {
    static CHOSEN: std::sync::OnceLock<usize> = std::sync::OnceLock::new();
    *CHOSEN.get_or_init(|| std::env::var("BROKEN").ok().and_then(|number| number.parse().ok()).unwrap_or(0))
}
"""
# comments, strings and letters, in which a brace is no brace
QUIET = re.compile(r'//[^\n]*|/\*.*?\*/|r(#*)".*?"\1|b?"(?:\\.|[^"\\])*"|b?\'(?:\\[^\']+|[^\'\\])\'', re.DOTALL)
OPENING, CLOSING = "({[", ")}]"


def blanked(text: str) -> str:
    """Of the same length, without what is only said."""
    return QUIET.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)


def closing(text: str, start: int) -> int:
    """Where what opens at a place closes."""
    depth = 0
    for place in range(start, len(text)):
        depth += (text[place] in OPENING) - (text[place] in CLOSING)
        if depth == 0:
            return place
    return len(text)


def bodies(text: str) -> list[tuple[int, int]]:
    """The bodies of functions that may hold several, each from its brace to the one that closes it."""
    code = blanked(text)
    macros = [(found.start(), closing(code, found.end() - 1)) for found in re.finditer(r"macro_rules!\s*\w+\s*[({]", code)]
    found = []
    for head in re.finditer(r"\b(const\s+)?(?:unsafe\s+)?fn\s+\w+", code):
        place = head.end()
        while place < len(code) and code[place] not in "{;":
            place = closing(code, place) + 1 if code[place] in "([" else place + 1
        returned = code[head.end() : place].rpartition("->")[2] if "->" in code[head.end() : place] else ""
        named = head.group(1) is None and not re.search(r"\bimpl\b", returned)
        if code[place : place + 1] == "{" and named and not any(a <= head.start() < b for a, b in macros):
            found.append((place, closing(code, place)))
    return found


def place_of(sound: str, broken: str) -> tuple[int, int]:
    """Where a text differs from the sound one."""
    start = next((k for k, (a, b) in enumerate(zip(sound, broken)) if a != b), min(len(sound), len(broken)))
    end = 0
    while end < min(len(sound), len(broken)) - start and sound[-1 - end] == broken[-1 - end]:
        end += 1
    return start, len(sound) - end


def not_inlined(before: str) -> str:
    """What stands before a body, where its function need not be inlined: within each other, bodies would multiply."""
    head = list(re.finditer(r"\bfn\s+\w+", blanked(before)))[-1].start()
    own = max(before.rfind(end, 0, head) for end in ("}\n", ";\n", "{\n"))
    return before[: own + 1] + before[own + 1 : head].replace("#[inline(always)]", "#[inline]") + before[head:]


def joined(sound: str, mutants: list[tuple[int, str]]) -> tuple[str, list[int]]:
    """The text of a file that holds as many of these as it can, each a number and the broken text, and which it holds."""
    of_body: dict[tuple[int, int], list[tuple[int, str]]] = {}
    for number, broken in mutants:
        start, end = place_of(sound, broken)
        around = [body for body in bodies(sound) if body[0] < start and end <= body[1]]
        if around:
            # the outermost: bodies that are exchanged then lie in none that is
            body = min(around)
            text = broken[body[0] + 1 : body[1] + len(broken) - len(sound)]
            of_body.setdefault(body, []).append((number, text))
    text = sound
    for (begin, end), variants in sorted(of_body.items(), reverse=True):
        arms = "".join(f"{number} => {{{body}\n}}\n" for number, body in variants)
        text = f"{not_inlined(text[:begin])}{{ match broken_here() {{\n{arms}_ => {{{sound[begin + 1 : end]}\n}}\n}} }}{text[end + 1 :]}"
    held = [number for variants in of_body.values() for number, _ in variants]
    return (text + CHOICE if held else sound), held


def holds(text: str, line: int) -> int | None:
    """The mutant to which a line of such a text belongs."""
    for before in reversed(text.splitlines()[:line]):
        if before.startswith("_ => {"):
            return None
        if arm := re.match(r"(\d+) => \{", before):
            return int(arm.group(1))
    return None
