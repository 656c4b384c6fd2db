"""Moves of the groups that break a row."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial

import numpy as np

from scenewright.domains.hall.patterns import CHAIN, GRID, WALL
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.retouch.columns import find_columns, propose_rows
from scenewright.domains.hall.retouch.lines import turn_half_round
from scenewright.domains.hall.retouch.mending import Retouch
from scenewright.domains.hall.retouch.places import fill_floor, nudge, shift
from scenewright.domains.hall.retouch.weigh_rows import (
    HallRows,
    list_faults,
    look_rows,
    measure_rows,
)
from scenewright.domains.hall.terms.state import Kept

Move = Callable[[HallRows, Kept, Floats, int], Iterator[Kept]]
ALONG_WALL = np.array([(along, 0.0) for along in (-1.5, -0.8, -0.4, 0.4, 0.8, 1.5)])
"""Metres by which a row at walls is moved along them."""
TURNS = tuple(0.3 * k for k in range(-12, 13))
"""Metres ahead of where they stand that are tried with groups turned half round."""
ASIDE = (0.0, 0.5, -0.5, 1.0, -1.0)
"""Metres along rows beside where they are that are tried."""


def hold_rows(*ids: str, moves: Sequence[Move], make_room: bool = True) -> Retouch:
    """The touch that mends the rows with some ids by moves of their groups."""
    look, propose = partial(look_rows, ids), partial(_propose, moves)
    return Retouch(look, measure_rows, propose, make_room=make_room)


def _propose(moves: Sequence[Move], seen: HallRows, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """The layouts that moves make of each group among boxes (n, 5) that breaks a row, and of
    objects too near it."""
    faults = list_faults(seen, kept, boxes)
    owner = np.repeat(np.arange(len(kept.pose)), np.diff(seen.problem.units.spans, axis=1)[:, 0])
    near = {int(owner[b.other]) for _, b in faults if 0 <= b.other < len(owner)}
    for move in moves:
        for unit in sorted({unit for unit, _ in faults} | near):
            yield from move(seen, kept, boxes, unit)


def nudge_or_slide(seen: HallRows, kept: Kept, boxes: Floats, unit: int) -> Iterator[Kept]:  # noqa: ARG001
    """Layouts with a unit moved a little, at walls along them."""
    if kept.rows[unit, 0] == WALL:
        yield from (shift(kept, unit, by) for by in ALONG_WALL)
    else:
        yield from nudge(kept, unit)


def turn_round(seen: HallRows, kept: Kept, boxes: Floats, unit: int) -> Iterator[Kept]:  # noqa: ARG001
    """Layouts with a unit turned half round, about where it stands."""
    yield from turn_half_round(kept, unit, TURNS)


def turn_aside(seen: HallRows, kept: Kept, boxes: Floats, unit: int) -> Iterator[Kept]:  # noqa: ARG001
    """Layouts with a unit turned by quarters, where it stands and a little beside that."""
    for quarters in (1, -1, 2):
        turned = kept.pose.copy()
        turned[unit, 2] += 0.5 * np.pi * quarters
        yield kept._replace(pose=turned)
        yield from nudge(kept._replace(pose=turned), unit)


def set_among_columns(seen: HallRows, kept: Kept, boxes: Floats, unit: int) -> Iterator[Kept]:  # noqa: ARG001
    """Layouts with a unit in rows whose pitch divides that of the columns."""
    if seen.problem.units.choices[unit, [CHAIN, GRID]].any():
        yield from propose_rows(find_columns(seen.problem), kept, unit)


def fill_free(seen: HallRows, kept: Kept, boxes: Floats, unit: int) -> Iterator[Kept]:
    """Layouts with a unit in rows over the floor free about it."""
    yield from fill_floor(seen.problem, kept, boxes, unit, ASIDE)
