"""Workers that check claims, each claim with a limit of its time and memory."""

import multiprocessing
import resource
import time
from multiprocessing.connection import wait

from .claim_check import REJECTED, TESTED, Outcome, check_claim

MEMORY = 4 << 30


def work(connection):
    """Checks claims as long as there are any: first in prime fields, then exactly."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    while (entry := connection.recv()) is not None:
        for exact in (False, True):
            try:
                outcome = check_claim(entry, exact)
            except MemoryError:
                outcome = None if exact else Outcome(entry["id"], REJECTED, TESTED, why="more memory than is allowed")
            except Exception as fault:  # whatever a certificate provokes is an outcome of its own claim alone
                outcome = Outcome(entry["id"], REJECTED, why=f"the checker failed: {fault!r}")
            if outcome is not None:
                connection.send(outcome)
            if outcome is None or outcome.how != TESTED:
                break
        connection.send(None)


class Worker:
    """A process with the claim that it works on."""

    def __init__(self):
        self.connection, other = multiprocessing.Pipe()
        self.process = multiprocessing.Process(target=work, args=(other,), daemon=True)
        self.process.start()
        other.close()
        self.number, self.began, self.outcomes = None, 0.0, []

    def begin(self, number, entry):
        self.number, self.began, self.outcomes = number, time.monotonic(), []
        self.connection.send(entry)

    def end(self):
        self.process.kill()
        self.process.join()
        self.connection.close()


def outcome_of(entry, outcomes, limit):
    """The exact outcome; that in prime fields where the other one was not reached in time and memory."""
    if not outcomes:
        return Outcome(entry["id"], REJECTED, why=f"not checked in {limit:g} s")
    last = outcomes[-1]
    if last.how == TESTED and last.found == REJECTED:
        last.why += f"; not expanded in {limit:g} s"
    return last


def check_all(entries, workers, limit, told=lambda done: None):
    """The outcomes of claims in their order, with the seconds that each took."""
    crew = [Worker() for _ in range(max(1, min(workers, len(entries))))]
    results, left = [None] * len(entries), list(range(len(entries)))[::-1]
    try:
        while None in results:
            for place, worker in enumerate(crew):
                if worker.number is None and left:
                    worker.begin(number := left.pop(), entries[number])
            busy = {worker.connection: worker for worker in crew if worker.number is not None}
            for ready in wait(list(busy), timeout=0.1):
                worker = busy[ready]
                try:
                    received = ready.recv()
                except EOFError:
                    received, worker.began = None, worker.began
                    crew[crew.index(worker)] = Worker()
                if received is not None:
                    worker.outcomes.append(received)
                    continue
                number, seconds = worker.number, time.monotonic() - worker.began
                results[number] = (outcome_of(entries[number], worker.outcomes, limit), seconds)
                worker.number = None
                told(number)
            for place, worker in enumerate(crew):
                if worker.number is not None and time.monotonic() - worker.began > limit:
                    number = worker.number
                    results[number] = (outcome_of(entries[number], worker.outcomes, limit), limit)
                    worker.end()
                    crew[place] = Worker()
                    told(number)
    finally:
        for worker in crew:
            worker.end()
    return results
