"""The verb ``plan``: what is read of a file as a brief to correct by hand, and a picture of it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from scenewright.cli import completion, tables, terminal
from scenewright.cli.reading import (
    CrsOption,
    HiddenOption,
    InputArgument,
    KeepOption,
    LayerOption,
    OriginOption,
    ScaleOption,
    SiteOption,
    map_options_of,
)
from scenewright.cli.show_input import print_input, print_warnings
from scenewright.core.atomic_file import recorded_run, whole_together
from scenewright.workflow.documents import input_document

if TYPE_CHECKING:
    from scenewright.core.brief import Brief
    from scenewright.core.plan import Plan


def plan(
    source: InputArgument,
    outputs: Annotated[
        list[Path] | None,
        typer.Option(
            "-o",
            "--output",
            metavar="OUT",
            help="A .json for the brief, a .svg to see it.",
            autocompletion=completion.outputs,
        ),
    ] = None,
    keep: KeepOption = False,
    scale: ScaleOption = 1.0,
    hidden_levels: HiddenOption = False,
    crs: CrsOption = "",
    origin: OriginOption = "",
    layers: LayerOption = None,
    site: SiteOption = "",
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")] = False,
) -> int:
    """Read a plan and write it as a brief to correct by hand; nothing is furnished."""
    from scenewright.formats import read_planned

    with recorded_run():
        brief, made = read_planned(
            source,
            keep,
            scale=scale,
            hidden_levels=hidden_levels,
            map_options=map_options_of(crs, origin, layers, site),
        )
        write_plan(brief, made, outputs or [])
    complete = brief.input_report is None or brief.input_report.complete
    if as_json:
        document = {"source": source, "rooms": len(made.spaces)}
        tables.print_json(document | input_document(brief))
    elif not quiet:
        console = terminal.console(stderr=True)
        print_input(console, brief.input_report)
        print_warnings(console, brief.input_report)
        for line in [*describe_plan(brief, made), *(f"wrote {path}" for path in outputs or [])]:
            tables.print_line(tables.output_console(), line)
    return 0 if complete else 1


def describe_plan(brief: Brief, made: Plan) -> list[str]:
    """What was read, in a line for all and one for each room."""
    from shapely import Polygon

    rows = [f"{len(made.spaces)} rooms on {len(made.levels)} level(s)"]
    for space in made.spaces:
        doors = sum(opening.kind != "window" for opening in space.openings)
        area = Polygon(space.outline, space.holes).area
        rows.append(
            f"  {space.name or space.id}: {area:.1f} m², {doors} doors, "
            f"{len(space.openings) - doors} windows"
        )
    return rows if brief.rooms else rows[:1]


def write_plan(brief: Brief, made: Plan, outputs: list[Path]) -> None:
    """The brief as JSON; the plan of the empty rooms in any format that shows it."""
    from scenewright.core.solution import unfurnished
    from scenewright.formats import brief_json, check_output, write

    for path in outputs:
        check_output(path, brief)
    with whole_together(outputs) as partials:
        for path, partial in zip(outputs, partials, strict=True):
            if path.suffix.lower() == ".json":
                partial.write_text(brief_json.dumps(brief), encoding="utf-8")
            else:
                write(unfurnished(brief), partial, made)
