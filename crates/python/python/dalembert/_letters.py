"""Symbols of SymPy as letters of the language of models: no two become one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from ._arguments import shown

__all__ = ["MEANINGS", "given_meanings", "is_letter", "letters_of", "meanings_of", "name_of", "plain", "told"]

MEANINGS = "`names` gives each symbol its meaning"

# the marks on letters and the primes of the language; a name with points is a part of something, such as `motor.q`
_LETTER = re.compile(r"[^\W\d][\w\u0300-\u036f]*(\.[^\W\d][\w\u0300-\u036f]*)*")
# names that have a meaning of their own, and words between parts of expressions
_TAKEN = {"t", "pi", "N", "O", "ground", "if", "at", "in"}


def plain(name: str) -> str:
    """A name of SymPy as one of the language of models: `\\theta_{1}` is theta_1."""
    return name.replace("\\", "").replace("{", "").replace("}", "").replace(" ", "_")


def is_letter(name: str) -> bool:
    """Whether a text can be the name of a letter of a model."""
    return _LETTER.fullmatch(name) is not None and name not in _TAKEN


def name_of(symbol: Any) -> str:
    """The name of a symbol or of a function of the time, q(t)."""
    return symbol.name if symbol.is_Symbol else symbol.func.__name__


def told(symbol: Any) -> str:
    """A symbol for reading, with all by which it differs from others."""
    from sympy import srepr

    return srepr(symbol) if symbol.is_Symbol else str(symbol)


def letters_of(expressions: Iterable[Any], time: Any) -> list[Any]:
    """Symbols and functions of the time that stand in expressions, by their names."""
    from sympy import Symbol, default_sort_key
    from sympy.core.function import AppliedUndef

    found = {atom for expression in expressions for atom in expression.atoms(Symbol, AppliedUndef)} - {time}
    return sorted(found, key=lambda atom: (name_of(atom), default_sort_key(atom)))


def given_meanings(names: Any) -> dict[Any, str]:
    """The argument `names` by symbols and names: a function of the time stands by its name where its argument is left out."""
    from sympy.core.function import AppliedUndef, UndefinedFunction

    if names is None:
        return {}
    if not isinstance(names, Mapping):
        raise TypeError(f"`names` is {shown(names)}; a dictionary is accepted, {{symbol: text}}, such as {{q1: 'theta'}}")
    given = {}
    for known, meaning in names.items():
        if isinstance(known, UndefinedFunction):
            known = known.__name__
        if not (isinstance(known, (str, AppliedUndef)) or getattr(known, "is_Symbol", False)):
            raise TypeError(f"`names` has the key {shown(known)}; a symbol of SymPy, a function of the time, or a name is accepted")
        if not isinstance(meaning, str) or not meaning.strip():
            raise TypeError(f"`names` gives {str(known)!r} the meaning {shown(meaning)}; the text of an expression of the model is accepted")
        given[known] = meaning.strip()
    return given


def meanings_of(symbols: list[Any], given: dict[Any, str], own: Iterable[Any] = ()) -> dict[Any, str]:
    """The meanings that `names` gives to some symbols; those of `own` need no letter.

    Raises ValueError for a name of none of the symbols or of several, and where two symbols would become one letter.
    """
    meanings = {symbol: given[symbol] for symbol in symbols if symbol in given}
    absent = [str(known) for known in given if not isinstance(known, str) and known not in meanings]
    for name in (known for known in given if isinstance(known, str)):
        meant = [symbol for symbol in symbols if name_of(symbol) == name and symbol not in meanings]
        if len(meant) > 1:
            raise ValueError(f"`names` has {name!r}, which is the name of {' and of '.join(map(told, meant))}; the symbols themselves are accepted as its keys")
        if not meant:
            absent.append(name)
        else:
            meanings[meant[0]] = given[name]
    if absent:
        there = ", ".join(dict.fromkeys(map(name_of, symbols))) or "no symbol"
        raise ValueError(f"SymPy's expressions hold no {', '.join(absent)}; they hold {there}; a name that they hold is accepted in `names`")
    letters: dict[str, Any] = {meaning: symbol for symbol, meaning in meanings.items()}
    for symbol in (symbol for symbol in symbols if symbol not in meanings and symbol not in own):
        other = letters.setdefault(plain(name_of(symbol)), symbol)
        if other is not symbol:
            raise ValueError(f"{told(other)} and {told(symbol)} are two symbols, and both would be the letter `{plain(name_of(symbol))}`; {MEANINGS}")
    return meanings
