"""Furniture groups found again in the pieces of a saved home."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import cos, pi, remainder, sin

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.catalog import Catalog, Group, Member
from scenewright.core.layout import corners
from scenewright.core.piece_edits import carry_pieces
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.changes.edits import leads, near_poses
from scenewright.domains.home.furnishing.furnish import (
    BACKED,
    SLACK,
    FurnishedPatch,
    too_tall,
    why_not,
)
from scenewright.domains.home.furnishing.obstacles import StandingObstacles, flat_kinds, standing_of
from scenewright.domains.home.grounds.hanging_walls import hanging_walls
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.programme import FALLBACK, Wish
from scenewright.geometry.fit import OUTSIDE, faults, is_backed

Floats = NDArray[np.float64]


def regroup_pieces(
    pieces: Sequence[Piece], boxes: Mapping[str, Floats], wishes: Sequence[Wish]
) -> tuple[FurnishedGroup, ...]:
    """The groups that pieces of one room make, in the order of their first pieces.

    ``boxes`` (5,) are their patches by group where they are known, else the box round the pieces;
    each takes its wish from ``wishes``, or is a usual one of its own.
    """
    groups: dict[str, list[Piece]] = {}
    for piece in pieces:
        if piece.function in GROUPS:
            groups.setdefault(piece.group, []).append(piece)
    left, found = list(wishes), []
    for group, members in groups.items():
        wish = _wish(members[0].function, left)
        box = boxes.get(group)
        furnished = _to_furnished_patch(members, _round(members) if box is None else box)
        found.append(FurnishedGroup(wish, group.rpartition("/")[2], furnished, tuple(members)))
    return tuple(found)


def _wish(function: str, left: list[Wish]) -> Wish:
    """The wish a group fulfils, taken off the list."""
    for wish in left:
        if function in (wish.group, FALLBACK.get(wish.group)):
            left.remove(wish)
            small = wish.small or function != wish.group
            return wish._replace(group=function, small=small)
    return Wish(function, 1)


def _to_furnished_patch(pieces: Sequence[Piece], box: Floats) -> FurnishedPatch:
    """Pieces as a dressed patch: each in the frame of the box."""
    ids = [p.id for p in pieces]
    s, c = sin(box[2]), cos(box[2])
    members = []
    for p in pieces:
        dx, dy = p.pose.x - box[0], p.pose.y - box[1]
        on = ids.index(p.on) if p.on in ids else -1
        members.append(
            Member(
                p.category,
                dx * s - dy * c,
                dx * c + dy * s,
                p.pose.z,
                remainder(p.pose.heading - box[2], 2 * pi),
                p.size,
                on,
                p.asset,
            )
        )
    case = Group(pieces[0].function, "as it stands", float(box[3]), float(box[4]), tuple(members))
    return FurnishedPatch(case, box, (True,) * len(members), 0)


def _round(pieces: Sequence[Piece]) -> Floats:
    """The box round the pieces, heading as the main piece does."""
    essential = GROUPS[pieces[0].function].essential
    standing = [p for p in pieces if p.on is None and p.pose.z < BACKED] or list(pieces)
    h = next((p for p in standing if p.category in essential), standing[0]).pose.heading
    frames = [(*p.pose[:2], p.pose.heading, *p.size[:2]) for p in standing]
    points = corners(np.array(frames)).reshape(-1, 2)
    axes = np.array([[sin(h), cos(h)], [-cos(h), sin(h)]])  # columns: to the right, ahead
    low, high = (points @ axes).min(0), (points @ axes).max(0)
    x, y = axes @ ((low + high) / 2)
    return np.array([x, y, h, *(high - low)])


def as_standing(pieces: Sequence[Piece], catalog: Catalog) -> StandingObstacles:
    """Pieces as what others are to keep clear of."""
    return standing_of(tuple(pieces), flat_kinds(catalog))


def find_misplaced(
    task: RoomTask, pieces: Sequence[Piece], standing: StandingObstacles
) -> dict[str, str]:
    """Why pieces cannot stand where they are, by id: outside the room, before a door or window,
    in something else, off their wall, or on a piece that cannot stay."""
    if not pieces:
        return {}
    boxes = np.array([(*p.pose[:2], p.pose.heading, *p.size[:2]) for p in pieces])
    spans = np.array([(p.pose.z, p.pose.z + p.size.height) for p in pieces])
    kinds = [task.catalog.kinds[p.category] for p in pieces]
    ground = task.ground
    codes, offenders = faults(
        boxes,
        spans,
        np.array([k.flat for k in kinds]),
        ground.edges,
        ground.keep_free,
        ground.windows,
        standing.boxes,
        standing.spans,
        SLACK,
    )
    codes = too_tall(boxes, spans, ground, task.space.height, codes)
    found: dict[str, str] = {}
    for i, (piece, kind) in enumerate(zip(pieces, kinds, strict=True)):
        code = int(codes[i])
        hangs = kind.support == "wall" and piece.on is None
        if code == 0 and hangs and not is_backed(boxes[i], hanging_walls(ground), BACKED):
            code = OUTSIDE
        if code or piece.on in found:
            member = Member(piece.category, 0, 0, piece.pose.z, 0, piece.size)
            found[piece.id] = why_not(member, code, int(offenders[i]), standing)
    return found


def newly_misplaced(
    task: RoomTask, pieces: Sequence[Piece], standing: StandingObstacles
) -> dict[str, str]:
    """What of :func:`find_misplaced` is due to ``standing``: what was wrong with a piece in the
    empty room has not come of a change to something else."""
    alone = find_misplaced(task, pieces, as_standing((), task.catalog))
    wrong = find_misplaced(task, pieces, standing)
    meets = {p.id for p in pieces if p.id in alone and _runs_into(p, standing)}
    return {name: why for name, why in wrong.items() if name not in alone or name in meets}


def _runs_into(piece: Piece, standing: StandingObstacles) -> bool:
    low, high = piece.pose.z, piece.pose.z + piece.size.height
    level = (standing.spans[:, 0] < high - SLACK) & (standing.spans[:, 1] > low + SLACK)
    box = np.array([[*piece.pose[:2], piece.pose.heading, *piece.size[:2]]])
    others = shapely.polygons(corners(standing.boxes[level]))
    area = shapely.area(shapely.intersection(others, shapely.polygons(corners(box))[0]))
    return bool((area > SLACK).any())


def settle_group(
    task: RoomTask, pieces: Sequence[Piece], standing: StandingObstacles
) -> tuple[Piece, ...]:
    """A group at the nearest place where most of it can stand, what makes it first."""
    if not pieces:
        return ()
    main = next((p for p in pieces if leads(p)), pieces[0])
    start = (main.pose.x, main.pose.y, main.pose.heading)
    best, least = tuple(pieces), float("inf")
    for end in near_poses(start, task.preset.settings.rearrange):
        there = carry_pieces(pieces, start, end)
        wrong = find_misplaced(task, there, standing)
        worth = sum(len(pieces) if leads(p) else 1 for p in there if p.id in wrong)
        if worth < least:
            best, least = there, worth
        if not worth:
            break
    return best
