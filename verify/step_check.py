"""Whether the steps of a part follow from the equalities that it presupposes."""

from .evaluation import Evaluation, operands, reached
from .part_check import Rejected
from .prime_field import NoPoint, PrimeField

MANY = 2


class LinearDegree:
    """A domain: the degree of an entry in some letters as it is written: 0, 1, or 2 for more."""

    def __init__(self, letters):
        self.letters = set(letters)

    def letter(self, place):
        return int(place in self.letters)

    def constant(self, _):
        return 0

    def circle(self, _):
        return 0, 0

    def negative(self, one):
        return one

    def add(self, one, other):
        return max(one, other)

    def multiply(self, one, other):
        return min(one + other, MANY)

    def power(self, one, _):
        return MANY if one else 0

    def divide(self, one, other):
        return MANY if other else one

    def root(self, one):
        return MANY if one else 0

    def function(self, _, *arguments):
        return MANY if any(arguments) else 0

    elementary = function


def justify(check):
    """Every letter has the only value that the equalities leave it."""
    for place, step in enumerate(check.solves):
        before = check.solves[:place]
        differences = [check.difference(check.part.given[by]) for by in step.by]
        if all(is_linear(check, each, before, step.letters) for each in differences):
            differences = independent(check, differences, before, step.letters)
        elif not (len(differences) == 1 and has_linear_numerator(check, differences[0], before, step.letters)):
            raise Rejected("an equality is not linear in the letters that it is solved for")
        for entry in differences:
            if not check.vanishes(entry, check.solves[: place + 1], rules=False):
                raise Rejected("a value does not satisfy the equality that it is said to follow from")


def is_linear(check, entry, before, letters):
    """As it is written, or else by its expansion."""
    angles = check.angles_of(before)
    if not angles_with(check, entry, before, letters):
        if Evaluation(check.program, before, LinearDegree(letters), angles).value(entry) <= 1:
            return True
    ring, value, places = expanded(check, entry, before, letters)
    return value is not None and not any(ring.factors[f].degrees()[place] for f in value.below for place in places)


def has_linear_numerator(check, entry, before, letters):
    """An equality with one letter, which may stand below too: it vanishes where its numerator does."""
    ring, value, places = expanded(check, entry, before, letters)
    return len(letters) == 1 and value is not None and value.above.degrees()[places[0]] == 1


def expanded(check, entry, before, letters):
    """The entry as a fraction whose numerator is linear in the letters, with their places in the ring; none where it is not."""
    ring = check.ring(rules=False)
    value = Evaluation(check.program, before, ring, check.angles_of(before)).value(entry)
    places = [ring.place[f"l{letter}"] for letter in letters]
    degrees = value.above.degrees()
    inside = angles_with(check, entry, before, letters)
    is_moving = inside and any(degrees[ring.place[name]] for name in ring.generators if name[0] in "rscf")
    if is_moving or any(sum(monomial[place] for place in places) > 1 for monomial in value.above.monoms()):
        return ring, None, places
    return ring, value, places


def angles_with(check, entry, before, letters):
    """Whether one of the letters stands inside an angle, a root or a function, also through the values of steps before."""
    opaque = ("cos", "sin", "root", "function", "exp", "ln", "tanh", "atan2")
    inside, left = [], [entry]
    values = {letter: value for step in before for letter, value in zip(step.letters, step.values)}
    seen = set()
    while left:
        for here in reached(check.program, [left.pop()]):
            if here in seen:
                continue
            seen.add(here)
            if check.program[here][0] in opaque:
                inside += operands(check.program[here])
            left += [values[here]] if here in values else []
    return bool(set(letters) & check.letters_inside(inside, before))


def independent(check, entries, before, letters):
    """As many of the equalities as letters, such that their determinant is not zero at a point of a prime field."""
    for _ in range(64):
        field = PrimeField()
        try:
            rows = [slopes(check, entry, before, letters, field) for entry in entries]
        except NoPoint:
            continue
        pivots = pivots_of(rows, len(letters), field)
        if len(pivots) == len(letters):
            return [entries[row] for row in pivots]
    raise Rejected("the equalities leave the letters open")


def slopes(check, entry, before, letters, field):
    """The factors of the letters in a linear equality."""
    angles = check.angles_of(before)

    def at(one):
        for letter in letters:
            field.letters[letter] = int(letter == one)
        return Evaluation(check.program, before, field, angles).value(entry)

    constant = at(None)
    return [field.add(at(letter), field.negative(constant)) for letter in letters]


def pivots_of(rows, count, field):
    """The rows that elimination takes as pivots."""
    left = {place: list(row) for place, row in enumerate(rows)}
    pivots = []
    for column in range(count):
        pivot = next((place for place, row in left.items() if row[column]), None)
        if pivot is None:
            return pivots
        chosen = left.pop(pivot)
        pivots.append(pivot)
        for row in left.values():
            factor = field.divide(row[column], chosen[column])
            row[:] = [(a - factor * b) % field.p for a, b in zip(row, chosen)]
    return pivots

