"""Doors, windows and passages: put on their walls, joined to the rooms they lead to.

The brief lists an opening in one of the rooms it touches, as a point near that room's outline.
Here it becomes one shared value on the middle line of the wall.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from scenewright.building import heads, outlines
from scenewright.building.outlines import project, run_lengths, wall_runs
from scenewright.core.brief import Brief, Door, Window
from scenewright.core.errors import InputError
from scenewright.core.space import Opening, OpeningKind, Points, Space

REACH = 0.35
SLIDE = 0.3
CLIP = 0.1
WIDEST_WALL = 0.6
THINNEST_WALL = 0.02


class Walls(NamedTuple):
    """All inner wall faces of one level: edges ``(e, 4)``, unit directions ``(e, 2)``, the index
    of the space each belongs to and whether it is part of that space's outline or a hole."""

    edges: Points
    directions: Points
    owner: Points


class Runs(NamedTuple):
    """The walls of a room as polylines, and the least and greatest x, y of each, ``(r, 4)``."""

    lines: list[Points]
    bounds: Points


class Stretch(NamedTuple):
    """Where an opening lies on a room's outline: its two ends, inside on the left."""

    start: Points
    end: Points


def find_openings(brief: Brief, spaces: tuple[Space, ...]) -> tuple[Opening, ...]:
    """One opening for every door and window of the brief; those listed twice are merged."""
    found: list[Opening] = []
    for level in dict.fromkeys(space.level for space in spaces):
        faces = _faces(spaces, level)
        mine: list[tuple[str, Opening]] = []
        for number, space in enumerate(spaces):
            if space.level == level:
                mine += _of_room(brief, number, spaces, faces)
        found += _merge_openings(mine)
    return _assign_ids(found)


def _faces(spaces: tuple[Space, ...], level: str) -> Walls:
    """Wall faces of a level as arrays."""
    rows, owner = [np.zeros((0, 4))], [np.zeros(0)]
    for number, space in enumerate(spaces):
        if space.level == level:
            own = np.vstack([outlines.edges(ring) for ring in (space.outline, *space.holes)])
            rows.append(own)
            owner.append(np.full(len(own), number))
    edges = np.vstack(rows)
    along = edges[:, 2:] - edges[:, :2]
    return Walls(edges, along / np.linalg.norm(along, axis=1)[:, None], np.concatenate(owner))


def _of_room(
    brief: Brief, number: int, spaces: tuple[Space, ...], faces: Walls
) -> list[tuple[str, Opening]]:
    room, space, by_id = brief.rooms[number], spaces[number], {s.id: s for s in spaces}
    where = f"rooms[{number}] '{room.name or space.id}'"
    listed: list[tuple[str, Door | Window]] = [
        *((f"doors[{i}]", door) for i, door in enumerate(room.doors)),
        *((f"windows[{i}]", window) for i, window in enumerate(room.windows)),
    ]
    found = []
    runs = runs_of(space)
    for which, opening in listed:
        place = f"{where} {which}"
        try:
            made = _opening(brief, number, list(by_id), faces, space, runs, opening)
            found.append((place, heads.under_other(made, by_id[made.spaces[-1]], opening)))
        except InputError as error:
            raise error.located(place=place) from None
    return found


def runs_of(space: Space) -> Runs:
    """The walls and columns of a room."""
    lines = [run for ring in (space.outline, *space.holes) for run in wall_runs(ring)]
    return Runs(lines, np.array([[*run.min(0), *run.max(0)] for run in lines]))


def _opening(
    brief: Brief,
    number: int,
    ids: list[str],
    faces: Walls,
    space: Space,
    runs: Runs,
    wish: Door | Window,
) -> Opening:
    stretch = stretch_of(runs, wish.at, wish.width, max(brief.wall_thickness, REACH))
    middle, along, width = line_of(stretch)
    beyond, gap = _beyond(faces, number, middle, along)
    if isinstance(wish, Door) and wish.to is not None:
        beyond = _resolve_target(wish.to, ids, beyond)
    thickness = gap if beyond is not None else _outer_wall(brief, space.level, middle, along)
    thickness = max(thickness, THINNEST_WALL)
    centre = middle + thickness / 2 * np.array([along[1], -along[0]])
    kind, sill, hinge, swing = _leaf(wish)
    head, roof = heads.heads_of(space, stretch.start, stretch.end, wish)
    return Opening(
        id=wish.id,
        kind=kind,
        level=space.level,
        x=round(float(centre[0]), 9),
        y=round(float(centre[1]), 9),
        ux=float(along[0]),
        uy=float(along[1]),
        width=round(width, 9),
        thickness=round(float(thickness), 9),
        sill=sill,
        head=head,
        hinge=hinge,
        swing=swing,
        spaces=(space.id,) if beyond is None else (space.id, ids[beyond]),
        use=wish.use if isinstance(wish, Door) else "both",
        roof=roof,
        ajar=wish.ajar if isinstance(wish, Door) else None,
    )


