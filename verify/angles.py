"""Angles as whole numbers of common steps: x/2 and x/3 are both whole numbers of x/6."""

from math import lcm

from .evaluation import Evaluation, NotExpressible, Undefined, reached

MOST_PARTS = 1 << 10


class Finer(Exception):
    """An angle is divided into more parts than were known."""


class Angles:
    """The arguments of sines and cosines, taken apart in a ring of their own."""

    def __init__(self, program, steps, ring, parts):
        self.program = program
        self.ring = ring
        self.parts = parts
        self.values = Evaluation(program, steps, ring, self)
        self.known = {}

    def steps_of(self, argument, level):
        """The keys of steps with their numbers."""
        place = (argument, level)
        if place not in self.known:
            self.known[place] = [self.step(*term) for term in self.terms(self.values.value(argument, level))]
        return self.known[place]

    def terms(self, value):
        """The terms of an argument with rational coefficients."""
        ring = self.ring
        lowest = ring.lowest(value)
        below = ring.denominator(lowest)
        for monomial, coefficient in lowest.above.to_dict().items():
            single = ring.context.from_dict({monomial: 1})
            if below.is_constant():
                yield str(single), coefficient / below.leading_coefficient()
                continue
            common = single.gcd(below)
            above, rest = divmod(single, common)[0], divmod(below, common)[0]
            scale = rest.leading_coefficient()
            yield f"{above} / {rest * (1 / scale)}", coefficient / scale * above.leading_coefficient()

    def step(self, term, coefficient):
        """A term as a whole number of its parts."""
        parts = int(self.parts.get(term, 1))
        needed = lcm(parts, int(coefficient.q))
        if needed > MOST_PARTS:
            raise NotExpressible(f"the angle {term} in {needed} parts")
        if needed != parts:
            self.parts[term] = needed
            raise Finer(term)
        return (f"{term} / {parts}", int((coefficient * parts).p))

    def survey_of(self, goals, levels):
        """The number of different steps of angles inside the goals, at every level at which they may be asked for."""
        for level in range(levels):
            for here in reached(self.program, goals):
                if self.program[here][0] in ("cos", "sin"):
                    try:
                        self.steps_of(self.program[here][1], level)
                    except Undefined:
                        continue
        return len({key for steps in self.known.values() for key, _ in steps})
