"""A claim with its parts, and what the checker says of it."""

from dataclasses import dataclass

from .certificate import Malformed, claim as read_claim
from .evaluation import NotExpressible, Undefined
from .part_check import EXACT, TESTED, PartCheck, Rejected
from .prime_field import TooHigh
from .angles import Finer
from .proofs import SHOWS, show
from .ring import Full

ACCEPTED = "accepted"
CONFIRMED = "confirmed"
NONE = "none"
REJECTED = "rejected"
ATTEMPTS = 40
MOST_ROOM = 16


@dataclass
class Outcome:
    """What was found: exactly, or by identity testing with the logarithm of the probability of error."""

    id: str
    found: str
    how: str = EXACT
    error: float = None
    why: str = ""


def check_claim(entry, exact):
    """Repeats the proof of a claim. `exact` expands every difference; else differences are looked at in prime fields."""
    try:
        claim = read_claim(entry)
    except Malformed as fault:
        return Outcome(str(entry.get("id")), REJECTED, why=str(fault))
    if not claim.parts:
        found = NONE if claim.none else REJECTED
        return Outcome(claim.id, found, why=claim.none or "neither a certificate nor a reason")
    shows = SHOWS.get(claim.verdict, set())
    outcome = Outcome(claim.id, CONFIRMED if claim.verdict in ("refuted", "undefined") else ACCEPTED)
    for part in claim.parts:
        if part.proof["by"] not in shows:
            return Outcome(claim.id, REJECTED, why=f"{part.proof['by']} does not show that a claim is {claim.verdict}")
        try:
            check = checked(claim, part, exact)
        except (Rejected, NotExpressible, Undefined, TooHigh, ZeroDivisionError) as fault:
            return Outcome(claim.id, REJECTED, how=EXACT if exact else TESTED, why=str(fault) or repr(fault))
        if check.how == TESTED:
            outcome.how = TESTED
            outcome.error = check.error if outcome.error is None else max(check.error, outcome.error)
    return outcome


def checked(claim, part, exact):
    """The work on a part, with finer steps of angles and more room as long as they are asked for."""
    parts, room = {}, 1
    for _ in range(ATTEMPTS):
        try:
            check = PartCheck(claim.program, part, exact, parts, room)
            show(check, claim.verdict)
            return check
        except Finer:
            continue
        except Full:
            room *= 2
        if room > MOST_ROOM:
            break
    raise Rejected("the angles of the part have no common steps, or there are too many of them")
