"""Rational functions of the number pi. It is transcendental, so that one of them is zero only where it vanishes identically."""

from flint import arb, fmpq_poly


def polynomial(value):
    """A whole or rational number as a polynomial in pi."""
    return value if isinstance(value, fmpq_poly) else fmpq_poly([value])


class OfHalfTurn:
    """A quotient of polynomials in pi."""

    __slots__ = ("above", "below")

    def __init__(self, above, below=1):
        above, below = polynomial(above), polynomial(below)
        common = above.gcd(below)
        self.above, self.below = above // common, below // common

    @classmethod
    def itself(cls):
        """The number pi."""
        return cls(fmpq_poly([0, 1]))

    @classmethod
    def of(cls, value):
        return value if isinstance(value, cls) else cls(value)

    def __add__(self, other):
        other = OfHalfTurn.of(other)
        return OfHalfTurn(self.above * other.below + other.above * self.below, self.below * other.below)

    def __neg__(self):
        return OfHalfTurn(-self.above, self.below)

    def __mul__(self, other):
        other = OfHalfTurn.of(other)
        return OfHalfTurn(self.above * other.above, self.below * other.below)

    def __rtruediv__(self, above):
        return OfHalfTurn(polynomial(above) * self.below, self.above)

    __radd__, __rmul__ = __add__, __mul__

    def __eq__(self, other):
        return (self + -OfHalfTurn.of(other)).above == 0

    def __str__(self):
        # one text for each function
        lead = self.below[self.below.degree()]
        return f"({self.above / lead})/({self.below / lead})"

    def ball(self):
        """An enclosure, at the precision of now."""
        return at_half_turn(self.above) / at_half_turn(self.below)


def at_half_turn(polynomial_of_it):
    """The value of a polynomial at pi, by Horner's rule."""
    total = arb(0)
    for coefficient in reversed(polynomial_of_it.coeffs()):
        total = total * arb.pi() + arb(coefficient)
    return total


def ball(value):
    """An enclosure of a rational number, or of a function of pi."""
    return value.ball() if isinstance(value, OfHalfTurn) else arb(value)
