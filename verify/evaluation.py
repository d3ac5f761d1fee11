"""Straight-line programs over any domain, with letters replaced by the steps of a part."""

from flint import fmpq

from .certificate import Solve

HIGHEST_MULTIPLE = 64

# the squares of cosine and sine of pi/n, with their signs
HALF_TURN = {
    1: (fmpq(-1), fmpq(0)),
    2: (fmpq(0), fmpq(1)),
    3: (fmpq(1, 4), fmpq(3, 4)),
    4: (fmpq(1, 2), fmpq(1, 2)),
    6: (fmpq(3, 4), fmpq(1, 4)),
}


class Undefined(Exception):
    """A division by what vanishes identically, or a root of a negative number."""


class NotExpressible(Exception):
    """The domain has no exact value for this."""


def number(text):
    """A rational number."""
    above, _, below = text.partition("/")
    try:
        value, divisor = int(above), int(below or "1")
    except ValueError as fault:
        raise NotExpressible(f"the constant {text}") from fault
    if divisor == 0:
        raise Undefined("a constant that divides by zero")
    return fmpq(value, divisor)


def reached(program, roots, closed=()):
    """The entries inside the given ones and themselves, ascending."""
    open_entries, found = list(roots), set()
    while open_entries:
        here = open_entries.pop()
        if here in found:
            continue
        found.add(here)
        if here not in closed:
            open_entries.extend(operands(program[here]))
    return sorted(found)


def operands(operation):
    """The places that an operation takes."""
    name = operation[0]
    if name in ("const", "letter"):
        return ()
    if name == "pow":
        return operation[1:2]
    if name == "function":
        return operation[2:3]
    return operation[1:]


class Evaluation:
    """Values of entries over a domain. Letters have the values of the steps from `first` to the last one but those before."""

    def __init__(self, program, steps, domain, angles):
        self.program = program
        self.solved = [each for each in steps if isinstance(each, Solve)]
        self.domain = domain
        self.angles = angles
        self.known = [{} for _ in range(len(self.solved) + 1)]

    def value(self, entry, level=0):
        """The value of an entry where the steps from this level on hold."""
        known = self.known[level]
        if entry in known:
            return known[entry]
        for here in reached(self.program, [entry], known):
            if here not in known:
                known[here] = self.operate(self.program[here], here, level)
        return known[entry]

    def letter(self, here, level):
        """A letter by the first step that gives it a value."""
        for place in range(level, len(self.solved)):
            step = self.solved[place]
            if here in step.letters:
                return self.value(step.values[step.letters.index(here)], place + 1)
        return self.domain.letter(here)

    def operate(self, operation, here, level):
        name, *rest = operation
        domain, known = self.domain, self.known[level]
        if name == "const":
            return domain.constant(number(rest[0]))
        if name == "letter":
            return self.letter(here, level)
        if name == "pow":
            return domain.power(known[rest[0]], rest[1])
        if name == "function":
            return domain.function(rest[0], known[rest[1]])
        if name in ("cos", "sin"):
            return self.circle(rest[0], level)[name == "sin"]
        values = [known[each] for each in rest]
        if name == "+":
            return domain.add(*values)
        if name == "-":
            return domain.add(values[0], domain.negative(values[1]))
        if name == "*":
            return domain.multiply(*values)
        if name == "/":
            return domain.divide(*values)
        if name == "neg":
            return domain.negative(values[0])
        if name == "root":
            return domain.root(values[0])
        return domain.elementary(name, *values)

    def circle(self, argument, level):
        """Cosine and sine of an entry, from those of the steps into which its terms are divided."""
        domain = self.domain
        point = (domain.constant(fmpq(1)), domain.constant(fmpq(0)))
        for key, times in self.angles.steps_of(argument, level):
            if abs(times) > HIGHEST_MULTIPLE:
                raise NotExpressible(f"{times} times an angle")
            cos, sin = self.part_of_half_turn(key) or domain.circle(key)
            single = (cos, sin if times > 0 else domain.negative(sin))
            for _ in range(abs(times)):
                point = turned(domain, point, single)
        return point

    def part_of_half_turn(self, key):
        """Cosine and sine of the letter pi over a whole number, as far as square roots give them."""
        if not isinstance(key, str):
            return None
        term, _, parts = key.rpartition(" / ")
        place = term[1:]
        if term[:1] != "l" or not place.isdigit() or self.program[int(place)] != ("letter", "pi"):
            return None
        if int(parts) not in HALF_TURN:
            raise NotExpressible(f"the cosine of pi/{parts}")
        domain = self.domain

        def signed_root(square):
            root = domain.root(domain.constant(abs(square)))
            return domain.negative(root) if square < 0 else root

        cos, sin = HALF_TURN[int(parts)]
        return signed_root(cos), signed_root(sin)


def turned(domain, one, other):
    """The addition theorems."""
    (a, b), (c, d) = one, other
    cos = domain.add(domain.multiply(a, c), domain.negative(domain.multiply(b, d)))
    sin = domain.add(domain.multiply(a, d), domain.multiply(b, c))
    return cos, sin
