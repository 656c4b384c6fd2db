"""Fixed items of a brief as pieces and back, in every domain."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import shapely

from scenewright.building.plan import room_ids
from scenewright.core.brief import Brief, FixedItem, Room
from scenewright.core.catalog import Catalog, footprint_of
from scenewright.core.footprint import read_footprint
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import STAIRS, Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.core.space import Radiator, Space

RADIATOR = "radiator"
REACHING = 1e-3
"""Square metres of a room's floor that pieces of the next one may cover unseen."""
RADIATED = 0.2
"""Depth of the floor before a radiator that is left free, in metres: advice on heating asks for 0.1
to 0.3 m, so that warm air rises and is not shut in."""


def fixed_pieces(room: Room, space: Space, catalog: Catalog) -> list[Piece]:
    """The fixed items of a room as pieces; a locked group stays one."""
    found = [_radiator(radiator, space, catalog) for radiator in space.radiators]
    known = {item.id for item in room.fixed if item.id}
    for number, item in enumerate(room.fixed, 1):
        category = item.category if item.category in catalog.kinds else "obstacle"
        size = Size(*item.size)
        asset = catalog.assets.get(item.asset or "")
        chosen = asset or catalog.choose(category, size)
        found.append(
            Piece(
                id=item.id or f"{space.id}/fixed/{category}_{number}",
                category=category,
                asset=chosen.id if chosen else "",
                space=space.id,
                pose=Pose(*item.at, item.z, item.heading),
                size=size,
                group=item.group or f"{space.id}/fixed",
                function=item.function or "fixed",
                on=item.on if item.on in known else None,
                fixed=True,
                footprint=(
                    read_footprint(item.footprint, *size[:2])
                    if item.footprint
                    else footprint_of(chosen, size)
                ),
            )
        )
    return [*found, *stair_pieces(space)]


def given_pieces(brief: Brief, plan: Plan, catalog: Catalog) -> tuple[Piece, ...]:
    """The fixed pieces of all rooms of a brief."""
    each = zip(brief.rooms, plan.spaces, strict=True)
    return tuple(piece for room, space in each for piece in fixed_pieces(room, space, catalog))


def reaching_in(
    standing: Sequence[Sequence[Piece]], spaces: Sequence[Space]
) -> list[tuple[Piece, ...]]:
    """For each of ``spaces``, the pieces of other rooms that reach into it: given the pieces of
    each, those that cover more than :data:`REACHING` of another's floor on the same level."""
    pieces = [piece for room in standing for piece in room]
    owners = [number for number, room in enumerate(standing) for _ in room]
    found: list[tuple[Piece, ...]] = [()] * len(spaces)
    if not pieces:
        return found
    footprints = polygons_of(pieces)
    tree = shapely.STRtree(footprints)
    for number, space in enumerate(spaces):
        floor = shapely.Polygon(space.outline, list(space.holes))
        near = [
            k
            for k in sorted(tree.query(floor, predicate="intersects").tolist())
            if owners[k] != number and spaces[owners[k]].level == space.level
        ]
        shared = shapely.area(shapely.intersection(floor, footprints[near]))
        found[number] = tuple(
            pieces[k] for k, area in zip(near, shared.tolist(), strict=True) if area > REACHING
        )
    return found


def stair_pieces(space: Space) -> Iterator[Piece]:
    """What stairs take of a space, as pieces that nobody moves; stairs are drawn with the
    building."""
    for part in space.stair_parts:
        x, y, heading, width, depth = part.box
        yield Piece(
            id=part.id,
            category=part.category,
            asset="",
            space=space.id,
            pose=Pose(x, y, 0.0, heading),
            size=Size(width, depth, part.height),
            group=f"{space.id}/fixed",
            function=STAIRS,
            fixed=True,
        )


def _radiator(radiator: Radiator, space: Space, catalog: Catalog) -> Piece:
    size = Size(radiator.width, radiator.depth, radiator.height)
    asset = catalog.choose(RADIATOR, size)
    pose = Pose(radiator.x, radiator.y, radiator.z, radiator.heading)
    return Piece(
        radiator.id,
        RADIATOR,
        asset.id if asset else "",
        space.id,
        pose,
        size,
        f"{space.id}/fixed",
        RADIATOR,
        fixed=True,
    )


