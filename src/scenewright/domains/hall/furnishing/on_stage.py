"""What stands on the stage instead of beside it: the lectern, at the side of it and near its edge,
as speakers do, so that what is shown behind them stays in sight, a screen along its back, and
before seats for an audience a single desk, in the middle."""

from __future__ import annotations

import math

from scenewright.core.catalog import Catalog, footprint_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import LeftOut
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.classes import is_audience_seat
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.hall_layout import Layer, PatternPart, PlacedGroup

STAGE, SCREEN, LECTERN, PIANO, DESK = "stage", "screen", "lectern", "piano", "desk"
CARRIED = (LECTERN, SCREEN, PIANO, DESK)
STAGE_ASIDE = 0.28
"""How far off the middle of the stage, as a share of its width: beside the steps at its ends."""
STAGE_EDGE = 0.5
"""Between the objects on a stage and its front edge, in metres."""
STAGE_BESIDE = 0.7
"""Between the end of a desk in the middle of a stage and the centre of a lectern, in metres."""
STAGE_BEHIND = 0.9
"""Least depth for who speaks, or plays, in metres."""
WING = 0.35
"""Between the back of a piano and the end of the stage, and its side and the back, in metres."""


def split_carried(
    wishes: list[HallDemand], fixed: tuple[Piece, ...], together: bool = False
) -> tuple[list[HallDemand], list[HallDemand]]:
    """Demands that stand on the floor, and those of one object that a stage has room for: one of
    the same zone, or one that stands already. A piano without a stage stands at a wall; it is laid
    out as any other object where all are ``together``, and so is a desk, or one without seats for
    an audience."""
    audience = any(is_audience_seat(wish.category, wish.sizes[0].width) for wish in wishes)
    stages = [(wish.zones, wish.sizes[0]) for wish in wishes if wish.category == STAGE]
    there = [piece.size for piece in fixed if piece.category == STAGE]
    carried = [
        wish
        for wish in wishes
        if wish.category in CARRIED
        and len(wish.sizes) == 1
        and not (wish.category in (PIANO, DESK) and (together or not wish.unstated))
        and (wish.category != DESK or audience)
        and any(
            _has_room(floor, wish)
            for floor in (*there, *(floor for zones, floor in stages if zones == wish.zones))
        )
    ]
    carried.sort(key=lambda wish: wish.category == PIANO)
    shows = [wish.zones for wish in carried if wish.category == SCREEN]
    wishes = [_along_wall(w) if w.category == STAGE and w.zones in shows else w for w in wishes]
    if not together:
        wishes = [_along_wall(w) if w.category == PIANO and w.unstated else w for w in wishes]
    ids = [wish.id for wish in carried]
    shown = [wish.id for wish in wishes if wish.category == STAGE]
    rest = [wish for wish in wishes if wish.id not in ids]
    looking = [
        wish._replace(facing=shown[0]) if wish.facing in ids and shown else wish for wish in rest
    ]
    return looking, carried


def _along_wall(wish: HallDemand) -> HallDemand:
    """A stage or a piano with its back at a wall."""
    front, left, _, right = wish.clearance
    return wish._replace(patterns=("wall",), clearance=(front, left, 0.0, right))


def _has_room(floor: Size, wish: HallDemand) -> bool:
    """Whether a stage is wide and deep enough to speak from behind an object, or to stand before
    a screen."""
    size = wish.sizes[0]
    if wish.category == PIANO:
        wide = 0.5 * floor.width > WING + size.depth + STAGE_BEHIND
        return wide and floor.depth > size.width + 2 * WING
    if wish.category == DESK:
        wide = STAGE_ASIDE * floor.width > 0.5 * size.width + STAGE_BESIDE
        return wide and floor.depth > STAGE_EDGE + size.depth + STAGE_BEHIND
    if wish.category == SCREEN:
        return floor.width >= size.width and floor.depth > size.depth + STAGE_EDGE + STAGE_BEHIND
    return (0.5 - STAGE_ASIDE) * floor.width > 0.5 * size.width + 0.3 and (
        floor.depth > STAGE_EDGE + size.depth + STAGE_BEHIND
    )


