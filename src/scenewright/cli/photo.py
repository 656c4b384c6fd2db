"""The verb ``photo``: rooms as a photographer shows them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from scenewright.cli import tables, terminal
from scenewright.cli.arguments import check_budget
from scenewright.cli.render import RoomOption, SceneArgument, size_of


def photo(
    source: SceneArgument,
    output: Annotated[
        Path,
        typer.Option("-o", "--output", metavar="PNG|FOLDER", help="One room, or a folder for all."),
    ],
    room: RoomOption = None,
    hour: Annotated[str, typer.Option(help="morning, noon, day (late), dusk, night.")] = "",
    size: Annotated[str, typer.Option(metavar="WxH", help="Pixels.")] = "1280x800",
    samples: Annotated[int, typer.Option(help="Paths of light a pixel; more, less noise.")] = 8,
    renderer: Annotated[
        str, typer.Option("--photo", metavar="RENDERER", help="own, or cycles: by Blender.")
    ] = "own",
    seed: Annotated[int, typer.Option(help="Same seed, same pictures.")] = 0,
    steps: Annotated[int | None, typer.Option(help="Search budget where it is arranged.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")] = False,
) -> int:
    """Photograph the rooms of a home or hall from inside: sun, sky and lamps, two bounces."""
    from scenewright.cli.progress import watching
    from scenewright.workflow.photograph import photograph

    check_budget(None, {"steps": steps})
    still = quiet or as_json
    with watching(terminal.console(stderr=True, quiet=still), still) as watch:
        made = photograph(
            source,
            output,
            rooms=room or (),
            hour=hour,
            size=size_of(size),
            samples=samples,
            renderer=renderer,
            seed=seed,
            steps=steps,
            progress=watch.progress,
            cancel=watch.cancelled,
        )
    if as_json:
        tables.print_json({"written": [*map(str, made.written)], "left_out": [*made.left_out]})
    elif not quiet:
        for path in made.written:
            tables.print_line(tables.output_console(), f"wrote {path}", "dim")
        for name in made.left_out:
            tables.print_line(tables.output_console(), f"left out: {name}: no free place to stand")
    return 0
