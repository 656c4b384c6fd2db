"""Chairs at tables: they come with an object of a group without being asked for."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import replace

import numpy as np

from scenewright.catalog.kinds.usual import is_high
from scenewright.core.catalog import Catalog
from scenewright.core.kind import TableChairs
from scenewright.core.scene import Piece, Pose, Size
from scenewright.geometry.boxes import Frame, common_area, make_frame

TOUCH, NEARLY = 1e-4, 1e-9
FEWEST_AROUND = 4
"""Chairs round a table that is small, at least."""
CHAIRS = "/chairs"
"""The ending of the function of chairs that came with a table."""


def out_of_table(
    category: str, asked: Collection[str], catalog: Catalog, height: float = 0.0
) -> float:
    """How far the chairs that come with a table of some ``height`` stand out before and behind it,
    in metres; 0 for what has none or is high, or where chairs are ``asked`` for by themselves."""
    company = company_of(category, catalog)
    if company is None or company.category in asked or is_high(category, height):
        return 0.0
    return catalog.of(company.category)[0].usual[1] - company.tuck


def seats_around(category: str, catalog: Catalog) -> bool:
    """Whether the chairs that come with a table stand at all its sides, not at two."""
    company = company_of(category, catalog)
    return company is not None and company.around


def grow_table(table: Piece, out: float, catalog: Catalog) -> Piece:
    """A table as large as the floor it takes with chairs that stand ``out`` metres before and
    behind it, or at all its sides: nobody walks between them."""
    aside = out if seats_around(table.category, catalog) else 0.0
    width, depth, height = table.size
    return replace(table, size=Size(width + 2 * aside, depth + 2 * out, height))


def with_chairs(
    pieces: tuple[Piece, ...],
    others: tuple[Piece, ...],
    catalog: Catalog,
    bringing: Collection[str] = (),
) -> tuple[Piece, ...]:
    """Chairs for all tables among ``pieces`` that are of demands ``bringing`` some, or have none
    asked for by themselves; a chair that would stand in something is left out."""
    asked = {p.category for p in (*pieces, *others) if not p.function.endswith(CHAIRS)}
    tables = [
        piece
        for piece in pieces
        if (company := company_of(piece.category, catalog))
        and (piece.function in bringing or company.category not in asked)
    ]
    found = [(table, chair) for table in tables for chair in _chairs(table, catalog)]
    return keep_free(found, (*pieces, *others))


def keep_free(chairs: list[tuple[Piece, Piece]], solid: tuple[Piece, ...]) -> tuple[Piece, ...]:
    """Those of some chairs, each with its table, that stand in nothing solid but that table nor in
    a chair kept before."""
    frames = [_frame(piece) for piece in (*solid, *(chair for _, chair in chairs))]
    rows = np.array(frames).reshape(-1, 8)
    stands = np.arange(len(frames)) < len(solid)
    for number, (table, _) in enumerate(chairs, len(solid)):
        off = rows[:, :2] - rows[number, :2]
        near = stands & ((off**2).sum(1) < (rows[:, 6] + rows[number, 6]) ** 2)
        others = (frames[k] for k in np.flatnonzero(near) if frames[k] != _frame(table))
        stands[number] = all(common_area(frames[number], other) <= TOUCH for other in others)
    return tuple(
        chair for (_, chair), kept in zip(chairs, stands[len(solid) :], strict=True) if kept
    )


def company_of(category: str, catalog: Catalog) -> TableChairs | None:
    """The chairs that come with a table; None if none do."""
    return catalog.kinds[category].chairs if category in catalog.kinds else None


def _chairs(table: Piece, catalog: Catalog) -> list[Piece]:
    company = company_of(table.category, catalog)
    if company is None or is_high(table.category, table.size.height):
        return []
    asset = catalog.of(company.category)[0]
    size = Size(*asset.usual)
    return [
        Piece(
            id=f"{table.id}/{company.category}_{number}",
            category=company.category,
            asset=asset.id,
            space=table.space,
            pose=pose,
            size=size,
            group=table.group,
            function=f"{table.function}{CHAIRS}",
        )
        for number, pose in enumerate(places_at(table, company, size.depth), 1)
    ]


def count_places(width: float, company: TableChairs) -> int:
    """Chairs that have room at a table ``width`` metres wide: along each of two sides, or an even
    number round all of it.

    >>> round_table = TableChairs("dining_chair", 0.6, 0.1, around=True)
    >>> [count_places(width, round_table) for width in (0.8, 1.2, 1.5, 1.8)]
    [4, 6, 6, 8]
    >>> count_places(2.4, TableChairs("dining_chair", 0.6, 0.1))
    8
    """
    if company.around:
        return max(2 * int(0.5 * math.pi * width / company.pitch + NEARLY), FEWEST_AROUND)
    return 2 * max(int(width / company.pitch + NEARLY), 1)


def places_at(table: Piece, company: TableChairs, deep: float) -> list[Pose]:
    """Where chairs ``deep`` metres deep stand at a table: before it, then behind it, or in turn all
    round it, each across from another."""
    count = count_places(table.size.width, company) // 2
    if company.around:
        ahead = table.size.width / 2 + deep / 2 - company.tuck
        turned = [_turn(table.pose, math.pi * k / count) for k in range(count)]
        return [_beside(pose, 0.0, ahead, side) for side in (0, 1) for pose in turned]
    ahead = table.size.depth / 2 + deep / 2 - company.tuck
    steps = [(k + 0.5 - count / 2) * table.size.width / count for k in range(count)]
    return [_beside(table.pose, along, ahead, side) for side in (0, 1) for along in steps]


def _turn(pose: Pose, angle: float) -> Pose:
    """A pose turned by an angle."""
    return pose._replace(heading=pose.heading + angle)


def _beside(pose: Pose, along: float, ahead: float, side: int) -> Pose:
    """A place in front of (0) or behind (1) a table, looking at it."""
    c, s = math.cos(pose.heading), math.sin(pose.heading)
    way = 1.0 if side == 0 else -1.0
    turned = pose.heading + (math.pi if side == 0 else 0.0)
    heading = (turned + math.pi) % (2 * math.pi) - math.pi
    return Pose(
        pose.x + along * s + way * ahead * c, pose.y - along * c + way * ahead * s, 0.0, heading
    )


def _frame(piece: Piece) -> Frame:
    pose, size = piece.pose, piece.size
    return make_frame(pose.x, pose.y, pose.heading, size.width, size.depth)
