"""Trying a move of one unit: what it would cost, looking only at what moved.

:func:`begin` keeps the unit as it is; the caller changes its pattern; :func:`judge` files the new
objects and tells the change of energy, or that a hard rule is broken; :func:`settle` or
:func:`undo` ends the trial.
"""

from __future__ import annotations

from scenewright.domains.hall.patterns import WALL
from scenewright.domains.hall.terms.measure import (
    access_of,
    crowd,
    note,
    proportion_of,
    used_area,
    write_row,
)
from scenewright.domains.hall.terms.order import aisles_of, count_lines
from scenewright.domains.hall.terms.place import middle_of, unfold
from scenewright.domains.hall.terms.state import PreparedHall, Scratch, State
from scenewright.domains.hall.terms.table import (
    ACCESS,
    AISLES,
    ALIGNMENT,
    BALANCE,
    EGRESS,
    EVENNESS,
    FACING,
    FILL,
    ORDER,
    PROPORTION,
    QUEUES,
    SIGHT,
    SPACE,
    space_cost,
)
from scenewright.domains.hall.terms.visitors import (
    TILL,
    egress_of,
    evenness_of,
    in_queue,
    look_again,
    order_of,
    queues_of,
)
from scenewright.domains.hall.terms.whole import (
    NOWHERE,
    OWN,
    REFUSED,
    facing_of,
    fill_and_balance,
    forget,
    hall_cost,
    place_all,
)
from scenewright.geometry.boxes import read_frame, square_to_segment
from scenewright.geometry.buckets import insert, remove
from scenewright.geometry.compiled import compiled, inlined


@compiled
def begin(p: PreparedHall, s: State, work: Scratch, unit: int) -> None:
    """Keep a unit as it is."""
    row, first, last = p.layer_spans[unit, 0], p.spans[unit, 0], p.spans[unit, 1]
    for k in range(s.used[unit]):
        for column in range(5):
            work.layers[k, column] = s.layers[row + k, column]
    for k in range(4):
        work.pose[k] = s.pose[unit, k]
    work.old[0], work.old[1] = s.code[unit], s.used[unit]
    for i in range(first, last):
        write_row(work.frames, i, read_frame(s.frames, i))
        write_row(work.clears, i, read_frame(s.clears, i))


@inlined
def put_back(p: PreparedHall, s: State, work: Scratch, unit: int) -> None:
    """Make a unit what it was at :func:`begin`, filed again."""
    row, first, last = p.layer_spans[unit, 0], p.spans[unit, 0], p.spans[unit, 1]
    s.code[unit], s.used[unit] = int(work.old[0]), int(work.old[1])
    for k in range(s.used[unit]):
        for column in range(5):
            s.layers[row + k, column] = work.layers[k, column]
    for k in range(4):
        s.pose[unit, k] = work.pose[k]
    for i in range(first, last):
        remove(s.buckets, i)
        write_row(s.frames, i, read_frame(work.frames, i))
        write_row(s.clears, i, read_frame(work.clears, i))
    for i in range(first, last):
        insert(s.buckets, i, s.clears[i, 0], s.clears[i, 1], s.clears[i, 6])


@compiled
def judge(p: PreparedHall, s: State, work: Scratch, unit: int) -> float:
    """Change of energy if the unit becomes what it is now; infinite if a hard rule breaks.

    The unit's objects must be filed as they were. Afterwards they are filed as they are now;
    end the trial with :func:`settle` or :func:`undo`.
    """
    first, last, zone = p.spans[unit, 0], p.spans[unit, 1], p.zones[unit]
    forget(work)
    work.old[10], work.old[15] = 0.0, 0.0
    for i in range(first, last):
        remove(s.buckets, i)
    if not unfold(p, s, work, unit):
        return REFUSED
    inside, at_walls = place_all(p, s, work, unit, True)
    if inside < 0.0:
        return REFUSED
    for i in range(first, last):
        before = read_frame(work.frames, i)
        crowd(p, s, work, i, before, read_frame(work.clears, i), -1.0, False)
    note(work, unit, 0.0)
    work.old[2], work.old[3] = inside, at_walls
    change = space_change(p, s, work, unit)
    work.old[4] = proportion_of(p, s, unit) if p.weights[PROPORTION] != 0.0 else 0.0
    change += p.weights[PROPORTION] * (work.old[4] - s.costs[PROPORTION, unit])
    change += zone_change(p, s, work, unit, zone) + order_change(p, s, work, unit)
    change += visit_change(p, s, work, unit) + own_change(p, s, work)
    if p.weights[FACING] != 0.0:
        for other in range(p.targets.shape[0]):
            if other == unit or p.targets[other] == unit:
                work.fresh[2, other] = facing_of(p, s, other)
                change += p.weights[FACING] * (work.fresh[2, other] - s.costs[FACING, other])
    return change


