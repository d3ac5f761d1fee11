"""What a part of a claim is about: its program, the values of its letters, and whether a difference vanishes."""

from .angles import Angles
from .certificate import MINORS, Rewrite, Solve
from .derivative import rate
from .evaluation import Evaluation, reached
from .prime_field import MOST_ROOTS, Bounds, NoPoint, PrimeField, TooHigh, error, root_modulo
from .ring import HalfAngleRing, Ring

MOST_POINTS = 64
TESTED = "tested"
EXACT = "exact"


class Rejected(Exception):
    """The certificate does not show what it says."""


class PartCheck:
    """A part in the checking. With `exact` a difference is expanded; else it is looked at in prime fields."""

    def __init__(self, program, part, exact, parts, room):
        self.program = list(program)
        self.part = part
        self.exact = exact
        self.room = room
        self.solves = [step for step in part.steps if isinstance(step, Solve)]
        self.rewrites = [step for step in part.steps if isinstance(step, Rewrite)]
        self.how = EXACT
        self.error = None
        self.goals = self.named()
        self.letters = [e for e in reached(self.program, self.goals) if self.program[e][0] == "letter"]
        self.parts = parts
        self.angles = self.angles_of(self.solves)
        self.leads = self.ordered()

    def named(self):
        """The entries that the part names."""
        part = self.part
        goals = [side for each in part.given + part.then for side in (each.left, each.right)]
        goals += [entry for pair in part.rates for entry in pair]
        for solve in self.solves:
            goals += solve.letters + solve.values
        proof = part.proof
        goals += [leaf for leaf, _ in proof.get("point", ())] + list(proof.get("positive", ()))
        goals += [proof[key] for key in ("unknown", "root", "scale", "printed") if key in proof]
        for key in ("equations", "coordinates", "speeds", "accelerations", "coefficients", *MINORS):
            goals += proof.get(key, ())
        goals += [proof["ratio"][0]] if "ratio" in proof else []
        for one in proof.get("products", ()):
            goals += [*one["roots"], *one["squares"]]
        for one in proof.get("combinations", ()):
            goals += [cofactor for _, cofactor in one["cofactors"]]
            goals += [] if one["factor"] is None else [one["factor"]]
        return goals

    def emit(self, *operation):
        """A new entry at the end of the program."""
        self.program.append(operation)
        return len(self.program) - 1

    def difference(self, relation):
        left = relation.left
        if relation.kind == "rate":
            left = rate(self.program, left, self.part.rates)
        return self.emit("-", left, relation.right)

    def letters_inside(self, entries, steps):
        """The letters on which entries depend, also through the values of solved ones."""
        values = {letter: value for step in steps for letter, value in zip(step.letters, step.values)}
        found, left = set(), list(entries)
        while left:
            for here in reached(self.program, [left.pop()]):
                if self.program[here][0] == "letter" and here not in found:
                    found.add(here)
                    left += [values[here]] if here in values else []
        return found

    # rings

    def angles_of(self, steps):
        kinds = [self.program[e][0] for e in reached(self.program, self.goals)]
        count = self.room * (2 + kinds.count("cos") + kinds.count("sin"))
        opaque = sum(kinds.count(name) for name in ("function", "exp", "ln", "tanh", "atan2"))
        self.sizes = (self.room * (kinds.count("root") + 1), self.room * (opaque + 1))
        ring = Ring(self.letters, (), count, *self.sizes)
        return Angles(self.program, steps, ring, self.parts)

    def ring(self, rules, letters=None, kind=Ring):
        """A ring with room for the angles of the part."""
        angles = self.angles.survey_of(self.goals, len(self.solves) + 1)
        leads = [lead for lead in self.leads] if rules else ()
        ring = kind(self.letters if letters is None else letters, leads, self.room * (angles + 1), *self.sizes)
        if rules:
            for lead in reversed(self.leads):
                self.add_rule(ring, lead)
        return ring

    def rule(self, lead):
        return next(step for step in self.rewrites if step.letter == lead)

    def ordered(self):
        """The letters whose powers are rewritten, each before those in its rule."""
        names = {f"l{step.letter}": step.letter for step in self.rewrites}
        uses = {}
        for step in self.rewrites:
            ring = self.angles.ring
            value = Evaluation(self.program, self.solves, ring, self.angles).value(self.difference(self.part.given[step.by]))
            degrees = value.above.degrees()
            uses[step.letter] = {
                other for name, other in names.items() if other != step.letter and degrees[ring.place[name]] > 0
            }
        order = []
        while len(order) < len(uses):
            free = [lead for lead in uses if lead not in order and not any(lead in uses[o] for o in uses if o not in order)]
            if not free:
                raise Rejected("powers are rewritten in a circle")
            order.append(free[0])
        return order

    def add_rule(self, ring, lead):
        """The rule of a letter, if the equality has no higher power of it, and this one with a number as its factor."""
        step = self.rule(lead)
        value = Evaluation(self.program, self.solves, ring, self.angles).value(self.difference(self.part.given[step.by]))
        place, factor = ring.place[f"l{lead}"], None
        for monomial, coefficient in value.above.to_dict().items():
            if monomial[place] == step.power and sum(monomial) == step.power:
                factor = coefficient
            elif monomial[place] >= step.power:
                raise Rejected("an equality has higher powers of the letter that it rewrites, or factors beside its power")
        if factor is None:
            raise Rejected("an equality has not the power that it rewrites")
        ring.rewrite(f"l{lead}", step.power, value.above * (1 / factor))

    # whether an entry vanishes

    def vanishes(self, entry, steps=None, rules=True):
        """Whether an entry vanishes after the steps: at a random point of a field, then exactly where that is asked for."""
        steps = self.solves if steps is None else steps
        tested = self.vanishes_at_points(entry, steps, rules)
        if tested is False:
            return False
        if not self.exact:
            if tested is None:
                raise TooHigh("no point of a prime field decides")
            self.how = TESTED
            self.error = max(tested, self.error) if self.error is not None else tested
            return True
        solved = {letter for step in steps for letter in step.letters}
        open_letters = [letter for letter in self.letters if letter not in solved]
        # what solved letters leave needs no generator of theirs
        letters = open_letters if steps == self.solves else None
        try:
            ring = self.ring(rules, letters, HalfAngleRing)
        except Rejected:
            # a power that angles rewrite is no polynomial in the tangents of their halves
            ring = self.ring(rules, letters)
        angles = self.angles if steps == self.solves else self.angles_of(steps)
        return ring.is_zero(Evaluation(self.program, steps, ring, angles).value(entry))

    def vanishes_at_points(self, entry, steps, rules):
        """The logarithm of the error where it vanishes, False where it does not, None where no point decides."""
        angles = self.angles if steps == self.solves else self.angles_of(steps)
        try:
            bounds = Bounds()
            bound = Evaluation(self.program, steps, bounds, angles).value(entry)
            for lead in self.leads if rules else ():
                by = self.difference(self.part.given[self.rule(lead).by])
                rule = Evaluation(self.program, self.solves, bounds, self.angles).value(by)
                bound = bound_of_rule(bound, bounds, rule)
            roots = bounds.roots + (len(self.leads) if rules else 0)
            limit = error(bound.degree * 2**roots, bound.bits * 2**roots, roots)
        except TooHigh:
            limit = None
        # with more roots than these not all signs are tried, and a zero shows nothing
        signs = 1 << min(bounds.roots, MOST_ROOTS)
        values = self.at_a_point(entry, steps, rules, angles, signs)
        if values is None or not any(values) and bounds.roots > MOST_ROOTS:
            return None
        if not any(values):
            return limit
        # zero for some signs of roots alone: which signs these are is for exact arithmetic
        return False if all(values) else None

    def at_a_point(self, entry, steps, rules, angles, signs):
        """The values at a point of a field for each choice of roots; none where no point was found."""
        for _ in range(MOST_POINTS):
            field = PrimeField()
            try:
                self.set_leads(field, rules)
                points = (field.with_signs(each) for each in range(signs))
                return [Evaluation(self.program, steps, point, angles).value(entry) for point in points]
            except NoPoint:
                continue
            except TooHigh:
                return None
        return None

    def set_leads(self, field, rules):
        """Values of the letters whose powers are rewritten."""
        for lead in reversed(self.leads) if rules else ():
            step = self.rule(lead)
            if step.power > 2:
                raise TooHigh("a power beyond the square is rewritten")
            entry = self.difference(self.part.given[step.by])
            trial, at = field.draw(), []
            for value in (0, 1, trial):
                field.letters[lead] = value
                at.append(Evaluation(self.program, self.solves, field, self.angles).value(entry))
            factor = field.add(at[1], field.negative(at[0]))
            if field.add(field.multiply(factor, field.power(trial, step.power)), at[0]) != at[2]:
                raise TooHigh("lower powers stand in an equality that rewrites one")
            square = field.divide(field.negative(at[0]), factor)
            field.letters[lead] = square if step.power == 1 else self.drawn_root(field, square)

    @staticmethod
    def drawn_root(field, square):
        root = root_modulo(square, field.p)
        if root is None:
            raise NoPoint("a number without a root")
        return root if field.random.getrandbits(1) else field.p - root


def bound_of_rule(bound, bounds, rule):
    """The bound where a letter is a root of a polynomial of this degree."""
    degree = rule.degree + sum(bounds.factors[factor][0] * power for factor, power in rule.below.items())
    bound.degree, bound.bits = bound.degree * (degree + 1), bound.bits + bound.degree * (rule.bits + 1)
    return bounds.checked(bound)
