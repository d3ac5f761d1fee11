"""Signs of the terms of normal forms."""

from .evaluation import Evaluation, NotExpressible, Undefined
from .part_check import Rejected
from .written_signs import WrittenSigns


def signs(check):
    """All terms above and below have one sign."""
    part = check.part
    if not set(part.proof["positive"]) <= set(lefts(check, ">")):
        raise Rejected("a letter is not given as positive")
    for relation in part.then:
        sign_of_entry = of_entry(check, check.difference(relation), part.proof["positive"])
        if not (relation.kind == "!=" or relation.kind == ">" and sign_of_entry > 0):
            raise Rejected("the signs of terms do not show this conclusion")


def is_positive(check, entry):
    """Whether an entry is positive by the terms of its normal form, or as it is written."""
    try:
        if of_entry(check, entry, lefts(check, ">")) > 0:
            return True
    except (Rejected, NotExpressible, Undefined):
        pass
    return WrittenSigns(check).of(entry) == (1, True)


def lefts(check, kind):
    """The left sides of relations of this kind whose right side is zero."""
    return [each.left for each in check.part.given if each.kind == kind and is_zero(check, each.right)]


def of_entry(check, entry, positive):
    """The sign of an entry by those of all its terms."""
    ring = check.ring(rules=True)
    value = ring.lowest(Evaluation(check.program, check.solves, ring, check.angles).value(entry))
    names = [{f"l{each}" for each in entries} for entries in (positive, lefts(check, "!="))]
    return sign(check, ring, value.above, *names) * sign(check, ring, ring.denominator(value), *names)


def is_zero(check, entry):
    return check.program[entry] == ("const", "0")


def sign(check, ring, polynomial, positive, apart):
    """The common sign of all terms, which do not vanish together."""
    common, strict, vanishing = 0, False, set()
    names = list(ring.generators)
    for monomial, coefficient in polynomial.to_dict().items():
        here = 1 if coefficient > 0 else -1
        open_names = []
        for name, exponent in zip(names, monomial):
            if exponent and name not in positive:
                if exponent % 2:
                    raise Rejected("a letter of unknown sign has an odd power")
                if name not in apart:
                    open_names.append(name)
        if common and here != common:
            raise Rejected("terms differ in sign")
        common = here
        strict = strict or not open_names
        if len(open_names) == 1:
            vanishing.add(open_names[0])
    if not common:
        raise Rejected("it vanishes identically")
    if not strict and not any(forbids(check, relation, ring, vanishing) for relation in check.part.given):
        raise Rejected("all terms may vanish together")
    return common


def forbids(check, relation, ring, names):
    """Whether a relation forbids that all these generators vanish."""
    if relation.kind == "=":
        return False
    value = Evaluation(check.program, check.solves, ring, check.angles).value(check.difference(relation))
    at_zero = value.above.subs({name: 0 for name in names})
    below = ring.denominator(value).subs({name: 0 for name in names})
    return at_zero.is_zero() and not below.is_zero()
