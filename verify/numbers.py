"""Exact numbers of points: sums of roots of square-free whole numbers with factors that are rational, or rational functions of pi."""

from flint import arb, ctx, fmpq, fmpz

from .evaluation import NotExpressible, Undefined
from .half_turn import OfHalfTurn, ball


class Number:
    """The sum of parts[d] sqrt(d) over square-free d; such roots are linearly independent over the rationals, and over their functions of pi."""

    __slots__ = ("parts",)

    def __init__(self, parts):
        self.parts = {d: c for d, c in parts.items() if c != 0}

    @classmethod
    def of(cls, value):
        return cls({1: value if isinstance(value, OfHalfTurn) else fmpq(value)})

    def __add__(self, other):
        parts = dict(self.parts)
        for d, c in other.parts.items():
            parts[d] = parts.get(d, fmpq(0)) + c
        return Number(parts)

    def __neg__(self):
        return Number({d: -c for d, c in self.parts.items()})

    def __mul__(self, other):
        parts = {}
        for a, x in self.parts.items():
            for b, y in other.parts.items():
                common = int(fmpz(a).gcd(fmpz(b)))
                d = a // common * (b // common)
                parts[d] = parts.get(d, fmpq(0)) + x * y * common
        return Number(parts)

    def conjugate(self, prime):
        """With the other root of a prime."""
        return Number({d: -c if d % prime == 0 else c for d, c in self.parts.items()})

    def inverse(self):
        """By the conjugates of one prime after the other."""
        if not self.parts:
            raise Undefined("a divisor is zero at the point")
        above, below = Number.of(1), self
        while any(d != 1 for d in below.parts):
            d = next(d for d in below.parts if d != 1)
            prime = int(fmpz(d).factor()[0][0])
            turned = below.conjugate(prime)
            above, below = above * turned, below * turned
        return above * Number.of(1 / below.parts[1])

    def is_zero(self):
        return not self.parts

    def sign(self):
        """1, 0 or -1, by an enclosure that excludes zero."""
        if self.is_zero():
            return 0
        kept = ctx.prec
        try:
            for precision in (64, 256, 1024, 4096, 16384):
                ctx.prec = precision
                value = sum((ball(c) * arb(d).sqrt() for d, c in self.parts.items()), arb(0))
                if value > 0:
                    return 1
                if value < 0:
                    return -1
        finally:
            ctx.prec = kept
        raise NotExpressible("the sign of a number")

    def root(self):
        """The non-negative root of a rational number."""
        if self.is_zero():
            return self
        value = self.parts.get(1)
        if set(self.parts) != {1} or isinstance(value, OfHalfTurn):
            raise NotExpressible("the root of an irrational number")
        if value < 0:
            raise Undefined("the root of a negative number at the point")
        whole = value.p * value.q
        outside, inside = 1, 1
        for factor, power in whole.factor():
            outside *= int(factor) ** (power // 2)
            inside *= int(factor) if power % 2 else 1
        return Number({inside: fmpq(outside, value.q)})


class ExactPoint:
    """A domain: letters, angles and functions have values at a point; what it leaves open takes a value of its own."""

    OPEN = fmpq(1)
    LETTERS = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47)
    OPEN_CIRCLE = (fmpq(3, 5), fmpq(4, 5))

    def __init__(self, letters, circles, functions):
        self.letters, self.circles, self.functions = letters, circles, functions
        self.opened = set()

    def constant(self, value):
        return Number.of(value)

    def letter(self, place):
        if place not in self.letters:
            # different ones, lest a determinant vanish
            self.letters[place] = Number.of(self.LETTERS[len(self.opened) % len(self.LETTERS)])
            self.opened.add(place)
        return self.letters[place]

    def circle(self, key):
        if key not in self.circles:
            self.opened.add(key)
            self.circles[key] = tuple(Number.of(each) for each in self.OPEN_CIRCLE)
        return self.circles[key]

    def root(self, square):
        return square.root()

    def function(self, name, value):
        key = (name, frozenset((d, str(c)) for d, c in value.parts.items()))
        if key not in self.functions:
            self.functions[key] = Number.of(self.OPEN)
        return self.functions[key]

    def elementary(self, name, *_):
        raise NotExpressible(f"a value of {name} at the point")

    def negative(self, one):
        return -one

    def add(self, one, other):
        return one + other

    def multiply(self, one, other):
        return one * other

    def power(self, one, exponent):
        result = one
        for _ in range(exponent - 1):
            result = result * one
        return result

    def divide(self, one, other):
        return one * other.inverse()

    def is_zero(self, one):
        return one.is_zero()
