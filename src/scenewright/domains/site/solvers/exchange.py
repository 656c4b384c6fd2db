"""Kernels that try exchanges and turns of buildings, looking again only at what they change.

A *slot* is where a building stands. Its front line stays when another takes its place.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from scenewright.domains.site.problem import Floats, Ints
from scenewright.domains.site.terms.measure import SitePrepared, SiteState, put, stands
from scenewright.geometry.box_grid import BoxGrid, enters
from scenewright.geometry.boxes import Frame, make_frame, part_of, read_frame
from scenewright.geometry.buckets import column_of, remove, row_of
from scenewright.geometry.compiled import compiled, inlined
from scenewright.geometry.sun import SILL, lit_hours
from scenewright.geometry.walker import REACH, Sights, look_along


class Lists(NamedTuple):
    """Lists of numbers, one a slot: ``items[starts[k] : starts[k + 1]]``."""

    starts: Ints
    items: Ints


class Slots(NamedTuple):
    """The buildings in n slots, and l landmarks after them.

    ``grid`` lists boxes as large as any that may come; ``frames`` and ``heights`` in it are those
    of the buildings placed. ``quality`` (n + l, 5) of sides; ``room`` (n, 2) greatest width and
    depth; ``made`` what eyes see; ``path`` of the sun and ``hours`` (n,) on fronts; ``eyes`` that
    may see a slot, ``shaded`` slots near it. The rest is scratch: ``log`` (rays, 3) eye, ray and
    building, ``old`` (rays, 2) value and distance before, ``logged`` (1,) how many; ``fresh`` (n,)
    hours, the move that last looked at an eye or slot, ``eye_marks`` and ``slot_marks``.
    """

    grid: BoxGrid
    quality: Floats
    room: Floats
    made: Sights
    path: Floats
    hours: Floats
    eyes: Lists
    shaded: Lists
    log: Ints
    old: Floats
    logged: Ints
    fresh: Floats
    eye_marks: Ints
    slot_marks: Ints


class ExchangeRule(NamedTuple):
    """What a unit of ray value and an hour of sun are worth, the direction (cos, sin) to the sun
    at noon, heights kept behind a building, square metres of slack, and the greatest height."""

    seen: float
    sun: float
    noon: tuple[float, float]
    behind: float
    loose: float
    top: float


@compiled
def fill_hours(v: Slots, top: float) -> None:
    """Write the hours of sun on all fronts."""
    for i in range(v.hours.shape[0]):
        v.hours[i] = lit_hours(v.grid, v.path, 1, SILL, top, i, 0)


@compiled
def exchange_all(
    p: SitePrepared,
    s: SiteState,
    v: Slots,
    rule: ExchangeRule,
    moves: Ints,
    who: Ints,
    tally: Floats,
) -> None:
    """Try moves (m, 3) in turn, two slots whose buildings change places or one and the quarters
    it turns by; those that gain are kept. ``who`` (n,) the building in each slot; ``tally`` (2,)
    moves tried and what was gained."""
    for m in range(moves.shape[0]):
        i, j, quarters = moves[m, 0], moves[m, 1], moves[m, 2]
        tally[0] += 1.0
        a, b = read_frame(v.grid.frames, i), read_frame(v.grid.frames, j)
        if i == j:
            fresh_a = make_frame(a[0], a[1], a[7] + 0.5 * math.pi * quarters, 2 * a[4], 2 * a[5])
            fresh_b = fresh_a
        elif not (has_room(v, i, b) and has_room(v, j, a)):
            continue
        else:
            fresh_a, fresh_b = in_place(a, b), in_place(b, a)
        swap(v, i, j)
        if not settle(p, s, v, rule, i, j, fresh_a, fresh_b):
            restore(p, s, v, i, j, a, b)
            continue
        write(v.grid, i, fresh_a)
        write(v.grid, j, fresh_b)
        gain = gain_of(v, rule, i, j, int(tally[0]))
        if gain > 1e-9:
            tally[1] += gain
            keep_hours(v, rule, i, j)
            other = who[i]
            who[i], who[j] = who[j], other
        else:
            take_back(v)
            restore(p, s, v, i, j, a, b)


@inlined
def has_room(v: Slots, i: int, frame: Frame) -> bool:
    """True if a building is no larger than any that slot ``i`` was made for."""
    return 2.0 * frame[4] <= v.room[i, 0] and 2.0 * frame[5] <= v.room[i, 1]


@inlined
def in_place(place: Frame, other: Frame) -> Frame:
    """A building of another one's size, its front in the middle of this one's."""
    return part_of(place, 0.0, place[5] - other[5], other[4], other[5])


@inlined
def swap(v: Slots, i: int, j: int) -> None:
    """Exchange heights and sides of two slots."""
    height = v.grid.heights[i]
    v.grid.heights[i], v.grid.heights[j] = v.grid.heights[j], height
    for k in range(5):
        side = v.quality[i, k]
        v.quality[i, k], v.quality[j, k] = v.quality[j, k], side


@inlined
def write(grid: BoxGrid, i: int, frame: Frame) -> None:
    """Let a box of the grid be another."""
    for k in range(8):
        grid.frames[i, k] = frame[k]


@inlined
def restore(p: SitePrepared, s: SiteState, v: Slots, i: int, j: int, a: Frame, b: Frame) -> None:
    """Two slots as they were."""
    swap(v, i, j)
    write(v.grid, i, a)
    write(v.grid, j, b)
    put(p, s, i, a)
    put(p, s, j, b)


@inlined
def settle(
    p: SitePrepared, s: SiteState, v: Slots, rule: ExchangeRule, i: int, j: int, a: Frame, b: Frame
) -> bool:
    """Let slots ``i`` and ``j`` be at some frames if both may stand there."""
    remove(s.buckets, i)
    remove(s.buckets, j)
    if not stands(p, s, i, a, rule.loose) or not in_sun(s, v, rule, i, a):
        return False
    put(p, s, i, a)
    if i != j:
        if not stands(p, s, j, b, rule.loose) or not in_sun(s, v, rule, j, b):
            return False
        put(p, s, j, b)
    return True


@inlined
def in_sun(s: SiteState, v: Slots, rule: ExchangeRule, i: int, frame: Frame) -> bool:
    """True if neither slot ``i`` at ``frame`` nor any near it stands too near behind the other."""
    if rule.behind <= 0.0:
        return True
    b, n, high = s.buckets, v.hours.shape[0], v.grid.heights[i]
    for k in range(n, v.grid.heights.shape[0]):
        if too_near(frame, high, read_frame(v.grid.frames, k), v.grid.heights[k], rule):
            return False
    far = rule.behind * rule.top + 2.0 * b.reach + frame[6]
    left, right = column_of(b, frame[0] - far), column_of(b, frame[0] + far)
    low, top = row_of(b, frame[1] - far), row_of(b, frame[1] + far)
    across = right - left + 1
    for k in range(across * (top - low + 1) + 1):
        place = (low + k // across) * b.columns + left + k % across
        if k == across * (top - low + 1):
            place = b.columns * b.rows
        j = b.heads[place]
        while j >= 0:
            if j != i and too_near(frame, high, read_frame(s.frames, j), v.grid.heights[j], rule):
                return False
            j = b.after[j]
    return True


@inlined
def too_near(a: Frame, high: float, b: Frame, other: float, rule: ExchangeRule) -> bool:
    """True if one box stands behind another, on the side away from the noon sun, by less than the
    multiple of its height that ``rule`` asks for."""
    c, s = rule.noon
    dx, dy = b[0] - a[0], b[1] - a[1]
    aside, ahead = abs(dx * s - dy * c), dx * c + dy * s
    wide = reach(a, s, -c) + reach(b, s, -c)
    deep = reach(a, c, s) + reach(b, c, s)
    tall = other if ahead > 0.0 else high
    return aside < wide - 1e-9 and abs(ahead) - deep < rule.behind * tall - 1e-6


@inlined
def reach(frame: Frame, c: float, s: float) -> float:
    """Half the length of a box along a direction."""
    across, along = frame[3] * c - frame[2] * s, frame[2] * c + frame[3] * s
    return abs(across) * frame[4] + abs(along) * frame[5]


@inlined
def gain_of(v: Slots, rule: ExchangeRule, i: int, j: int, move: int) -> float:
    """The gain of exchanging two slots: rays and hours are measured again."""
    v.logged[0], seen, hours = 0, 0.0, 0.0
    for pick in range(2 if i != j else 1):
        k = j if pick else i
        for t in range(v.eyes.starts[k], v.eyes.starts[k + 1] if rule.seen > 0.0 else 0):
            e = v.eyes.items[t]
            if v.eye_marks[e] != move:
                v.eye_marks[e] = move
                seen += see_again(v, e, i, j)
    for pick in range(2 if i != j else 1):
        k = j if pick else i
        for t in range(v.shaded.starts[k], v.shaded.starts[k + 1] if rule.sun > 0.0 else 0):
            b = v.shaded.items[t]
            if v.slot_marks[b] != move:
                v.slot_marks[b] = move
                v.fresh[b] = lit_hours(v.grid, v.path, 1, SILL, rule.top, b, 0)
                hours += v.fresh[b] - v.hours[b]
    return seen * rule.seen + hours * rule.sun


@inlined
def see_again(v: Slots, e: int, i: int, j: int) -> float:
    """Look again along the rays of an eye that met slot ``i`` or ``j`` or may now; the change."""
    made, grid = v.made, v.grid
    c, s = math.cos(made.turns[e]), math.sin(made.turns[e])
    x, y, z, change = made.eyes[e, 0], made.eyes[e, 1], made.eyes[e, 2], 0.0
    for r in range(made.ways.shape[0]):
        ax = made.ways[r, 0] * c - made.ways[r, 1] * s
        ay, az = made.ways[r, 0] * s + made.ways[r, 1] * c, made.ways[r, 2]
        met = made.found[e, r] == i or made.found[e, r] == j
        if not met:
            far = min(made.distances[e, r], REACH)
            far = min(far, z / -az) if az < 0.0 else far
            met = meets(grid, i, x, y, z, ax, ay, az, far)
            met = met or (i != j and meets(grid, j, x, y, z, ax, ay, az, far))
        if met:
            m = v.logged[0]
            v.log[m, 0], v.log[m, 1], v.log[m, 2] = e, r, made.found[e, r]
            v.old[m, 0], v.old[m, 1] = made.values[e, r], made.distances[e, r]
            v.logged[0] = m + 1
            look_along(grid, v.quality, made, REACH, e, r)
            change += made.values[e, r] - v.old[m, 0]
    return change


@inlined
def meets(
    grid: BoxGrid, i: int, x: float, y: float, z: float, ax: float, ay: float, az: float, far: float
) -> bool:
    """True if a ray meets a box before ``far``."""
    f = read_frame(grid.frames, i)
    dx, dy = f[0] - x, f[1] - y
    if abs(dx * ay - dy * ax) > f[6] or dx * ax + dy * ay < -f[6]:
        return False
    distance, _, _ = enters(f, grid.heights[i], x, y, z, ax, ay, az)
    return distance < far


@inlined
def take_back(v: Slots) -> None:
    """Let eyes see again what the log says they saw."""
    for m in range(v.logged[0]):
        e, r = v.log[m, 0], v.log[m, 1]
        v.made.found[e, r] = v.log[m, 2]
        v.made.values[e, r], v.made.distances[e, r] = v.old[m, 0], v.old[m, 1]


@inlined
def keep_hours(v: Slots, rule: ExchangeRule, i: int, j: int) -> None:
    """Let the hours last looked at be those of the slots near two."""
    if rule.sun <= 0.0:
        return
    for pick in range(2):
        k = j if pick else i
        for t in range(v.shaded.starts[k], v.shaded.starts[k + 1]):
            v.hours[v.shaded.items[t]] = v.fresh[v.shaded.items[t]]
