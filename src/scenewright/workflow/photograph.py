"""Photographs of the rooms of an arranged scene, written one after the other."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from scenewright import domains
from scenewright.catalog.loading import catalog_of
from scenewright.core.atomic_file import recorded_run
from scenewright.core.errors import CancelledError, InputError
from scenewright.core.solution import Solution
from scenewright.render.contact_sheet import write_sheet
from scenewright.render.daylight import HOURS
from scenewright.render.observations.world import build_world
from scenewright.render.photo.photograph import SAMPLES, SIZE, Photo, shut_doors
from scenewright.render.photo.photograph import photograph as photograph_world
from scenewright.workflow.cycles import find_program, photograph_by_cycles
from scenewright.workflow.observe import SOLVING, Tell, check_rooms, named_rooms, solve_source
from scenewright.workflow.request import check_name

LEAST, MOST, MOST_SAMPLES = 16, 4096, 4096
RENDERERS = {"own": photograph_world, "cycles": photograph_by_cycles}
"""What follows light: our own tracer, or the path tracer of Blender."""


class Photographs(NamedTuple):
    """The files written, and the names of rooms left out for want of a free place."""

    written: tuple[Path, ...]
    left_out: tuple[str, ...]


def photograph(
    source: Solution | str | os.PathLike[str],
    output: str | os.PathLike[str],
    *,
    rooms: Sequence[str] = (),
    hour: str = "",
    size: tuple[int, int] = SIZE,
    samples: int = SAMPLES,
    renderer: str = "own",
    seed: int = 0,
    steps: int | None = None,
    progress: Tell | None = None,
    cancel: Callable[[], bool] | None = None,
) -> Photographs:
    """Photograph the ``rooms`` (none named: all) of a solution, a saved one, or a brief that is
    arranged first, at an ``hour`` of :data:`~scenewright.render.daylight.HOURS` (none named: that
    of the brief, else ``day``): one room into the picture ``output``, or each into a folder of that
    name. Light is followed by a ``renderer`` of :data:`RENDERERS`. Raises :class:`InputError` for
    what cannot be photographed.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     options = {"size": (32, 20), "samples": 1, "steps": 200}
    ...     made = photograph("sample:home-room", f"{folder}/a", **options)
    >>> [path.name for path in made.written], made.left_out
    (['room.png'], ())
    """
    check_photo(hour, size, samples, seed)
    check_name("renderer", renderer, [*RENDERERS])
    if renderer == "cycles":
        find_program()
    tell = progress or (lambda _share, _words: None)
    with recorded_run():
        tell(0.0, "reading")
        solution, plan = solve_source(source, seed, steps, tell, cancel)
        scene = domains.scene_of(solution, plan)
        check_rooms(solution.brief.domain, scene.spaces)
        wanted = named_rooms(scene, rooms)
        catalog = catalog_of(solution.brief.catalogs)
        alone = Path(output).suffix.lower() == ".png"
        if alone and len(wanted or scene.spaces) != 1:
            fault = f"one picture is of one room, but {len(wanted or scene.spaces)} are asked for"
            raise InputError(fault, "name one by --room, or give a folder", file=str(output))
        world = build_world(shut_doors(scene), catalog)
        lit = hour or scene.hour or "day"
        photos = RENDERERS[renderer](world, catalog, wanted, lit, size, samples, seed)
        told = _told(photos, len(wanted or scene.spaces), tell, cancel)
        written: dict[str, Path] = {}
        for one in told:
            path = Path(output) if alone else _path_of(one, Path(output), {*written.values()})
            write_sheet(one.pixels, path)
            written[one.space.id] = path
    if not written:
        raise InputError("no room has a free place for a camera", "name another by --room")
    named = [space for space in scene.spaces if not wanted or space.id in wanted]
    left = tuple(space.name or space.id for space in named if space.id not in written)
    return Photographs(tuple(written.values()), left)


def _told(
    photos: Iterator[Photo], count: int, tell: Tell, cancel: Callable[[], bool] | None
) -> Iterator[Photo]:
    for number, photo in enumerate(photos, 1):
        if cancel is not None and cancel():
            raise CancelledError
        name = photo.space.name or photo.space.id
        tell(SOLVING + (1 - SOLVING) * min(number / count, 1.0), name)
        yield photo


def _path_of(photo: Photo, folder: Path, taken: set[Path]) -> Path:
    """A file named after the room, that no room before has."""
    name = re.sub(r"[^\w-]+", "-", photo.space.id)[:60]
    ends = ("", *(f"-{number}" for number in range(2, len(taken) + 3)))
    return next(path for end in ends if (path := folder / f"{name}{end}.png") not in taken)


def check_photo(hour: str, size: tuple[int, int], samples: int, seed: int) -> None:
    """Raise :class:`InputError` for what no camera can do."""
    check_name("hour", hour, ["", *HOURS])
    checks = (
        (all(LEAST <= side <= MOST for side in size), "--size", f"{LEAST} to {MOST} pixels a side"),
        (1 <= samples <= MOST_SAMPLES, "--samples", f"1 to {MOST_SAMPLES:,}"),
        (seed >= 0, "--seed", "0 or more"),
    )
    for right, name, wanted in checks:
        if not right:
            raise InputError(f"{name} cannot be used", f"give {wanted}")
