"""Guidelines of interior design (Merrell et al. 2011) for the single pieces of a room.

Clearance, circulation, pairwise distance and angle, conversation, balance, alignment, emphasis and
symmetry; the sign is turned, low is good, and the weights, which the paper does not print, are
those of :mod:`scenewright.domains.hall.terms.guidelines`. What the paper hard-wires by kind of
furniture is read from the problem: relations are the pairs; a piece whose role is to face the main
wall is a seat of the conversation, one that backs it is the focal point seats look at; a piece that
belongs to a wall has its back there.
"""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.home.terms import clearance
from scenewright.domains.home.terms.assemble import PreparedHome
from scenewright.domains.home.terms.orientation import inward
from scenewright.domains.home.terms.table import KEEP_FREE, OBSTACLES, WINDOW
from scenewright.engine.guidelines import (
    ALIGNMENT,
    ANGLE,
    BACK,
    BALANCE,
    CIRCULATION,
    CLEARANCE,
    DISTANCE,
    EMPHASIS,
    OVERLAP,
    within_range,
)
from scenewright.geometry.boxes import (
    Floats,
    Frame,
    area_in_polygon,
    common_area,
    distance_to_segment,
    nearest_segment,
    read_frame,
    read_sides,
    wrap,
)
from scenewright.geometry.compiled import compiled, inlined
from scenewright.geometry.flood import NONE, Bits, flood
from scenewright.geometry.paths import CLEAR, RouteGrid, sweep_box

ONE = np.uint64(1)
CONVERSATION = 2.0
NEAR, FAR = 1.2, 2.4  # how far apart seats of a conversation are, metres (4 and 8 feet)
SYMMETRY = 1.0
SAME_SIZE = 0.05  # pieces whose sizes differ by less are of one kind, metres
MIRRORED = 0.3  # how near to its mirror image a piece counts in full, metres
LOOSE = 0.05  # a wanted distance is a range of this share either way
ZONES = ((KEEP_FREE, OVERLAP + CLEARANCE), (OBSTACLES, OVERLAP), (WINDOW, OVERLAP + CLEARANCE))
"""What a square metre of a piece costs in the zones of a room, by their term."""


@inlined
def are_related(p: PreparedHome, i: int, j: int) -> bool:
    """True if two pieces are related: one may stand in the clearance of the other."""
    for k in range(p.related_start[i], p.related_start[i + 1]):
        r = p.related[k]
        if p.pairs[r, 0] == j or p.pairs[r, 1] == j:
            return True
    return False


@inlined
def at_wall(frame: Frame, walls: Floats) -> float:
    """Middle of the back off a wall and front off its normal, at the wall that costs least.

    ``walls`` (w, 4) x0, y0, x1, y1 in metres.
    """
    x, y = frame[0] - frame[2] * frame[5], frame[1] - frame[3] * frame[5]
    least = math.inf
    for k in range(walls.shape[0]):
        dx, dy = walls[k, 2] - walls[k, 0], walls[k, 3] - walls[k, 1]
        ahead = (frame[3] * dx - frame[2] * dy) / max(math.sqrt(dx * dx + dy * dy), 1e-9)
        far = distance_to_segment(x, y, walls[k, 0], walls[k, 1], walls[k, 2], walls[k, 3])
        least = min(least, BACK * far - ANGLE * ahead)
    return least if least < math.inf else 0.0


@inlined
def stands(p: PreparedHome, i: int, frame: Frame) -> float:
    """Area outside the room and in zones, clearance that is blocked, and the wall: at the back
    of a piece that belongs to one, square to the others."""
    outside = max(4.0 * frame[4] * frame[5] - area_in_polygon(frame, p.edges), 0.0)
    total = OVERLAP * outside + clearance.measure_entered_area(
        frame, p.traits[i, 0], p.zones, p.weights
    )
    clear = read_sides(p.clear, i)
    total += CLEARANCE * clearance.zone_blocked(frame, clear, p.edges, p.zones)
    if p.traits[i, 1] > 0.5:
        return total + at_wall(frame, p.walls)
    k, _ = nearest_segment(frame[0], frame[1], p.walls)
    return total - ALIGNMENT * math.cos(4.0 * (frame[7] - inward(p.walls[k]))) if k >= 0 else total


