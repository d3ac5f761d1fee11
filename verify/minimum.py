"""Stability of a steady motion by a minimum of the energy: symmetric linear equations, the minors of their matrices, and Lagrange's and Dirichlet's theorem.

The checker differentiates the equations of motion itself and forms the minors. Where those of the potential energy are positive the quadratic form has a
minimum; where one principal minor is negative it has a negative value, which gives a root with a positive real part (J. J. Sylvester; A. M. Lyapunov).
That the energy is kept beyond the linear equations is mechanics, which the workbench shows.
"""

from .certificate import Relation
from .certificate import part as read_part
from .derivative import rate
from .part_check import PartCheck, Rejected
from .products import products
from .stability import determinant_of
from .written_signs import written_signs

SIGNS = {"products": products, "written_signs": written_signs}


def minimum(check):
    """The printed condition is that of the minimum."""
    proof = check.part.proof
    for equation in proof["equations"]:
        if not check.vanishes(equation):
            raise Rejected("an equation of motion does not hold on the steady motion")
    inertia, damping, stiffness = (matrix(check, proof, key) for key in ("accelerations", "speeds", "coordinates"))
    size = len(proof["equations"])
    if any(len(row) != size for row in inertia):
        raise Rejected("there are not as many equations as coordinates")
    for one in range(size):
        for other in range(size):
            if not check.vanishes(damping[one][other]):
                raise Rejected("the linear equations hold speeds")
            for form in (inertia, stiffness):
                if not check.vanishes(check.emit("-", form[one][other], form[other][one])):
                    raise Rejected("the linear equations are not symmetric")
    leading = [range(count) for count in range(1, size + 1)]
    subsets = [[k for k in range(size) if number >> k & 1] for number in range(1, 1 << size)]
    for key, form, chosen in (("inertia", inertia, leading), ("leading", stiffness, leading), ("principal", stiffness, subsets)):
        same_minors(check, proof[key], form, chosen)
    implied(check, proof)


def matrix(check, proof, letters):
    one = check.emit("const", "1")
    return [[rate(check.program, equation, {letter: one}) for letter in proof[letters]] for equation in proof["equations"]]


def same_minors(check, entries, form, subsets):
    if len(entries) != len(subsets):
        raise Rejected("there are not as many minors as the theorem has")
    for entry, chosen in zip(entries, subsets):
        own = determinant_of(check, [[form[i][j] for j in chosen] for i in chosen])
        if not check.vanishes(check.emit("-", own, entry)):
            raise Rejected("a minor is not that of the linear equations")


def implied(check, proof):
    """The signs that the theorem asks for, each from what is given and what it adds."""
    printed = (proof["printed"], ">")
    asked = [((), entry, ">") for entry in proof["inertia"]]
    asked += [((printed,), entry, ">") for entry in proof["leading"]]
    asked.append((tuple((entry, ">=") for entry in proof["principal"]), proof["printed"], ">="))
    if len(asked) != len(proof["implied"]):
        raise Rejected("there are not as many signs as the theorem asks for")
    for (added, entry, kind), text in zip(asked, proof["implied"]):
        part = read_part(text, check.program)
        if part.steps != check.part.steps or part.proof["by"] not in SIGNS:
            raise Rejected("a sign is shown on another motion, or by no rule of signs")
        if [(each.kind, each.left) for each in part.then] != [(kind, entry)] or not is_zero(check, part.then[0]):
            raise Rejected("a sign is that of another expression")
        for relation in part.given:
            if not is_known(check, relation, added):
                raise Rejected("a sign rests on what is not given")
        inner = PartCheck(check.program, part, check.exact, check.parts, check.room)
        SIGNS[part.proof["by"]](inner)


def is_zero(check, relation):
    return check.program[relation.right] == ("const", "0")


def is_known(check, relation, added):
    """Whether a relation is given, in this form or another one, or was added."""
    if relation in check.part.given or is_zero(check, relation) and (relation.left, relation.kind) in added:
        return True

    def is_same(given: Relation):
        if given.kind != relation.kind:
            return False
        return check.vanishes(check.emit("-", check.difference(relation), check.difference(given)))

    return any(is_same(given) for given in check.part.given)
