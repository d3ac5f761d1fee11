"""Errors without a place in a text that a user has."""

from __future__ import annotations

from typing import Any

from ._native import ModelError

__all__ = ["of_issues", "refusal"]


def of_issues(issues: list[dict[str, Any]]) -> ModelError:
    """An error of some issues; its own attributes are those of the first."""
    error = ModelError("\n".join(map(_line, issues)))
    for key, value in issues[0].items():
        setattr(error, key, value)
    error.issues = issues
    return error


def refusal(name: str, title: str, remedy: str) -> ModelError:
    """An error of one issue."""
    return of_issues([{"file": name, "line": None, "column": None, "title": title, "label": "", "remedy": remedy}])


def _line(issue: dict[str, Any]) -> str:
    place = "" if issue["line"] is None else f"{issue['file']}:{issue['line']}:{issue['column']}: "
    label = f": {issue['label']}" if issue["label"] else ""
    remedy = f"; {issue['remedy']}" if issue["remedy"] else ""
    return f"{place}{issue['title']}{label}{remedy}"
