"""What each group is to be straight before: the bed at whose foot it stands, a window, a sofa."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from math import cos, sin
from typing import NamedTuple

from scenewright.catalog.classes import BEDS, SOFAS
from scenewright.core.catalog import Group
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.measures import ALIKE
from scenewright.domains.home.problem import Ground

OFF_FROM = 1.6  # what is farther aside belongs to something else, metres
BY_WINDOW = 0.9  # farthest aside a desk may be to belong to a window, metres
AT_BACK = 0.5  # distance up to which a window is in the wall behind a desk, metres
SEATED, AT_FOOT, AT_WINDOW = 1.5, 1.0, 0.8
"""What a metre off the axis of a sofa or its screen, of a bed and of a window costs."""
FIRST = ("media", "chest", "vanity", "sideboard")
"""Groups for the axis of a bed; the first of those at its foot has it."""
MAIN = {"media": ("tv",), "seating": SOFAS}
"""Members that are to be on the axis, where that is not the middle of the group."""


class Axis(NamedTuple):
    """A point that a group is to be straight before, and what a metre aside of it costs."""

    x: float
    y: float
    weight: float


def find_aside(case: Group) -> float:
    """How far to the right of the middle of a case stands what is to be on the axis, metres."""
    named = MAIN.get(case.function, ())
    return next((m.x for m in case.members if m.category in named), 0.0)


def list_axes(
    group: FurnishedGroup, placed: Sequence[FurnishedGroup], ground: Ground
) -> list[Axis]:
    """The axes that a group belongs on."""
    row = AXES.get(group.wish.group)
    return list(row(group, placed, ground)) if row else []


def _of_window(
    group: FurnishedGroup, _: Sequence[FurnishedGroup], ground: Ground
) -> Iterator[Axis]:
    """The nearest window in the wall behind a desk."""
    x, y, heading, _, depth = group.dressed.box.tolist()
    found = list[tuple[float, Axis]]()
    for u, v, turn, width, _, _ in ground.windows.tolist():
        along = abs((u - x) * sin(heading) - (v - y) * cos(heading))
        ahead = (u - x) * cos(heading) + (v - y) * sin(heading) + depth / 2
        if cos(turn - heading) > ALIKE and abs(ahead) < AT_BACK and along < width / 2 + BY_WINDOW:
            found.append((along, Axis(u, v, AT_WINDOW)))
    yield from (axis for _, axis in sorted(found)[:1])


def _of_bed(group: FurnishedGroup, placed: Sequence[FurnishedGroup], _: Ground) -> Iterator[Axis]:
    """The bed at whose foot a group stands, unless another group has that axis."""
    beds = [p for g in placed for p in g.pieces if p.category in BEDS]
    for bed in beds:
        rivals = [g for g in placed if g.wish.group in FIRST and _is_at_foot(g, bed)]
        if min(rivals, key=_rank, default=None) is group:
            yield Axis(bed.pose.x, bed.pose.y, AT_FOOT)


def _rank(group: FurnishedGroup) -> int:
    return FIRST.index(group.wish.group)


def _is_at_foot(group: FurnishedGroup, bed: Piece) -> bool:
    """Whether a group stands before the foot of a bed, turned to it."""
    (x, y, heading), (u, v, _, turn) = group.dressed.box[:3].tolist(), bed.pose
    along = (x - u) * sin(turn) - (y - v) * cos(turn)
    ahead = (x - u) * cos(turn) + (y - v) * sin(turn)
    return cos(turn - heading) < -ALIKE and ahead > bed.size.depth / 2 and abs(along) < OFF_FROM


def _of_sofa(
    group: FurnishedGroup, placed: Sequence[FurnishedGroup], ground: Ground
) -> Iterator[Axis]:
    """The sofa before a screen; in a room without seats the bed."""
    if not any(g.wish.group == "seating" for g in placed):
        yield from _of_bed(group, placed, ground)
        return
    sofas = [p for g in placed for p in g.pieces if p.category in SOFAS]
    yield from _facing(group, max(sofas, key=lambda p: p.size.width * p.size.depth, default=None))


def _of_screen(
    group: FurnishedGroup, placed: Sequence[FurnishedGroup], _: Ground
) -> Iterator[Axis]:
    """The screen before a sofa."""
    screens = (p for g in placed for p in g.pieces if p.category == "tv")
    yield from _facing(group, next(screens, None))


def _facing(group: FurnishedGroup, other: Piece | None) -> Iterator[Axis]:
    """What a group faces, if that faces it."""
    if other is None:
        return
    (x, y, heading), (u, v, _, turn) = group.dressed.box[:3].tolist(), other.pose
    along = (u - x) * sin(heading) - (v - y) * cos(heading)
    ahead = (u - x) * cos(heading) + (v - y) * sin(heading)
    if cos(turn - heading) < -ALIKE and ahead > 0.0 and abs(along) < OFF_FROM:
        yield Axis(u, v, SEATED)


Lister = Callable[[FurnishedGroup, Sequence[FurnishedGroup], Ground], Iterator[Axis]]
AXES: dict[str, Lister] = {
    "media": _of_sofa,
    "seating": _of_screen,
    "chest": _of_bed,
    "vanity": _of_bed,
    "sideboard": _of_bed,
    "desk": _of_window,
    "kids_desk": _of_window,
}
"""By group what lists the axes it belongs on."""
