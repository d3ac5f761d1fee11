"""Sums of products that vanish, although what is given and the opposite of the conclusion would make one of them positive."""

from .evaluation import number
from .part_check import Rejected


def products(check):
    """All products are not negative where everything given and the opposite of the conclusion hold, one is positive, and their sum vanishes."""
    given, then = check.part.given, check.part.then
    if len(then) != 1 or then[0].kind not in (">", ">="):
        raise Rejected("products show one sign")
    # the opposite of f > 0 is -f >= 0, and that of f >= 0 is -f > 0
    opposite = check.emit("neg", check.difference(then[0])), then[0].kind == ">="
    total, is_positive = check.emit("const", "0"), False
    for one in check.part.proof["products"]:
        value, is_strict = product(check, one, opposite, given)
        total = check.emit("+", total, value)
        is_positive = is_positive or is_strict
    if not is_positive:
        raise Rejected("none of the products is positive")
    if not check.vanishes(total):
        raise Rejected("the sum of the products does not vanish")


def product(check, one, opposite, given):
    """The entry of a product, and whether it excludes zero."""
    name, *rest = check.program[one["number"]]
    if name != "const" or number(rest[0]) <= 0:
        raise Rejected("a product has no positive number")
    value, is_strict = one["number"], not one["roots"] and not one["squares"]
    for place in sorted(set(one["of"])):
        times = one["of"].count(place)
        if place == len(given):
            entry, excludes_zero = opposite
        else:
            entry, excludes_zero = check.difference(given[place]), sign_of(given[place], times)
        is_strict = is_strict and excludes_zero
        for _ in range(times):
            value = check.emit("*", value, entry)
    for root in one["roots"]:
        if check.program[root][0] != "root":
            raise Rejected("a factor is said to be a root, and is none")
        value = check.emit("*", value, root)
    for entry in one["squares"]:
        value = check.emit("*", value, check.emit("*", entry, entry))
    return value, is_strict


def sign_of(relation, times):
    """Whether so many factors with this relation exclude zero; they are not negative together."""
    if relation.kind == "!=" and times % 2 or relation.kind not in (">", ">=", "!="):
        raise Rejected("a factor may be negative")
    return relation.kind != ">="
