"""The claims of a paper with their verdicts."""

from __future__ import annotations

import json
import os
from collections import Counter
from dataclasses import dataclass
from html import escape
from typing import Any

from ._apart import apart
from ._arguments import shown
from ._html import COLOURS, formula, table
from ._warnings import warn

__all__ = ["Claim", "Correction", "Ledger", "Unread", "judge"]


@dataclass(frozen=True)
class Correction:
    """A smallest edit of a refuted claim that makes it true.

    says: the edit in a sentence. formula: the corrected formula in LaTeX. verdict, sentence: that the corrected formula holds, and on what ground.
    """

    says: str
    formula: str
    verdict: str
    sentence: str


@dataclass(frozen=True)
class Claim:
    """A claim of a paper with its verdict.

    name: its id, such as paper/eq5. kind: equation of motion, identity, ... says: the claim in a sentence of the file. printed: the formula in LaTeX
    as printed; read: the same as it was read. given: hypotheses of the file. verdict: proved, refuted, enclosed, identified, undecided or
    undefined; sentence: on what ground. requires: conditions under which it holds. allowed: the hypotheses beside the formula. counterexample: exact
    numbers at which it fails, by names; left and right: the values of both sides there. missing: the terms that the right side lacks, text and LaTeX.
    corrections: smallest edits that make it true, all of one size. unexpected: why this is not the verdict that the file expects.
    """

    name: str
    kind: str
    says: str
    printed: str
    read: list[str]
    given: list[str]
    verdict: str
    sentence: str
    requires: list[str]
    allowed: str
    counterexample: dict[str, str]
    left: str | None
    right: str | None
    missing: tuple[str, str] | None
    corrections: list[Correction]
    note: str
    expected: str | None
    unexpected: str | None

    @property
    def correction(self) -> str | None:
        """The corrected formula in LaTeX, the first where there are several; None where there is none."""
        return self.corrections[0].formula if self.corrections else None

    @property
    def fails(self) -> bool:
        """Whether the verdict is not the one that the file expects; where it expects none, whether the claim was not shown to hold."""
        if self.expected is not None or self.unexpected is not None:
            return self.unexpected is not None
        return self.verdict not in ("proved", "enclosed", "identified", "tested")

    def __str__(self) -> str:
        lines = [f"{self.name}: {self.verdict}: {self.sentence}", f"  printed    {self.printed}"]
        if self.counterexample:
            lines.append("  at         " + ", ".join(f"{name} = {value}" for name, value in self.counterexample.items()))
        if self.missing:
            lines.append(f"  missing    {self.missing[0]}")
        lines += [f"  corrected  {one.formula}  ({one.says})" for one in self.corrections]
        return "\n".join(lines)


@dataclass(frozen=True)
class Unread:
    """A claim that was not judged, since its formula, its hypotheses or its table in the file has a fault.

    name: its id. printed: the formula in LaTeX as printed. line: the line of the text at which the fault stands, from 1. fault: the fault in a
    sentence. accepted: the input that would be accepted, if one is named.
    """

    name: str
    printed: str
    line: int
    fault: str
    accepted: str | None

    def __str__(self) -> str:
        told = f"{self.name}: not read: line {self.line}: {self.fault}"
        return told if self.accepted is None else f"{told}; accepted: {self.accepted}"


