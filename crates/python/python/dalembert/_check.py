"""Equations of motion of SymPy beside those of a model."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from html import escape
from typing import Any

from ._apart import apart
from ._arguments import shown
from ._html import COLOURS, formula, table
from ._letters import given_meanings, letters_of, meanings_of, name_of, plain
from ._model import Model
from ._refusals import refusal
from ._sympy import needed, written

__all__ = ["Check", "CheckedEquation", "check"]

# longer equations are handed over with their common parts by themselves
_LONG = 200
# longer ones are not printed
_PRINTED = 2000
# characters of a divisor that is printed
_READABLE = 300
# characters of a text of the language
_LONGEST_TEXT = 10_000
# names that are made here
_MADE = re.compile(r"(letter|speed_of_method|meaning_of_speed|multiplier_of_method|long_part|common_part)_\d+")


@dataclass(frozen=True)
class CheckedEquation:
    """The finding on one equation of motion of SymPy.

    name: the speed along which it is written, or the constraint. verdict: proved, identified, refuted, undecided or undefined; sentence says on
    what ground. printed: SymPy's left side in LaTeX. left: the value of the left side with the model's accelerations put in, text and LaTeX, where it
    is not zero and can be read. terms: the terms that differ from the model's equation along the same speed, dictionaries with `of` (the acceleration
    whose coefficient differs; None of terms without accelerations), `theirs`, `ours` and `difference`, theirs less ours, each text and LaTeX. point:
    exact numbers at which the equation does not hold.
    """

    name: str
    verdict: str
    sentence: str
    printed: str = field(repr=False)
    left: tuple[str, str] | None
    terms: list[dict[str, Any]]
    point: dict[str, str]

    def __str__(self) -> str:
        lines = [f"{self.name}: {self.verdict}: {self.sentence}"]
        for term in self.terms:
            lines.append(f"  {_place(term)}: theirs less ours is {_text(term['difference'])}" + (f" (theirs {_text(term['theirs'])}, ours {_text(term['ours'])})" if term["of"] else ""))
        if self.left is not None and not self.terms:
            lines.append(f"  value along the motions of the model: {self.left[0]}")
        if self.point:
            lines.append("  at " + ", ".join(f"{name} = {value}" for name, value in self.point.items()))
        return "\n".join(lines)


def _text(side: tuple[str, str] | None) -> str:
    return "too long to be read" if side is None else side[0]


def _place(term: dict[str, Any]) -> str:
    return "terms without accelerations" if term["of"] is None else f"the coefficient of {term['of']}"


@dataclass(frozen=True)
class Check:
    """Whether SymPy's equations of motion are those of a model.

    same: True where they are, which is proved, or identified with a stated probability of error; False where they are not; None where it is not
    decided. verdict, sentence: the same in a word and in a sentence. equations: a CheckedEquation for each; `failed` those that do not hold.
    requires: divisors that must not vanish.
    """

    verdict: str
    sentence: str
    equations: list[CheckedEquation]
    requires: list[str]
    _requires_latex: list[str] = field(repr=False)

    @property
    def same(self) -> bool | None:
        """Whether they are the same equations of motion; None where that is not decided."""
        return {"proved": True, "identified": True, "refuted": False}.get(self.verdict)

    @property
    def failed(self) -> list[CheckedEquation]:
        """The equations that do not hold along every motion of the model, or were not decided."""
        return [one for one in self.equations if one.verdict not in ("proved", "identified")]

    def __bool__(self) -> bool:
        raise TypeError("a check has no truth value of its own; `.same` is True, False, or None where nothing is decided")

    def __repr__(self) -> str:
        lines = [f"{self.verdict}: {self.sentence}"] + [str(one) for one in self.equations]
        if self.requires:
            lines.append("where " + _readable(self.requires, self.requires))
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        rows = []
        for one in self.equations:
            ground = escape(one.sentence)
            for term in one.terms:
                sides = "" if term["of"] is None else f" (theirs {_formula(term['theirs'])}, ours {_formula(term['ours'])})"
                ground += f"<br>{escape(_place(term))}: theirs less ours is {_formula(term['difference'])}{sides}"
            if one.left is not None and not one.terms:
                ground += f"<br>along the motions of the model its value is {_formula(one.left)}"
            if one.point:
                ground += "<br><small>at " + escape(", ".join(f"{name} = {value}" for name, value in one.point.items())) + "</small>"
            rows.append([f"{escape(one.name)}<br>{formula(one.printed + ' = 0')}", (one.verdict, COLOURS.get(one.verdict)), ground])
        where = "<br>where " + _readable(self.requires, list(map(formula, self._requires_latex))) if self.requires else ""
        colour = COLOURS.get(self.verdict, "#656d76")
        return f'<b style="color:{colour}">{escape(self.verdict)}</b>: {escape(self.sentence)}{where}' + table(["equation", "verdict", "ground"], rows)


def _readable(texts: list[str], shown: list[str]) -> str:
    """Conditions on divisors, the long ones by their number."""
    short = [one for text, one in zip(texts, shown) if len(text) <= _READABLE]
    longer = len(texts) - len(short)
    return ", ".join(short + ([f"and {longer} longer divisor{'s are' if longer > 1 else ' is'} not zero (`requires`)"] if longer else []))


def _formula(side: tuple[str, str] | None) -> str:
    return "too long to be read" if side is None else formula(side[1])


def check(method: Any, model: Model, names: Mapping[Any, str] | None = None, *, seconds: float | None = 300.0) -> Check:
    """Whether equations of motion of SymPy are those of a model.

    method: a KanesMethod or a LagrangesMethod of sympy.physics.mechanics whose equations are formed (or what has q, u, mass_matrix_full and
    forcing_full as these have).
    names: what SymPy's coordinates and symbols are in the model, by symbol or by name; what is left out has the same name there. A meaning is a
    letter of the model or an expression of its language: {q1: "theta", "I": "m*l^2/12"}. Speeds of Kane's method need none where kinematic
    equations define them; the spin of a wheel whose angle is left out has no such equation, and needs its meaning: {u3: "wheel'"}.
    seconds: the check is broken off then, with TimeoutError; None for no limit. So does Ctrl-C.

    The equations may be other combinations, along other speeds, with multipliers or with dependent speeds. Raises ModelError where a letter has no
    partner, or where SymPy's coordinates do not determine the motion of the model.
    """
    if not isinstance(model, Model):
        raise TypeError(f"`model` is {shown(model)}; a dalembert.Model is accepted")
    equations, printed = _Equations(method, model, names).parts()
    found = apart("check", (model, equations), seconds)
    of = dict(zip([f"constraint {k + 1}" for k in range(len(equations["constraints"]))] + [name for name, _ in equations["equations"]], printed))
    checked = [CheckedEquation(**one, printed=of.get(one["name"], r"\text{" + one["name"] + "}")) for one in found["equations"]]
    requires = found["requires"]
    sentence = found["sentence"]
    meant = {word for _, meaning in equations["letters"] for word in re.findall(r"[^\W\d]\w*", meaning)}
    silent = [name for name in model.parameters if name not in meant]
    if found["verdict"] == "refuted" and silent:
        sentence += f"; no letter of SymPy stands for {', '.join(silent)} of the model, whose equations hold for all values of its letters"
    return Check(found["verdict"], sentence, checked, [text for text, _ in requires], [latex for _, latex in requires])


class _Equations:
    """The parts of a method of SymPy, in letters that no name of a model is."""

    def __init__(self, method: Any, model: Model, names: Mapping[Any, str] | None) -> None:
        sympy = needed()
        from sympy.core.function import AppliedUndef
        from sympy.physics.vector import dynamicsymbols

        # JointsMethod and its like hold the method that they used
        method = getattr(method, "method", method)
        missing = [name for name in ("q", "mass_matrix_full", "forcing_full") if not hasattr(type(method), name) and not hasattr(method, name)]
        if missing:
            raise TypeError(f"{type(method).__name__} has no {', '.join(missing)}; a KanesMethod or a LagrangesMethod of sympy.physics.mechanics is accepted")
        try:
            self.matrix, self.right = sympy.Matrix(method.mass_matrix_full), sympy.Matrix(method.forcing_full)
        except (ValueError, TypeError, AttributeError) as error:
            raise ValueError(f"the equations of this {type(method).__name__} are not formed yet: kanes_equations() or form_lagranges_equations() forms them") from error
        self.time = dynamicsymbols._t
        self.model, self.sympy = model, sympy
        self.q = list(method.q)
        rates = [one.diff(self.time) for one in self.q]
        u = list(getattr(method, "u", rates))
        self.multipliers = list(getattr(method, "lam_vec", None) or [])
        self.by_rates = u == rates
        self.u = [] if self.by_rates else u
        self.unknown = ([one.diff(self.time) for one in rates] if self.by_rates else [one.diff(self.time) for one in u]) + self.multipliers
        if self.matrix.shape != (len(self.q) + len(self.unknown),) * 2 or self.right.shape[0] != self.matrix.shape[0]:
            raise ValueError(
                f"the full matrix has the shape {self.matrix.shape}, and there are {len(self.q)} coordinates, {len(u)} speeds and {len(self.multipliers)} multipliers; "
                "a square matrix over the rates of all of these is accepted"
            )
        self.constraints = self._constraints(method)
        functions = [one for one in (*self.q, *self.u, *self.multipliers) if not isinstance(one, (AppliedUndef, sympy.Symbol))]
        if functions:
            raise ValueError(f"{functions[0]} is a coordinate or a speed of the method; functions of {self.time} are accepted, and rates of all coordinates as speeds")
        # by symbol, and for what stands in the place of parts of expressions
        self.names: dict[Any, str] = {}
        self.plain_symbols: dict[Any, Any] = {}
        self.letters = self._letters(given_meanings(names))

    def _constraints(self, method: Any) -> list[Any]:
        """Constraints between coordinates and between speeds, as far as the method knows them."""
        known = list(getattr(method, "coneqs", None) or [])
        for name in ("_f_h", "_hol_coneqs"):
            known += list(getattr(method, name, None) or [])
        slopes, rest = getattr(method, "_k_nh", None), getattr(method, "_f_nh", None)
        if slopes is not None and rest is not None and len(rest):
            known += list(self.sympy.Matrix(slopes) * self.sympy.Matrix(method.u) + self.sympy.Matrix(rest))
        return [self.sympy.sympify(one) for one in known]

    def _letters(self, given: dict[Any, str]) -> list[tuple[str, str]]:
        native = self.model._native
        own = [*self.u, *self.multipliers]
        # a speed may stand in no equation
        found = letters_of([*self.matrix, *self.right, *self.constraints, *self.q, *own], self.time)
        try:
            meanings = meanings_of(found, given, own)
        except ValueError as error:
            title, _, remedy = str(error).rpartition("; ")
            raise refusal(native.name, title, remedy) from None
        found = [symbol for symbol in found if symbol not in own]
        states = [name for name, _ in native.states]
        known = states[: native.positions] + list(self.model.parameters) + native.inputs
        unmatched = [name_of(symbol) for symbol in found if symbol not in meanings and plain(name_of(symbol)) not in known]
        if unmatched:
            both = f"SymPy has {', '.join(map(name_of, found))}; the model has {', '.join(known)}"
            raise refusal(native.name, f"no letter of the model is called {', '.join(unmatched)}; {both}", "`names` says what a letter of SymPy is in the model")
        letters = []
        for place, symbol in enumerate(found, 1):
            # messages show it
            name = plain(name_of(symbol))
            taken = not name.isidentifier() or name in (*self.names.values(), "t", "pi") or _MADE.fullmatch(name)
            self.names[symbol] = f"letter_{place}" if taken else name
            letters.append((self.names[symbol], meanings.get(symbol, name)))
        # a speed whose coordinate the method leaves out, such as that of a wheel, has no kinematic equation; `names` may have its meaning
        self.named_speeds: list[str] = []
        for place, one in enumerate(self.u, 1):
            self.names[one] = f"speed_of_method_{place}"
            if one in meanings:
                letters.append((f"meaning_of_speed_{place}", meanings[one]))
                self.named_speeds.append(f"speed_of_method_{place} - meaning_of_speed_{place}")
        for place, one in enumerate(self.multipliers, 1):
            self.names[one] = f"multiplier_of_method_{place}"
        return letters

    def _text(self, expression: Any) -> str:
        return written(expression, lambda symbol, order: self.names[symbol] + "'" * order)

    def _symbol(self, text: str) -> Any:
        """A symbol that is no other, and is written so."""
        symbol = self.sympy.Dummy(text)
        self.names[symbol] = text
        return symbol

    def _lettered(self, expression: Any) -> Any:
        """The expression with plain symbols for functions of the time and their derivatives."""
        from sympy.core.function import AppliedUndef

        for kind in (self.sympy.Derivative, AppliedUndef):
            found = sorted(expression.atoms(kind) - {self.time}, key=self.sympy.default_sort_key)
            expression = expression.xreplace({one: self._plain_symbol(one) for one in found})
        return expression

    def _plain_symbol(self, part: Any) -> Any:
        if part not in self.plain_symbols:
            self.plain_symbols[part] = self._symbol(self._text(part))
        return self.plain_symbols[part]

    def _short(self, expression: Any, abbreviations: list[tuple[str, str]]) -> str:
        """The text of an expression, with abbreviations for parts of it where it would be too long for the language."""
        text = self._text(expression)
        if len(text) <= _LONGEST_TEXT:
            return text

        def named(part: Any) -> Any:
            inside = self._short(part, abbreviations)
            name = f"long_part_{len(abbreviations)}"
            abbreviations.append((name, inside))
            return self._symbol(name)

        if expression.is_Piecewise:
            return self._text(expression.func(*((named(value), condition) for value, condition in expression.args)))
        if (expression.is_Add or expression.is_Mul) and len(expression.args) > 2:
            half = len(expression.args) // 2
            parts = [expression.func(*expression.args[:half]), expression.func(*expression.args[half:])]
        else:
            parts = list(expression.args)
        return self._text(expression.func(*(part if part.is_Atom else named(part) for part in parts)))

    def parts(self) -> tuple[dict[str, Any], list[str]]:
        """The texts that the model is handed, and the left sides in LaTeX."""
        sympy, n = self.sympy, len(self.q)
        rates = sympy.Matrix([one.diff(self.time) for one in self.q] + self.unknown)
        # the rows of rates of coordinates hold no accelerations
        rows = list(self.matrix * rates - self.right)
        kinematics, dynamics = rows[:n], rows[n:]
        if self.by_rates:
            kinematics = [row for row in kinematics if sympy.expand(row) != 0]
        everything = [self._lettered(row) for row in kinematics + self.constraints + dynamics]
        abbreviations: list[tuple[str, str]] = []
        if sum(row.count_ops() for row in everything) > _LONG:
            common, everything = sympy.cse(everything, symbols=(self._symbol(f"common_part_{k}") for k in range(10**9)), optimizations=None, list=True)
            for symbol, value in common:
                abbreviations.append((self.names[symbol], self._short(value, abbreviations)))
        texts = [self._short(row, abbreviations) for row in everything]
        k, m = len(kinematics), len(kinematics) + len(self.constraints)
        titles = self._titles(len(dynamics))
        equations = {
            "letters": self.letters,
            "speeds": [self.names[one] for one in self.u],
            "accelerations": [self._text(one) for one in self.unknown[: len(self.unknown) - len(self.multipliers)]],
            "multipliers": [self.names[one] for one in self.multipliers],
            "abbreviations": abbreviations,
            "kinematics": texts[:k] + self.named_speeds,
            "constraints": texts[k:m],
            "equations": list(zip(titles, texts[m:])),
        }
        return equations, [sympy.latex(row) if row.count_ops() < _PRINTED else r"\text{too long to be printed}" for row in self.constraints + dynamics]

    def _titles(self, count: int) -> list[str]:
        along = [str(one).replace(f"({self.time})", "") for one in (self.u or self.q)]
        return [f"equation {place + 1}" + (f" ({along[place]})" if place < len(along) else "") for place in range(count)]
