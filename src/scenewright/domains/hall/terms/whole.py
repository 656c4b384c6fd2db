"""The energy of a hall layout measured afresh: every object filed, every term summed up.

:func:`measure_all` starts from patterns, :func:`measure_frames` from footprints as they stand; the
parts are those that :mod:`scenewright.domains.hall.terms.trial` measures again for what a move
touches.
"""

from __future__ import annotations

import math

from scenewright.domains.hall.terms.measure import (
    SLACK,
    access_of,
    crowd,
    meets,
    proportion_of,
    used_area,
    wall_covered,
    within,
)
from scenewright.domains.hall.terms.order import aisles_of, all_lines
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
    HALL_TERMS,
    ORDER,
    PROPORTION,
    QUEUES,
    SIGHT,
    SPACE,
    facing_cost,
    fill_cost,
    space_cost,
)
from scenewright.domains.hall.terms.visitors import (
    egress_of,
    evenness_of,
    look_again,
    order_of,
    queues_of,
    welcome_of,
)
from scenewright.engine.whole_terms import join_terms, with_data
from scenewright.geometry.boxes import common_area, read_frame
from scenewright.geometry.buckets import insert, remove
from scenewright.geometry.compiled import compiled, inlined

REFUSED = math.inf
NOWHERE = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
hall_cost = join_terms(HALL_TERMS)
"""Weighted costs of the whole hall, of the terms with data of their own."""
OWN = with_data(HALL_TERMS)[0].number if with_data(HALL_TERMS) else len(HALL_TERMS)
"""The first of those."""


@inlined
def forget(work: Scratch) -> None:
    """Nothing is touched."""
    g = work.marks.shape[0]
    for k in range(work.touched[g]):
        work.marks[work.touched[k]] = 0
    work.touched[g] = 0


@inlined
def place_all(
    p: PreparedHall, s: State, work: Scratch, unit: int, strict: bool
) -> tuple[float, float]:
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


@inlined
def facing_of(p: PreparedHall, s: State, unit: int) -> float:
    """How far a unit is turned away from what it looks at, a desk from the entrance."""
    target = p.targets[unit]
    if target < 0:
        return welcome_of(p, s, unit)
    x, y = middle_of(s, p.spans[unit, 0], p.spans[unit, 1])
    to_x, to_y = middle_of(s, p.spans[target, 0], p.spans[target, 1])
    return facing_cost(x, y, s.pose[unit, 2], to_x, to_y)


@inlined
def fill_and_balance(
    p: PreparedHall, s: State, zone: int, unit: int, area: float, x: float, y: float
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


@inlined
def sum_up(p: PreparedHall, s: State, work: Scratch) -> float:
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
        s.costs[AISLES, unit] = aisles_of(p, s, unit)
        total += p.weights[AISLES] * s.costs[AISLES, unit]
        total += p.weights[SPACE] * s.costs[SPACE, unit]
        total += p.weights[PROPORTION] * s.costs[PROPORTION, unit]
    for zone in range(p.zone_areas.shape[0]):
        fill, balance = fill_and_balance(p, s, zone, -1, 0.0, 0.0, 0.0)
        s.costs[FILL, zone], s.costs[BALANCE, zone] = fill, balance
        total += p.weights[FILL] * fill + p.weights[BALANCE] * balance
    for link in range(p.links.shape[0]):
        s.costs[ACCESS, link] = access_of(p, s, work, link)
        total += p.weights[ACCESS] * s.costs[ACCESS, link]
    s.costs[ALIGNMENT, 0] = all_lines(p, s)
    total += p.weights[ALIGNMENT] * s.costs[ALIGNMENT, 0] + sum_up_visits(p, s)
    return total + hall_cost(s.frames, -1, NOWHERE, p.weights, p.own, s.costs[:, 0])


@inlined
def sum_up_visits(p: PreparedHall, s: State) -> float:
    """Costs of the terms about visitors, where they weigh anything, and the evenness; the sum."""
    w, total = p.weights, 0.0
    if w[EVENNESS] != 0.0:
        s.costs[EVENNESS, 0] = evenness_of(p, s)
        total += w[EVENNESS] * s.costs[EVENNESS, 0]
    if w[SIGHT] != 0.0 and p.main >= 0:
        s.costs[SIGHT, 0] = look_again(p, s, -1)
        total += w[SIGHT] * s.costs[SIGHT, 0]
    if w[ORDER] != 0.0:
        s.costs[ORDER, 0] = order_of(p, s, -1, 0.0, 0.0)
        total += w[ORDER] * s.costs[ORDER, 0]
    for u in range(p.spans.shape[0]):
        if w[QUEUES] != 0.0:
            s.costs[QUEUES, u] = queues_of(p, s, u)
            total += w[QUEUES] * s.costs[QUEUES, u]
        if w[EGRESS] != 0.0:
            s.costs[EGRESS, u] = egress_of(p, u, s.extent[u, 1], s.extent[u, 2])
            total += w[EGRESS] * s.costs[EGRESS, u]
    return total


@compiled
def measure_frames(p: PreparedHall, s: State, work: Scratch, strict: bool) -> float:
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
def may_stand(p: PreparedHall, s: State, host: int) -> bool:
    """Whether a partition keeps doors free and, where it stands off its host or is no border's,
    lies in its zone clear of obstacles and of other partitions."""
    frame, zone = read_frame(s.walls, host), int(p.hosts[host, 4])
    if meets(frame, p.keep_free):
        return False
    if s.offsets[host] == 0.0 and zone != int(p.hosts[host, 5]):
        return True
    if s.offsets[host] < 0.0:
        zone = int(p.hosts[host, 5])
    if not within(frame, p, zone) or meets(frame, p.obstacles):
        return False
    for other in range(s.walls.shape[0]):
        there = other != host and s.walls[other, 4] > 0.0
        if there and common_area(frame, read_frame(s.walls, other)) > SLACK:
            return False
    return True


@compiled
def place_walls(p: PreparedHall, s: State) -> bool:
    """Whether every partition may stand where it does."""
    for host in range(s.walls.shape[0]):
        if s.walls[host, 4] > 0.0 and not may_stand(p, s, host):
            return False
    return True


@compiled
def measure_all(p: PreparedHall, s: State, work: Scratch) -> float:
    """Every part of the energy afresh; the energy without the route, infinite if a hard rule is
    broken or a wall row finds no room. Objects are filed anew."""
    if not place_walls(p, s):
        return REFUSED
    for unit in range(p.spans.shape[0]):
        if not unfold(p, s, work, unit):
            return REFUSED
    return measure_frames(p, s, work, True)
