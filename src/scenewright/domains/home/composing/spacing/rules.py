"""How near pieces of different groups may stand to one another, by the rows of homes.

Groups are placed by the floor they need. Between them there may still be a bed whose foot touches
the fridge, a sofa in line with the hob, a chair that cannot be pushed back, a cupboard whose doors
open against a bed. The rows of homes (:mod:`~scenewright.domains.home.rules.weigh_home`) that are
weighed late say how much floor is left free; floor that is cut off is found by walking.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from scenewright.core.same import once
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.composing.spacing.cut_off import cost_of_cut_off, cost_of_shut_off
from scenewright.domains.home.composing.spacing.shut_in import list_shut_in
from scenewright.domains.home.measures import ON_FLOOR
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.rules.classes import MOVED
from scenewright.domains.home.rules.weigh_home import LATE, compile_table, list_faults, say_fault


class Close(NamedTuple):
    """Two groups, where a piece of the second (empty: a fixed piece) takes floor that a piece of
    the first needs, what that costs, and what its row ``says`` (empty: found by walking)."""

    group: str
    other: str
    cost: float
    says: str = ""


@once(256)
def list_close(
    groups: Sequence[FurnishedGroup], fixed: Sequence[Piece] = (), ground: Ground | None = None
) -> tuple[Close, ...]:
    """The pairs of groups that stand too near to one another by the rows weighed late
    (:data:`LATE`); and groups that shut the aisle of a bed in, or cut off floor or a door of the
    ``ground``; of the same groups found once."""
    faults = list_faults(compile_table(LATE), groups, fixed, ground)
    found = [Close(fault.group, fault.other, fault.cost, say_fault(fault)) for fault in faults]
    if ground is None:
        return tuple(found)
    own = [(g.name, p) for g in groups for p in g.pieces if _is_low(p)]
    low = [*own, *(("", p) for p in fixed if _is_low(p))]
    for name, piece in own:
        shut = list_shut_in(piece, low, ground)
        found += [Close(name, other, cost) for other, cost in shut if other != name]
    return (*found, *_list_cut_off(low, ground))


def _list_cut_off(low: Sequence[tuple[str, Piece]], ground: Ground) -> Iterator[Close]:
    """Floor or a door cut off, as the fault of the group whose removal frees most; fixed
    pieces alone may cut off some."""
    solid = [(name, p) for name, p in low if p.category not in MOVED]
    cost = _measure_cut([p for _, p in solid], ground)
    if not cost:
        return
    less = {
        n: _measure_cut([p for name, p in solid if name != n], ground)
        for n in dict.fromkeys(name for name, _ in solid if name)
    }
    worst = min(less, key=lambda name: less[name], default="")
    if less.get(worst, cost) < cost:
        yield Close(worst, "", cost)


def _measure_cut(pieces: Sequence[Piece], ground: Ground) -> float:
    """What it costs that pieces cut off floor, and doors."""
    return cost_of_cut_off(pieces, ground) + cost_of_shut_off(pieces, ground)


def measure_closeness(
    groups: Sequence[FurnishedGroup], fixed: Sequence[Piece] = (), ground: Ground | None = None
) -> float:
    """What it costs in all that groups stand too near to one another or, of chairs, to walls and
    doors."""
    return sum(close.cost for close in list_close(groups, fixed, ground))


def _is_low(piece: Piece) -> bool:
    low = piece.pose.z < ON_FLOOR or piece.category == "wall_shelf"  # a screen hangs over it
    return low and piece.category != "rug"
