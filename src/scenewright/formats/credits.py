"""Credits as plain text: a paragraph an author and licence, a line a model."""

from __future__ import annotations

import os

from scenewright.catalog.credits import UNKNOWN, Credit, credits_of_solution
from scenewright.catalog.loading import catalog_of
from scenewright.core.atomic_file import write_atomically
from scenewright.core.solution import Solution


def write(solution: Solution, path: str | os.PathLike[str]) -> None:
    """Write the credits of a solution to ``path``; the file appears whole or not at all."""
    rows = credits_of_solution(solution, catalog_of(solution.brief.catalogs))
    write_atomically(path, text(solution.brief.name, rows))


def text(name: str, rows: tuple[Credit, ...]) -> str:
    """The text, ending in a newline.

    >>> row = Credit("Jane Doe", "CC0-1.0", (("model:tower", "Tower", 3),))
    >>> print(text("Town", (row,)), end="")
    Credits of Town
    <BLANKLINE>
    Jane Doe, licence CC0-1.0
      Tower (model:tower), 3 times
    """
    parts = [f"Credits of {name}\n"]
    for row in rows:
        message = row.author if row.author != UNKNOWN else "Author not stated"
        lines = [f"{message}, licence {row.licence}"]
        for identity, title, count in row.assets:
            lines.append(f"  {title} ({identity})" + (f", {count} times" if count > 1 else ""))
        parts.append("\n".join(lines) + "\n")
    return "\n".join(parts)
