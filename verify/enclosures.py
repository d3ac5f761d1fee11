"""Numbers in enclosures: balls of Arb, whose radius holds every rounding."""

from flint import arb, ctx

from .derivative import rate
from .evaluation import Evaluation, NotExpressible, Undefined
from .part_check import Rejected

PRECISIONS = (128, 512, 2048)


class WholeArguments:
    """Angles as they are: a ball has a cosine itself."""

    @staticmethod
    def steps_of(argument, level):
        return [((argument, level), 1)]


class Balls:
    """A domain without letters but pi: every entry is a number. A letter that is left counts as one."""

    def __init__(self, program):
        self.program = program
        self.values = None
        self.left = set()

    def letter(self, place):
        if self.program[place] == ("letter", "pi"):
            return arb.pi()
        self.left.add(place)
        return arb(1)

    def constant(self, value):
        return arb(value)

    def circle(self, key):
        angle = self.values.value(*key)
        return angle.cos(), angle.sin()

    def root(self, square):
        if square < 0:
            raise Undefined("the root of a negative number")
        return square.sqrt()

    def function(self, name, *_):
        raise NotExpressible(f"a value of {name}")

    def elementary(self, name, one, other):
        if name == "atan2":
            return one.atan2(other)
        return {"exp": one.exp, "ln": one.log, "tanh": one.tanh}[name]()

    def negative(self, one):
        return -one

    def add(self, one, other):
        return one + other

    def multiply(self, one, other):
        return one * other

    def power(self, one, exponent):
        return one**exponent

    def divide(self, one, other):
        if other.contains(0):
            raise Undefined("a divisor may be zero")
        return one / other


def sign(check, entry):
    """1 or -1 by an enclosure that excludes zero; none where none does."""
    kept = ctx.prec
    try:
        for precision in PRECISIONS:
            ctx.prec = precision
            value = ball(check, entry)
            if value > 0:
                return 1
            if value < 0:
                return -1
    finally:
        ctx.prec = kept
    return None


def ball(check, entry):
    """An entry after the steps. A letter that is left has no influence on it: the derivative by it vanishes."""
    domain = Balls(check.program)
    domain.values = Evaluation(check.program, check.solves, domain, WholeArguments)
    value = domain.values.value(entry)
    for letter in domain.left:
        rates = {letter: check.emit("const", "1")}
        for step in reversed(check.solves):
            rates |= {each: rate(check.program, of, rates) for each, of in zip(step.letters, step.values)}
        if not check.vanishes(rate(check.program, entry, rates)):
            raise Rejected("a letter without a value stands in a number")
    return value


def enclosure(check):
    """Every conclusion holds by enclosures."""
    for relation in check.part.then:
        if relation.kind != ">" or sign(check, check.difference(relation)) != 1:
            raise Rejected("an enclosure does not show a conclusion")


def excluded(check):
    """A conclusion fails by enclosures."""
    for relation in check.part.then:
        found = sign(check, check.difference(relation)) if relation.kind in (">", "=") else None
        if found == -1 or relation.kind == "=" and found == 1:
            return
    raise Rejected("no enclosure shows that a conclusion fails")
