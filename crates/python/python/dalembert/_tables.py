"""Tables of a text in TOML, found by their headings."""

from __future__ import annotations

import re
from collections.abc import Iterator

__all__ = ["without_table"]

_TOKEN = re.compile(
    r'''"""(?:\\.|[^\\])*?"{3,5}|\'\'\'.*?'{3,5}|"(?:\\.|[^"\\\n])*"|'[^'\n]*'|#[^\n]*|[\[\]{}]|\n|[^"'#\[\]{}\n]+|.''',
    re.DOTALL,
)
_FIRST_KEY = re.compile(r"""\s*(?P<heading>\[*)\s*(?:"(?P<quoted>(?:\\.|[^"\\])*)"|'(?P<literal>[^']*)'|(?P<bare>[\w-]+))""")


def _statements(text: str) -> Iterator[str]:
    """Headings, keys with their values, and lines of comments, each with the end of its line."""
    parts: list[str] = []
    depth = 0
    for token in (found.group() for found in _TOKEN.finditer(text)):
        parts.append(token)
        depth += (token in ("[", "{")) - (token in ("]", "}"))
        if token == "\n" and depth <= 0:
            yield "".join(parts)
            parts, depth = [], 0
    yield "".join(parts)


def without_table(text: str, name: str) -> str:
    """A text without a table and the tables in it, whose lines stay empty: all else keeps its line."""
    kept: list[str] = []
    is_top, is_within = True, False
    for statement in _statements(text):
        found = _FIRST_KEY.match(statement)
        if found is None:
            kept.append(statement if not is_within else "\n" * statement.count("\n"))
            continue
        is_named = name in found.group("quoted", "literal", "bare")
        if found["heading"]:
            is_top, is_within = False, is_named
        is_dropped = is_within or (is_top and is_named)
        kept.append("\n" * statement.count("\n") if is_dropped else statement)
    return "".join(kept)
