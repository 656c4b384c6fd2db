"""A hob before a window, moved along its line: units change places, cabinets give up width.

A kitchen is made to measure where it stands best as a whole, and a window then costs less than the
worktop beside the hob. Within its line there is often another order, or a wider cabinet on one side
and a narrower one on the other, with the same faults and the hob beside the window.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, islice
from math import ceil, cos, sin
from typing import NamedTuple

from scenewright.catalog.assets.furniture.cooking import UNDER_WORKTOP
from scenewright.catalog.classes import PLAIN_CABINETS
from scenewright.core.catalog import Group, Member
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.case_faults import find_neighbour
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.kitchens.slits import belongs, is_unit
from scenewright.domains.home.composing.placed_faults import DARK, measure_cases_before_windows
from scenewright.domains.home.composing.places.forms import cost_of_case
from scenewright.domains.home.composing.places.moving import dress_group
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.least_sizes import CABINET

HOB, FRIDGE, CORNER = "hob_cabinet", "fridge", "corner_cabinet"
LONGEST = 6  # units of a line that change places
WIDEST, STEP = 1.2, 0.05
"""How wide a cabinet becomes, and by how much at once, metres."""
RATED, TRIED = 12, 3  # orders of a line that are rated, and of these those that are furnished


class Order(NamedTuple):
    """Units of a line from left to right with their widths, and by how much that is off what was:
    places changed and metres given up."""

    units: tuple[Member, ...]
    widths: tuple[float, ...]
    off: float


def move_hob(task: RoomTask, placed: Placed, at: int) -> Iterator[Placed]:
    """The groups of a room with the hob of a kitchen elsewhere in its line, before no window, those
    first whose kitchen has least wrong with it."""
    run, rule = placed[at], task.preset.settings.composing
    case = run.dressed.case
    line = find_line(case)
    if run.wish.most is not None or not 1 < len(line) <= LONGEST:
        return
    orders = (o for o in list_orders(line) if _is_bright(task, run, line, o))
    laid = [lay_out(case, line, order) for order in islice(orders, RATED)]
    laid.sort(key=lambda c: round(cost_of_case(c, task.ground.area, rule), 6))
    rest = (*task.fixed, *task.beside, *(p for g in placed if g is not run for p in g.pieces))
    standing = standing_of(rest, flat_kinds(task.catalog))
    for other in laid[:TRIED]:
        dressed = dress_group(task, run, other, run.dressed.box, standing)
        if dressed is not None and len(dressed.pieces) == len(run.pieces):
            yield (*placed[:at], dressed, *placed[at + 1 :])


def find_line(case: Group) -> tuple[Member, ...]:
    """The units in one line with the hob of a case, from left to right, up to a corner."""
    units = [m for m in case.members if is_unit(m) and m.category != CORNER]
    hob = next((m for m in units if m.category == HOB), None)
    if hob is None:
        return ()
    left, right = (list(_follow(hob, units, side)) for side in (-1, 1))
    return (*reversed(left), hob, *right)


def _follow(unit: Member, units: list[Member], side: int) -> Iterator[Member]:
    at = find_neighbour(unit, units, side)
    while at is not None:
        yield at
        at = find_neighbour(at, units, side)


def list_orders(line: tuple[Member, ...]) -> list[Order]:
    """The units of a line in other orders and widths, those first that change least."""
    found = [
        Order(units, wide, off + sum(a is not b for a, b in zip(units, line, strict=True)))
        for units in _list_turns(line)
        for wide, off in _list_widths(units)
    ]
    return sorted((order for order in found if order.off > 0.0), key=lambda order: order.off)


def _list_turns(line: tuple[Member, ...]) -> Iterator[tuple[Member, ...]]:
    """The units of a line as they stand, from the other end, and with two of them exchanged."""
    yield line
    yield line[::-1]
    for one, other in combinations(range(len(line)), 2):
        units = list(line)
        units[one], units[other] = line[other], line[one]
        yield tuple(units)


def _list_widths(units: tuple[Member, ...]) -> Iterator[tuple[tuple[float, ...], float]]:
    """The widths as they are, and with one cabinet narrower and another as much wider, and the
    metres given up."""
    widths = [m.size.width for m in units]
    yield tuple(widths), 0.0
    able = [k for k, m in enumerate(units) if m.category in PLAIN_CABINETS]
    for one in able:
        for other in able:
            most = min(widths[one] - CABINET.width, WIDEST - widths[other]) if one != other else 0.0
            steps = (STEP * k for k in range(1, ceil(most / STEP)))
            for metres in (*steps, *((most,) if most > 0.0 else ())):
                changed = list(widths)
                changed[one], changed[other] = widths[one] - metres, widths[other] + metres
                yield tuple(changed), metres


def lay_out(case: Group, line: tuple[Member, ...], order: Order) -> Group:
    """The case with the units of a line in an order, what hangs above each with it."""
    first = line[0]
    c, s = cos(first.heading), sin(first.heading)
    along = c * first.x + s * first.y - first.size.width / 2
    moves: list[tuple[Member, float, float]] = []
    for unit, width in zip(order.units, order.widths, strict=True):
        moves.append((unit, along + width / 2 - c * unit.x - s * unit.y, width))
        along += width

    def change(member: Member) -> Member:
        own = next((move for move in moves if belongs(member, move[0])), None)
        if own is None:
            return member
        unit, by, width = own
        size = member.size._replace(width=member.size.width + width - unit.size.width)
        return member._replace(x=member.x + c * by, y=member.y + s * by, size=size)

    return case._replace(members=tuple(map(change, case.members)))


def _is_bright(task: RoomTask, run: FurnishedGroup, line: tuple[Member, ...], order: Order) -> bool:
    """Whether neither the hob of a kitchen nor a tall fridge in its line is before a window."""
    tall = (m for m in line if m.category == FRIDGE and m.size.height > UNDER_WORKTOP)
    seen = (*(m for m in line if m.category == HOB), *tall)
    laid = lay_out(run.dressed.case._replace(members=seen), line, order)
    shown = laid._replace(members=tuple(m._replace(category=HOB) for m in laid.members))
    boxes = run.dressed.box[None]
    return not (measure_cases_before_windows(shown, boxes, task.ground) > DARK).any()
