"""Graph-driven Metropolis-Hastings (GD-MH) of halls, compiled.

f = exp(-λ E); a move is accepted with min(1, f' / f) and refused outright if an object leaves its
zone or overlaps (Cao, Cheng, Zhang 2024, 3.3). What moves, and how, is led by which energy is
high. ``free`` of 0 is the paper; above, that share of the moves is drawn blindly and includes
ours.
"""

from __future__ import annotations

import math

from scenewright.domains.hall.patterns import SINGLE, WALL
from scenewright.domains.hall.settings import MoveSettings
from scenewright.domains.hall.solvers.moves import change_form, scatter, slide, snap, spread, turn
from scenewright.domains.hall.solvers.ordering import line_up, match_pitch
from scenewright.domains.hall.terms.place import build
from scenewright.domains.hall.terms.state import Kept, PreparedHall, Scratch, State
from scenewright.domains.hall.terms.table import ACCESS, FILL, PROPORTION, REACH, SPACE, space_cost
from scenewright.domains.hall.terms.trial import begin, judge, settle, undo
from scenewright.domains.hall.terms.whole import measure_all
from scenewright.engine.draws import Stream, bell, below, uniform
from scenewright.geometry.boxes import Floats, read_frame, read_sides
from scenewright.geometry.circulation import is_reached, route
from scenewright.geometry.compiled import compiled, inlined
from scenewright.geometry.flood import Bits
from scenewright.geometry.paths import CLEAR, RouteGrid, sweep_box

KINDS = 9
"""Kinds of moves drawn blindly: the paper's four, five of ours."""


@compiled
def count_missed(
    p: PreparedHall, s: State, grid: RouteGrid, base: Bits, free: Bits, reached: Bits, inset: Floats
) -> float:
    """Objects, locked ones among them, and doors the route does not reach; ``base`` takes the floor
    less partitions. Each unit's share of the objects is left in its costs."""
    for row in range(base.shape[0]):
        for word in range(base.shape[1]):
            base[row, word] = grid.free[row, word]
    for h in range(s.walls.shape[0]):
        if s.walls[h, 4] > 0.0:
            sweep_box(base, grid, read_frame(s.walls, h), grid.radius, CLEAR)
    bare = RouteGrid(grid.x0, grid.y0, grid.cell, grid.radius, base, grid.doors)
    count = route(s.frames, p.access, inset, bare, free, reached, math.inf)
    for k in range(p.standing.shape[0]):
        frame, sides = read_frame(p.standing, k), read_sides(p.standing_access, k)
        if not is_reached(frame, sides, reached, bare):
            count += 1.0
    for u in range(p.spans.shape[0]):
        s.costs[REACH, u] = 0.0
    if count > 0.0:
        for i in range(s.frames.shape[0]):
            frame, sides = read_frame(s.frames, i), read_sides(p.access, i)
            if not is_reached(frame, sides, reached, bare):
                s.costs[REACH, p.unit_of[i]] += 1.0
    return count


@inlined
def drawn_unit(p: PreparedHall, s: State, term: int, stream: Stream) -> int:
    """A unit drawn by its cost of a term above what it costs at best."""
    least = space_cost(0.0, 1.0) if term == SPACE else 0.0
    total, g = 0.0, p.spans.shape[0]
    for u in range(g):
        total += max(s.costs[term, u] - least, 0.0) + 0.01
    rest = uniform(stream) * total
    for u in range(g):
        rest -= max(s.costs[term, u] - least, 0.0) + 0.01
        if rest <= 0.0:
            return u
    return g - 1