def _leaf(wish: Door | Window) -> tuple[OpeningKind, float, int, int]:
    """Kind, sill, hinge and swing. Facing the wall from inside, left is the end of the edge."""
    if isinstance(wish, Window):
        return "window", wish.sill, 0, 0
    if wish.swing in ("slide", "none"):
        return ("door" if wish.swing == "slide" else "passage"), 0.0, 0, 0
    return "door", 0.0, 1 if wish.hinge == "left" else -1, 1 if wish.swing == "in" else -1


def stretch_of(runs: Runs, place: tuple[float, float], width: float, reach: float) -> Stretch:
    """The best piece of the walls ``runs`` for an opening or a radiator: the nearest on which it
    fits.

    A wall is an edge with all that follow at less than 25 degrees, so a curved wall is one. What
    is put there is slid along it by at most 0.3 m and narrowed by at most 0.1 m to fit.
    """
    at = np.array(place)
    low, high = runs.bounds[:, :2] - reach, runs.bounds[:, 2:] + reach
    beside = np.flatnonzero(((at >= low) & (at <= high)).all(axis=1))
    away = [(runs.lines[i], *project(runs.lines[i], at)) for i in beside]
    near = [row for row in away if row[2] <= reach]
    if not near:
        raise _off_the_wall(runs, at, reach)
    run, s, _ = min(near, key=lambda row: row[2] + _overhang(row[0], row[1], width))
    return _fit_to_run(run, s, width)


def _overhang(run: Points, s: float, width: float) -> float:
    length = run_lengths(run)[-1]
    return float(max(width / 2 - s, 0.0) + max(s + width / 2 - length, 0.0))


def _fit_to_run(run: Points, s: float, width: float) -> Stretch:
    lengths = run_lengths(run)
    length = float(lengths[-1])
    slid = min(max(s, width / 2), max(length - width / 2, width / 2))
    if width > length + CLIP:
        raise InputError(
            f"is {width:g} m wide, but its wall only {length:.2f} m", "make it narrower"
        )
    if abs(slid - s) > SLIDE and width <= length:
        raise InputError(
            f"reaches {abs(slid - s):.2f} m over the end of its wall", "move it along the wall"
        )
    low, high = max(slid - width / 2, 0.0), min(slid + width / 2, length)
    ends = [[np.interp(t, lengths, run[:, axis]) for axis in (0, 1)] for t in (low, high)]
    return Stretch(np.array(ends[0]), np.array(ends[1]))


def line_of(stretch: Stretch) -> tuple[Points, Points, float]:
    """The middle of a stretch, its unit direction and its length."""
    along = stretch.end - stretch.start
    width = float(np.hypot(*along))
    return (stretch.start + stretch.end) / 2, along / width, width


def _off_the_wall(runs: Runs, at: Points, reach: float) -> InputError:
    away = [project(run, at) for run in runs.lines]
    best = min(range(len(away)), key=lambda i: away[i][1])
    run, (s, far) = runs.lines[best], away[best]
    x, y = (np.interp(s, run_lengths(run), run[:, axis]) for axis in (0, 1))
    return InputError(
        f"is off the wall: ({at[0]:g}, {at[1]:g}) is {far:.2f} m from the nearest wall of the "
        f"room, at ({x:.2f}, {y:.2f})",
        f"put it within {reach:g} m of a wall",
    )


