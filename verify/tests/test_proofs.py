"""Combinations, signs, points, enclosures and steps: what does not follow is rejected."""

import unittest

from verify.claim_check import check_claim

from .writing import Claim


def outcome(entry):
    return check_claim(entry, True).found


def combination(cofactor="2"):
    """From x - y = 0 follows 2 x - 2 y = 0."""
    claim = Claim()
    x, y, two, zero = claim.letter("x"), claim.letter("y"), claim.number(2), claim.number(0)
    then = claim.put("-", claim.product(two, x), claim.product(two, y))
    one = {"multiplier": [], "cofactors": [[0, claim.number(cofactor)]], "factor": None}
    given = [("=", claim.put("-", x, y), zero)]
    return claim.part([("=", then, zero)], {"by": "combination", "combinations": [one]}, given)


def signs(sign="+"):
    """m + x^2 > 0 where m > 0."""
    claim = Claim()
    m, x, zero = claim.letter("m"), claim.letter("x"), claim.number(0)
    then = [(">", claim.put(sign, m, claim.put("pow", x, 2)), zero)]
    return claim.part(then, {"by": "signs", "positive": [m]}, [(">", m, zero)])


def written(sign="+"):
    """(x - y)^2 + m > 0 where m > 0: its expansion mixes signs."""
    claim = Claim()
    m, x, y, zero = (*(claim.letter(name) for name in "mxy"), claim.number(0))
    then = [(">", claim.put(sign, claim.put("pow", claim.put("-", x, y), 2), m), zero)]
    return claim.part(then, {"by": "written_signs"}, [(">", m, zero)])


def products(number="1", edge=">"):
    """root(x) < x where x > 1: with r = root(x) and the opposite r - x >= 0 the products (r - x) r, (r - x) (x - 1), r - x, (x - 1)^2 and x - 1 add up
    to zero."""
    claim = Claim()
    x, zero = claim.letter("x"), claim.number(0)
    root, distance = claim.put("root", x), claim.put("-", x, claim.number(1))
    factors = [([1], [root]), ([0, 1], []), ([1], []), ([0, 0], []), ([0], [])]
    listed = [{"number": claim.number(1), "of": of, "roots": roots, "squares": []} for of, roots in factors]
    listed[-1]["number"] = claim.number(number)
    return claim.part([(">", x, root)], {"by": "products", "products": listed}, [(edge, distance, zero)])


def real_roots(edge="-21/10", kind=">"):
    """x^3 - 3 x + 3 > 0 where x > -2.1: its one real root is below -2.1."""
    claim = Claim()
    x, zero = claim.letter("x"), claim.number(0)
    cube = claim.sum(claim.put("pow", x, 3), claim.product(claim.number(-3), x), claim.number(3))
    return claim.part([(kind, cube, zero)], {"by": "real_roots"}, [(">", x, claim.number(edge))])



def number_pi(kind="=", above="2", value=None):
    """above pi m = 6 m, or >, fails where m = 1: pi is a number, to which the point gives no value."""
    claim = Claim("refuted")
    m, pi, zero = claim.letter("m"), claim.letter("pi"), claim.number(0)
    sides = claim.product(claim.number(above), pi, m), claim.product(claim.number(6), m)
    point = [[m, claim.number(1)]] + ([] if value is None else [[pi, claim.number(value)]])
    return claim.part([(kind, *sides)], {"by": "counterexample", "point": point}, [(">", pi, zero)])


def digits(printed="6284/1000"):
    """2 pi is less than a number."""
    claim = Claim("enclosed")
    return claim.part([(">", claim.number(printed), claim.product(claim.number(2), claim.letter("pi")))], {"by": "enclosure"})

def secant(is_square=True):
    """1/cos^2 x >= 1 for every angle at which it has a value; 1/cos x >= 1 fails."""
    claim = Claim()
    cos, one = claim.put("cos", claim.letter("x")), claim.number(1)
    below = claim.put("pow", cos, 2) if is_square else cos
    return claim.part([(">=", claim.put("/", one, below), one)], {"by": "real_roots"}, [("!=", cos, claim.number(0))])


