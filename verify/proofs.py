"""The proofs of parts, each repeated from the program alone."""

from .enclosures import enclosure, excluded
from .evaluation import Evaluation, Undefined, reached
from .expanded_signs import signs
from .half_turn import OfHalfTurn
from .minimum import minimum
from .part_check import Rejected
from .point_check import counterexample, example, exact_point, holds
from .products import products
from .real_roots import real_roots
from .ring import Ring
from .stability import stability
from .step_check import justify
from .written_signs import written_signs

SHOWS = {
    "proved": {"identity", "combination", "signs", "written_signs", "products", "real_roots", "example", "stability", "minimum"},
    "identified": {"identity"},
    "tested": {"identity"},
    "enclosed": {"enclosure"},
    "refuted": {"counterexample", "no_root", "excluded", "stability"},
    "undefined": {"undefined"},
}


def show(check, verdict):
    """Repeats the proof of a part."""
    if check.part.proof["by"] == "stability" and ("point" in check.part.proof) != (verdict == "refuted"):
        raise Rejected("a point refutes, and a ratio proves")
    justify(check)
    PROOFS[check.part.proof["by"]](check)


def identity(check):
    """The sides of every conclusion are equal."""
    for relation in check.part.then:
        if relation.kind not in ("=", "rate"):
            raise Rejected("an identity shows equalities alone")
        if not check.vanishes(check.difference(relation)):
            raise Rejected("the sides of a conclusion differ")


def combination(check):
    """Multiples of the conclusions are combinations of what is given."""
    given, combinations = check.part.given, check.part.proof["combinations"]
    if len(combinations) != len(check.part.then):
        raise Rejected("there is not one combination for each conclusion")
    for relation, one in zip(check.part.then, combinations):
        multiplier = check.emit("const", "1")
        for place in one["multiplier"]:
            if given[place].kind == "=":
                raise Rejected("a multiplier is not said to differ from zero")
            multiplier = check.emit("*", multiplier, check.difference(given[place]))
        total = check.emit("const", "0")
        for place, cofactor in one["cofactors"]:
            if given[place].kind != "=":
                raise Rejected("a cofactor multiplies what is no equality")
            total = check.emit("+", total, check.emit("*", cofactor, check.difference(given[place])))
        conclusion = check.difference(relation)
        if relation.kind == "=" and one["factor"] is None:
            gap = check.emit("-", check.emit("*", multiplier, conclusion), total)
        elif relation.kind == "!=" and one["factor"] is not None:
            gap = check.emit("-", check.emit("*", one["factor"], conclusion), check.emit("+", multiplier, total))
        else:
            raise Rejected("no such combination shows this conclusion")
        if not check.vanishes(gap):
            raise Rejected("a combination is not what it is said to be")


class PointWithUnknown(Ring):
    """Polynomials in one letter; everything else has a rational value at a point."""

    def __init__(self, unknown, point):
        super().__init__([unknown], (), 0, 0, 0)
        self.unknown = unknown
        self.point = point

    def rational(self, value):
        if set(value.parts) - {1} or isinstance(value.parts.get(1), OfHalfTurn):
            raise Rejected("a value of the point is not rational")
        return self.constant(value.parts.get(1, 0))

    def letter(self, place):
        return super().letter(place) if place == self.unknown else self.rational(self.point.letter(place))

    def circle(self, key):
        return tuple(self.rational(each) for each in self.point.circle(key))


def no_root(check):
    """No value of the unknown but zero satisfies the conclusions at the point."""
    point, formal = exact_point(check)
    unknown = check.part.proof["unknown"]
    if formal or unknown in point.letters:
        raise Rejected("the point gives the unknown a value, or angles beside their coordinates")
    at_point = Evaluation(check.program, check.solves, point, check.angles)
    for relation in check.part.given:
        if unknown not in reached(check.program, [relation.left, relation.right]) and not holds(check, relation, at_point):
            raise Rejected("something that is presupposed does not hold at the point")
    ring = PointWithUnknown(unknown, point)
    values = Evaluation(check.program, check.solves, ring, check.angles)
    common = None
    for relation in check.part.then:
        if relation.kind != "=":
            raise Rejected("conclusions about an unknown are equalities")
        above = values.value(check.difference(relation)).above
        common = above if common is None else common.gcd(above)
    if common is None or common.is_zero() or len(common) != 1:
        raise Rejected("the conclusions have a root, or hold for every value")


def undefined(check):
    """A conclusion divides by what vanishes identically."""
    ring = check.ring(rules=True)
    values = Evaluation(check.program, check.solves, ring, check.angles)
    try:
        for relation in check.part.then:
            values.value(check.difference(relation))
    except Undefined:
        return
    raise Rejected("no divisor of the conclusions vanishes identically")


PROOFS = {
    "identity": identity,
    "combination": combination,
    "signs": signs,
    "written_signs": written_signs,
    "products": products,
    "real_roots": real_roots,
    "counterexample": counterexample,
    "example": example,
    "no_root": no_root,
    "undefined": undefined,
    "stability": stability,
    "minimum": minimum,
    "enclosure": enclosure,
    "excluded": excluded,
}
