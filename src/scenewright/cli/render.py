"""The verb ``render``: what cameras in a scene see, into a folder of pictures and arrays."""

from __future__ import annotations

from math import radians
from pathlib import Path
from typing import Annotated, Any

import typer

from scenewright.cli import completion, tables, terminal
from scenewright.cli.arguments import check_budget
from scenewright.core.errors import InputError

SceneArgument = Annotated[
    str,
    typer.Argument(
        metavar="SCENE",
        help="A saved solution; or a file or sample:NAME that is arranged first.",
        autocompletion=completion.inputs,
    ),
]
PoseOption = Annotated[
    list[str] | None,
    typer.Option(
        "--camera",
        metavar="X,Y,Z,YAW,PITCH",
        help="One by hand, in metres and degrees; may be repeated.",
    ),
]
RoomOption = Annotated[
    list[str] | None, typer.Option(metavar="NAME", help="Only in this room; may be repeated.")
]
COLUMNS = ("camera", "room", "yaw", "pitch", "clearance")


def render(
    source: SceneArgument,
    output: Annotated[Path, typer.Option("-o", "--output", metavar="FOLDER")],
    cameras: Annotated[int | None, typer.Option(help="Cameras drawn by the seed (4).")] = None,
    pose: PoseOption = None,
    trajectory: Annotated[int, typer.Option(help="Poses on a way through the rooms.")] = 0,
    room: RoomOption = None,
    rgb: Annotated[bool, typer.Option("--rgb", help="Colour.")] = False,
    depth: Annotated[bool, typer.Option("--depth", help="Metres along the camera's axis.")] = False,
    instance: Annotated[bool, typer.Option("--instance", help="Numbers of things.")] = False,
    semantic: Annotated[bool, typer.Option("--semantic", help="Numbers of classes.")] = False,
    normals: Annotated[bool, typer.Option("--normals", help="Directions of surfaces.")] = False,
    size: Annotated[str, typer.Option(metavar="WxH", help="Pixels.")] = "640x480",
    fov: Annotated[float, typer.Option(help="Width of the view in degrees.")] = 75.0,
    eye: Annotated[float, typer.Option(help="Metres above the floor.")] = 1.5,
    clearance: Annotated[float, typer.Option(help="Metres to walls and pieces.")] = 0.2,
    seed: Annotated[int, typer.Option(help="Same seed, same cameras.")] = 0,
    steps: Annotated[int | None, typer.Option(help="Search budget where it is arranged.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document only.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")] = False,
) -> int:
    """Observe a home or hall from inside: colour, depth, masks, normals (all unless some named)."""
    check_budget(None, {"steps": steps})
    flags = (rgb, depth, instance, semantic, normals)
    options: dict[str, Any] = {
        "cameras": cameras,
        "size": size_of(size),
        "fov": radians(fov),
        "eye": eye,
        "clearance": clearance,
        "seed": seed,
        "rooms": room or (),
        "poses": [_pose(words) for words in pose or ()],
        "trajectory": trajectory,
        "steps": steps,
    }
    document = _observe(source, output, flags, options, quiet or as_json)
    if as_json:
        tables.print_json(document)
    elif not quiet:
        rows = [{key: one[key] for key in COLUMNS} for one in document["cameras"]]
        tables.table(tables.output_console(), rows, title="cameras")
        tables.print_line(tables.output_console(), f"wrote {output}", "dim")
    return 0


def _observe(
    source: str, output: Path, flags: tuple[bool, ...], options: dict[str, Any], quiet: bool
) -> dict[str, Any]:
    """Write the folder; its document."""
    from scenewright.cli.progress import watching
    from scenewright.render.observations.views import KINDS
    from scenewright.workflow.observation_files import document_of
    from scenewright.workflow.observe import observe

    kinds = [kind for kind, wanted in zip(KINDS, flags, strict=True) if wanted] or KINDS
    with watching(terminal.console(stderr=True, quiet=quiet), quiet) as watch:
        told: dict[str, Any] = {"progress": watch.progress, "cancel": watch.cancelled}
        made = observe(source, output, kinds=kinds, **options, **told)
    return document_of(made.taken)


def size_of(words: str) -> tuple[int, int]:
    """Pixels of ``--size``."""
    parts = words.lower().split("x")
    if len(parts) != 2 or not all(part.isascii() and part.isdigit() for part in parts):
        raise InputError(f"--size '{words[:40]}' is no size", "give pixels, such as 640x480")
    return int(parts[0][:9]), int(parts[1][:9])


def _pose(words: str) -> tuple[float, float, float, float, float]:
    try:
        x, y, z, yaw, pitch = map(float, words.split(","))
    except ValueError:
        raise InputError(
            f"--camera '{words[:40]}' is no pose", "give x,y,z,yaw,pitch, such as 2,1.5,1.5,90,-10"
        ) from None
    return x, y, z, radians(yaw), radians(pitch)