def half_turn(value="-1"):
    """cos x = -1 where x = pi."""
    claim = Claim()
    x, pi = claim.letter("x"), claim.letter("pi")
    step = {"step": "solve", "letters": [x], "values": [pi], "by": [0]}
    return claim.part([("=", claim.put("cos", x), claim.number(value))], {"by": "identity"}, [("=", x, pi)], [step])


def counterexample(x="1/2", given=True):
    """x^2 = x fails at x = 1/2, where x > 0."""
    claim = Claim("refuted")
    letter, zero = claim.letter("x"), claim.number(0)
    point = {"by": "counterexample", "point": [[letter, claim.number(x)]]}
    presupposed = [(">", letter, zero)] if given else []
    return claim.part([("=", claim.put("pow", letter, 2), letter)], point, presupposed)


def circle(sine="4/5"):
    """cos x = sin x fails where they are 3/5 and 4/5."""
    claim = Claim("refuted")
    x = claim.letter("x")
    cos, sin = claim.put("cos", x), claim.put("sin", x)
    point = [[cos, claim.number("3/5")], [sin, claim.number(sine)]]
    return claim.part([("=", cos, sin)], {"by": "counterexample", "point": point})


def irrational(square="2"):
    """root(2) root(3) = root(7) fails, root(2) root(3) = root(6) does not."""
    claim = Claim("refuted")
    left = claim.product(claim.put("root", claim.number(2)), claim.put("root", claim.number(3)))
    right = claim.put("root", claim.number(square))
    return claim.part([("=", left, right)], {"by": "counterexample", "point": []})


def enclosure(digits):
    """cos(1/10) is this number to four decimals."""
    claim = Claim("enclosed")
    value, printed = claim.put("cos", claim.number("1/10")), claim.number(digits)
    half, zero = claim.number("1/20000"), claim.number(0)
    above = claim.put("-", value, claim.put("-", printed, half))
    below = claim.put("-", claim.put("+", printed, half), value)
    return claim.part([(">", above, zero), (">", below, zero)], {"by": "enclosure"})


def cancelling(power=1):
    """m cos(1/10) / m is a number; m cos(1/10) / m^2 is none."""
    claim = Claim("enclosed")
    m = claim.letter("m")
    quotient = claim.put("/", claim.product(m, claim.put("cos", claim.number("1/10"))), m if power == 1 else claim.put("pow", m, power))
    return claim.part([(">", quotient, claim.number("99/100"))], {"by": "enclosure"})


def oscillator(printed="k", sign="+"):
    """m q'' + c q' + k q = 0 with m, c > 0: the state of rest is stable where k > 0."""
    claim = Claim()
    m, c, k, q, u, a, s = (claim.letter(name) for name in ("m", "c", "k", "q", "u", "a", "s"))
    zero, one = claim.number(0), claim.number(1)
    equation = claim.sum(claim.product(m, a), claim.product(c, u), claim.product(k, q))
    given = [("=", each, zero) for each in (q, u, a)] + [(">", each, zero) for each in (m, c)]
    steps = [{"step": "solve", "letters": [each], "values": [zero], "by": [by]} for by, each in enumerate((q, u, a))]
    proof = {"by": "stability", "equations": [equation], "coordinates": [q], "speeds": [u], "accelerations": [a]}
    proof |= {"resting": [0], "root": s, "scale": one, "neutral": 0, "coefficients": [k, claim.put(sign, zero, c), m]}
    proof |= {"printed": claim.letter(printed), "ratio": [m, None]}
    return claim.part([(">", claim.letter(printed), zero)], proof, given, steps)


