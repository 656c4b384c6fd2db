"""What is to be done in each room: the room as a task, and what it is wished to hold."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from zlib import crc32

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.ceiling import living_area, planes
from scenewright.building.labels import is_entered
from scenewright.core.brief import Brief, Room
from scenewright.core.catalog import Catalog
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.home.attempts.attempt import RoomTask, floor_of, out_of_reach
from scenewright.domains.home.cases.library import Library
from scenewright.domains.home.furnishing.enlarge import enlarge_pieces
from scenewright.domains.home.furnishing.extras import extras
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.presets import HomePreset
from scenewright.domains.home.programme import (
    INSTEAD_OF,
    STANDS_FOR,
    WELCOME,
    Wish,
    most_of,
    programme,
    resolve_bedrooms,
    standing_groups,
    standing_kinds,
)
from scenewright.domains.home.settings import fit_settings
from scenewright.domains.home.wished.beds import take_wished_bed
from scenewright.domains.home.wished.requests import limit_sizes
from scenewright.domains.home.wished.wishes import apply_wishes

Cancel = Callable[[], bool]

Floats = NDArray[np.float64]

NO_PIPES: Floats = np.zeros((0, 5))
SIDEWAYS = 0.4  # the width of a person turned sideways, metres


def task_of(
    brief: Brief,
    room: Room,
    space: Space,
    fixed: tuple[Piece, ...],
    catalog: Catalog,
    library: Library,
    preset: HomePreset,
    solver: str,
    seed: int,
    cancel: Cancel | None = None,
    beside: tuple[Piece, ...] = (),
    entered: tuple[int, ...] = (),
    closet: bool = False,
    pipes: Floats = NO_PIPES,
) -> RoomTask:
    """One room as a task: the ground that ``fixed`` pieces leave, its stream of random numbers,
    and what no route reaches even while the room is empty; ``entered`` are the doors that one comes
    in by, ``closet`` says whether clothes can hang in a closet of the room, ``pipes`` are its walls
    to rooms with water."""
    shape = shapely.Polygon(space.outline, list(space.holes))
    taken = sum(p.size.width * p.size.depth for p in fixed if p.size.height > 0.05)
    taken += covered_by(shape, beside)
    floor = living_area(shape, planes(space), space.height)
    area = max(floor - taken, 0.1)
    stream = int(np.random.SeedSequence([seed, crc32(space.id.encode())]).generate_state(1)[0])
    ground = ground_of(space, fixed, area, beside)._replace(pipes=pipes)
    task = RoomTask(
        space,
        ground,
        fixed,
        catalog,
        preset._replace(settings=fit_settings(preset.settings, space.functions)),
        solver,
        brief.route_width,
        _use_width(shape, brief.route_width),
        frozenset(),
        stream % 2**31,
        cancel,
        limit_sizes(library, room),
        brief.accessible,
        frozenset(w.what for w in room.wishes if w.forbid),
        asked=room,
        beside=beside,
        entered=entered,
        closet=closet,
    )
    return task._replace(tight=out_of_reach(task, ()))


def covered_by(floor: shapely.Polygon, pieces: tuple[Piece, ...]) -> float:
    """Square metres of a floor that pieces of other rooms take."""
    return float(sum(floor.intersection(shape).area for shape in polygons_of(pieces)))


def add_lamps_and_curtains(task: RoomTask, placed: tuple[Piece, ...]) -> list[Piece]:
    """What is placed, rugs and screens as large as they can be, with its lamps and curtains."""
    grown = grow_pieces(task, placed)
    return [*grown, *list_extras(task, grown)]


def grow_pieces(task: RoomTask, placed: Sequence[Piece]) -> list[Piece]:
    """What is placed, its rugs and screens as large as they can be."""
    if not task.preset.settings.exact:
        return list(placed)
    return enlarge_pieces(placed, task.beside, task.ground, task.space.height, task.catalog)


def list_extras(task: RoomTask, standing: Sequence[Piece]) -> list[Piece]:
    """The lamps, curtains, mats and pictures that go with the furniture of a room."""
    if not task.preset.settings.exact:
        return []
    there = {p.id for p in standing} | task.forbidden
    more = extras(task.space, task.ground, (*standing, *task.beside), task.catalog)
    return [p for p in more if there.isdisjoint((p.id, p.category))]


def _use_width(shape: shapely.Polygon, width: float) -> float:
    """The width of the way to pieces: a room nowhere as wide as two routes is used sideways."""
    across = 2 * float(shapely.maximum_inscribed_circle(shape, tolerance=0.02).length)
    return width if across >= 2 * width else min(width, SIDEWAYS)


def wishes_of(
    room: Room, task: RoomTask, rooms: tuple[Space, ...], fixed: tuple[Piece, ...]
) -> tuple[Wish, ...]:
    """What the user asked for in a room, else what its function and size bring, less what
    already stands there."""
    groups = {p.group: p.function for p in fixed if p.function in GROUPS}
    standing = Counter(groups.values())
    have = standing_kinds(fixed)
    there = have | standing.keys() | standing_groups(fixed)
    if room.ask is not None:
        asked = tuple(
            Wish(
                ask.group,
                0 if ask.required else 1,
                required=ask.required,
                most=ask.size or most_of(task.space.functions, ask.group),
            )
            for ask in room.ask
            for _ in range(ask.count)
        )
        return apply_wishes(_less(asked, standing), room, task.library, there)
    others = frozenset(
        f for s in _served(task.space, rooms) for f in resolve_bedrooms(s.functions, 0.0)
    )
    usual = programme(task.space, floor_of(task.ground), others, have)
    if task.welcome is not None:
        usual = (
            *(w for w in usual if w.rank < WELCOME),
            *(Wish(group, WELCOME) for group in task.welcome),
        )
    replaced = {g for w in room.wishes if not w.forbid for g in INSTEAD_OF.get(w.what, ())}
    out = task.elsewhere | replaced
    given = {kind for wish in task.instead for kind in STANDS_FOR.get(wish.group, ())}
    usual = tuple(w for w in usual if not given.intersection(STANDS_FOR.get(w.group, ())))
    usual = tuple(w for w in (*task.instead, *usual) if w.group not in out)
    usual = take_wished_bed(usual, room)
    return apply_wishes(_less(usual, standing), room, task.library, there)


def _served(space: Space, rooms: Sequence[Space]) -> list[Space]:
    """The other rooms of a home whose furniture serves a room: not those nobody can enter."""
    others = [room for room in rooms if room.id != space.id]
    return [room for room in others if is_entered(room) or not is_entered(space)]


def _less(wishes: tuple[Wish, ...], standing: Counter[str]) -> tuple[Wish, ...]:
    """Wishes without one for each group of the same function that stands."""
    left, kept = standing.copy(), []
    for wish in wishes:
        if left[wish.group] > 0:
            left[wish.group] -= 1
        else:
            kept.append(wish)
    return tuple(kept)
