"""The referee of villages: overlaps beyond shared walls, outside, on lanes, blocked doors, no way.

It sees the brief, the blocks and the pieces, uses exact polygons, and shares no code with what
places houses.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Flags, Floats, Indices, Shape, Shapes
from scenewright.check.buildings import (
    find_collisions,
    find_off_ground,
    measure_shared,
    split_sound,
    state_fault,
)
from scenewright.check.owed import find_owed
from scenewright.check.rooms import count_findings
from scenewright.check.shared_ground import intersect_footprints
from scenewright.core.catalog import Catalog
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import outline_of, polygons_of
from scenewright.core.plan import Plan
from scenewright.core.report import Finding, Report
from scenewright.core.scene import Piece
from scenewright.core.solution import Patch, Solution
from scenewright.domains.village.blocks import BlockPlan
from scenewright.domains.village.brief import Lane
from scenewright.domains.village.check.demands import list_owed
from scenewright.domains.village.check.lanes import (
    LaidLane,
    cover_laid_lanes,
    find_on_laid_lanes,
    find_on_lanes,
)

DOOR, COURT = 0.9, 1.0
"""Width of a door, and how deep the ground before it must be free, in metres."""
WAY = 0.5
"""Half the width of a way that leads to a house, in metres."""
START = 1.2
"""How far before a street side, in metres, the street begins."""


class JudgedBlock(NamedTuple):
    """A block with its ground, where people may walk, its free square, the sound houses on it with
    their footprints, and the middle (n, 2) and direction out (n, 2) of each door, and the
    ground of lanes that were laid."""

    plan: BlockPlan
    floor: Shape
    walkable: Shape
    square: Shape
    houses: tuple[Piece, ...]
    shapes: Shapes
    doors: Floats
    out: Floats
    laid: Shape


def check(solution: Solution, plan: Plan, kinds: Catalog) -> Report:
    """Judge the houses of every block; see :func:`scenewright.domains.check`. Houses have no
    ``kinds``."""
    del kinds
    part = solution.brief.part
    findings, figures = judge_blocks(
        solution.pieces, solution.patches, plan.detail.blocks, part.lanes, solution.detail or ()
    )
    owed = [*list_owed(part.blocks, plan.detail, solution.pieces, solution.patches)]
    findings += find_owed(owed, solution.left_out)
    totals = {**count_findings(solution.pieces, findings), "blocks": figures}
    return Report(tuple(findings), (), totals)


def judge_blocks(
    pieces: Sequence[Piece],
    patches: Sequence[Patch],
    blocks: Sequence[BlockPlan],
    lanes: Sequence[Lane] = (),
    laid: Sequence[LaidLane] = (),
) -> tuple[list[Finding], dict[str, dict[str, Any]]]:
    """Every violation on some blocks and the ``lanes`` of their brief and those ``laid`` for
    them, and their figures. Broken pieces become findings."""
    known = {block.id for block in blocks}
    findings, sound = split_sound(pieces, known, "a block")
    figures = {}
    for block in blocks:
        here = [p for p in sound if p.space == block.id]
        own = [lane for lane in laid if lane.block == block.id]
        judged = _make_judged(block, here, patches, own)
        reached = find_reached(judged)
        findings += [
            *find_overlaps(judged),
            *find_outside(judged),
            *find_on_lanes(judged.houses, judged.shapes, lanes),
            *find_on_laid_lanes(judged.houses, judged.shapes, judged.laid),
            *find_blocked_doors(judged),
            *_unreachable(judged, reached),
        ]
        figures[block.id] = figures_of(judged, reached)
    return findings, figures


def _make_judged(
    block: BlockPlan, houses: list[Piece], patches: Sequence[Patch], laid: Sequence[LaidLane]
) -> JudgedBlock:
    squares = [p.box for p in patches if p.space == block.id and np.isfinite(p.box).all()]
    square = shapely.union_all(shapely.polygons(corners(np.array(squares).reshape(-1, 5))))
    doors, out = np.zeros((len(houses), 2)), np.zeros((len(houses), 2))
    for k, piece in enumerate(houses):
        doors[k], out[k] = door_of(piece)
    return JudgedBlock(
        block,
        shapely.Polygon(block.outline),
        shapely.Polygon(block.ground.outline, block.ground.holes),
        square,
        tuple(houses),
        polygons_of(houses),
        doors,
        out,
        cover_laid_lanes(laid),
    )


def door_of(piece: Piece) -> tuple[Floats, Floats]:
    """The middle (2,) of the side of a house that is farthest ahead, and the direction out (2,).

    >>> from scenewright.core.scene import Pose, Size
    >>> hut = Piece("a/hut", "building", "", "a", Pose(0, 0, 0, np.pi / 2), Size(4, 6, 3))
    >>> [v.round(6).tolist() for v in door_of(hut)]
    [[0.0, 3.0], [0.0, 1.0]]
    """
    ring = outline_of(piece)
    out = np.array([np.cos(piece.pose.heading), np.sin(piece.pose.heading)])
    middle = (ring + np.roll(ring, -1, axis=0)) / 2
    return middle[int(np.argmax(np.round(middle @ out, 6)))], out


def find_overlaps(judged: JudgedBlock) -> list[Finding]:
    """Pairs that share more than a wall: an area more than 1 cm thick; and houses on the square."""
    found = find_collisions(judged.houses, judged.shapes)
    for piece, shape in zip(judged.houses, judged.shapes, strict=True):
        depth, area = measure_shared(shapely.intersection(shape, judged.square))
        if depth > TOLERANCE:
            message = f"{piece.id} stands on the square by {depth:.2f} m ({area:.2f} m²)"
            found.append(state_fault("blocked_path", piece, message, depth, area, "square"))
    return found


def find_outside(judged: JudgedBlock) -> list[Finding]:
    """Houses that leave the block by more than 1 cm, or stand off the ground."""
    found = []
    wider = shapely.buffer(judged.floor, TOLERANCE, join_style="mitre")
    shapely.prepare(wider)
    for piece, shape in zip(judged.houses, judged.shapes, strict=True):
        if not wider.covers(shape):
            rest = shapely.difference(shape, judged.floor)
            points = shapely.points(shapely.get_coordinates(shapely.segmentize(rest, 0.1)))
            depth = float(shapely.distance(points, judged.floor).max(initial=0.0))
            message = f"{piece.id} is {depth:.2f} m ({rest.area:.2f} m²) outside {judged.plan.id}"
            found.append(state_fault("out_of_bounds", piece, message, depth, float(rest.area)))
        found += find_off_ground(piece)
    return found


def find_blocked_doors(judged: JudgedBlock) -> list[Finding]:
    """Doors before which another house stands, or ground that belongs to somebody else."""
    if not judged.houses:
        return []
    along = np.stack([-judged.out[:, 1], judged.out[:, 0]], 1)
    rows = ((-1, 0.02), (-1, COURT), (1, COURT), (1, 0.02))
    courts = shapely.polygons(
        np.stack([judged.doors + s * DOOR / 2 * along + d * judged.out for s, d in rows], 1)
    )
    tree, found = shapely.STRtree(judged.shapes), []
    shapely.prepare(judged.walkable)
    for k, (piece, court) in enumerate(zip(judged.houses, courts, strict=True)):
        near = [int(n) for n in tree.query(court, predicate="intersects") if n != k]
        for n in near:
            depth, area = measure_shared(intersect_footprints(court, judged.shapes[n]))
            if depth > TOLERANCE:
                message = f"the door of {piece.id} is blocked by {judged.houses[n].id}"
                other = judged.houses[n].id
                found.append(state_fault("blocked_door", piece, message, depth, area, other))
        out = shapely.difference(court, judged.walkable)
        depth, area = measure_shared(out)
        if depth > TOLERANCE:
            message = f"the door of {piece.id} opens on ground beyond the block that is no street"
            found.append(state_fault("blocked_door", piece, message, depth, area))
    return found


def find_reached(judged: JudgedBlock) -> Flags:
    """Which houses (n,) a way 1 m wide leads to from a street: its middle may go where a disc of
    that width keeps off every house."""
    around = shapely.union_all(shapely.buffer(judged.shapes, WAY - TOLERANCE))
    free = shapely.get_parts(shapely.difference(judged.walkable, around))
    streets = shapely.union_all(shapely.linestrings(judged.plan.streets)).buffer(START)
    streets = shapely.union(streets, judged.laid)
    ways = shapely.union_all(free[shapely.intersects(streets, free)])
    spots = shapely.points(judged.doors + judged.out * WAY)
    return np.asarray(shapely.dwithin(ways, spots, 0.1))


def _unreachable(judged: JudgedBlock, reached: Flags) -> list[Finding]:
    lost: Indices = np.flatnonzero(~reached)
    return [
        state_fault(
            "unreachable_building",
            judged.houses[k],
            f"no way {2 * WAY:g} m wide leads from a street to the door of {judged.houses[k].id}",
        )
        for k in lost.tolist()
    ]


def figures_of(judged: JudgedBlock, reached: Flags) -> dict[str, Any]:
    """Figures of a block: metres and square metres, shares in [0, 1]."""
    count = len(judged.houses)
    areas = np.asarray(shapely.area(judged.shapes))
    covered = float(shapely.area(shapely.union_all(judged.shapes).intersection(judged.floor)))
    gap = None
    if count > 1:
        away = np.asarray(shapely.distance(judged.shapes[:, None], judged.shapes[None]))
        np.fill_diagonal(away, np.inf)
        gap = round(float(np.median(away.min(1))), 2)
    sides = shapely.union_all(shapely.linestrings(judged.plan.streets))
    setback = round(float(np.median(shapely.distance(judged.shapes, sides))), 2) if count else None
    return {
        "houses": count,
        "area": round(judged.plan.area, 2),
        "coverage": round(covered / judged.plan.area, 4),
        "small": int((areas < 50).sum()),
        "medium": int(((areas >= 50) & (areas <= 100)).sum()),
        "large": int((areas > 100).sum()),
        "median_gap": gap,
        "median_setback": setback,
        "reached_share": round(float(reached.mean()), 4) if count else 1.0,
    }