@inlined
def space_change(p: PreparedHall, s: State, work: Scratch, unit: int) -> float:
    """Change of the weighted space term of all touched units; their new costs go to ``fresh``."""
    change, g = 0.0, work.marks.shape[0]
    for k in range(work.touched[g]):
        other = work.touched[k]
        own = s.covered[other, 0] + s.covered[other, 2]
        if other == unit:
            own = work.old[2] + work.old[3]
        covered = own + max(s.covered[other, 1] + work.delta[other], 0.0)
        work.fresh[0, other] = space_cost(covered, p.beta[other])
        change += p.weights[SPACE] * (work.fresh[0, other] - s.costs[SPACE, other])
    return change


@inlined
def order_change(p: PreparedHall, s: State, work: Scratch, unit: int) -> float:
    """Change of the weighted terms of a unit's gaps and of the lines of the hall; its lines are
    entered as they are now, and :func:`undo` strikes them out again."""
    change = 0.0
    if p.weights[AISLES] != 0.0:
        work.old[8] = aisles_of(p, s, unit)
        change += p.weights[AISLES] * (work.old[8] - s.costs[AISLES, unit])
    if p.weights[ALIGNMENT] != 0.0:
        first, last = p.spans[unit, 0], p.spans[unit, 1]
        work.old[9] = count_lines(p, s, work.frames, first, last, -1)
        work.old[9] += count_lines(p, s, s.frames, first, last, 1)
        work.old[10] = 1.0
        change += p.weights[ALIGNMENT] * work.old[9]
    return change


@inlined
def visit_change(p: PreparedHall, s: State, work: Scratch, unit: int) -> float:
    """Change of the weighted terms about visitors, and of the evenness; masks of what hides are
    written, and :func:`undo` brings the old ones back."""
    w, change = p.weights, 0.0
    work.old[11], work.old[12] = s.costs[EVENNESS, 0], s.costs[SIGHT, 0]
    if w[EVENNESS] != 0.0 and (s.code[unit] == WALL) != (int(work.old[0]) == WALL):
        work.old[11] = evenness_of(p, s)
        change += w[EVENNESS] * (work.old[11] - s.costs[EVENNESS, 0])
    if w[SIGHT] != 0.0 and p.main >= 0:
        for u in range(s.shade.shape[0]):
            work.shade[u] = s.shade[u]
        work.old[12] = look_again(p, s, unit)
        work.old[15] = 1.0
        change += w[SIGHT] * (work.old[12] - s.costs[SIGHT, 0])
    if w[ORDER] != 0.0:
        work.old[13] = order_of(p, s, unit, work.old[6], work.old[7])
        change += w[ORDER] * (work.old[13] - s.costs[ORDER, 0])
    if w[EGRESS] != 0.0:
        work.old[14] = egress_of(p, unit, work.old[6], work.old[7])
        change += w[EGRESS] * (work.old[14] - s.costs[EGRESS, unit])
    if w[QUEUES] != 0.0:
        for u in range(p.spans.shape[0]):
            if p.roles[u] & TILL:
                work.fresh[3, u] = s.costs[QUEUES, u]
                if in_queue(p, s, work, unit, u):
                    work.fresh[3, u] = queues_of(p, s, u)
                change += w[QUEUES] * (work.fresh[3, u] - s.costs[QUEUES, u])
    return change


@inlined
def own_change(p: PreparedHall, s: State, work: Scratch) -> float:
    """Change of the weighted terms with data of their own."""
    change = hall_cost(s.frames, -1, NOWHERE, p.weights, p.own, work.old[:0])
    for k in range(OWN, s.costs.shape[0]):
        change -= p.weights[k] * s.costs[k, 0]
    return change


@inlined
def settle_visits(p: PreparedHall, s: State, work: Scratch, unit: int) -> None:
    """Keep what :func:`visit_change` found."""
    s.costs[EVENNESS, 0], s.costs[SIGHT, 0] = work.old[11], work.old[12]
    if p.weights[ORDER] != 0.0:
        s.costs[ORDER, 0] = work.old[13]
    if p.weights[EGRESS] != 0.0:
        s.costs[EGRESS, unit] = work.old[14]
    if p.weights[QUEUES] != 0.0:
        for u in range(p.spans.shape[0]):
            if p.roles[u] & TILL:
                s.costs[QUEUES, u] = work.fresh[3, u]


