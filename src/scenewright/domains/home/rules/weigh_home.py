"""The rows of homes weighed for the groups of a room."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.arranging.degrees import HEADING, KIND, NUMBER, THINGS, RoomParts
from scenewright.arranging.row_arrays import Table, compile_rows
from scenewright.arranging.rows import (
    DOORS,
    ENTRANCES,
    OPENINGS,
    PANES,
    PIPES,
    TURNS,
    WINDOWS,
    Row,
    is_lone,
    say,
)
from scenewright.arranging.weighing import Broken, weigh
from scenewright.core.same import once
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.groups import GROUPS, LABELS
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.rules.bedroom import BEDROOM
from scenewright.domains.home.rules.every import EVERY
from scenewright.domains.home.rules.kitchen import KITCHEN
from scenewright.domains.home.rules.living import LIVING
from scenewright.domains.home.rules.zones import ZONED
from scenewright.domains.home.settings import CompositionCosts

Floats = NDArray[np.float64]

ROWS: tuple[Row, ...] = (*EVERY, *ZONED, *BEDROOM, *LIVING, *KITCHEN)
"""All rows of homes."""
LATE = tuple(row for row in ROWS if row.late)
"""Those weighed once a home is furnished."""
LONE = tuple(row for row in ROWS if is_lone(row) and not (row.late or row.only))
"""Those weighed while rooms are composed, of pieces whatever else is there."""
UNKNOWN = 2.0
"""No row is about a group whose floor is not known."""
FAR = 1e3
CORNERS = np.array([[-FAR, -FAR], [FAR, -FAR], [FAR, FAR], [-FAR, FAR]])
ENDLESS = np.column_stack((CORNERS, np.roll(CORNERS, -1, axis=0)))
"""Edges, metres, of a floor without walls."""
NOWHERE = RoomParts(ENDLESS, np.zeros((0, 4)), np.zeros((0, 4)), np.zeros((0, 6)), FAR)
"""A room that nothing is known about."""


class Fault(NamedTuple):
    """A broken row: the piece, its group, the other group that breaks it (empty: all together, the
    room or fixed pieces), its degree in ]0, 1], and what it costs."""

    row: Row
    group: str
    piece: str
    other: str
    degree: float
    cost: float


@once(64)
def compile_table(rows: tuple[Row, ...], costs: CompositionCosts | None = None) -> Table:
    """The rows compiled with the costs of a preset, of the same rows once; without costs those
    that have a name are 1."""
    return compile_rows(rows, {} if costs is None else costs._asdict())


@lru_cache(maxsize=8)
def list_together(functions: tuple[str, ...]) -> tuple[Row, ...]:
    """The rows that are weighed while a room of these functions is composed, of pieces beside one
    another and those that only such rooms have."""
    return tuple(
        row
        for row in ROWS
        if (row.early or not row.late) and (row.only == functions if row.only else not is_lone(row))
    )


@lru_cache(maxsize=32)
def find_rows(*ids: str) -> tuple[Row, ...]:
    """The rows with these ids, in their order in :data:`ROWS`."""
    return tuple(row for row in ROWS if row.id in ids)


def sum_rows(
    ids: tuple[str, ...],
    groups: Sequence[FurnishedGroup],
    ground: Ground | None = None,
    fixed: Sequence[Piece] = (),
    costs: CompositionCosts | None = None,
) -> float:
    """What rows cost that do not hold, by their ids; as :func:`compile_table` and
    :func:`list_faults`."""
    table = compile_table(find_rows(*ids), costs)
    return sum(fault.cost for fault in list_faults(table, groups, fixed, ground))


def list_faults(
    table: Table,
    groups: Sequence[FurnishedGroup],
    fixed: Sequence[Piece] = (),
    ground: Ground | None = None,
) -> list[Fault]:
    """The rows of a table that do not hold among groups, what is there already (``fixed``) and the
    parts of a room, in the order of the table."""
    each = [read_group(group, table) for group in groups]
    sizes = [len(one) for one in each]
    things = np.concatenate((*each, read_fixed(fixed, table)))
    things[: sum(sizes), NUMBER] = np.repeat(np.arange(len(groups)), sizes)
    room = NOWHERE if ground is None else read_room(ground)
    broken = weigh(table, things, room)
    if not broken:
        return []
    names = [(g.name, p) for g in groups for p in (*(q.id for q in g.pieces), "")]
    names += [("", p.id) for p in fixed] or [("", "")]
    return [Fault(b.row, *names[b.thing], _name(b, names), b.degree, b.cost) for b in broken]


def say_fault(fault: Fault) -> str:
    """What is wrong, in the words of the row, with the name of the other group if there is one."""
    other = re.sub(r"_\d+$", "", fault.other.rpartition("/")[2])
    words = LABELS.get(other, other.replace("_", " ")) if other in GROUPS else ""
    return say(fault.row, to=words and f"the {words}")


def _name(broken: Broken, names: Sequence[tuple[str, str]]) -> str:
    """The name of the group of the other by which a row is broken."""
    return names[broken.other][0] if broken.other >= 0 else ""


@once(2048)
def read_group(group: FurnishedGroup, table: Table) -> Floats:
    """The things (n, 10) of a group: its pieces, then its floor as a whole."""
    kinds, other = table.kinds, len(table.kinds) + 1
    function = table.groups.get(group.wish.group, other)
    rows = [_read_piece(p, kinds.get(p.category, 0), function) for p in group.pieces]
    if group.dressed is None:
        return np.array([*rows, [0.0] * KIND + [0.0, other, 0.0, UNKNOWN]])
    return np.array([*rows, [*group.dressed.box.tolist(), 0.0, 0.0, function, 0.0, 1.0]])


@once(64)
def read_fixed(pieces: Sequence[Piece], table: Table) -> Floats:
    """The things (n, 10) of what is there already."""
    kinds, other = table.kinds, len(table.kinds) + 1
    rows = [_read_piece(p, kinds.get(p.category, 0), other) for p in pieces]
    things = np.array(rows).reshape(len(rows), THINGS)
    things[:, NUMBER] = -1.0
    return things


def _read_piece(piece: Piece, kind: int, function: int) -> list[float]:
    (x, y, z, heading), (width, depth, _) = piece.pose, piece.size
    return [x, y, heading, width, depth, z, kind, function, 0.0, 0.0]


@once(64)
def read_room(ground: Ground) -> RoomParts:
    """The parts of a room."""
    panes = ground.windows[:, :5]
    parts = [(ground.keep_free, DOORS), (panes, PANES), (ground.entrances, ENTRANCES)]
    parts.append((ground.pipes, PIPES))
    for part, window in ((WINDOWS, 1.0), (OPENINGS, 0.0)):
        parts.append((ground.strips[ground.strips[:, 5] == window, :5], part))
    way = ground.edges[:, 2:4] - ground.edges[:, :2]
    turns = np.unique(np.remainder(np.arctan2(way[:, 1], way[:, 0]), np.pi / 2).round(4))
    parts.append((np.eye(1, 5, HEADING) * turns[:, None], TURNS))
    boxes = np.concatenate([np.pad(b, ((0, 0), (0, 1)), constant_values=p) for b, p in parts])
    lines = [np.ascontiguousarray(each) for each in (ground.edges, ground.paths, ground.walls)]
    return RoomParts(lines[0], lines[1], lines[2], boxes, ground.area)