def put_on_stage(
    hall: HallContext, carried: list[HallDemand], pieces: tuple[Piece, ...], catalog: Catalog
) -> tuple[tuple[Piece, ...], tuple[PlacedGroup, ...], tuple[LeftOut, ...]]:
    """The pieces of carried demands on the first stage among ``pieces``, their groups, and what has
    no stage: on alternating sides of the middle, looking where the stage does."""
    stages = [piece for piece in pieces if piece.category == STAGE]
    found, groups, missing = list[Piece](), list[PlacedGroup](), list[LeftOut]()
    for number, wish in enumerate(carried):
        if not stages:
            why = "its stage found no room"
            missing.append(LeftOut(hall.space.id, wish.name, why, wish.required))
            continue
        stage, zone = stages[0], wish.zones[0] if wish.zones else hall.names[0]
        room = hall.space.height - stage.pose.z - stage.size.height
        side = 1.0 if _find_turn(carried, number) % 2 else -1.0
        piece = _on(stage, wish, side, f"{hall.space.id}/{wish.id}", catalog, room)
        found.append(piece)
        part = PatternPart("single", (Layer(1, 0.0, 0.0),))
        pose = (piece.pose.x, piece.pose.y, piece.pose.heading)
        placed = piece.group, wish.id, hall.space.id, zone, "single", pose, (part,), (piece.id,)
        groups.append(PlacedGroup(*placed))
    return tuple(found), tuple(groups), tuple(missing)


def _find_turn(carried: list[HallDemand], number: int) -> int:
    """The turn of an object, a piano's after the lectern's: the two stand at different sides."""
    lecterns = [k for k, wish in enumerate(carried) if wish.category == LECTERN]
    return lecterns[-1] + 1 if carried[number].category == PIANO and lecterns else number


def _on(
    stage: Piece, wish: HallDemand, side: float, group: str, catalog: Catalog, room: float
) -> Piece:
    """One object at one ``side`` (-1 or 1) of a stage or along its back, at most ``room`` metres
    high."""
    size = Size(*wish.sizes[0])
    size = size._replace(height=min(size.height, room))
    right, ahead, turn = _stand(stage.size, wish.category, size, side)
    c, s = math.cos(stage.pose.heading), math.sin(stage.pose.heading)
    x, y = stage.pose.x + right * s + ahead * c, stage.pose.y - right * c + ahead * s
    heading = stage.pose.heading + turn
    asset = catalog.choose(wish.category, size)
    return Piece(
        id=f"{group}/{wish.category}_1",
        category=wish.category,
        asset=asset.id if asset else "",
        space=stage.space,
        pose=Pose(x, y, stage.pose.z + stage.size.height, heading),
        size=size,
        group=group,
        function=wish.id,
        footprint=footprint_of(asset, size),
        on=stage.id,
    )


def _stand(floor: Size, category: str, size: Size, side: float) -> tuple[float, float, float]:
    """How far to the right of the middle of a stage and before it an object stands, and how it is
    turned: a piano with its back to the wing, so that the player is seen from the side, a desk so
    that who stands behind it looks at the audience."""
    if category == SCREEN:
        return 0.0, 0.5 * (size.depth - floor.depth), 0.0
    if category == PIANO:
        right = 0.5 * (floor.width - size.depth) - WING
        return side * right, WING + 0.5 * (size.width - floor.depth), side * 0.5 * math.pi
    if category == DESK:
        return 0.0, 0.5 * (floor.depth - size.depth) - STAGE_EDGE, math.pi
    return side * STAGE_ASIDE * floor.width, 0.5 * (floor.depth - size.depth) - STAGE_EDGE, 0.0