def minimum(printed="k", spring="+", trusted=False):
    """m q'' + k q = 0 with m > 0: the state of rest is stable where k > 0, and unstable where k < 0."""
    claim = Claim()
    m, k, q, u, a = (claim.letter(name) for name in "mkqua")
    zero = claim.number(0)
    equation = claim.put(spring, claim.product(m, a), claim.product(k, q))
    given = [("=", each, zero) for each in (q, u, a)] + [(">", m, zero)]
    steps = [{"step": "solve", "letters": [each], "values": [zero], "by": [by]} for by, each in enumerate((q, u, a))]
    told = claim.letter(printed)
    implied = [([], (">", m, zero)), ([(">", told, zero)], (">", k, zero)), ([(">=", k, zero)], (">=", told, zero))]
    parts = []
    for more, then in implied:
        relations = [{"is": kind, "left": left, "right": right} for kind, left, right in given + more + ([(">", k, zero)] if trusted else [])]
        then = [{"is": then[0], "left": then[1], "right": then[2]}]
        parts.append({"given": relations, "steps": steps, "rates": [], "then": then, "proof": {"by": "written_signs"}})
    proof = {"by": "minimum", "equations": [equation], "coordinates": [q], "speeds": [u], "accelerations": [a]}
    proof |= {"printed": told, "inertia": [m], "leading": [k], "principal": [k], "implied": parts}
    return claim.part([(">", told, zero)], proof, given, steps)


def solved(value="3", given=True):
    """From x - 3 = 0 follows x^2 = 9."""
    claim = Claim()
    x, three = claim.letter("x"), claim.number(3)
    steps = [{"step": "solve", "letters": [x], "values": [claim.number(value)], "by": [0]}]
    presupposed = [("=", claim.put("-", x, three) if given else claim.put("pow", x, 2), claim.number(0))]
    nine = claim.number(9 if value == "3" else int(value) ** 2)
    return claim.part([("=", claim.put("pow", x, 2), nine)], {"by": "identity"}, presupposed, steps)


def cosine_of_one():
    """cos 1 = sin 1 is false, but not since a point says that they are 3/5 and 4/5."""
    claim = Claim("refuted")
    one = claim.number(1)
    cos, sin = claim.put("cos", one), claim.put("sin", one)
    point = [[cos, claim.number("3/5")], [sin, claim.number("4/5")]]
    return claim.part([("=", cos, sin)], {"by": "counterexample", "point": point})


def hidden_angle():
    """y + cos x = 1 does not give y the value 0 where x is y."""
    claim = Claim()
    x, y, zero, one = claim.letter("x"), claim.letter("y"), claim.number(0), claim.number(1)
    given = [("=", x, y), ("=", claim.sum(y, claim.put("cos", x)), one)]
    steps = [{"step": "solve", "letters": [each], "values": [value], "by": [by]} for by, each, value in ((0, x, y), (1, y, zero))]
    return claim.part([("=", y, zero)], {"by": "identity"}, given, steps)


