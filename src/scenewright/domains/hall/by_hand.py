"""What follows in a hall from an edit by hand: what gives way, groups and ways as they are now."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
import shapely

from scenewright.arranging.give_way import Ways, give_way, nearest_place
from scenewright.building.door_approach import door_zone, gates
from scenewright.building.plan import plan_rooms
from scenewright.catalog.loading import catalog_of
from scenewright.core.catalog import Catalog
from scenewright.core.errors import InputError
from scenewright.core.layout import corners
from scenewright.core.piece_edits import Edited, frame_of, transfer_frame
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import STAIRS, Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Space
from scenewright.domains.hall.hall_layout import HallLayout, PlacedGroup
from scenewright.domains.hall.seats.chairs import CHAIRS
from scenewright.domains.hall.visit.tour import tour

PARTITION = "partition"
FRONT = 0.6
"""Metres of floor before an object that one stands on who uses it."""
OUTSIDE_HALL = 0.05
"""How far outside its hall a piece may be put, metres: outlines are not drawn more exactly."""


def goes_with(piece: Piece, other: Piece) -> bool:
    """Whether a piece follows another wherever it goes: its chairs, what stands on it."""
    return piece.id.startswith(f"{other.id}/") or piece.on == other.id


def ways_of(solution: Solution, plan: Plan) -> Ways:
    """What may give way in the halls of a solution: each object with its chairs, in its zone."""
    kinds, pieces = catalog_of(solution.brief.catalogs).kinds, solution.pieces
    leads = [p for p in pieces if not p.fixed and not _follows(p)]
    units = [(p.id, *(q.id for q in pieces if goes_with(q, p))) for p in leads]
    held = {p.id for p in pieces if p.fixed or p.function in (PARTITION, STAIRS)}
    floors = {space.id: floor_of(space) for space in plan.spaces}
    zones = {} if solution.detail is None else _zone_floors(solution.detail.layout, floors)
    return Ways(
        {name: unit for unit in units if not held & {*unit} for name in unit},
        lambda piece: zones.get(piece.group, floors[piece.space]),
        held,
        lambda piece: piece.category in kinds and kinds[piece.category].flat,
        solution.brief.passage_width,
        lambda piece: piece.function == PARTITION,
        FRONT,
    )


def _zone_floors(
    layout: HallLayout, floors: Mapping[str, shapely.Geometry]
) -> dict[str, shapely.Geometry]:
    """The floor of its zone, by the id of each group."""
    outlines = {(z.space, z.id): shapely.Polygon(z.outline, [*z.holes]) for z in layout.zones}
    meant = {group.id: (group.space, group.zone) for group in layout.groups}
    parts = {
        key: shapely.intersection(shape.buffer(OUTSIDE_HALL, join_style="mitre"), floors[key[0]])
        for key, shape in outlines.items()
    }
    return {group: parts[key] for group, key in meant.items() if key in parts}


def floor_of(space: Space) -> shapely.Geometry:
    """The floor of a hall that pieces may stand on: without what keeps its doors usable."""
    floor = shapely.Polygon(space.outline, [*space.holes])
    doors = [gate for gate in gates(space) if gate.opening.kind != "window"]
    kept = np.array([box for gate in doors for box in door_zone(space, gate)]).reshape(-1, 5)
    return shapely.difference(floor, shapely.union_all(shapely.polygons(corners(kept))))


def make_way(solution: Solution, edited: Edited, plan: Plan) -> Edited:
    """Edited pieces with all that those moved run into at the nearest free place. InputError for
    one that was put outside its hall, and where there is no place for what would have to move."""
    if not edited.moved:
        return edited
    ways, before = ways_of(solution, plan), solution.pieces
    halls = {s.id: shapely.Polygon(s.outline, [*s.holes]) for s in plan.spaces}
    moved = [p for p in edited.pieces if p.id in edited.moved]
    for piece, shape in zip(moved, polygons_of(moved).tolist(), strict=True):
        away = halls[piece.space].distance(shape)
        if away > OUTSIDE_HALL:
            fault = f"moved there, '{piece.id}' would stand {away:.2f} m outside the hall"
            raise InputError(fault, _name_nearest(before, moved, ways))
    given = give_way(before, edited.pieces, edited.moved, ways)
    if given.stuck:
        fault = f"there is no place for '{given.stuck[0]}', which would have to make room"
        raise InputError(fault, _name_nearest(before, moved, ways))
    return edited._replace(pieces=given.pieces)


def _name_nearest(before: Sequence[Piece], moved: Sequence[Piece], ways: Ways) -> str:
    """The place nearest to the one wanted where nothing has to move."""
    unit = [piece.id for piece in moved]
    place = nearest_place(before, unit, frame_of(moved[0]), ways)
    if place is None:
        return "move it further in, or a single piece by its own id"
    return f"the nearest place that fits '{unit[0]}' is ({place[0]:.2f}, {place[1]:.2f})"


def with_groups(before: Solution, after: Solution, catalog: Catalog) -> Solution:
    """A solution with its groups as its pieces stand now, and a visitor's way through the halls
    where something changed."""
    was, now = ({p.id: p for p in s.pieces} for s in (before, after))
    touched = {p.space for p in after.pieces if was.get(p.id) != p}
    touched |= {p.space for p in before.pieces if p.id not in now}
    if after.detail is None or not touched:
        return after
    groups = [_follow(group, was, now) for group in after.detail.layout.groups]
    layout = after.detail.layout._replace(groups=tuple(g for g in groups if g.objects))
    spaces = {s.id: s for s in plan_rooms(after.brief).spaces if s.id in touched}
    width = after.brief.route_width
    tours = [
        tour(spaces[one.space], after.pieces, layout, catalog, width) or one
        if one.space in spaces
        else one
        for one in after.detail.tours
    ]
    return replace(after, detail=after.detail._replace(layout=layout, tours=tuple(tours)))


def _follow(group: PlacedGroup, was: Mapping[str, Piece], now: Mapping[str, Piece]) -> PlacedGroup:
    """A group without what is gone, and with its pose where all of it went the same way."""
    here = tuple(name for name in group.objects if name in now)
    both = [name for name in here if name in was]
    if not both:
        return group._replace(objects=here)
    start, end = frame_of(was[both[0]]), frame_of(now[both[0]])
    meant = [transfer_frame(frame_of(was[name]), start, end) for name in both]
    apart = [math.dist(pose[:2], now[n].pose[:2]) for pose, n in zip(meant, both, strict=True)]
    moved = max(apart) < OUTSIDE_HALL and start != end
    pose = transfer_frame(group.pose, start, end) if moved else group.pose
    return group._replace(objects=here, pose=pose)


def _follows(piece: Piece) -> bool:
    """Whether a piece is carried along by another, or never moves."""
    return piece.function.endswith(CHAIRS) or piece.on is not None or piece.function == PARTITION
