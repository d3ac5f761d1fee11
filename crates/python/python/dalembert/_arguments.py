"""Arguments of calls: each is what is accepted, or an error says what is."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

__all__ = ["LONGEST", "mapping", "names", "number", "seconds_of", "shown", "span_of", "whole"]

# seconds, where there is no limit
LONGEST = 1e9
# characters of a value in a message
_SHOWN = 80


def shown(value: Any) -> str:
    """A value for a message, the middle left out where it is long."""
    try:
        text = " ".join(repr(value).split())
    except Exception:
        # a number of thousands of digits has no text in Python
        return f"a value of the type {type(value).__name__}"
    return text if len(text) <= _SHOWN else f"{text[:_SHOWN - 20]}...{text[-15:]}"


def number(name: str, value: Any) -> float:
    """A number in SI units."""
    try:
        if isinstance(value, (str, bytes, bool)) or getattr(value, "ndim", 0) or getattr(value, "dtype", None) == bool:
            raise TypeError
        return float(value)
    except OverflowError:
        raise ValueError(f"`{name}` is {shown(value)}; a number in SI units of a size up to 1.7e308 is accepted") from None
    except (TypeError, ValueError):
        raise TypeError(f"`{name}` is {shown(value)}; a number in SI units is accepted") from None


def whole(name: str, value: Any, most: int | None = None, least: int = 1) -> int:
    """A whole number from `least` on."""
    try:
        is_whole = not isinstance(value, (bool, str, bytes)) and int(value) == value and least <= value and (most is None or value <= most)
    except (TypeError, ValueError, OverflowError):
        is_whole = False
    if not is_whole:
        raise ValueError(f"`{name}` is {shown(value)}; a whole number from {least} {'on' if most is None else f'to {most}'} is accepted")
    return int(value)


def span_of(value: Any) -> float:
    """A positive time that a motion lasts."""
    span = number("span", value)
    if not 0 < span < float("inf"):
        raise ValueError(f"`span` is {span:g}; a positive time in seconds is accepted")
    return span


def seconds_of(value: Any) -> float | None:
    """A limit of time in seconds; None for none."""
    if value is None:
        return None
    seconds = number("seconds", value)
    if not 0 < seconds < float("inf"):
        raise ValueError(f"`seconds` is {seconds:g}; a positive time in seconds is accepted, and None for no limit")
    return min(seconds, LONGEST)


def names(name: str, value: Any, accepted: str) -> list[str]:
    """Names, or one alone."""
    listed = [value] if isinstance(value, str) else list(value) if isinstance(value, Iterable) and not isinstance(value, (bytes, Mapping)) else [None]
    if not all(isinstance(one, str) for one in listed):
        raise TypeError(f"`{name}` is {shown(value)}; {accepted} are accepted, a list of texts")
    # texts of NumPy are texts
    return list(map(str, listed))


def mapping(name: str, value: Any, example: str) -> dict[str, Any]:
    """A dictionary whose keys are names; None for an empty one."""
    if value is None:
        return {}
    if not isinstance(value, Mapping) or not all(isinstance(key, str) for key in value):
        raise TypeError(f"`{name}` is {shown(value)}; a dictionary with names as its keys is accepted, such as {example}")
    return dict(value)
