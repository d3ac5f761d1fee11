"""Values at random points of a prime field, and bounds of degrees: identity testing (Schwartz 1980; Zippel 1979).

A prime p lies between 2^255 and 2^256. Letters are random numbers, each angle a random point of the circle by the tangent of its
half. What is tested is a quotient of polynomials in these numbers; where its numerator is not zero, of degree d and with the sum
of absolute values of its integer coefficients below 2^b, it vanishes at the point with a probability of at most
d / 2^255 + (b / 255 + 1) / 2^240: no more than b / 255 of more than 2^240 such primes divide all its coefficients. The prime is drawn
once for a process and the points for each test, from the system's source of random numbers, which no certificate can know.
"""

from functools import cache
from math import lcm, log2
from random import SystemRandom

from flint import fmpz

LEAST = 1 << 255
PRIMES = 240
# numbers with a root in every field, beside 2: formulas have roots of small numbers, and no point would give these a value elsewhere
SQUARES = (3, 5, 7, 11, 13)
MOST_ROOTS = 4


class NoPoint(Exception):
    """A divisor vanishes at the point, or a number has no root in the field; another point may do."""


class TooHigh(Exception):
    """The degree is too high for these fields."""


@cache
def prime():
    """A random prime that is 1 modulo 8, so that -1 and 2 are squares, and modulo which small numbers are squares by reciprocity."""
    while True:
        candidate = LEAST + SystemRandom().getrandbits(255) & ~7 | 1
        has_roots = all(candidate % number in {k * k % number for k in range(1, number)} for number in SQUARES)
        if has_roots and fmpz(candidate).is_prime():
            return candidate