class Ledger(list[Claim]):
    """The claims of a paper, a list of Claim that a notebook shows as a table.

    title, citation, summary: as the paper's file has them. unread: the claims that were not judged. broken_off: why claims at the end are missing;
    None where all are there. ledger["eq5"] is the claim whose name ends so.
    """

    def __init__(
        self, claims: list[Claim], title: str, citation: str, summary: str, unread: list[Unread], broken_off: str | None
    ) -> None:
        super().__init__(claims)
        self.title, self.citation, self.summary, self.unread, self.broken_off = title, citation, summary, unread, broken_off

    @property
    def failed(self) -> list[Claim]:
        """The claims whose verdict is not the one that the file expects, or, where it expects none, that were not shown to hold."""
        return [claim for claim in self if claim.fails]

    @property
    def counts(self) -> dict[str, int]:
        """The number of claims with each verdict."""
        return dict(Counter(claim.verdict for claim in self))

    def __getitem__(self, place: Any) -> Any:
        if not isinstance(place, str):
            return super().__getitem__(place)
        found = [claim for claim in self if claim.name == place or claim.name.endswith("/" + place) or claim.name.partition("/")[2] == place]
        if len(found) != 1:
            what = f"no claim is called {place!r}" if not found else f"{place!r} may be {' or '.join(claim.name for claim in found)}"
            raise KeyError(f"{what}; there are {', '.join(claim.name for claim in self) or 'no claims'}")
        return found[0]

    def _counted(self) -> str:
        counts = [f"{count} {verdict}" for verdict, count in self.counts.items()]
        if self.unread:
            counts.append(f"{len(self.unread)} not read")
        told = f"{len(self) + len(self.unread)} claims: " + ", ".join(counts)
        return told if self.broken_off is None else f"{told}; {self.broken_off}"

    def __repr__(self) -> str:
        return "\n".join([self.title, *map(str, self), *map(str, self.unread), self._counted()])

    def _repr_html_(self) -> str:
        rows = []
        for claim in self:
            ground = escape(claim.sentence)
            if claim.requires:
                ground += "<br>where " + escape(", ".join(claim.requires))
            if claim.counterexample:
                ground += "<br><small>at " + escape(", ".join(f"{name} = {value}" for name, value in claim.counterexample.items())) + "</small>"
            if claim.missing:
                ground += f"<br>missing: {formula(claim.missing[1])}"
            for correction in claim.corrections:
                ground += f"<br>corrected: {formula(correction.formula)}<br><small>{escape(correction.verdict)}: {escape(correction.sentence)}</small>"
            said = f"<br>{escape(claim.says)}" if claim.says else ""
            rows.append([escape(claim.name) + said, formula(claim.printed), (claim.verdict, COLOURS.get(claim.verdict)), ground])
        for claim in self.unread:
            ground = escape(f"line {claim.line}: {claim.fault}")
            rows.append([escape(claim.name), f"<code>{escape(claim.printed)}</code>", ("not read", None), ground])
        head = f"<b>{escape(self.title)}</b><br>{escape(self.citation)}<br>{escape(self._counted())}"
        return head + table(["claim", "printed", "verdict", "ground"], rows)


def judge(paper: str | os.PathLike[str], *, seconds: float | None = 300.0) -> Ledger:
    """Judges the claims of a paper: proved, or refuted with an exact counterexample and the smallest edit that makes the formula true.

    paper: the name of a file, or the text of one (whatever has more than a line); files that a text names lie beside the working directory.
    seconds: claims that have no verdict by then are missing, and `broken_off` says so; no correction is looked for in the last half second. None for
    no limit. Ctrl-C breaks it off.

    A claim with a fault is not judged: it stands in `unread` of the result, and a warning tells the fault. A fault of the system or of a letter
    raises a ModelError.
    """
    if isinstance(paper, str) and "\n" in paper:
        path, text = "paper.toml", paper
    else:
        path, text = _path(paper), None
    heard: list[Any] = []
    broken_off = None
    try:
        found = apart("judge", (path, text), seconds, heard.append)
    except TimeoutError as error:
        if not heard:
            raise
        found = {**heard[0], "findings": heard[1:], "unread": []}
        broken_off = f"{error}; {found['claims'] - len(heard) + 1} of {found['claims']} claims have no verdict"
    claims = [_claim(*finding) for finding in found["findings"]]
    unread = [_unread(claim) for claim in found["unread"]]
    for claim in unread:
        warn(str(claim))
    return Ledger(claims, found["title"], found["citation"], found["summary"], unread, broken_off)


def _path(paper: Any) -> str:
    accepted = "the name of a file, or the text of one, is accepted"
    try:
        path = os.fsdecode(paper)
    except TypeError:
        raise TypeError(f"`paper` is {shown(paper)}; {accepted}") from None
    if not path.strip():
        raise ValueError(f"`paper` is empty; {accepted}")
    return path


def _unread(written: str) -> Unread:
    told = json.loads(written)
    error = told["error"]
    return Unread(told["id"], told["printed"], error["line"], error["says"], error["accepted"])


def _claim(written: str, unexpected: str | None) -> Claim:
    told = json.loads(written)
    missing = (told["missing"], told["missing_latex"]) if told["missing"] else None
    corrections = [Correction(one["says"], one["formula"], one["verdict"], one["evidence"]) for one in told["corrections"]]
    return Claim(
        name=told["id"],
        kind=told["kind"],
        says=told["says"],
        printed=told["printed"],
        read=told["read"],
        given=told["given"],
        verdict=told["verdict"],
        sentence=told["evidence"],
        requires=told["requires"] + told["signs"],
        allowed=told["allowed"],
        counterexample=told["counterexample"],
        left=told["left"],
        right=told["right"],
        missing=missing,
        corrections=corrections,
        note=told["note"],
        expected=told["expected"],
        unexpected=unexpected,
    )
