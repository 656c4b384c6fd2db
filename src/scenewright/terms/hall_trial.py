"""Trying a move of one unit: what it would cost, looking only at what moved.

:func:`begin` keeps the unit as it is; the caller changes its pattern; :func:`judge` files the new
objects and tells the change of energy, or that a hard rule is broken; :func:`settle` or
:func:`undo` ends the trial.
"""

from __future__ import annotations

import math

from scenewright.geometry.boxes import read_frame, square_to_segment
from scenewright.geometry.buckets import insert, remove
from scenewright.geometry.compiled import compiled, inlined
from scenewright.terms.hall_measure import (
    access_of,
    crowd,
    meets,
    note,
    proportion_of,
    used_area,
    wall_covered,
    within,
    write_row,
)
from scenewright.terms.hall_place import middle_of, unfold
from scenewright.terms.hall_state import Prepared, Scratch, State
from scenewright.terms.hall_terms import (
    ACCESS,
    BALANCE,
    FACING,
    FILL,
    PROPORTION,
    SPACE,
    facing_cost,
    fill_cost,
    space_cost,
)

REFUSED = math.inf


@compiled
def begin(p: Prepared, s: State, work: Scratch, unit: int) -> None:
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
def put_back(p: Prepared, s: State, work: Scratch, unit: int) -> None:
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


@inlined
def forget(work: Scratch) -> None:
    """Nothing is touched."""
    g = work.marks.shape[0]
    for k in range(work.touched[g]):
        work.marks[work.touched[k]] = 0
    work.touched[g] = 0


@inlined
def place_all(p: Prepared, s: State, work: Scratch, unit: int, strict: bool) -> tuple[float, float]:
    """File the objects of a unit one by one; α_S and α_W, the first -1 if a hard rule breaks
    (only where ``strict``)."""
    zone, inside, at_walls = p.zones[unit], 0.0, 0.0
    for i in range(p.spans[unit, 0], p.spans[unit, 1]):
        frame, clear = read_frame(s.frames, i), read_frame(s.clears, i)
        if strict:
            if not within(frame, p, zone) or meets(frame, p.keep_free):
                return -1.0, 0.0
            if meets(frame, p.obstacles) or meets(frame, s.walls):
                return -1.0, 0.0
        shared = crowd(p, s, work, i, frame, clear, 1.0, strict)
        if shared < 0.0:
            return -1.0, 0.0
        inside += shared
        at_walls += wall_covered(clear, p, s.walls)
        insert(s.buckets, i, clear[0], clear[1], clear[6])
    return inside, at_walls


@compiled
def judge(p: Prepared, s: State, work: Scratch, unit: int) -> float:
    """Change of energy if the unit becomes what it is now; infinite if a hard rule breaks.

    The unit's objects must be filed as they were. Afterwards they are filed as they are now;
    end the trial with :func:`settle` or :func:`undo`.
    """
    first, last, zone = p.spans[unit, 0], p.spans[unit, 1], p.zones[unit]
    forget(work)
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
    change += zone_change(p, s, work, unit, zone)
    if p.weights[FACING] != 0.0:
        for other in range(p.targets.shape[0]):
            if p.targets[other] >= 0 and (other == unit or p.targets[other] == unit):
                work.fresh[2, other] = facing_of(p, s, other)
                change += p.weights[FACING] * (work.fresh[2, other] - s.costs[FACING, other])
    return change


@inlined
def facing_of(p: Prepared, s: State, unit: int) -> float:
    """How far a unit is turned away from what it looks at; 0 if it looks at nothing."""
    target = p.targets[unit]
    if target < 0:
        return 0.0
    x, y = middle_of(s, p.spans[unit, 0], p.spans[unit, 1])
    to_x, to_y = middle_of(s, p.spans[target, 0], p.spans[target, 1])
    return facing_cost(x, y, s.pose[unit, 2], to_x, to_y)


@inlined
def space_change(p: Prepared, s: State, work: Scratch, unit: int) -> float:
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
def zone_change(p: Prepared, s: State, work: Scratch, unit: int, zone: int) -> float:
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
def comes_near(p: Prepared, s: State, work: Scratch, unit: int, link: int) -> bool:
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


@inlined
def fill_and_balance(
    p: Prepared, s: State, zone: int, unit: int, area: float, x: float, y: float
) -> tuple[float, float]:
    """E_u of a zone and how far its groups' common middle lies from the zone's, with other
    values for one unit (-1: none)."""
    total, cx, cy = 0.0, 0.0, 0.0
    for u in range(p.zones.shape[0]):
        if p.zones[u] == zone:
            used = area if u == unit else s.extent[u, 0]
            ux, uy = (x, y) if u == unit else (s.extent[u, 1], s.extent[u, 2])
            total, cx, cy = total + used, cx + used * ux, cy + used * uy
    if total <= 0.0:
        return 0.0, 0.0
    dx, dy = cx / total - p.middles[zone, 0], cy / total - p.middles[zone, 1]
    size = p.zone_areas[zone]
    return fill_cost(p.least[zone], total / size), math.sqrt((dx * dx + dy * dy) / size)