@inlined
def looks(seat: Frame, other: Frame) -> float:
    """Cosine of the angle between the front of a seat and the way to another piece."""
    dx, dy = other[0] - seat[0], other[1] - seat[1]
    return (dx * seat[2] + dy * seat[3]) / max(math.sqrt(dx * dx + dy * dy), 1e-9)


@inlined
def converse(a: Frame, b: Frame) -> float:
    """Two seats: in speaking distance, each looking at the other (both terms in [0, 1])."""
    far = math.sqrt((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2)
    facing = 0.25 * (1.0 + looks(a, b)) * (1.0 + looks(b, a))
    return -CONVERSATION * (within_range(far, NEAR, FAR) + facing)


@inlined
def beside(p: PreparedHome, frames: Floats, i: int, frame: Frame) -> float:
    """What a piece costs with each other one: overlap, clearance, conversation, emphasis.

    ``frames`` (n, 8), piece ``i`` taken to ``frame``.
    """
    total, role, clear = 0.0, p.traits[i, 2], read_sides(p.clear, i)
    for j in range(frames.shape[0]):
        if j == i:
            continue
        other, seen = read_frame(frames, j), p.traits[j, 2]
        total += OVERLAP * common_area(frame, other)
        if not are_related(p, i, j):
            covered = clearance.zones_covered(frame, other, clear, read_sides(p.clear, j))
            total += CLEARANCE * covered
        if role > 0.0 and seen > 0.0:
            total += converse(frame, other)
        elif role > 0.0 and seen < 0.0:
            total -= EMPHASIS * looks(frame, other)
        elif role < 0.0 and seen > 0.0:
            total -= EMPHASIS * looks(other, frame)
    return total


@inlined
def relation(p: PreparedHome, r: int, a: Frame, b: Frame) -> float:
    """One pair: distance, angle and bearing as wanted, and parallel or square to each other."""
    dx, dy, between = b[0] - a[0], b[1] - a[1], b[7] - a[7]
    distance, angle, bearing = p.targets[r, 0], p.targets[r, 1], p.targets[r, 2]
    total = -ALIGNMENT * math.cos(4.0 * between)
    if not math.isnan(distance):
        far = math.sqrt(dx * dx + dy * dy)
        most = (1.0 + LOOSE) * distance if distance >= 0.0 else math.inf
        total -= DISTANCE * within_range(far, (1.0 - LOOSE) * abs(distance), most)
    if not math.isnan(angle):
        total -= ANGLE * math.cos(abs(wrap(between)) - abs(wrap(angle)))
    if not math.isnan(bearing):
        total -= ANGLE * math.cos(math.atan2(dy, dx) - a[7] - bearing)
    return total * p.targets[r, 3]


@inlined
def measure_relations(p: PreparedHome, frames: Floats, i: int, frame: Frame) -> float:
    """All pairs a piece is in.

    ``frames`` (n, 8), piece ``i`` taken to ``frame``.
    """
    total = 0.0
    for k in range(p.related_start[i], p.related_start[i + 1]):
        r = p.related[k]
        first, second = p.pairs[r, 0], p.pairs[r, 1]
        a = frame if first == i else read_frame(frames, first)
        b = frame if second == i else read_frame(frames, second)
        total += relation(p, r, a, b)
    return total


@compiled
def own_cost(p: PreparedHome, frames: Floats, i: int) -> float:
    """Everything that changes with one piece's pose, but composition and circulation.

    ``frames`` (n, 8).
    """
    frame = read_frame(frames, i)
    return (
        stands(p, i, frame) + beside(p, frames, i, frame) + measure_relations(p, frames, i, frame)
    )


@compiled
def summed_cost(p: PreparedHome, frames: Floats) -> float:
    """The cost of frames (n, 8) but composition and circulation; what is of two counts once."""
    total = 0.0
    for i in range(frames.shape[0]):
        frame = read_frame(frames, i)
        total += stands(p, i, frame)
        total += 0.5 * (beside(p, frames, i, frame) + measure_relations(p, frames, i, frame))
    return total


@compiled
def balance(p: PreparedHome, frames: Floats) -> float:
    """Distance of the pieces' common centre of mass from the middle of the room, weighed.

    ``frames`` (n, 8) in metres.
    """
    x, y, mass = 0.0, 0.0, 1e-9
    for i in range(frames.shape[0]):
        area = frames[i, 4] * frames[i, 5]
        x, y, mass = x + area * frames[i, 0], y + area * frames[i, 1], mass + area
    dx = x / mass - 0.5 * (p.bounds[0] + p.bounds[2])
    dy = y / mass - 0.5 * (p.bounds[1] + p.bounds[3])
    return BALANCE * math.sqrt(dx * dx + dy * dy)


@inlined
def mirrored(seat: Frame, other: Frame, focus: Frame) -> float:
    """s(f, g; u, p) in [0, 1]: how nearly a seat's mirror image in the axis of the focal point
    is another one of its size: 1 within 0.3 m, falling off as a square, times (1 + cos) / 2 of the
    angle between their fronts."""
    if abs(seat[4] - other[4]) > 0.5 * SAME_SIZE or abs(seat[5] - other[5]) > 0.5 * SAME_SIZE:
        return 0.0
    dx, dy, c, s = seat[0] - focus[0], seat[1] - focus[1], focus[2], focus[3]
    along, across = dx * c + dy * s, dx * s - dy * c
    x, y = focus[0] + along * c - across * s, focus[1] + along * s + across * c
    far = math.sqrt((other[0] - x) ** 2 + (other[1] - y) ** 2)
    turned = other[7] - (2.0 * focus[7] - seat[7])
    return within_range(far, 0.0, MIRRORED) * 0.5 * (1.0 + math.cos(turned))


@compiled
def symmetry(p: PreparedHome, frames: Floats) -> float:
    """-Σ_f max_g s(f, g; u, p) over the seats f, g about the focal point, weighed; a seat on the
    axis is its own image. A room without a focal point has no axis. ``frames`` (n, 8)."""
    total = 0.0
    for k in range(frames.shape[0]):
        if p.traits[k, 2] >= 0.0:
            continue
        for i in range(frames.shape[0]):
            most = 0.0
            for j in range(frames.shape[0]):
                if p.traits[i, 2] > 0.0 and p.traits[j, 2] > 0.0:
                    seat, other = read_frame(frames, i), read_frame(frames, j)
                    most = max(most, mirrored(seat, other, read_frame(frames, k)))
            total -= SYMMETRY * most
        break
    return total


@compiled
def composition(p: PreparedHome, frames: Floats) -> float:
    """What pieces at ``frames`` (n, 8) cost as a picture: balance and symmetry."""
    return balance(p, frames) + symmetry(p, frames)


@compiled
def circulation(frames: Floats, grid: RouteGrid, free: Bits, reached: Bits) -> float:
    """Every further region beside the first in which a person can stand, weighed.

    ``free`` and ``reached`` (h, k) are scratch. A room without doors has an empty grid.
    """
    for row in range(free.shape[0]):
        for word in range(free.shape[1]):
            free[row, word], reached[row, word] = grid.free[row, word], NONE
    for i in range(frames.shape[0]):
        sweep_box(free, grid, read_frame(frames, i), grid.radius, CLEAR)
    count = 0
    for row in range(free.shape[0]):
        for word in range(free.shape[1]):
            while (free[row, word] & ~reached[row, word]) != NONE:
                left = free[row, word] & ~reached[row, word]
                reached[row, word] |= left & (~left + ONE)
                flood(reached, free)
                count += 1
    return CIRCULATION * max(count - 1, 0)