def is_radiator(piece: Piece) -> bool:
    """Whether a piece is one of the radiators its room lists."""
    return piece.fixed and piece.function == RADIATOR


def is_item(item: FixedItem, piece: Piece) -> bool:
    """Whether a piece is a brief's fixed item, by id or (where it has none) by place."""
    if item.id:
        return item.id == piece.id
    apart = max(abs(item.at[0] - piece.pose.x), abs(item.at[1] - piece.pose.y))
    return item.category == piece.category and apart < 1e-3


def item_of(piece: Piece, name: str = "") -> FixedItem:
    """A piece as the fixed item of a brief."""
    x, y, z, heading = piece.pose
    return FixedItem(
        id=piece.id,
        category=piece.category,
        asset=piece.asset or None,
        at=(x, y),
        z=max(z, 0.0),
        heading=heading,
        size=(piece.size.width, piece.size.depth, piece.size.height),
        name=name,
        on=piece.on,
        group=piece.group,
        function=piece.function,
        footprint=list(piece.footprint) or None,
    )


def find_item(items: Iterable[FixedItem], piece: Piece) -> FixedItem | None:
    """The item of a brief that a piece is, if any."""
    return next((item for item in items if is_item(item, piece)), None)


def lock_item(piece: Piece, before: FixedItem | None) -> FixedItem:
    """A piece that stays as the item of a brief: locked by hand, but where it stands as the brief
    had it ``before``."""
    item = item_of(piece, before.name if before else "")
    place = (piece.pose.x, piece.pose.y), piece.pose.z, piece.pose.heading
    if before is not None and (before.at, before.z, before.heading) == place:
        return item.model_copy(update={"locked": before.locked})
    return item.model_copy(update={"locked": True})


def move_items(brief: Brief, before: Sequence[Piece], after: Sequence[Piece]) -> Brief:
    """The brief with its fixed items where they were moved to, in their rooms; itself if none
    was."""
    was = {piece.id: piece for piece in before}
    moved = [
        (was[piece.id], piece) for piece in after if piece.id in was and piece != was[piece.id]
    ]

    def follow(item: FixedItem) -> FixedItem:
        now = next((now for one, now in moved if is_item(item, one) and one.pose != now.pose), None)
        return lock_item(now, item) if now else item

    rooms = [
        room.model_copy(update={"fixed": [*map(follow, room.fixed)]}) if room.fixed else room
        for room in brief.rooms
    ]
    same = all(a.fixed == b.fixed for a, b in zip(rooms, brief.rooms, strict=True))
    return brief if same else brief.model_copy(update={"rooms": rooms})


def locked_rooms(solution: Solution) -> Brief:
    """The brief to solve again: locked pieces are its fixed items, everything else is free.

    A locked piece keeps its whole furniture group: a locked table its chairs. Fixed items of the
    brief inside stand among the pieces; one that was unlocked in the file is free too. Id,
    category, asset, pose and size are kept.
    """
    rooms = [
        _room_with_locked(room, [piece for piece in solution.pieces if piece.space == space])
        for room, space in zip(solution.brief.rooms, room_ids(solution.brief), strict=True)
    ]
    return solution.brief.model_copy(update={"rooms": rooms})


def _room_with_locked(room: Room, here: list[Piece]) -> Room:
    here = [piece for piece in here if not is_radiator(piece)]
    groups = {p.group for p in here if p.fixed and p.function not in ("", "fixed", "light")}
    kept = [p for p in here if (p.fixed or p.group in groups) and p.function != STAIRS]
    locked = [lock_item(piece, find_item(room.fixed, piece)) for piece in kept]
    unplaced = [item for item in room.fixed if not any(is_item(item, piece) for piece in here)]
    return room.model_copy(update={"fixed": [*locked, *unplaced]})