@inlined
def drawn_term(p: PreparedHall, s: State, stream: Stream) -> int:
    """Space, fill or proportion, drawn by how much each costs above its best."""
    space, fill, proportion = 0.02, 0.02, 0.02
    best = space_cost(0.0, 1.0)
    for u in range(p.spans.shape[0]):
        space += max(s.costs[SPACE, u] - best, 0.0)
        number = p.spans[u, 1] - p.spans[u, 0] - 1
        proportion += max(s.costs[PROPORTION, u] - 0.5 * number, 0.0)
    for z in range(p.zone_areas.shape[0]):
        fill += s.costs[FILL, z]
    rest = uniform(stream) * (space + fill + proportion)
    if rest < space:
        return SPACE
    return FILL if rest < space + fill else PROPORTION


@inlined
def choose_move(
    p: PreparedHall, s: State, stream: Stream, size: float, form: float
) -> tuple[int, int, float]:
    """The paper's choice: unit, kind of move (0 spread, 1 slide, 2 turn, 3 pattern) and step;
    ``form`` is the share of those that change the pattern."""
    term = drawn_term(p, s, stream)
    unit = drawn_unit(p, s, SPACE if term == FILL else term, stream)
    step = uniform(stream) * size
    if uniform(stream) < form:
        return unit, 3, step
    if term == PROPORTION:
        return unit, 0, -step
    if term == FILL:
        return below(stream, p.spans.shape[0]), 0, step
    if s.covered[unit, 1] + s.covered[unit, 2] > s.covered[unit, 0]:
        return unit, 1 if uniform(stream) < 0.75 else 2, step
    return unit, 0 if uniform(stream) < 0.5 else 1, step


@inlined
def called_for(p: PreparedHall, s: State, stream: Stream) -> int:
    """A unit that stands in the way of something: one that is not reached, or one in a zone whose
    passage is too narrow; -1 if all is well."""
    g, links = p.spans.shape[0], p.links.shape[0]
    total = 0.0
    for u in range(g):
        total += s.costs[REACH, u]
    if total > 0.0 and p.weights[REACH] != 0.0:
        return drawn_unit(p, s, REACH, stream)
    start = below(stream, max(links, 1))
    for k in range(links):
        link = (start + k) % links
        if s.costs[ACCESS, link] > 0.0:
            zone = int(p.links[link, below(stream, 2)])
            first = below(stream, g)
            for turn in range(g):
                if p.zones[(first + turn) % g] == zone:
                    return (first + turn) % g
    return -1


@inlined
def propose(
    p: PreparedHall,
    s: State,
    work: Scratch,
    stream: Stream,
    size: float,
    free: float,
    rule: MoveSettings,
) -> int:
    """Write a move of one unit; the unit."""
    blind = uniform(stream) < free
    unit, kind, step = choose_move(p, s, stream, size, rule.form)
    if blind:
        unit, kind = below(stream, p.spans.shape[0]), below(stream, KINDS)
        step = (uniform(stream) - 0.5) * 2.0 * size
        called = called_for(p, s, stream) if uniform(stream) < rule.called else -1
        if called >= 0:
            unit, step = called, 2.0 * step
    begin(p, s, work, unit)
    if kind == 0 and s.code[unit] == SINGLE:
        kind = 1
    if kind == 0:
        spread(p, s, unit, step, stream)
    elif kind == 1:
        slide(s, unit, max(abs(step), 0.02) * (4.0 if uniform(stream) < rule.far else 1.0), stream)
    elif kind == 2 and s.code[unit] != WALL:
        turn(p, s, unit, stream)
    elif kind == 3:
        change_form(p, s, unit, stream)
    elif kind == 4 and s.code[unit] != WALL:
        snap(p, s, unit, stream)
    elif kind in (6, 7) and s.code[unit] != WALL:
        line_up(p, s, unit, stream)
    elif kind == 8:
        match_pitch(p, s, unit, stream)
    else:
        scatter(p, s, unit, stream)
    return unit


