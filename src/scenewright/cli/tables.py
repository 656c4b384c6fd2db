"""Tables and documents on the terminal, whatever they tell."""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping, Sequence
from typing import Any

from rich import box
from rich.cells import cell_len
from rich.console import Console
from rich.table import Table
from rich.text import Text

OTHERS = 90
"""Columns left to the rest of a table of which some is on one line."""
WIDE = 150
"""Columns of a file that a wide table is written to."""


def print_json(document: Any) -> None:
    """One JSON document on the standard output."""
    sys.stdout.write(json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False) + "\n")


def table(
    console: Console, rows: Sequence[Mapping[str, Any]], title: str, whole: Sequence[str] = ()
) -> None:
    """Rows with the same keys as a table; what stands under the keys ``whole`` is on one line, so
    that it can be copied."""
    if not rows:
        console.print(f"no {title}")
        return
    shown = bare(*(key.replace("_", " ") for key in rows[0]), title=title)
    for row in rows:
        shown.add_row(*(Text(_cell(value)) for value in row.values()))
    for key, column in zip(rows[0], shown.columns, strict=True):
        if key in whole:
            column.no_wrap, column.min_width = True, max(cell_len(_cell(row[key])) for row in rows)
    needed = OTHERS + sum(column.min_width or 0 for column in shown.columns)
    narrow = bool(whole) and console.width < needed
    (Console(width=needed, file=console.file) if narrow else console).print(shown)


def wide(console: Console) -> Console:
    """The console, or in a file or pipe one on which each row of a wide table is one line."""
    return console if console.is_terminal else Console(width=max(console.width, WIDE))


def bare(*columns: str, title: str) -> Table:
    """A table without rows yet."""
    made = Table(box=box.SIMPLE_HEAD, title=Text(title, "bold"), title_justify="left")
    for column in columns:
        made.add_column(column, overflow="fold")
    return made


def _cell(value: object) -> str:
    if isinstance(value, bool):
        return "yes" if value else ""
    if isinstance(value, float):
        return f"{value:,.4g}" if abs(value) < 1e4 else f"{value:,.0f}"
    if isinstance(value, Mapping):
        return ", ".join(f"{key} {_cell(part)}" for key, part in value.items())
    if isinstance(value, (list, tuple)):
        return " × ".join(_cell(part) for part in value)
    return "" if value is None else str(value)
