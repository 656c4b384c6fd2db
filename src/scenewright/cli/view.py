"""The verb ``view``: models from their best views, plain and by saliency, on one sheet."""

from __future__ import annotations

from collections.abc import Sequence

from rich.console import Console

from scenewright.cli import tables
from scenewright.cli.progress import watching
from scenewright.workflow.portraits import (
    Sitter,
    Viewed,
    ViewRequest,
    check_view,
    describe_portraits,
    draw_portraits,
    list_skipped,
    select_columns,
)


def view(request: ViewRequest, console: Console) -> Viewed:
    """Draw the models and write the sheet; InputError if not one can be drawn."""
    check_view(request)
    return draw_watched(None, request, console)


def draw_watched(
    sitters: Sequence[Sitter] | None, request: ViewRequest, console: Console
) -> Viewed:
    """Draw sitters, or the models the request names, with a bar where it takes long."""
    with watching(console, console.quiet) as watch:
        return draw_portraits(sitters, request, watch.progress, watch.cancelled)


def tell_viewed(request: ViewRequest, viewed: Viewed, as_json: bool, quiet: bool) -> None:
    """Print what was drawn, as a table or as one JSON document."""
    if as_json:
        tables.print_json(describe_portraits(request, viewed))
    elif not quiet:
        console = tables.output_console()
        tables.table(console, select_columns(viewed), title="models", whole=("name",))
        for line in [*list_skipped(viewed), f"wrote {request.output}"]:
            tables.print_line(console, line, "dim")
