"""Low tables between seats that look at each other: what the pattern ``around`` leaves room for."""

from __future__ import annotations

import math

import numpy as np

from scenewright.arranging.verdict import better
from scenewright.core.catalog import Catalog, footprint_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.build_problem import MARGIN
from scenewright.domains.hall.hall_layout import PlacedGroup
from scenewright.domains.hall.patterns import AROUND
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.solvers.outcome import (
    MeasuredLayout,
    lacking,
    measure_layout,
    verdict_on,
)
from scenewright.geometry.boxes import Frame, common_area, make_frame

CATEGORY, TABLES = "coffee_table", "/tables"
"""The kind between seats, and the ending of its function."""
SHORT_TABLE, LONG_TABLE, LOW_TABLE_HEIGHT = 0.6, 1.1, 0.42
"""Side and length of a low table, for up to three seats and for more, and its height, in metres."""
TOUCH = 1e-4


def low_tables(
    groups: tuple[PlacedGroup, ...],
    pieces: tuple[Piece, ...],
    others: tuple[Piece, ...],
    catalog: Catalog,
) -> tuple[Piece, ...]:
    """A table in the middle of each company of two seats and more that stands ``around`` one. What
    would stand in something is left out."""
    known = {piece.id: piece for piece in pieces}
    solid = [_frame(piece) for piece in (*pieces, *others)]
    found: list[Piece] = []
    for group in (group for group in groups if group.pattern == "around"):
        first = 0
        for layer in group.parts[0].layers:
            seats = [known[name] for name in group.objects[first : first + layer.number]]
            first += layer.number
            table = _table(group, seats, layer.across, len(found), catalog)
            if layer.number > 1 and all(common_area(_frame(table), f) <= TOUCH for f in solid):
                found.append(table)
    return tuple(found)


def keep_reached(
    problem: HallProblem, layout: MeasuredLayout, tables: tuple[Piece, ...]
) -> tuple[Piece, ...]:
    """The tables of a layout to which the route leads, and which bar nothing else from it nor
    narrow a passage: all of them, else one after the other as long as no more is out of reach."""
    if not tables or _as_open(problem, layout, tables):
        return tables
    kept: tuple[Piece, ...] = ()
    for table in tables:
        if _as_open(problem, layout, (*kept, table)):
            kept = (*kept, table)
    return kept


def _as_open(problem: HallProblem, layout: MeasuredLayout, tables: tuple[Piece, ...]) -> bool:
    """Whether the route misses no more with some tables, which it has to reach too, and no passage
    is narrower than asked for; whoever gets to the table gets to the seats round it."""
    rows = [(t.pose.x, t.pose.y, t.pose.heading, t.size.width, t.size.depth) for t in tables]
    ground, boxes = problem.ground, np.array(rows)
    sides = ground.standing_access.reshape(-1, 4)
    with_tables = ground._replace(
        obstacles=np.concatenate([ground.obstacles, boxes]),
        standing=np.concatenate([ground.standing.reshape(-1, 5), boxes]),
        standing_access=np.concatenate([sides, np.ones((len(boxes), 4))]),
    )
    access = problem.units.access.copy()
    for unit in np.flatnonzero(layout.kept.rows[:, 0] == AROUND):
        access[slice(*problem.units.spans[unit])] = 0.0
    units = problem.units._replace(access=access)
    among = problem._replace(ground=with_tables, units=units)
    p, s, missed = measure_layout(among, layout)
    before = layout._replace(lacking=max(layout.lacking, MARGIN))
    after = layout._replace(missed=missed, lacking=lacking(p, s))
    return better(verdict_on(after, bare=0.0), verdict_on(before, bare=1.0))


def _table(
    group: PlacedGroup, seats: list[Piece], far: float, number: int, catalog: Catalog
) -> Piece:
    """The table before some seats whose middles are ``far`` from its middle line."""
    ahead = [
        (p.pose.x + far * math.cos(p.pose.heading), p.pose.y + far * math.sin(p.pose.heading))
        for p in seats
    ]
    x, y = (float(v) for v in np.mean(ahead, axis=0))
    size = Size(SHORT_TABLE, SHORT_TABLE if len(seats) < 4 else LONG_TABLE, LOW_TABLE_HEIGHT)
    asset = catalog.choose(CATEGORY, size)
    return Piece(
        id=f"{group.id}/{CATEGORY}_{number + 1}",
        category=CATEGORY,
        asset=asset.id if asset else "",
        space=group.space,
        pose=Pose(x, y, 0.0, group.pose[2]),
        size=size,
        group=group.id,
        function=f"{group.demand}{TABLES}",
        footprint=footprint_of(asset, size),
    )


def _frame(piece: Piece) -> Frame:
    pose, size = piece.pose, piece.size
    return make_frame(pose.x, pose.y, pose.heading, size.width, size.depth)
