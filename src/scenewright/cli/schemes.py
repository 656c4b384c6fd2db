"""Figures of schemes: a table of them, one row a site, block, area or an alternative."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from rich.console import Console

from scenewright.cli.tables import print_line, table
from scenewright.workflow.schemes import scheme_row

SHARES = (
    ("floor_by_use", "m² of floor"),
    ("dwellings_by_kind", "lived in"),
    ("dwellings_by_size", "dwellings"),
)
"""Figures that are told of each scheme below its table."""


def print_schemes(
    console: Console, sites: Mapping[str, Mapping[str, Any]], noun: str = "site"
) -> None:
    """A table of the schemes of some sites, or of what has another ``noun``, then floor by use and
    dwellings by size."""
    rows = [{noun: name} | scheme_row(row) for name, row in sites.items() if scheme_row(row)]
    if rows:
        table(console, rows, "scheme")
    for name, row in sites.items():
        for key, word in SHARES:
            told = ", ".join(f"{what} {value:.0f}" for what, value in row.get(key, {}).items())
            if told:
                print_line(console, f"{name}, {word}: {told}", "dim")
