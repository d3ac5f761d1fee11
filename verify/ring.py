"""Fractions of polynomials over the rationals, modulo sin^2 = 1 - cos^2, squares of roots and powers that hypotheses rewrite."""

from flint import Ordering, fmpq, fmpq_mpoly_ctx, fmpz

from .evaluation import Undefined

# longer polynomials are not divided on trial, and not factored
MOST_DIVIDED = 3000
MOST_FACTORED = 1000


class Full(Exception):
    """More angles, roots or functions than the ring has room for."""


class Fraction:
    """A polynomial over a product of factors of the ring."""

    __slots__ = ("above", "below")

    def __init__(self, above, below):
        self.above = above
        self.below = below


class Ring:
    """The ring of a part: a generator for each letter, two for each angle, one for each root and function."""

    def __init__(self, letters, leads, angles, roots, functions):
        names = [f"r{k}" for k in reversed(range(roots))] + [f"l{place}" for place in leads]
        names += [f"f{k}" for k in range(functions)] + [f"s{k}" for k in range(angles)]
        names += [f"c{k}" for k in range(angles)] + [f"l{place}" for place in letters if place not in leads]
        self.context = fmpq_mpoly_ctx.get(names or ["one"], Ordering.lex)
        self.generators = dict(zip(names, self.context.gens()))
        self.place = {name: place for place, name in enumerate(names)}
        self.order = list(leads)
        self.room = {"angles": angles, "roots": roots, "functions": functions}
        self.angles, self.roots, self.functions = {}, [], {}
        self.rules = {}
        self.factors = []
        self.one = self.context.constant(1)

    # the rules, those of the first generators first

    def rewrite(self, name, power, polynomial):
        """Powers of a generator are rewritten: `polynomial` is that power less lower terms."""
        self.rules[name] = (self.place[name], power, polynomial)
        self.rules = dict(sorted(self.rules.items(), key=lambda rule: rule[1][0]))

    def reduced(self, polynomial):
        """The polynomial without powers that are rewritten."""
        for place, power, rule in self.rules.values():
            if not polynomial.is_zero() and polynomial.degrees()[place] >= power:
                polynomial = polynomial % rule
        return polynomial

    # generators

    def taken(self, kind, known):
        if known >= self.room[kind]:
            raise Full(kind)
        return known

    def letter(self, place):
        return Fraction(self.generators[f"l{place}"], {})

    def circle(self, key):
        if key not in self.angles:
            number = self.angles[key] = self.taken("angles", len(self.angles))
            cos, sin = self.generators[f"c{number}"], self.generators[f"s{number}"]
            self.rewrite(f"s{number}", 2, sin**2 + cos**2 - 1)
        number = self.angles[key]
        return Fraction(self.generators[f"c{number}"], {}), Fraction(self.generators[f"s{number}"], {})

    def root(self, square):
        """The root of c N/D is root(c) R/D, where R is D root(N/D) and R^2 = N D; c is positive and D of one sign convention."""
        square = self.lowest(square)
        below = self.denominator(square)
        if square.above.is_zero():
            return square
        content = content_of(square.above) / content_of(below)
        above, below = square.above * (1 / content_of(square.above)), below * (1 / content_of(below))
        front = self.root_of_number(content)
        if above.is_one() and below.is_one():
            return front
        if above.is_constant() and below.is_constant():
            raise Undefined("the root of a negative number")
        return self.multiply(front, self.divide(self.root_generator(above, below), Fraction(below, {})))

    def root_generator(self, above, below):
        """The generator R; roots of other fractions with one product N D may differ in sign."""
        for number, known in enumerate(self.roots):
            if known == (above, below):
                break
        else:
            number = self.taken("roots", len(self.roots))
            self.roots.append((above, below))
            generator = self.generators[f"r{number}"]
            self.rewrite(f"r{number}", 2, generator**2 - self.reduced(above * below))
        return Fraction(self.generators[f"r{number}"], {})

    def root_of_number(self, value):
        """A positive number: a rational times roots of primes."""
        outside, result = fmpq(1, value.q), self.constant(fmpq(1))
        for prime, power in (value.p * value.q).factor():
            outside *= prime ** (power // 2)
            if power % 2:
                result = self.multiply(result, self.root_generator(self.context.constant(prime), self.one))
        return self.multiply(self.constant(outside), result)

    def function(self, name, *arguments):
        key = (name, *(self.key(each) for each in arguments))
        if key not in self.functions:
            self.functions[key] = self.taken("functions", len(self.functions))
        return Fraction(self.generators[f"f{self.functions[key]}"], {})

    elementary = function

    # arithmetic

    def constant(self, value):
        return Fraction(self.context.constant(value), {})

    def negative(self, one):
        return Fraction(-one.above, one.below)

    def add(self, one, other):
        if one.below == other.below:
            return self.cancelled(one.above + other.above, one.below)
        common = dict(one.below)
        for factor, power in other.below.items():
            common[factor] = max(power, common.get(factor, 0))
        sides = [each.above * self.product({f: p - each.below.get(f, 0) for f, p in common.items()}) for each in (one, other)]
        return self.cancelled(self.reduced(sides[0] + sides[1]), common)

    def multiply(self, one, other):
        below = dict(one.below)
        for factor, power in other.below.items():
            below[factor] = below.get(factor, 0) + power
        return self.cancelled(self.reduced(one.above * other.above), below)

    def power(self, one, exponent):
        result = one
        for _ in range(exponent - 1):
            result = self.multiply(result, one)
        return result

    def divide(self, one, other):
        divisor = self.reduced(other.above)
        if divisor.is_zero():
            raise Undefined("a divisor vanishes identically")
        below = self.factored(divisor)
        scale = self.product(below)
        # what was taken out of the divisor beside its factors is a number
        constant = divisor.leading_coefficient() / scale.leading_coefficient()
        above = self.reduced(one.above * self.product(other.below)) * (1 / constant)
        below = dict(below)
        for factor, power in one.below.items():
            below[factor] = below.get(factor, 0) + power
        return self.cancelled(above, below)

    def factored(self, divisor):
        """Irreducible factors where the divisor is short; their product is the divisor up to a number."""
        if divisor.is_constant():
            return {}
        if len(divisor) > MOST_FACTORED:
            return {self.factor(divisor): 1}
        below = {}
        for factor, power in divisor.factor()[1]:
            number = self.factor(factor)
            below[number] = below.get(number, 0) + int(power)
        return below

    def factor(self, polynomial):
        """The number of a factor, which has the leading coefficient one."""
        monic = polynomial * (1 / polynomial.leading_coefficient())
        for number, known in enumerate(self.factors):
            if known == monic:
                return number
        self.factors.append(monic)
        return len(self.factors) - 1

    def product(self, powers):
        result = self.one
        for factor, power in powers.items():
            if power:
                result = result * self.factors[factor] ** power
        return self.reduced(result) if result is not self.one else result

    def cancelled(self, above, below):
        """Without the factors that divide what stands above."""
        if above.is_zero():
            return Fraction(above, {})
        if not below or len(above) > MOST_DIVIDED:
            return Fraction(above, below)
        below = dict(below)
        for factor in list(below):
            while below[factor]:
                quotient = divided(above, self.factors[factor])
                if quotient is None:
                    break
                above = quotient
                below[factor] -= 1
            if not below[factor]:
                del below[factor]
        return Fraction(above, below)

    def denominator(self, one):
        return self.product(one.below)

    def lowest(self, one):
        """Without common divisors above and below."""
        below = self.denominator(one)
        if below.is_constant() or one.above.is_zero():
            return one
        common = one.above.gcd(below)
        if common.is_constant():
            return one
        return self.divide(Fraction(divided(one.above, common), {}), Fraction(divided(below, common), {}))

    def key(self, one):
        """A text that is the same for equal fractions in lowest terms."""
        lowest = self.lowest(one)
        return f"{lowest.above} / {self.denominator(lowest)}"

    def is_zero(self, one):
        return self.reduced(one.above).is_zero()


class HalfAngleRing(Ring):
    """The same with the tangent t of half of each step: cos = (1 - t^2)/(1 + t^2), sin = 2 t/(1 + t^2), so that nothing is left modulo
    cos^2 + sin^2 = 1, and every divisor that cancels is seen."""

    def circle(self, key):
        if key not in self.angles:
            self.angles[key] = self.taken("angles", len(self.angles))
        t = self.generators[f"c{self.angles[key]}"]
        below = Fraction(1 + t**2, {})
        return self.divide(Fraction(1 - t**2, {}), below), self.divide(Fraction(2 * t, {}), below)


def content_of(polynomial):
    """The positive number that leaves whole coefficients without a common divisor."""
    coefficients = polynomial.coeffs()
    above, below = fmpz(0), fmpz(1)
    for each in coefficients:
        above, below = above.gcd(each.p), below * each.q // below.gcd(each.q)
    return fmpq(above, below)


def divided(one, other):
    """The quotient, where the division leaves no rest."""
    if any(a < b for a, b in zip(one.degrees(), other.degrees())):
        return None
    quotient, rest = divmod(one, other)
    return quotient if rest.is_zero() else None
