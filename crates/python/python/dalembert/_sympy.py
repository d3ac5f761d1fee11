"""SymPy's expressions as texts of the language of models, and back. SymPy is imported where it is used."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import SimpleNamespace
from typing import Any

from ._arguments import shown
from ._letters import MEANINGS, given_meanings, is_letter, letters_of, meanings_of, name_of, plain, told

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
}
# of two arguments each
_NESTED = {"Min": "min", "Max": "max"}
_RELATIONS = {"StrictLessThan": "<", "LessThan": "<=", "StrictGreaterThan": ">", "GreaterThan": ">="}
_INVERSE = {"sec": "1/cos({})", "csc": "1/sin({})", "cot": "cos({0})/sin({0})"}
# of powers, in the language
_LARGEST = 64
# of one, in an exponent with decimals
_PARTS = 1000


def needed() -> Any:
    """SymPy, or the way to it."""
    try:
        import sympy
    except ImportError:
        raise ImportError('SymPy is not installed; `pip install "dalembert[sympy]"` or `pip install sympy` brings it') from None
    return sympy


def from_sympy(expression: Any, names: Mapping[Any, str] | None = None) -> str:
    """The text of an expression of SymPy in the language of models.

    Functions of the time are called as they are, q(t) is q and its derivatives q' and q''; `names` gives others by symbol or by name:
    from_sympy(q1.diff()**2, {"q1": "theta"}) is "theta'^2". A symbol whose name is no name of the language needs one there, and so do two symbols
    that would become one letter, such as `m_{1}` and `m_1`. Raises ValueError for them, and for what the language does not have; TypeError for what is
    no expression.
    """
    sympy = needed()
    from sympy.physics.vector import dynamicsymbols

    try:
        scalar = sympy.sympify(expression, strict=True)
    except sympy.SympifyError:
        scalar = None
    if not isinstance(scalar, sympy.Expr) or getattr(scalar, "is_Matrix", False):
        raise TypeError(f"`expression` is {shown(expression)}; a scalar expression of SymPy is accepted")
    symbols = letters_of([scalar], dynamicsymbols._t)
    meanings = meanings_of(symbols, given_meanings(names))
    for symbol in symbols:
        if symbol not in meanings and not is_letter(plain(name_of(symbol))):
            raise ValueError(f"{told(symbol)} has a name that no letter of the language has; {MEANINGS}")

    def letter(symbol: Any, order: int) -> str:
        meant = meanings.get(symbol, plain(name_of(symbol)))
        if is_letter(meant):
            return meant + "'" * order
        for _ in range(order):
            meant = f"rate({meant})"
        return meant if order or is_letter(meant.rstrip("'")) else f"({meant})"

    return written(scalar, letter)


def written(expression: Any, letter: Callable[[Any, int], str]) -> str:
    """The text of an expression whose letters a function gives by symbol and number of derivatives."""
    sympy = needed()
    from sympy.core.function import AppliedUndef
    from sympy.physics.vector import dynamicsymbols

    time = dynamicsymbols._t

    def refused(part: Any, why: str) -> ValueError:
        return ValueError(f"{part} cannot be written in the language of models: {why}")

    # a number for each level: sums 1, products 2, powers 3, all else 4
    def held(part: Any, level: int) -> str:
        text, own = text_of(part)
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

    def text_of(part: Any) -> tuple[str, int]:
        if part == time:
            return "t", 4
        if part is sympy.pi:
            return "pi", 4
        if part.is_Rational or part.is_Float:
            return number(part)
        if part in (sympy.oo, -sympy.oo, sympy.zoo, sympy.nan):
            raise refused(part, "it is no finite number")
        if part is sympy.E:
            return "exp(1)", 4
        if part.is_Symbol:
            return letter(part, 0), 4
        if isinstance(part, AppliedUndef):
            if part.args != (time,):
                raise refused(part, f"functions of {time} alone are accepted")
            return letter(part, 0), 4
        if isinstance(part, sympy.Derivative):
            function, *by = part.args
            if not isinstance(function, AppliedUndef) or function.args != (time,) or any(one[0] != time for one in by):
                raise refused(part, "time derivatives of functions of the time are accepted; .doit() may give some")
            order = sum(one[1] for one in by)
            if order not in (1, 2):
                raise refused(part, "the first and the second time derivative are accepted")
            return letter(function, int(order)), 4
        if part.is_Add:
            terms = [text if level > 1 or text.startswith("-") else f"({text})" for text, level in map(text_of, part.as_ordered_terms())]
            return "".join(term if i == 0 else f" - {term[1:]}" if term.startswith("-") else f" + {term}" for i, term in enumerate(terms)), 1
        if part.is_Mul:
            return product(part)
        if part.is_Pow:
            return power(part.base, part.exp)
        if part.is_Piecewise:
            return pieces(part), 4
        name = type(part).__name__
        if name in _NESTED:
            *others, last = part.args
            text = text_of(last)[0]
            for one in reversed(others):
                text = f"{_NESTED[name]}({text_of(one)[0]}, {text})"
            return text, 4
        if name == "Step":
            return f"if({text_of(part.args[0])[0]} > 0, 1, 0)", 4
        if name in _INVERSE:
            return _INVERSE[name].format(text_of(part.args[0])[0]), 2
        if name in _FUNCTIONS:
            return f"{_FUNCTIONS[name]}({', '.join(text_of(one)[0] for one in part.args)})", 4
        raise refused(part, f"{name} is no function of the language")

    def product(part: Any) -> tuple[str, int]:
        coefficient, rest = part.as_coeff_Mul()
        if coefficient.is_number and coefficient.is_negative:
            text, level = text_of(-coefficient * rest)
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
                above.append(held(one, 3) if not one.is_Mul else f"({text_of(one)[0]})")
        text = "*".join(above) or "1"
        if below:
            text += "/" + (below[0] if len(below) == 1 else f"({'*'.join(below)})")
        return text, 2

    def power(base: Any, exponent: Any) -> tuple[str, int]:
        if base is sympy.E:
            return f"exp({text_of(exponent)[0]})", 4
        if exponent.is_Rational or exponent.is_Float:
            # a decimal fraction of few digits is meant so
            near = sympy.Rational(str(exponent))
            exponent = near if near == exponent or float(near) == float(exponent) else exponent
            if abs(exponent) > _LARGEST:
                raise refused(base**exponent, f"exponents from -{_LARGEST} to {_LARGEST} are accepted")
            if exponent.is_negative:
                return f"1/{held(base ** -exponent, 3)}", 2
            if exponent == sympy.Rational(1, 2):
                return f"sqrt({text_of(base)[0]})", 4
            if exponent.is_Integer:
                return f"{held(base, 4)}^{exponent}", 3
            if exponent.is_Rational and max(exponent.p, exponent.q) <= _LARGEST:
                return f"{held(base, 4)}^({exponent})", 3
            if exponent.is_Rational and _PARTS % exponent.q == 0:
                return f"{held(base, 4)}^{float(exponent)}", 3
        return f"exp(({text_of(exponent)[0]})*ln({text_of(base)[0]}))", 4

    def pieces(part: Any) -> str:
        if sympy.Or(*(condition for _, condition in part.args)) != True:  # noqa: E712, a truth value of SymPy
            raise refused(part, "a last piece with the condition True is accepted, so that there is a value everywhere")
        cases = []
        for value, condition in part.args:
            known = condition if condition in (True, False) else _decided(condition)
            cases += [(value, condition)] if known is None else [(value, sympy.true)] if known else []
            if known:
                break
        *others, (value, _) = cases
        text = text_of(value)[0] if others else f"({text_of(value)[0]})"
        for value, condition in reversed(others):
            relation = _RELATIONS.get(type(condition).__name__)
            if relation is None:
                raise refused(part, "conditions with <, <=, > and >= are accepted")
            text = f"if({text_of(condition.lhs)[0]} {relation} {text_of(condition.rhs)[0]}, {text_of(value)[0]}, {text})"
        return text

    return text_of(expression)[0]


def _decided(condition: Any) -> bool | None:
    """Whether a comparison of equal sides holds; None for other comparisons. SymPy leaves them, for sides that may be complex."""
    if type(condition).__name__ not in _RELATIONS or condition.lhs != condition.rhs:
        return None
    return type(condition).__name__ in ("LessThan", "GreaterThan")


def to_sympy(program: str) -> SimpleNamespace:
    """The objects of a program for SymPy, as `Equations.sympy` writes it."""
    needed()
    from sympy import Basic
    from sympy.matrices import MatrixBase

    from ._step import unfolded

    space = unfolded(program)
    found = {name: value for name, value in space.items() if isinstance(value, (Basic, MatrixBase)) and not name.startswith("_")}
    words = {"pi"}
    parts = ("t", "q", "u", "kinematics", "mass_matrix", "inertia", "forces", "constraints", "jacobian", "bias", "multipliers", "equations")
    letters = {name: value for name, value in found.items() if name not in words and name not in parts}
    return SimpleNamespace(letters=letters, values=space.get("values", {}), **{name: found[name] for name in parts if name in found})
