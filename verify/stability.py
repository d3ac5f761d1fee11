"""Stability of a steady motion in the first approximation: linear equations, their characteristic polynomial, and Hurwitz's theorem.

The checker differentiates the equations of motion itself, forms the determinant, and writes down the conditions that the theorem has for
these coefficients. Of the theorem it trusts what it says (A. Hurwitz, Math. Ann. 46 (1895), 273-284).
"""

from .derivative import rate
from .evaluation import Evaluation, reached
from .part_check import Rejected
from .point_check import all_given_hold, exact_point, independent_angles
from .expanded_signs import is_positive


def stability(check):
    """The printed condition is that of the roots, or differs from it at a point."""
    proof = check.part.proof
    for equation in proof["equations"]:
        if not check.vanishes(equation):
            raise Rejected("an equation of motion does not hold on the steady motion")
    coefficients, root = proof["coefficients"], proof["root"]
    if check.program[root][0] != "letter" or root in reached(check.program, coefficients + [proof["scale"], proof["printed"]]):
        raise Rejected("a coefficient holds the root")
    if not 0 <= proof["neutral"] <= len(proof["equations"]) - len(set(proof["resting"])):
        raise Rejected("there are more roots zero than speeds that are constant")
    polynomial = check.emit("const", "0")
    for power, coefficient in enumerate(coefficients):
        term = check.emit("*", coefficient, power_of(check, root, power + proof["neutral"]))
        polynomial = check.emit("+", polynomial, term)
    determinant = check.emit("*", determinant_of(check, matrix(check, proof)), proof["scale"])
    if not check.vanishes(check.emit("-", determinant, polynomial)):
        raise Rejected("the polynomial is not the characteristic one")
    if check.vanishes(proof["scale"]):
        raise Rejected("the polynomial is a multiple by zero")
    conditions = conditions_of(check, coefficients)
    if "point" in proof:
        differ_at_point(check, conditions, proof["printed"])
    else:
        same(check, conditions, proof)


def power_of(check, root, power):
    result = check.emit("const", "1")
    for _ in range(power):
        result = check.emit("*", result, root)
    return result


def matrix(check, proof):
    """The linear equations: s^2 M + s D + K for what rests, s M + D for speeds that are constant."""
    one, root = check.emit("const", "1"), proof["root"]
    rows = []
    for equation in proof["equations"]:
        row = []
        for place, letters in enumerate(zip(proof["coordinates"], proof["speeds"], proof["accelerations"])):
            stiffness, damping, inertia = (rate(check.program, equation, {letter: one}) for letter in letters)
            entry = check.emit("+", check.emit("*", inertia, root), damping)
            if place in proof["resting"]:
                entry = check.emit("+", check.emit("*", entry, root), stiffness)
            elif not check.vanishes(stiffness):
                raise Rejected("the linear equations know a coordinate that does not rest")
            row.append(entry)
        rows.append(row)
    if any(len(row) != len(rows) for row in rows):
        raise Rejected("there are not as many equations as coordinates")
    return rows


def determinant_of(check, rows):
    """By the first row."""
    if not rows:
        return check.emit("const", "1")
    total = check.emit("const", "0")
    for place, entry in enumerate(rows[0]):
        minor = [[value for column, value in enumerate(row) if column != place] for row in rows[1:]]
        term = check.emit("*", entry, determinant_of(check, minor))
        total = check.emit("-" if place % 2 else "+", total, term)
    return total


def conditions_of(check, coefficients):
    """What must be positive by the theorem."""

    def times(*factors):
        result = check.emit("const", "1")
        for factor in factors:
            result = check.emit("*", result, factor)
        return result

    def less(one, other):
        return check.emit("-", one, other)

    falling = coefficients[::-1]
    degree = len(falling) - 1
    if all(check.vanishes(odd) for odd in coefficients[1::2]) and degree in (2, 4):
        a, _, c, *rest = falling
        if degree == 2:
            return [times(a, c)]
        e = rest[1]
        return [times(a, c), times(a, e), less(times(c, c), times(check.emit("const", "4"), a, e))]
    if degree == 1:
        return [times(*falling)]
    if degree == 2:
        a, b, c = falling
        return [times(a, b), times(a, c)]
    if degree == 3:
        a, b, c, d = falling
        return [times(a, b), times(a, d), less(times(b, c), times(a, d))]
    if degree == 4:
        a, b, c, d, e = falling
        inner = less(times(d, less(times(b, c), times(a, d))), times(b, b, e))
        return [times(a, b), times(a, c), times(a, e), times(a, inner)]
    raise Rejected(f"the theorem is not written down for the degree {degree}")


def same(check, conditions, proof):
    """All conditions but one are positive by their signs, and that one is a positive multiple of the printed one."""
    left = [condition for condition in conditions if not is_positive(check, condition)]
    if len(left) != 1:
        raise Rejected("the signs of terms leave not one condition of the roots, but others too")
    ratio, square = proof["ratio"]
    multiple = check.emit("*", ratio, proof["printed"])
    if square is not None:
        place, power = square
        relation = check.part.given[place]
        if relation.kind == "=" or power not in (2, 4):
            raise Rejected("a factor is no even power of what differs from zero")
        multiple = check.emit("*", multiple, check.emit("pow", check.difference(relation), power))
    if not check.vanishes(check.emit("-", left[0], multiple)):
        raise Rejected("the condition of the roots is no such multiple of the printed one")
    if not is_positive(check, ratio):
        raise Rejected("the ratio of the conditions is not positive by its signs")


def differ_at_point(check, conditions, printed):
    """The printed condition holds and one of the roots fails, or the other way round."""
    point, formal = exact_point(check)
    values = Evaluation(check.program, check.solves, point, check.angles)
    all_given_hold(check, values)
    independent_angles(check, formal)
    signs = [values.value(condition).sign() for condition in conditions]
    said = values.value(printed).sign()
    if not (said == 1 and -1 in signs or said == -1 and all(sign == 1 for sign in signs)):
        raise Rejected("the printed condition and that of the roots agree at the point")
