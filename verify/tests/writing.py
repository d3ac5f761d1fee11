"""Certificates for tests, written by hand."""


class Claim:
    """A claim whose program grows by one entry for each call."""

    def __init__(self, verdict="proved"):
        self.program = []
        self.entry = {"id": "test/eq1", "verdict": verdict, "program": self.program, "parts": []}

    def put(self, *operation):
        """The place of an operation, an old one where it is known."""
        if list(operation) not in self.program:
            self.program.append(list(operation))
        return self.program.index(list(operation))

    def letter(self, name):
        return self.put("letter", name)

    def number(self, text):
        return self.put("const", str(text))

    def sum(self, *terms):
        return self.fold("+", terms)

    def product(self, *factors):
        return self.fold("*", factors)

    def fold(self, name, entries):
        first, *rest = entries
        for each in rest:
            first = self.put(name, first, each)
        return first

    def part(self, then, by, given=(), steps=(), rates=()):
        """A part; `then` and `given` are triples of a relation and two places."""
        told = [[{"is": kind, "left": left, "right": right} for kind, left, right in each] for each in (given, then)]
        self.entry["parts"].append(
            {"given": told[0], "steps": list(steps), "rates": list(rates), "then": told[1], "proof": by}
        )
        return self.entry
