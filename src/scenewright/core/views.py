"""How values show themselves: a line as text, tables and drawings in a notebook.

What draws lies in higher layers. It is loaded by name when a notebook asks for it, so that values
of the core need no import of it and a ``repr`` loads nothing.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

NOTEBOOK = "scenewright.formats.notebook"
"""The module with a function for each view."""


def show(view: str, value: Any) -> Any:
    """A value as the ``view`` of that name shows it."""
    return getattr(import_module(NOTEBOOK), view)(value)


def describe(kind: str, *words: str, **facts: object) -> str:
    """A value in one line, as Python writes calls; facts that are ``None`` are left out.

    >>> describe("Brief", "home", "Flat", rooms=3, levels=None)
    "Brief('home', 'Flat', rooms=3)"
    """
    named = (f"{name}={value!r}" for name, value in facts.items() if value is not None)
    return f"{kind}({', '.join([*map(repr, words), *named])})"
