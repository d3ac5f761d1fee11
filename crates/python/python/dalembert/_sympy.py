"""SymPy's expressions as texts of the language of models, and back. SymPy is imported where it is used."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import SimpleNamespace
from typing import Any

__all__ = ["from_sympy", "to_sympy", "written"]

_FUNCTIONS = {
    "sin": "sin",
    "cos": "cos",
    "tan": "tan",
    "exp": "exp",
    "log": "ln",
    "tanh": "tanh",
    "sinh": "sinh",
    "cosh": "cosh",
    "asin": "asin",
    "acos": "acos",
    "atan": "atan",
    "atan2": "atan2",
    "Abs": "abs",
    "sign": "sign",
    "Min": "min",
    "Max": "max",
}
_INVERSE = {"sec": "1/cos({})", "csc": "1/sin({})", "cot": "cos({0})/sin({0})"}
_GREEK = set("alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi omega".split())


def needed() -> Any:
    """SymPy, or the way to it."""
    try:
        import sympy
    except ImportError:
        raise ImportError('SymPy is not installed; `pip install "dalembert[sympy]"` or `pip install sympy` brings it') from None
    return sympy


def plain(name: str) -> str:
    """A name of SymPy as one of the language of models: `\\theta_{1}` is theta_1."""
    return name.replace("\\", "").replace("{", "").replace("}", "").replace(" ", "_")


def from_sympy(expression: Any, names: Mapping[Any, str] | None = None) -> str:
    """The text of an expression of SymPy in the language of models.

    Functions of the time are called as they are, q(t) is q and its derivatives q' and q''; `names` gives others by symbol or by name:
    from_sympy(q1.diff()**2, {"q1": "theta"}) is "theta'^2".
    """
    given = {_name(known): value for known, value in (names or {}).items()}

    def name_of(name: str, order: int) -> str:
        if name not in given:
            return plain(name) + "'" * order
        meant = given[name]
        if order == 0:
            return meant if meant.replace("_", "a").replace("'", "a").isalnum() else f"({meant})"
        if meant.replace("_", "a").isalnum():
            return meant + "'" * order
        for _ in range(order):
            meant = f"rate({meant})"
        return meant

    return written(needed().sympify(expression), name_of)


def _name(known: Any) -> str:
    """The name of a symbol, of a function of the time, or of a text."""
    if isinstance(known, str):
        return known
    return known.func.__name__ if getattr(known, "args", ()) else known.name


def written(expression: Any, name_of: Callable[[str, int], str]) -> str:
    """The text of an expression whose letters have the names that a function gives by name and number of derivatives."""
    sympy = needed()
    from sympy.core.function import AppliedUndef
    from sympy.physics.vector import dynamicsymbols

    time = dynamicsymbols._t

    def refused(part: Any, why: str) -> ValueError:
        return ValueError(f"{part} cannot be written in the language of models: {why}")

    # a number for each level: sums 1, products 2, powers 3, all else 4
    def held(part: Any, level: int) -> str:
        text, own = told(part)
        return text if own >= level else f"({text})"

    def number(value: Any) -> tuple[str, int]:
        if value.is_Float:
            text = repr(float(value)) if value._prec <= 53 else str(value)
            if text.lstrip("-") in ("inf", "nan"):
                raise refused(value, "it is no finite number")
        else:
            text = str(value)
        if text.startswith("-"):
            return text, 1
        return text, 2 if "/" in text else 4

    def told(part: Any) -> tuple[str, int]:
        if part == time:
            return "t", 4
        if part is sympy.pi:
            return "pi", 4
        if part.is_Rational or part.is_Float:
            return number(part)
        if part is sympy.E:
            return "exp(1)", 4
        if part.is_Symbol:
            return name_of(part.name, 0), 4
        if isinstance(part, AppliedUndef):
            if part.args != (time,):
                raise refused(part, f"functions of {time} alone are accepted")
            return name_of(part.func.__name__, 0), 4
        if isinstance(part, sympy.Derivative):
            function, *by = part.args
            if not isinstance(function, AppliedUndef) or function.args != (time,) or any(one[0] != time for one in by):
                raise refused(part, "derivatives of functions of the time by the time are accepted; .doit() may give some")
            return name_of(function.func.__name__, int(sum(one[1] for one in by))), 4
        if part.is_Add:
            terms = [text if level > 1 or text.startswith("-") else f"({text})" for text, level in map(told, part.as_ordered_terms())]
            return "".join(term if i == 0 else f" - {term[1:]}" if term.startswith("-") else f" + {term}" for i, term in enumerate(terms)), 1
        if part.is_Mul:
            return product(part)
        if part.is_Pow:
            return power(part.base, part.exp)
        if part.is_Piecewise:
            return pieces(part), 4
        name = type(part).__name__
        if name in _INVERSE:
            return _INVERSE[name].format(told(part.args[0])[0]), 2
        if name in _FUNCTIONS:
            return f"{_FUNCTIONS[name]}({', '.join(told(one)[0] for one in part.args)})", 4
        raise refused(part, f"{name} is no function of the language")

    def product(part: Any) -> tuple[str, int]:
        coefficient, rest = part.as_coeff_Mul()
        if coefficient.is_number and coefficient.is_negative:
            text, level = told(-coefficient * rest)
            return "-" + (text if level >= 2 else f"({text})"), 1
        above: list[str] = []
        below: list[str] = []
        for one in part.args:
            if one.is_Pow and one.exp.is_Rational and one.exp.is_negative:
                below.append(held(one.base ** -one.exp, 3))
            elif one.is_Rational and one.q != 1:
                below.append(str(one.q))
                if one.p != 1:
                    above.insert(0, str(one.p))
            else:
                above.append(held(one, 3) if not one.is_Mul else f"({told(one)[0]})")
        text = "*".join(above) or "1"
        if below:
            text += "/" + (below[0] if len(below) == 1 else f"({'*'.join(below)})")
        return text, 2

    def power(base: Any, exponent: Any) -> tuple[str, int]:
        if base is sympy.E:
            return f"exp({told(exponent)[0]})", 4
        if exponent.is_Rational and exponent.is_negative:
            return f"1/{held(base ** -exponent, 3)}", 2
        if exponent == sympy.Rational(1, 2):
            return f"sqrt({told(base)[0]})", 4
        if exponent.is_Integer:
            if exponent > 64:
                raise refused(base**exponent, "exponents up to 64 are accepted")
            return f"{held(base, 4)}^{exponent}", 3
        if exponent.is_Rational:
            return f"{held(base, 4)}^({exponent})", 3
        return f"exp(({told(exponent)[0]})*ln({told(base)[0]}))", 4

    def pieces(part: Any) -> str:
        value, condition = part.args[0]
        if condition == True or len(part.args) == 1:  # noqa: E712, a truth value of SymPy
            return f"({told(value)[0]})"
        relation = {"StrictLessThan": "<", "LessThan": "<=", "StrictGreaterThan": ">", "GreaterThan": ">="}.get(type(condition).__name__)
        if relation is None:
            raise refused(part, "conditions with <, <=, > and >= are accepted")
        test = f"{told(condition.lhs)[0]} {relation} {told(condition.rhs)[0]}"
        return f"if({test}, {told(value)[0]}, {pieces(type(part)(*part.args[1:], evaluate=False))})"

    return told(expression)[0]


def to_sympy(program: str) -> SimpleNamespace:
    """The objects of a program for SymPy, as `Equations.sympy` writes it."""
    needed()
    space: dict[str, Any] = {}
    exec(compile(program, "<equations of motion>", "exec"), space)
    from sympy import Basic
    from sympy.matrices import MatrixBase

    found = {name: value for name, value in space.items() if isinstance(value, (Basic, MatrixBase)) and not name.startswith("_")}
    words = {"pi"}
    parts = ("t", "q", "u", "kinematics", "mass_matrix", "inertia", "forces", "constraints", "jacobian", "bias", "multipliers", "equations")
    letters = {name: value for name, value in found.items() if name not in words and name not in parts}
    return SimpleNamespace(letters=letters, values=space.get("values", {}), **{name: found[name] for name in parts if name in found})
