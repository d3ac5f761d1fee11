"""python3 -m verify DIR: checks every file of certificates in a folder and prints what was found."""

import argparse
import os
import sys
import time
from collections import Counter
from pathlib import Path

from .altered import altered
from .certificate import Malformed, read
from .claim_check import ACCEPTED, CONFIRMED, NONE, REJECTED, TESTED
from .pool import check_all

COLUMNS = ("claims", "proved", "tested", "refuted", "none", "rejected")


def column(outcome):
    """The column of the table in which a claim is counted."""
    if outcome.found == ACCEPTED:
        return "tested" if outcome.how == TESTED else "proved"
    return {CONFIRMED: "refuted", NONE: "none", REJECTED: "rejected"}[outcome.found]


def arguments():
    parser = argparse.ArgumentParser(prog="python3 -m verify", description=__doc__)
    parser.add_argument("folder", type=Path, metavar="DIR", help="the folder of `dalembert ledger --certificates DIR`, or one file of it")
    parser.add_argument("--limit", type=float, default=20.0, metavar="SECONDS", help="the time for a claim (20); what is not expanded in it counts as tested")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1, help="processes at work at once (one for each processor)")
    parser.add_argument("--altered", action="store_true", help="checks every claim once more with one conclusion changed, which must be rejected")
    parser.add_argument("--claims", action="store_true", help="prints a line for every claim")
    return parser.parse_args()


def main():
    asked = arguments()
    files = sorted(asked.folder.glob("*.json")) if asked.folder.is_dir() else [asked.folder]
    if not files:
        print(f"error: {asked.folder} holds no file of certificates; one that ledger --certificates wrote is accepted", file=sys.stderr)
        return 2
    print(f"{'paper':<28}" + "".join(f"{name:>10}" for name in COLUMNS) + f"{'seconds':>10}")
    reasons, rejected, errors, slowest = Counter(), [], [], []
    for file in files:
        began = time.monotonic()
        try:
            paper, entries = read(file)
        except (OSError, ValueError, KeyError, Malformed) as fault:
            print(f"error: {file}: {fault}", file=sys.stderr)
            return 2
        results = check_all(entries, asked.workers, asked.limit)
        counted = Counter(column(outcome) for outcome, _ in results)
        counted["claims"] = len(results)
        print(f"{paper:<28}" + "".join(f"{counted[name]:>10}" for name in COLUMNS) + f"{time.monotonic() - began:>10.1f}", flush=True)
        for outcome, seconds in results:
            slowest.append((seconds, outcome.id))
            if asked.claims:
                bound = f" (error below 2^{outcome.error:.0f})" if outcome.error is not None else ""
                print(f"  {column(outcome):<9} {seconds:7.2f} s  {outcome.id}{bound}{': ' if outcome.why else ''}{outcome.why}")
            if outcome.found == NONE:
                reasons[outcome.why] += 1
            if outcome.found == REJECTED:
                rejected.append(outcome)
            if outcome.found == ACCEPTED and outcome.error is not None:
                errors.append(outcome.error)
    accepted = altered_and_accepted(files, asked) if asked.altered else []
    for reason, count in reasons.most_common():
        print(f"{count} without a certificate: {reason}")
    if errors:
        print(f"{len(errors)} accepted by identity testing: for each the probability of error is below 2^{max(errors):.0f}")
    for outcome in rejected:
        print(f"rejected: {outcome.id}: {outcome.why}")
    for outcome in accepted:
        print(f"accepted: {outcome.id}")
    return 1 if rejected or accepted else 0


def altered_and_accepted(files, asked):
    """The claims that are accepted although a conclusion was changed."""
    entries = [entry for file in files for entry in altered(read(file)[1])]
    outcomes = [outcome for outcome, _ in check_all(entries, asked.workers, asked.limit)]
    accepted = [outcome for outcome in outcomes if outcome.found != REJECTED]
    print(f"{len(entries)} claims altered: {len(entries) - len(accepted)} rejected")
    return accepted


if __name__ == "__main__":
    sys.exit(main())