@inlined
def zone_change(p: PreparedHall, s: State, work: Scratch, unit: int, zone: int) -> float:
    """Change of the weighted terms of the unit's zone and of the links it has."""
    work.old[5] = used_area(p, s, unit)
    x, y = middle_of(s, p.spans[unit, 0], p.spans[unit, 1])
    work.old[6], work.old[7] = x, y
    fill, balance = fill_and_balance(p, s, zone, unit, work.old[5], x, y)
    change = p.weights[FILL] * (fill - s.costs[FILL, zone])
    change += p.weights[BALANCE] * (balance - s.costs[BALANCE, zone])
    if p.weights[ACCESS] != 0.0:
        for link in range(p.links.shape[0]):
            if int(p.links[link, 0]) == zone or int(p.links[link, 1]) == zone:
                work.fresh[1, link] = s.costs[ACCESS, link]
                if comes_near(p, s, work, unit, link):
                    work.fresh[1, link] = access_of(p, s, work, link)
                change += p.weights[ACCESS] * (work.fresh[1, link] - s.costs[ACCESS, link])
    return change


@inlined
def comes_near(p: PreparedHall, s: State, work: Scratch, unit: int, link: int) -> bool:
    """True if an object of a unit lies, or lay, where it could narrow the passage of a link."""
    half = p.links[link, 2]
    for k in range(p.borders.shape[0]):
        if int(p.borders[k, 4]) != link:
            continue
        x0, y0, x1, y1 = p.borders[k, 0], p.borders[k, 1], p.borders[k, 2], p.borders[k, 3]
        for i in range(p.spans[unit, 0], p.spans[unit, 1]):
            far = (half + s.frames[i, 6]) ** 2
            if square_to_segment(s.frames[i, 0], s.frames[i, 1], x0, y0, x1, y1) <= far:
                return True
            if square_to_segment(work.frames[i, 0], work.frames[i, 1], x0, y0, x1, y1) <= far:
                return True
    return False


@compiled
def settle(p: PreparedHall, s: State, work: Scratch, unit: int) -> None:
    """Keep the move: write the costs found by :func:`judge`."""
    zone, g = p.zones[unit], work.marks.shape[0]
    s.covered[unit, 0], s.covered[unit, 2] = work.old[2], work.old[3]
    for k in range(work.touched[g]):
        other = work.touched[k]
        s.covered[other, 1] = max(s.covered[other, 1] + work.delta[other], 0.0)
        s.costs[SPACE, other] = work.fresh[0, other]
    s.costs[PROPORTION, unit] = work.old[4]
    s.extent[unit, 0], s.extent[unit, 1], s.extent[unit, 2] = work.old[5], work.old[6], work.old[7]
    if p.weights[AISLES] != 0.0:
        s.costs[AISLES, unit] = work.old[8]
    if p.weights[ALIGNMENT] != 0.0:
        s.costs[ALIGNMENT, 0] += work.old[9]
    settle_visits(p, s, work, unit)
    hall_cost(s.frames, -1, NOWHERE, p.weights, p.own, s.costs[:, 0])
    fill, balance = fill_and_balance(p, s, zone, -1, 0.0, 0.0, 0.0)
    s.costs[FILL, zone], s.costs[BALANCE, zone] = fill, balance
    if p.weights[ACCESS] != 0.0:
        for link in range(p.links.shape[0]):
            if int(p.links[link, 0]) == zone or int(p.links[link, 1]) == zone:
                s.costs[ACCESS, link] = work.fresh[1, link]
    if p.weights[FACING] != 0.0:
        for other in range(p.targets.shape[0]):
            if other == unit or p.targets[other] == unit:
                s.costs[FACING, other] = work.fresh[2, other]


@compiled
def undo(p: PreparedHall, s: State, work: Scratch, unit: int) -> None:
    """Take the move back."""
    if work.old[10] != 0.0:
        first, last = p.spans[unit, 0], p.spans[unit, 1]
        count_lines(p, s, s.frames, first, last, -1)
        count_lines(p, s, work.frames, first, last, 1)
    if work.old[15] != 0.0:
        for u in range(s.shade.shape[0]):
            s.shade[u] = work.shade[u]
    put_back(p, s, work, unit)
