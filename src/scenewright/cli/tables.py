"""Tables, lines and documents on the terminal: nothing a user may want to copy is ever cut.

In a file or pipe every row and every line stays on one line. On a terminal text is broken between
words only; where the longest words of a table do not fit side by side, its rows are written as
blocks of one field a line.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Collection, Mapping, Sequence
from typing import Any, Literal

from rich import box
from rich.cells import cell_len
from rich.console import Console
from rich.table import Table
from rich.text import Text

from scenewright.cli import terminal
from scenewright.text import escape_unprintable, printable

UNBROKEN = 100_000
"""Columns of a file or pipe: more than any line has."""
PADDING = 3
"""Columns between two columns of a table; one more than all of them stands at its edge."""


def print_json(document: Any) -> None:
    """One JSON document on the standard output, escaped as far as its encoding needs it."""
    text = json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False)
    try:
        text.encode(sys.stdout.encoding or "utf-8")
    except UnicodeEncodeError:
        text = json.dumps(document, indent=2, allow_nan=False)
    sys.stdout.write(escape_unprintable(text) + "\n")


def output_console() -> Console:
    """The standard output: as wide as its terminal; in a file or pipe, or on a terminal that does
    not tell how wide it is, no line is broken."""
    console = terminal.console()
    is_width_known = console.is_terminal and not console.is_dumb_terminal
    return console if is_width_known else terminal.console(width=UNBROKEN, height=UNBROKEN)


def print_line(console: Console, text: str, style: str = "", whole: bool = False) -> None:
    """One line. A narrow terminal breaks it between words; ``whole``, or where a word is wider
    than the terminal, it is left to the terminal to wrap, so that it can be copied."""
    unbroken = whole or not console.is_terminal or _longest_word(text) > console.width
    console.print(Text(text, style), soft_wrap=unbroken)


def table(
    console: Console,
    rows: Sequence[Mapping[str, Any]],
    title: str,
    whole: Collection[str] = (),
    right: Collection[str] = (),
) -> None:
    """Rows with the same keys as a table; cells under the keys ``whole`` are never broken, not
    even between words; those under ``right`` are set to the right."""
    if not rows:
        console.print(Text(f"no {title}"))
        return
    cells = {key: [printable(_cell(row[key])) for row in rows] for key in rows[0]}
    heads = {key: key.replace("_", " ") for key in cells}
    natural = [max(map(cell_len, [heads[key], *own])) for key, own in cells.items()]
    least = [
        max(cell_len(text) if key in whole else _longest_word(text) for text in [heads[key], *own])
        for key, own in cells.items()
    ]
    widths = _column_widths(natural, least, console.width - PADDING * len(cells) - 1)
    print_line(console, title, "bold")
    if widths is None:
        _print_blocks(console, cells, heads)
        return
    shown = Table(box=box.SIMPLE_HEAD)
    for key, width in zip(cells, widths, strict=True):
        side: Literal["left", "right"] = "right" if key in right else "left"
        shown.add_column(Text(heads[key]), width=width, justify=side, overflow="fold")
    for row in zip(*cells.values(), strict=True):
        shown.add_row(*map(Text, row))
    console.print(shown)


def _column_widths(natural: list[int], least: list[int], space: int) -> list[int] | None:
    """Widths of columns within ``space``: those wider than the widest cap that fits are narrowed
    to it, none below its least; ``None`` where even the least do not fit.

    >>> _column_widths([4, 30, 20], [4, 6, 18], 40)
    [4, 18, 18]
    >>> _column_widths([4, 30], [4, 6], 9) is None
    True
    """
    for cap in range(min(max(natural), space), -1, -1):
        widths = [max(low, min(high, cap)) for low, high in zip(least, natural, strict=True)]
        if sum(widths) <= space:
            return widths
    return None


def _print_blocks(
    console: Console, cells: Mapping[str, Sequence[str]], heads: Mapping[str, str]
) -> None:
    """Each row as a block of lines, its fields one below the other."""
    for row in zip(*cells.values(), strict=True):
        console.print()
        for head, text in zip(heads.values(), row, strict=True):
            if text:
                name = f"{head}: " if head else ""
                console.print(Text.assemble((name, "bold"), text), soft_wrap=True)
    console.print()


def _longest_word(text: str) -> int:
    """Columns that the longest word takes, with the blanks that a line begins with."""
    return max(map(cell_len, re.findall(r"^\s*\S+|\S+", text, re.MULTILINE)), default=0)


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
