"""Signs in one unknown, a letter or an angle, wherever everything given holds: exactly, at the real roots of all polynomials and between them."""

from flint import fmpq, fmpz_poly

from .evaluation import Evaluation, NotExpressible, Undefined
from .part_check import Rejected
from .ring import HalfAngleRing


def real_roots(check):
    """The conclusion holds at every value of the unknown at which everything that is given on it holds."""
    then = check.part.then
    if len(then) != 1 or then[0].kind not in (">", ">="):
        raise Rejected("real roots show one sign")
    unknown = Unknown(check)
    conclusion = unknown.fraction(check.difference(then[0]))
    if conclusion is None:
        raise Rejected("the conclusion holds other unknowns")
    given = [(relation.kind, unknown.fraction(check.difference(relation))) for relation in check.part.given]
    given = [(kind, fraction) for kind, fraction in given if fraction is not None]
    polynomials = [each for _, fraction in [*given, (None, conclusion)] for each in fraction]
    for signs in cells(polynomials, unknown.is_angle):
        pairs = [signs[2 * place] * signs[2 * place + 1] if signs[2 * place + 1] else None for place in range(len(given) + 1)]
        *known, own = pairs
        is_there = all(sign is not None and allows(kind, sign) for (kind, _), sign in zip(given, known))
        if is_there and own is not None and not allows(then[0].kind, own):
            raise Rejected("the conclusion fails at a value of the unknown")


def allows(kind, sign):
    """Whether a relation admits this sign."""
    return {"=": sign == 0, "!=": sign != 0, ">": sign > 0, ">=": sign >= 0}[kind]


class Unknown:
    """The one letter, or the tangent of half an angle, in which expressions are fractions of polynomials."""

    def __init__(self, check):
        self.ring = check.ring(rules=False, kind=HalfAngleRing)
        self.values = Evaluation(check.program, check.solves, self.ring, check.angles)
        self.name = None
        self.is_angle = False

    def fraction(self, entry):
        """Above and below as polynomials with whole coefficients; none where other unknowns stand there."""
        try:
            value = self.ring.lowest(self.values.value(entry))
        except (NotExpressible, Undefined):
            return None
        above, below = value.above, self.ring.denominator(value)
        names = list(self.ring.generators)
        used = {names[place] for one in (above, below) for monomial in one.to_dict() for place, power in enumerate(monomial) if power}
        if not used:
            return dense(above, 0), dense(below, 0)
        name = used.pop()
        if used or name[0] not in "lc" or self.name not in (None, name):
            return None
        self.name, self.is_angle = name, name[0] == "c"
        place = self.ring.place[name]
        return dense(above, place), dense(below, place)


def dense(polynomial, place):
    """A positive multiple with whole coefficients."""
    terms = {int(monomial[place]) if monomial else 0: coefficient for monomial, coefficient in polynomial.to_dict().items()}
    scale = 1
    for coefficient in terms.values():
        scale = scale * int(coefficient.q)
    return fmpz_poly([int((terms.get(power, fmpq(0)) * scale).p) for power in range(max(terms, default=0) + 1)])


def sign(number):
    return (number > 0) - (number < 0)


def cells(polynomials, is_angle):
    """The signs of all polynomials between their real roots, at these, and for an angle at half a turn."""
    product = fmpz_poly([1])
    for each in polynomials:
        if each.degree() > 0:
            product = product * (each // each.gcd(product) if each.gcd(product).degree() > 0 else each)
    free = square_free(product)
    samples = between(free)
    for sample in samples:
        yield [sign(each(sample)) for each in polynomials]
    for low, high in zip(samples, samples[1:]):
        yield [sign_at_root(each, free, low, high) for each in polynomials]
    if is_angle:
        yield from at_infinity(polynomials)


def square_free(polynomial):
    common = polynomial.gcd(polynomial.derivative())
    return polynomial // common if common.degree() > 0 else polynomial


def between(free):
    """Rational numbers that hold one real root each between two neighbours, and all of them."""
    roots = [root.real for root, _ in free.complex_roots() if root.imag.is_zero()] if free.degree() > 0 else []
    ends = sorted((fraction(root.lower()), fraction(root.upper())) for root in roots)
    if not ends:
        return [fmpq(0)]
    inner = [(one[1] + other[0]) / 2 for one, other in zip(ends, ends[1:])]
    if any(one[1] >= other[0] for one, other in zip(ends, ends[1:])):
        raise NotExpressible("roots that were not held apart")
    samples = [ends[0][0] - 1, *inner, ends[-1][1] + 1]
    changes = [sign(free(one)) * sign(free(other)) for one, other in zip(samples, samples[1:])]
    if any(change != -1 for change in changes):
        raise NotExpressible("roots that were not held apart")
    return samples


def fraction(ball):
    """An exact number with a binary exponent."""
    mantissa, exponent = ball.mid().man_exp()
    return fmpq(int(mantissa)) * (fmpq(2) ** int(exponent))


def sign_at_root(polynomial, free, low, high):
    """The sign at the one root of `free` between two numbers; each root of the polynomial is one of `free`."""
    common = polynomial.gcd(free)
    if polynomial == 0 or common.degree() > 0 and sign(common(low)) * sign(common(high)) == -1:
        return 0
    return sign(polynomial(low))


def at_infinity(polynomials):
    """The signs of each fraction where the tangent of half the angle has no value: that of the limit, and none where it has none."""
    signs = []
    for above, below in zip(polynomials[::2], polynomials[1::2]):
        lead = [sign(int(each[each.degree()])) if each != 0 else 0 for each in (above, below)]
        if above.degree() > below.degree():
            signs += [0, 0]
        elif above.degree() < below.degree():
            signs += [0, 1]
        else:
            signs += lead
    yield signs
