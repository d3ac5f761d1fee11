"""True claims are accepted, and those with one sign turned are not."""

import unittest

from verify.claim_check import check_claim

from .writing import Claim

IDENTITY = {"by": "identity"}


def found(entry):
    """What both ways of looking at differences find."""
    return {check_claim(entry, exact).found for exact in (False, True)}


def double_angle(sign):
    """sin 2x = 2 sin x cos x, and cos(a + b) by the addition theorem."""
    claim = Claim()
    x, y = claim.letter("x"), claim.letter("y")
    two = claim.number(2)
    left = claim.put("sin", claim.product(two, x))
    right = claim.product(two, claim.put("sin", x), claim.put("cos", x))
    of_sum = claim.put("cos", claim.sum(x, y))
    cosines = claim.product(claim.put("cos", x), claim.put("cos", y))
    sines = claim.product(claim.put("sin", x), claim.put("sin", y))
    return claim.part([("=", left, right), ("=", of_sum, claim.put(sign, cosines, sines))], IDENTITY)


def halves(sign):
    """tan(x/2) = sin x / (1 + cos x): x and x/2 have a common step."""
    claim = Claim()
    x = claim.letter("x")
    half = claim.put("/", x, claim.number(2))
    left = claim.put("/", claim.put("sin", half), claim.put("cos", half))
    right = claim.put("/", claim.put("sin", x), claim.put(sign, claim.number(1), claim.put("cos", x)))
    return claim.part([("=", left, right)], IDENTITY)


def roots(sign):
    """(r - s)(r + s) = x - y for the roots r, s of x and y."""
    claim = Claim()
    x, y = claim.letter("x"), claim.letter("y")
    r, s = claim.put("root", x), claim.put("root", y)
    left = claim.product(claim.put("-", r, s), claim.put("+", r, s))
    return claim.part([("=", left, claim.put(sign, x, y))], IDENTITY)


def unit_vector(sign):
    """(a^2 + b^2)/(1 - c) = 1 + c where a^2 + b^2 + c^2 = 1."""
    claim = Claim()
    a, b, c = (claim.letter(name) for name in "abc")
    one = claim.number(1)
    squares = [claim.put("pow", each, 2) for each in (a, b, c)]
    left = claim.put("/", claim.sum(*squares[:2]), claim.put("-", one, c))
    given = [("=", claim.sum(*squares), one)]
    steps = [{"step": "rewrite", "letter": c, "power": 2, "by": 0}]
    return claim.part([("=", left, claim.put(sign, one, c))], IDENTITY, given, steps)


def pendulum(sign):
    """The rate of u^2/2 - g cos(q)/l vanishes where l u' + g sin q = 0."""
    claim = Claim()
    q, u, rate, g, length = (claim.letter(name) for name in ("q", "u", "u'", "g", "l"))
    pull = claim.product(g, claim.put("sin", q))
    given = [("=", claim.sum(claim.product(length, rate), pull), claim.number(0))]
    value = claim.put("neg", claim.put("/", pull, length))
    steps = [{"step": "solve", "letters": [rate], "values": [value], "by": [0]}]
    kinetic = claim.put("/", claim.put("pow", u, 2), claim.number(2))
    energy = claim.put(sign, kinetic, claim.put("/", claim.product(g, claim.put("cos", q)), length))
    then = [("rate", energy, claim.number(0))]
    return claim.part(then, IDENTITY, given, steps, [[q, u], [u, rate]])


class Identities(unittest.TestCase):
    def test_true_claims_are_accepted_and_false_ones_are_rejected(self):
        for claim, right, wrong in (
            (double_angle, "-", "+"),
            (halves, "+", "-"),
            (roots, "-", "+"),
            (unit_vector, "+", "-"),
            (pendulum, "-", "+"),
        ):
            with self.subTest(claim.__name__):
                self.assertEqual(found(claim(right)), {"accepted"})
                self.assertEqual(found(claim(wrong)), {"rejected"})

    def test_the_root_of_a_square_is_not_the_letter(self):
        claim = Claim()
        x = claim.letter("x")
        claim.part([("=", claim.put("root", claim.put("pow", x, 2)), x)], IDENTITY)
        self.assertEqual(found(claim.entry), {"rejected"})

    def test_roots_are_not_negative(self):
        claim = Claim()
        x, y = claim.letter("x"), claim.letter("y")
        quotient = claim.put("root", claim.put("/", x, y))
        product = claim.put("/", claim.put("root", claim.product(x, y)), y)
        claim.part([("=", quotient, product)], IDENTITY)
        self.assertEqual(found(claim.entry), {"rejected"})

    def test_numbers_come_out_of_roots(self):
        claim = Claim()
        x, eight, two = claim.letter("x"), claim.number(8), claim.number(2)
        left = claim.put("root", claim.product(eight, x))
        right = claim.product(two, claim.put("root", two), claim.put("root", x))
        claim.part([("=", left, right)], IDENTITY)
        self.assertEqual(check_claim(claim.entry, True).found, "accepted")

    def test_the_error_of_identity_testing_is_told(self):
        outcome = check_claim(double_angle("-"), False)
        self.assertEqual(outcome.how, "tested")
        self.assertLess(outcome.error, -200)
        self.assertEqual(check_claim(double_angle("-"), True).how, "exact")

    def test_a_divisor_that_vanishes_shows_nothing(self):
        claim = Claim()
        x = claim.letter("x")
        quotient = claim.put("/", x, claim.put("-", x, x))
        claim.part([("=", quotient, quotient)], IDENTITY)
        self.assertEqual(found(claim.entry), {"rejected"})
        claim.entry["verdict"] = "undefined"
        claim.entry["parts"][0]["proof"] = {"by": "undefined", "divisor": claim.put("-", x, x)}
        self.assertEqual(check_claim(claim.entry, True).found, "confirmed")


if __name__ == "__main__":
    unittest.main()