@inlined
def in_the_way(p: PreparedHall, s: State, host: int) -> bool:
    """Whether a passage of a zone beside a host is too narrow, or an object there not reached."""
    for side in (4, 5):
        zone = int(p.hosts[host, side])
        for link in range(p.links.shape[0]):
            beside = int(p.links[link, 0]) == zone or int(p.links[link, 1]) == zone
            if beside and s.costs[ACCESS, link] > 0.0:
                return True
        for u in range(p.zones.shape[0]):
            if p.zones[u] == zone and s.costs[REACH, u] > 0.0:
                return True
    return False


@inlined
def stand_off(p: PreparedHall, s: State, host: int, stream: Stream) -> int:
    """Move a partition aside, parallel to its host, or back onto it; the host, -1 if it stays."""
    least, most = p.host_shifts[host, 0], p.host_shifts[host, 1]
    if least == most:
        return -1
    off = s.offsets[host] + bell(stream)
    if s.offsets[host] != 0.0 and uniform(stream) < 0.3:
        off = 0.0
    s.offsets[host] = min(max(off, least), most)
    build(p, s, host)
    return host


@compiled
def move_wall(
    p: PreparedHall, s: State, work: Scratch, size: float, stream: Stream, rule: MoveSettings
) -> int:
    """Extend or shorten one end of a partition, most often as far as its border lets it; the
    host, or -1 if it has none or stays what it is."""
    host = below(stream, p.hosts.shape[0])
    low, high = s.partitions[host, 0], s.partitions[host, 1]
    work.pose[0], work.pose[1], work.pose[2] = low, high, s.offsets[host]
    if high <= low:
        return -1
    astray = s.offsets[host] != 0.0 or in_the_way(p, s, host)
    if uniform(stream) < (rule.aside if astray else rule.seldom):
        return stand_off(p, s, host, stream)
    step = (uniform(stream) - 0.5) * 4.0 * size
    least, most = p.host_spans[host, 0], p.host_spans[host, 1]
    if uniform(stream) < rule.out:
        step = most - least
    if uniform(stream) < 0.5:
        s.partitions[host, 0] = min(max(low - step, least), high - 0.5)
    else:
        s.partitions[host, 1] = max(min(high + step, most), low + 0.5)
    if s.partitions[host, 0] == low and s.partitions[host, 1] == high:
        return -1
    build(p, s, host)
    return host


@inlined
def undo_wall(p: PreparedHall, s: State, work: Scratch, host: int) -> None:
    """Take the move of a partition back."""
    s.partitions[host, 0], s.partitions[host, 1] = work.pose[0], work.pose[1]
    s.offsets[host] = work.pose[2]
    build(p, s, host)
    measure_all(p, s, work)


@inlined
def step_once(
    p: PreparedHall,
    s: State,
    work: Scratch,
    stream: Stream,
    bare: float,
    rate: float,
    size: float,
    free: float,
    rule: MoveSettings,
) -> float:
    """One iteration; the energy without the route after it, infinity if the move was refused."""
    limit = bare - math.log(1.0 - uniform(stream)) / rate
    host = -1
    share = rule.walls * min(rule.few / p.unit_of.shape[0], 1.0)
    if p.hosts.shape[0] > 0 and uniform(stream) < share:
        host = move_wall(p, s, work, size, stream, rule)
    if host >= 0:
        after = measure_all(p, s, work)
        if after <= limit:
            return after
        undo_wall(p, s, work, host)
        return math.inf
    unit = propose(p, s, work, stream, size, free, rule)
    after = bare + judge(p, s, work, unit)
    if after <= limit:
        settle(p, s, work, unit)
        return after
    undo(p, s, work, unit)
    return math.inf