@compiled
def settle(p: Prepared, s: State, work: Scratch, unit: int) -> None:
    """Keep the move: write the costs found by :func:`judge`."""
    zone, g = p.zones[unit], work.marks.shape[0]
    s.covered[unit, 0], s.covered[unit, 2] = work.old[2], work.old[3]
    for k in range(work.touched[g]):
        other = work.touched[k]
        s.covered[other, 1] = max(s.covered[other, 1] + work.delta[other], 0.0)
        s.costs[SPACE, other] = work.fresh[0, other]
    s.costs[PROPORTION, unit] = work.old[4]
    s.extent[unit, 0], s.extent[unit, 1], s.extent[unit, 2] = work.old[5], work.old[6], work.old[7]
    fill, balance = fill_and_balance(p, s, zone, -1, 0.0, 0.0, 0.0)
    s.costs[FILL, zone], s.costs[BALANCE, zone] = fill, balance
    if p.weights[ACCESS] != 0.0:
        for link in range(p.links.shape[0]):
            if int(p.links[link, 0]) == zone or int(p.links[link, 1]) == zone:
                s.costs[ACCESS, link] = work.fresh[1, link]
    if p.weights[FACING] != 0.0:
        for other in range(p.targets.shape[0]):
            if p.targets[other] >= 0 and (other == unit or p.targets[other] == unit):
                s.costs[FACING, other] = work.fresh[2, other]


@compiled
def undo(p: Prepared, s: State, work: Scratch, unit: int) -> None:
    """Take the move back."""
    put_back(p, s, work, unit)


@compiled
def measure_all(p: Prepared, s: State, work: Scratch) -> float:
    """Every part of the energy afresh; the energy without the route, infinite if a hard rule is
    broken or a wall row finds no room. Objects are filed anew."""
    for host in range(s.walls.shape[0]):
        if s.walls[host, 4] > 0.0 and meets(read_frame(s.walls, host), p.keep_free):
            return REFUSED
    for unit in range(p.spans.shape[0]):
        if not unfold(p, s, work, unit):
            return REFUSED
    return measure_frames(p, s, work, True)


@compiled
def measure_frames(p: Prepared, s: State, work: Scratch, strict: bool) -> float:
    """As :func:`measure_all` for footprints and clearances as they stand, whatever the patterns
    say; hard rules only count where ``strict``."""
    for i in range(s.frames.shape[0]):
        remove(s.buckets, i)
    for unit in range(p.spans.shape[0]):
        for k in range(3):
            s.covered[unit, k] = 0.0
    for unit in range(p.spans.shape[0]):
        forget(work)
        inside, at_walls = place_all(p, s, work, unit, strict)
        if inside < 0.0:
            return REFUSED
        s.covered[unit, 0], s.covered[unit, 2] = inside, at_walls
        g = work.marks.shape[0]
        for k in range(work.touched[g]):
            s.covered[work.touched[k], 1] += work.delta[work.touched[k]]
    return sum_up(p, s, work)


@inlined
def sum_up(p: Prepared, s: State, work: Scratch) -> float:
    """Costs of all terms from what is covered and where things stand; the weighted sum."""
    total = 0.0
    for unit in range(p.spans.shape[0]):
        covered = s.covered[unit, 0] + s.covered[unit, 1] + s.covered[unit, 2]
        s.costs[SPACE, unit] = space_cost(covered, p.beta[unit])
        s.costs[PROPORTION, unit] = proportion_of(p, s, unit)
        s.extent[unit, 0] = used_area(p, s, unit)
        x, y = middle_of(s, p.spans[unit, 0], p.spans[unit, 1])
        s.extent[unit, 1], s.extent[unit, 2] = x, y
        s.costs[FACING, unit] = facing_of(p, s, unit)
        total += p.weights[FACING] * s.costs[FACING, unit]
        total += p.weights[SPACE] * s.costs[SPACE, unit]
        total += p.weights[PROPORTION] * s.costs[PROPORTION, unit]
    for zone in range(p.zone_areas.shape[0]):
        fill, balance = fill_and_balance(p, s, zone, -1, 0.0, 0.0, 0.0)
        s.costs[FILL, zone], s.costs[BALANCE, zone] = fill, balance
        total += p.weights[FILL] * fill + p.weights[BALANCE] * balance
    for link in range(p.links.shape[0]):
        s.costs[ACCESS, link] = access_of(p, s, work, link)
        total += p.weights[ACCESS] * s.costs[ACCESS, link]
    return total
