"""Signs of entries as they are written: squares, roots, exponentials, and letters that are given as positive."""

from .part_check import Rejected
from .evaluation import number, reached

# a sign is a pair: 1 or -1, and whether zero is excluded


def opposite(sign):
    return sign and (-sign[0], sign[1])


def total(one, other):
    """The sign of a sum: none where the terms differ in sign."""
    if one is None or other is None or one[0] != other[0]:
        return None
    return one[0], one[1] or other[1]


def product(one, other):
    if one is None or other is None:
        return None
    return one[0] * other[0], one[1] and other[1]


def square(one, apart):
    return 1, bool(apart or one and one[1])


class WrittenSigns:
    """The signs of the entries of a part."""

    def __init__(self, check):
        self.program = check.program
        self.positive, self.not_negative, self.apart, self.negative = set(), set(), set(), set()
        for relation in check.part.given:
            if self.program[relation.right] == ("const", "0"):
                if relation.kind == ">":
                    self.positive.add(relation.left)
                    self.negative |= self.opposite_of(relation.left)
                elif relation.kind == ">=":
                    self.not_negative.add(relation.left)
                elif relation.kind == "!=":
                    self.apart.add(relation.left)
        self.known = {}

    def opposite_of(self, entry):
        """The entry whose opposite this one is."""
        name, *rest = self.program[entry]
        if name == "neg":
            return {rest[0]}
        return {rest[1]} if name == "-" and self.program[rest[0]] == ("const", "0") else set()

    def of(self, entry):
        """The sign of an entry; none where it is not seen."""
        for here in reached(self.program, [entry], self.known):
            if here not in self.known:
                self.known[here] = self.given(here) or self.single(self.program[here])
        return self.known[entry]

    def given(self, entry):
        if entry in self.positive:
            return 1, True
        if entry in self.negative:
            return -1, True
        return (1, False) if entry in self.not_negative else None

    def single(self, operation):
        name, *rest = operation
        if name == "const":
            value = number(rest[0])
            return (1 if value >= 0 else -1, value != 0)
        if name in ("letter", "function", "cos", "sin", "ln", "tanh", "atan2"):
            return None
        if name == "exp":
            return 1, True
        sign = self.known[rest[0]]
        if name == "neg":
            return opposite(sign)
        if name == "root":
            return 1, sign == (1, True)
        if name == "pow":
            return square(sign, rest[0] in self.apart) if rest[1] % 2 == 0 else sign
        other = self.known[rest[1]]
        if name == "+":
            return total(sign, other)
        if name == "-" and self.program[rest[1]] == ("const", "0"):
            return sign
        if name == "-":
            return total(sign, opposite(other))
        if name == "*":
            return square(sign, rest[0] in self.apart) if rest[0] == rest[1] else product(sign, other)
        if other is None or not other[1]:
            return None
        return product(sign, other)


def written_signs(check):
    """Every conclusion, as it is written."""
    signs = WrittenSigns(check)
    for relation in check.part.then:
        sign = signs.of(check.difference(relation))
        if relation.kind not in (">", ">=") or sign is None or sign[0] != 1 or relation.kind == ">" and not sign[1]:
            raise Rejected("the signs of the terms as written do not show this conclusion")