def _beyond(faces: Walls, number: int, middle: Points, along: Points) -> tuple[int | None, float]:
    """The space across the wall and its distance: the first face hit straight outwards."""
    out = np.array([along[1], -along[0]])
    faced = faces.directions @ along < -0.5
    rows = np.flatnonzero(faced & (faces.owner != number))
    if len(rows) == 0:
        return None, 0.0
    start, direction = faces.edges[rows, :2] - middle, faces.directions[rows]
    across = direction[:, 0] * out[1] - direction[:, 1] * out[0]
    t = (start[:, 1] * direction[:, 0] - start[:, 0] * direction[:, 1]) / across
    s = (out[0] * start[:, 1] - out[1] * start[:, 0]) / across
    length = np.linalg.norm(faces.edges[rows, 2:] - faces.edges[rows, :2], axis=1)
    hit = (t > -0.06) & (t <= WIDEST_WALL) & (s >= 0) & (s <= length)
    if not hit.any():
        return None, 0.0
    best = int(np.argmin(np.where(hit, t, np.inf)))
    return int(faces.owner[rows[best]]), float(t[best])


def _resolve_target(to: str, ids: list[str], beyond: int | None) -> int | None:
    if to not in ids:
        raise InputError(f"leads to '{to}', which is not a room", f"use one of: {', '.join(ids)}")
    if beyond is None or ids[beyond] != to:
        there = "the outside" if beyond is None else f"'{ids[beyond]}'"
        raise InputError(
            f"should lead to '{to}', but beyond the wall is {there}", "move it or leave out 'to'"
        )
    return beyond


def _outer_wall(brief: Brief, level: str, middle: Points, along: Points) -> float:
    """Thickness of the wall outside: that of the listed wall it lies on, else the usual one."""
    for wall in brief.walls:
        start, end = np.array(wall.start), np.array(wall.end)
        line, off = end - start, middle - start
        length = float(np.hypot(*line))
        if wall.level not in ("", level) or length < outlines.SAME_POINT:
            continue
        away = abs(line[0] * off[1] - line[1] * off[0]) / length
        beside = -0.1 <= (line @ off) / length**2 <= 1.1 and away <= wall.thickness / 2 + 0.05
        if beside and abs(line @ along) > 0.9 * length:
            return wall.thickness
    return brief.outer_wall_thickness


def _merge_openings(found: list[tuple[str, Opening]]) -> list[Opening]:
    """Openings without those listed from both sides; two that only overlap are an error."""
    kept: list[tuple[str, Opening]] = []
    for place, opening in found:
        others = [(where, other) for where, other in kept if _overlap(opening, other)]
        if not others:
            kept.append((place, opening))
        for where, other in others:
            if not _same(opening, other):
                raise InputError(
                    f"overlaps {where}", "move one of them along the wall", place=place
                )
    return [opening for _, opening in kept]


def _overlap(one: Opening, other: Opening) -> bool:
    dx, dy = other.x - one.x, other.y - one.y
    along, across = dx * one.ux + dy * one.uy, dx * one.uy - dy * one.ux
    return (
        abs(one.ux * other.ux + one.uy * other.uy) > 0.9
        and abs(across) < (one.thickness + other.thickness) / 2
        and abs(along) < (one.width + other.width) / 2 - 0.05
        and min(one.head, other.head) - max(one.sill, other.sill) > 0.05
    )


def _same(one: Opening, other: Opening) -> bool:
    between = float(np.hypot(other.x - one.x, other.y - one.y))
    joined = len(one.spaces) == 2 and set(one.spaces) == set(other.spaces)
    alike = (one.kind == "window") == (other.kind == "window")
    return joined and alike and between < max(0.3, min(one.width, other.width) / 2)


def _assign_ids(found: list[Opening]) -> tuple[Opening, ...]:
    """Openings with an id each: the one given, else ``kitchen-window-2``."""
    taken = {opening.id for opening in found if opening.id}
    if len(taken) < sum(bool(opening.id) for opening in found):
        ids = [opening.id for opening in found if opening.id]
        double = next(i for i in ids if ids.count(i) > 1)
        raise InputError(f"two openings have the id '{double}'", "give every opening its own id")
    named: list[Opening] = []
    for opening in found:
        stem = f"{opening.spaces[0]}-{opening.kind}"
        names = (f"{stem}-{k}" for k in range(1, len(found) + len(taken) + 2))
        fresh = opening.id or next(name for name in names if name not in taken)
        taken.add(fresh)
        named.append(replace(opening, id=fresh))
    return tuple(named)