def root_modulo(square, p):
    """A root of a number modulo a prime (Tonelli and Shanks); none of a number without one."""
    if square == 0 or pow(square, (p - 1) // 2, p) != 1:
        return 0 if square == 0 else None
    twos = (p - 1 & 1 - p).bit_length() - 1
    odd = p - 1 >> twos
    unit = pow(next(k for k in range(2, p) if pow(k, (p - 1) // 2, p) != 1), odd, p)
    root, rest = pow(square, (odd + 1) // 2, p), pow(square, odd, p)
    # the order of the rest, a power of two, falls in each round
    while rest != 1:
        order = next(k for k in range(1, twos) if pow(rest, 1 << k, p) == 1)
        factor = pow(unit, 1 << twos - order - 1, p)
        unit, twos = factor * factor % p, order
        root, rest = root * factor % p, rest * unit % p
    return root


class PrimeField:
    """A random point. `signs` chooses the root of each square."""

    def __init__(self):
        self.p = prime()
        self.random = SystemRandom()
        self.signs = 0
        self.letters, self.circles, self.roots, self.functions = {}, {}, {}, {}

    def with_signs(self, signs):
        """The same point with other roots of squares."""
        self.signs = signs
        self.roots = {}
        return self

    def draw(self):
        return self.random.randrange(1, self.p)

    def constant(self, value):
        return int(value.p) * self.inverse(int(value.q) % self.p) % self.p

    def inverse(self, value):
        if value == 0:
            raise NoPoint("a divisor is zero")
        return pow(value, -1, self.p)

    def letter(self, place):
        if place not in self.letters:
            self.letters[place] = self.draw()
        return self.letters[place]

    def circle(self, key):
        if key not in self.circles:
            t = self.draw()
            below = self.inverse((1 + t * t) % self.p)
            self.circles[key] = ((1 - t * t) * below % self.p, 2 * t * below % self.p)
        return self.circles[key]

    def root(self, square):
        if square not in self.roots:
            root = root_modulo(square, self.p)
            if root is None:
                raise NoPoint("a number without a root")
            turned = self.signs >> len(self.roots) & 1
            self.roots[square] = self.p - root if turned else root
        return self.roots[square]

    def function(self, *key):
        if key not in self.functions:
            self.functions[key] = self.draw()
        return self.functions[key]

    elementary = function

    def negative(self, one):
        return -one % self.p

    def add(self, one, other):
        return (one + other) % self.p

    def multiply(self, one, other):
        return one * other % self.p

    def power(self, one, exponent):
        return pow(one, exponent, self.p)

    def divide(self, one, other):
        return one * self.inverse(other) % self.p

    def is_zero(self, one):
        return one == 0


class Bound:
    """A quotient of polynomials: degree above, log2 of the sum of its coefficients' sizes, factors below with powers, an integer."""

    __slots__ = ("degree", "bits", "below", "integer")

    def __init__(self, degree, bits, below, integer=1):
        self.degree, self.bits, self.below, self.integer = degree, bits, below, integer


class Bounds:
    """The bounds of a program, operation by operation. A factor below is known by the place in the order of divisions."""

    MOST_BITS = 1 << 20

    def __init__(self):
        self.factors = []
        self.of_divisor = {}
        self.circles = {}
        self.roots = 0

    def constant(self, value):
        return Bound(0, log2(max(1, abs(int(value.p)))), {}, int(value.q))

    def letter(self, place):
        return Bound(1, 0.0, {})

    def circle(self, key):
        if key not in self.circles:
            self.circles[key] = self.factor(2, 1.0)
        below = {self.circles[key]: 1}
        return Bound(2, 1.0, below), Bound(1, 1.0, below)

    def factor(self, degree, bits):
        self.factors.append((degree, bits))
        return len(self.factors) - 1

    def root(self, square):
        self.roots += 1
        degree = square.degree + sum(self.factors[f][0] * p for f, p in square.below.items())
        return Bound(degree + 1, square.bits, {})

    def function(self, *key):
        return Bound(1, 0.0, {})

    elementary = function

    def negative(self, one):
        return one

    def scaled(self, one, below, integer):
        """Degree and bits above where the denominator is this multiple of its own."""
        degree, bits = one.degree, one.bits + log2(integer // one.integer)
        for factor, power in below.items():
            missing = power - one.below.get(factor, 0)
            degree += self.factors[factor][0] * missing
            bits += self.factors[factor][1] * missing
        return degree, bits

    def add(self, one, other):
        below = dict(one.below)
        for factor, power in other.below.items():
            below[factor] = max(power, below.get(factor, 0))
        integer = lcm(one.integer, other.integer)
        (a, b), (c, d) = self.scaled(one, below, integer), self.scaled(other, below, integer)
        return self.checked(Bound(max(a, c), max(b, d) + 1, below, integer))

    def multiply(self, one, other):
        below = dict(one.below)
        for factor, power in other.below.items():
            below[factor] = below.get(factor, 0) + power
        return self.checked(Bound(one.degree + other.degree, one.bits + other.bits, below, one.integer * other.integer))

    def power(self, one, exponent):
        below = {factor: power * exponent for factor, power in one.below.items()}
        return self.checked(Bound(one.degree * exponent, one.bits * exponent, below, one.integer**exponent))

    def divide(self, one, other):
        key = id(other)
        if key not in self.of_divisor:
            self.of_divisor[key] = (self.factor(other.degree, other.bits), other)
        inverse = {self.of_divisor[key][0]: 1}
        degree, bits = self.scaled(Bound(0, 0.0, {}), other.below, other.integer)
        return self.multiply(one, Bound(degree, bits, inverse))

    def checked(self, bound):
        if bound.degree.bit_length() > 200 or bound.bits > self.MOST_BITS or bound.integer.bit_length() > self.MOST_BITS:
            raise TooHigh("degrees beyond those of the fields")
        return bound


def error(degree, bits, roots):
    """The logarithm to the base 2 of the probability that a numerator which is not zero vanishes at the point."""
    # conjugates of roots, and the points at which all of them exist
    widened = 4.0**roots
    chance = widened * (degree / 2.0**255 + (bits / 255 + 1) / 2.0**PRIMES)
    return log2(chance)