class Proofs(unittest.TestCase):
    def test_what_follows_is_accepted(self):
        for entry in (combination(), signs(), written(), enclosure("9950/10000"), solved()):
            self.assertEqual(outcome(entry), "accepted")
        for entry in (counterexample(), circle(), irrational("7")):
            self.assertEqual(outcome(entry), "confirmed")

    def test_a_wrong_cofactor_is_rejected(self):
        self.assertEqual(outcome(combination("-2")), "rejected")

    def test_terms_that_differ_in_sign_are_rejected(self):
        self.assertEqual(outcome(signs("-")), "rejected")
        self.assertEqual(outcome(written("-")), "rejected")

    def test_products_add_up_to_zero_and_one_of_them_is_positive(self):
        self.assertEqual(outcome(products()), "accepted")
        for wrong in (products("2"), products("-1"), products(edge=">="), products(edge="!=")):
            self.assertEqual(outcome(wrong), "rejected")

    def test_real_roots_decide_an_expression_in_one_unknown(self):
        self.assertEqual(outcome(real_roots()), "accepted")
        self.assertEqual(outcome(real_roots("-2104/1000")), "rejected")
        self.assertEqual(outcome(secant()), "accepted")
        self.assertEqual(outcome(secant(is_square=False)), "rejected")

    def test_a_minimum_has_the_minors_of_its_equations_and_their_signs(self):
        self.assertEqual(outcome(minimum()), "accepted")
        # another letter, the other sign of the spring, a hypothesis that is not given
        for wrong in (minimum("w"), minimum(spring="-"), minimum(trusted=True)):
            self.assertEqual(outcome(wrong), "rejected")

    def test_half_a_turn_has_its_cosine(self):
        self.assertEqual(outcome(half_turn()), "accepted")
        self.assertEqual(outcome(half_turn("1")), "rejected")

    def test_a_letter_that_is_not_given_as_positive_is_rejected(self):
        entry = signs()
        entry["parts"][0]["given"] = []
        self.assertEqual(outcome(entry), "rejected")

    def test_a_point_at_which_the_claim_holds_is_rejected(self):
        self.assertEqual(outcome(counterexample("1")), "rejected")
        self.assertEqual(outcome(irrational("6")), "rejected")

    def test_a_point_that_violates_the_hypotheses_is_rejected(self):
        self.assertEqual(outcome(counterexample("-1/2")), "rejected")
        self.assertEqual(outcome(counterexample("-1/2", given=False)), "confirmed")

    def test_a_point_off_the_circle_is_rejected(self):
        self.assertEqual(outcome(circle("1/2")), "rejected")

    def test_a_number_with_a_wrong_digit_is_rejected(self):
        self.assertEqual(outcome(enclosure("9951/10000")), "rejected")

    def test_the_condition_of_stability_is_that_of_the_roots(self):
        self.assertEqual(outcome(oscillator()), "accepted")
        self.assertEqual(outcome(oscillator("q")), "rejected")
        # another polynomial
        self.assertEqual(outcome(oscillator(sign="-")), "rejected")

    def test_a_letter_without_a_value_must_cancel(self):
        self.assertEqual(outcome(cancelling()), "accepted")
        self.assertEqual(outcome(cancelling(2)), "rejected")

    def test_pi_is_a_number_to_which_no_point_gives_a_value(self):
        self.assertEqual(outcome(number_pi()), "confirmed")
        self.assertEqual(outcome(number_pi(">", "1")), "confirmed")
        # 2 pi m > 6 m holds there
        self.assertEqual(outcome(number_pi(">")), "rejected")
        self.assertEqual(outcome(number_pi(value="1")), "rejected")
        self.assertEqual(outcome(digits()), "accepted")
        self.assertEqual(outcome(digits("6283/1000")), "rejected")

    def test_no_point_chooses_the_cosine_of_a_number(self):
        self.assertEqual(outcome(cosine_of_one()), "rejected")

    def test_an_equality_with_the_letter_inside_an_angle_is_not_linear(self):
        self.assertEqual(outcome(hidden_angle()), "rejected")

    def test_a_value_that_does_not_follow_is_rejected(self):
        self.assertEqual(outcome(solved("4")), "rejected")
        self.assertEqual(outcome(solved(given=False)), "rejected")

    def test_a_proof_must_show_the_verdict(self):
        entry = counterexample()
        entry["verdict"] = "proved"
        self.assertEqual(outcome(entry), "rejected")

    def test_an_entry_that_is_none_is_rejected(self):
        for bad in (["+", 0, 9], ["letter"], ["pow", 0, 1], ["unknown", 0], []):
            entry = combination()
            entry["program"].insert(0, bad)
            self.assertEqual(outcome(entry), "rejected")
        for key, bad in (("positive", [-1]), ("positive", ["m"]), ("by", "trust")):
            entry = signs()
            entry["parts"][0]["proof"][key] = bad
            self.assertEqual(outcome(entry), "rejected")

    def test_a_claim_without_a_certificate_says_why(self):
        self.assertEqual(outcome({"id": "test/eq1", "verdict": "definition", "none": "it makes no claim"}), "none")
        self.assertEqual(outcome({"id": "test/eq1", "verdict": "proved"}), "rejected")


if __name__ == "__main__":
    unittest.main()
