"""The input report on the terminal: what became of a file's features, a line for each kind."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from scenewright.cli.tables import print_line

if TYPE_CHECKING:
    from rich.console import Console

    from scenewright.core.brief.input_report import InputReport, InputRow

MOST_KINDS = 12
MOST_REASONS = 3
"""Kinds that are listed, and reasons of one kind; the rest is counted."""


def print_input(console: Console, report: InputReport | None) -> None:
    """What was read, and what became of it; nothing for a brief that was not changed."""
    if report is not None:
        for line in describe_input(report):
            print_line(console, line, "dim")


def print_warnings(console: Console, report: InputReport | None) -> None:
    """What stands in the file and is missing, in bold: the result may be wrong."""
    for warning in report.warnings if report else ():
        print_line(console, f"warning: not all of the file was read: {warning}", "bold yellow")


def describe_input(report: InputReport) -> list[str]:
    """A line on the file, then one on each kind of its features, the most frequent first.

    >>> from scenewright.core.brief.input_report import Fate, report_input
    >>> fates = [Fate("way/1", "building", "used"), Fate("node/7", "tree", "left out", "no place")]
    >>> for line in describe_input(report_input(fates, format="GeoJSON", unit="degrees")):
    ...     print(line)
    read: GeoJSON, degrees: 2 features
      building: 1 used
      tree: 1 left out: no place (node/7)
    """
    kinds: dict[str, list[InputRow]] = {}
    for row in report.rows:
        kinds.setdefault(row.kind, []).append(row)
    listed = sorted(kinds.items(), key=lambda one: -_count(one[1]))
    head = ", ".join(filter(None, [report.format, report.system, report.unit]))
    lines = [f"read: {head}{': ' if head else ''}{report.features:,} features"]
    lines += [f"  {kind}: {_describe_rows(rows)}" for kind, rows in listed[:MOST_KINDS]]
    if rest := listed[MOST_KINDS:]:
        lines.append(f"  {len(rest)} other kinds: {sum(_count(rows) for _, rows in rest):,}")
    return lines + [f"  floor: {text}" for text in [report.describe_floor()] if text]


def _describe_rows(rows: Sequence[InputRow]) -> str:
    """The rows of one kind on a line, with the most frequent reasons."""
    plain = [row.model_copy(update={"examples": []}) for row in rows if row.outcome == "used"]
    told = [row for row in rows if row.outcome != "used"]
    words = [row.describe() for row in (*plain, *told[:MOST_REASONS])]
    if rest := told[MOST_REASONS:]:
        words.append(f"{_count(rest):,} more for {len(rest)} other reasons")
    return "; ".join(words)


def _count(rows: Sequence[InputRow]) -> int:
    return sum(row.count for row in rows)