@compiled
def run(
    p: PreparedHall,
    s: State,
    work: Scratch,
    grid: RouteGrid,
    bits: Bits,
    inset: Floats,
    stream: Stream,
    tally: Floats,
    schedule: Floats,
    rule: MoveSettings,
    first: int,
    steps: int,
    last: Kept,
    best: Kept,
) -> None:
    """Make ``steps`` iterations, starting from iteration ``first``.

    ``schedule`` (4,): λ at the start and the end, all iterations I, and the share of free moves;
    λ rises geometrically. ``tally`` (5,): energy now, of the route in it, of the best, moves
    accepted, energy of ``last``. The route costs ten times a move, so it is looked at after every
    ``rule.block`` accepted moves, and Metropolis' rule decides on the block as a whole: if it is
    refused, the layout ``last`` kept comes back. Only layouts so looked at become ``best``.
    ``bits`` (3, h, k) is scratch.
    """
    count, waiting = schedule[2], 0
    weighed = p.weights[REACH] != 0.0
    keep(s, last)
    tally[4] = tally[0]
    for step in range(first, first + steps):
        share = step / count
        rate = schedule[0] * (schedule[1] / schedule[0]) ** share
        size = max(1.0 - share, 0.5 if schedule[3] == 0.0 else 0.05)
        bare = tally[0] - tally[1]
        after = step_once(p, s, work, stream, bare, rate, size, schedule[3], rule)
        if after < math.inf:
            tally[0], tally[3], waiting = after + tally[1], tally[3] + 1.0, waiting + 1
        if waiting == (rule.block if weighed else 1) or (waiting > 0 and step + 1 == first + steps):
            waiting = 0
            look_at_route(p, s, work, grid, bits, inset, stream, tally, rate, last, best)


@inlined
def look_at_route(
    p: PreparedHall,
    s: State,
    work: Scratch,
    grid: RouteGrid,
    bits: Bits,
    inset: Floats,
    stream: Stream,
    tally: Floats,
    rate: float,
    last: Kept,
    best: Kept,
) -> None:
    """Decide on the moves since the last look; keep the layout or bring the last one back."""
    ways = tally[1]
    if p.weights[REACH] != 0.0:
        ways = p.weights[REACH] * count_missed(p, s, grid, bits[0], bits[1], bits[2], inset)
    total = tally[0] - tally[1] + ways
    if ways > tally[1] and total > tally[4] - math.log(1.0 - uniform(stream)) / rate:
        set_back(p, s, last)
        tally[0] = measure_all(p, s, work) + tally[1]
        return
    tally[0], tally[1] = total, ways
    if p.weights[REACH] != 0.0:
        keep(s, last)
        tally[4] = total
    if total < tally[2]:
        tally[2] = total
        keep(s, best)


@inlined
def keep(s: State, kept: Kept) -> None:
    """Copy what makes a layout."""
    for u in range(s.pose.shape[0]):
        kept.rows[u, 0], kept.rows[u, 1] = s.code[u], s.used[u]
        for k in range(4):
            kept.pose[u, k] = s.pose[u, k]
    for k in range(s.layers.shape[0]):
        for c in range(5):
            kept.layers[k, c] = s.layers[k, c]
    for h in range(s.partitions.shape[0]):
        kept.walls[h, 0], kept.walls[h, 1] = s.partitions[h, 0], s.partitions[h, 1]
        kept.offsets[h] = s.offsets[h]


@compiled
def set_back(p: PreparedHall, s: State, kept: Kept) -> None:
    """Make a state the kept layout again, but for where its objects stand and what they cost."""
    for u in range(s.pose.shape[0]):
        s.code[u], s.used[u] = int(kept.rows[u, 0]), int(kept.rows[u, 1])
        for k in range(4):
            s.pose[u, k] = kept.pose[u, k]
    for k in range(s.layers.shape[0]):
        for c in range(5):
            s.layers[k, c] = kept.layers[k, c]
    for h in range(s.partitions.shape[0]):
        s.partitions[h, 0], s.partitions[h, 1] = kept.walls[h, 0], kept.walls[h, 1]
        s.offsets[h] = kept.offsets[h]
        build(p, s, h)


def bring_back(p: PreparedHall, s: State, work: Scratch, kept: Kept) -> float:
    """Make a state the kept layout again; its energy without the route."""
    set_back(p, s, kept)
    return measure_all(p, s, work)
