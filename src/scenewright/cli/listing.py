"""The verbs ``list`` and ``schema``: names one may use, and the form of the files."""

from __future__ import annotations

from typing import Annotated

import typer

from scenewright.cli import completion, tables


def list_(
    what: Annotated[
        str,
        typer.Argument(
            metavar="WHAT",
            help="solvers terms patterns presets formats groups styles assets samples.",
            autocompletion=completion.lists,
        ),
    ],
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
) -> int:
    """List names: solvers, terms, patterns, presets, formats, groups, styles, assets, samples."""
    from scenewright.workflow import lists

    rows = lists.rows(what)
    if as_json:
        tables.print_json(rows)
    else:
        tables.table(tables.output_console(), lists.select_columns(what, rows), title=what)
    return 0


def schema(
    what: Annotated[
        str,
        typer.Argument(
            metavar="WHAT", help="brief or solution.", autocompletion=completion.schemas
        ),
    ] = "brief",
) -> int:
    """Print the JSON Schema of an input file."""
    from scenewright.workflow import lists

    tables.print_json(lists.schema(what))
    return 0
