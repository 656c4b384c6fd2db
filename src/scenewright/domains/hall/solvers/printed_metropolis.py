"""GD-MH as printed (Cao, Cheng, Zhang 2024, 3.3): which energy is high leads every move.

E_s high: expand, or translate or turn where clearances of others or walls are covered. E_u high:
expand in the zone whose E_u is high. E_p high: shrink the group with the largest share of the
floor. E_a high: shorten or remove a wall of the two zones. A zone that lacks wall gets some. A
group that nothing satisfies changes its pattern. A move that breaks a hard rule is drawn anew and
is no iteration; one that Metropolis' rule refuses is.
"""

from __future__ import annotations

import math

from scenewright.domains.hall.patterns import SINGLE, WALL
from scenewright.domains.hall.settings import GuidedSettings
from scenewright.domains.hall.solvers.guided_metropolis import (
    drawn_unit,
    keep,
    look_at_route,
    undo_wall,
)
from scenewright.domains.hall.solvers.moves import change_pattern, slide, spread, turn
from scenewright.domains.hall.terms.place import build
from scenewright.domains.hall.terms.state import Floats, Ints, Kept, PreparedHall, Scratch, State
from scenewright.domains.hall.terms.table import ACCESS, FILL, PROPORTION, SPACE, space_cost
from scenewright.domains.hall.terms.trial import begin, judge, settle, undo
from scenewright.domains.hall.terms.whole import measure_all
from scenewright.engine.draws import Stream, below, uniform
from scenewright.geometry.compiled import compiled, inlined
from scenewright.geometry.flood import Bits
from scenewright.geometry.paths import RouteGrid


@inlined
def drawn_energy(p: PreparedHall, s: State, stream: Stream) -> int:
    """One of the four energies, drawn by how much each lies above what it is at best."""
    space, fill, access, proportion = 0.02, 0.02, 0.0, 0.02
    best = space_cost(0.0, 1.0)
    for u in range(p.spans.shape[0]):
        space += p.weights[SPACE] * max(s.costs[SPACE, u] - best, 0.0)
        number = p.spans[u, 1] - p.spans[u, 0] - 1
        proportion += p.weights[PROPORTION] * max(s.costs[PROPORTION, u] - 0.5 * number, 0.0)
    for z in range(p.zone_areas.shape[0]):
        fill += p.weights[FILL] * s.costs[FILL, z]
    for k in range(p.links.shape[0]):
        access += p.weights[ACCESS] * s.costs[ACCESS, k]
    rest = uniform(stream) * (space + fill + access + proportion)
    if rest < space:
        return SPACE
    if rest < space + fill:
        return FILL
    return ACCESS if rest < space + fill + access else PROPORTION


@inlined
def unit_in(p: PreparedHall, zone: int, stream: Stream) -> int:
    """A unit drawn among those of a zone; any if it has none."""
    g = p.spans.shape[0]
    first = below(stream, g)
    for k in range(g):
        if p.zones[(first + k) % g] == zone:
            return (first + k) % g
    return first


@inlined
def filled_least(p: PreparedHall, s: State, stream: Stream) -> int:
    """A zone drawn by its E_u."""
    total = 0.0
    for z in range(p.zone_areas.shape[0]):
        total += s.costs[FILL, z]
    rest = uniform(stream) * total
    for z in range(p.zone_areas.shape[0]):
        rest -= s.costs[FILL, z]
        if rest < 0.0:
            return z
    return 0


@inlined
def largest_share(p: PreparedHall, s: State) -> int:
    """The unit whose extent takes the largest share of the floor of its zone, among those whose
    gaps are too wide; the largest of all if none are."""
    unit, most = 0, -1.0
    for u in range(p.spans.shape[0]):
        number = p.spans[u, 1] - p.spans[u, 0] - 1
        wide = s.costs[PROPORTION, u] > 0.5 * number + 1e-6
        share = s.extent[u, 0] / p.zone_areas[p.zones[u]] + (10.0 if wide else 0.0)
        if share > most:
            unit, most = u, share
    return unit


@inlined
def tight_link(p: PreparedHall, s: State, stream: Stream) -> int:
    """A link drawn among those whose passage is too narrow; -1 if none is."""
    links = p.links.shape[0]
    first = below(stream, max(links, 1))
    for k in range(links):
        if s.costs[ACCESS, (first + k) % links] > 0.0:
            return (first + k) % links
    return -1


@inlined
def wall_of(p: PreparedHall, s: State, zone: int, built: bool, stream: Stream) -> int:
    """A border of a zone drawn among those with a wall (``built``), or among all; -1: none."""
    count = p.hosts.shape[0]
    first = below(stream, max(count, 1))
    for k in range(count):
        h = (first + k) % count
        beside = int(p.hosts[h, 4]) == zone or int(p.hosts[h, 5]) == zone
        if beside and (not built or s.partitions[h, 1] > s.partitions[h, 0]):
            return h
    return -1


@inlined
def short_of_wall(p: PreparedHall, s: State, stream: Stream) -> int:
    """A zone with less wall than its objects need; -1 if there is none."""
    zones = p.zone_areas.shape[0]
    first = below(stream, zones)
    for k in range(zones):
        z, length = (first + k) % zones, 0.0
        for row in range(p.loop_spans[z, 0], p.loop_spans[z, 1]):
            length += s.stretches[p.loops[row], 4]
        if p.wall_needs[z] > length:
            return z
    return -1


@inlined
def cut_wall(
    p: PreparedHall, s: State, work: Scratch, host: int, step: float, end: bool, shortest: float
) -> None:
    """Shorten a wall at one end; one that would be shorter than ``shortest`` goes."""
    low, high = s.partitions[host, 0], s.partitions[host, 1]
    work.pose[0], work.pose[1], work.pose[2] = low, high, 0.0
    if high - low - step < shortest:
        s.partitions[host, 0], s.partitions[host, 1] = 0.0, 0.0
    elif end:
        s.partitions[host, 1] = high - step
    else:
        s.partitions[host, 0] = low + step
    build(p, s, host)


@inlined
def raise_wall(p: PreparedHall, s: State, work: Scratch, host: int, step: float, end: bool) -> None:
    """Lengthen a wall within its passage gaps, or build one where there is none."""
    low, high = s.partitions[host, 0], s.partitions[host, 1]
    least, most = p.host_spans[host, 0], p.host_spans[host, 1]
    work.pose[0], work.pose[1], work.pose[2] = low, high, 0.0
    if high <= low:
        low, high = least, most
    elif end:
        high = max(min(high + step, most), high)
    else:
        low = min(max(low - step, least), low)
    s.partitions[host, 0], s.partitions[host, 1] = low, high
    build(p, s, host)


@inlined
def wall_move(
    p: PreparedHall, s: State, work: Scratch, term: int, stream: Stream, shortest: float
) -> int:
    """Cut a wall at a narrow passage where E_a leads, or build where a zone lacks wall; the host
    of the wall, -1 if there is nothing to do."""
    step, end = 2.0 * uniform(stream), uniform(stream) < 0.5
    if term == ACCESS:
        link = tight_link(p, s, stream)
        zone = int(p.links[link, below(stream, 2)]) if link >= 0 else -1
        host = wall_of(p, s, zone, True, stream)
        if host >= 0:
            cut_wall(p, s, work, host, step, end, shortest)
        return host
    zone = short_of_wall(p, s, stream)
    host = wall_of(p, s, zone, False, stream) if zone >= 0 else -1
    if host >= 0:
        raise_wall(p, s, work, host, step, end)
    return host


@inlined
def unit_move(
    p: PreparedHall,
    s: State,
    work: Scratch,
    term: int,
    stream: Stream,
    size: float,
    stuck: Ints,
    rule: GuidedSettings,
) -> int:
    """Write the move of one unit that an energy asks for, another pattern where it was refused
    ``rule.stuck`` times in a row; the unit."""
    step = uniform(stream) * size
    if term == FILL:
        unit = unit_in(p, filled_least(p, s, stream), stream)
    elif term == PROPORTION:
        unit = largest_share(p, s)
    elif term == ACCESS:
        link = max(tight_link(p, s, stream), 0)
        unit = unit_in(p, int(p.links[link, below(stream, 2)]), stream)
    else:
        unit = drawn_unit(p, s, SPACE, stream)
    begin(p, s, work, unit)
    crowded = s.covered[unit, 1] + s.covered[unit, 2] > s.covered[unit, 0]
    if stuck[unit] >= rule.stuck:
        stuck[unit] = 0
        change_pattern(p, s, unit, stream)
    elif term == PROPORTION:
        spread(p, s, unit, -step, stream)
    elif term == ACCESS or (term == SPACE and crowded) or s.code[unit] == SINGLE:
        if uniform(stream) < rule.turned and s.code[unit] != WALL:
            turn(p, s, unit, stream)
        else:
            slide(s, unit, max(step, 0.02), stream)
    else:
        spread(p, s, unit, step, stream)
    return unit


@inlined
def draw_once(
    p: PreparedHall,
    s: State,
    work: Scratch,
    stream: Stream,
    bare: float,
    limit: float,
    size: float,
    stuck: Ints,
    rule: GuidedSettings,
) -> tuple[float, bool]:
    """One move drawn and judged: the energy without the route after it, infinity if it is
    refused, and whether it broke no hard rule."""
    term, host = drawn_energy(p, s, stream), -1
    if p.hosts.shape[0] > 0 and (term == ACCESS or uniform(stream) < rule.walls):
        host = wall_move(p, s, work, term, stream, rule.shortest)
    if host >= 0:
        after = measure_all(p, s, work)
        if after <= limit:
            return after, True
        undo_wall(p, s, work, host)
        return math.inf, after < math.inf
    unit = unit_move(p, s, work, term, stream, size, stuck, rule)
    after = bare + judge(p, s, work, unit)
    if after <= limit:
        settle(p, s, work, unit)
        stuck[unit] = 0
        return after, True
    undo(p, s, work, unit)
    stuck[unit] += 1
    return math.inf, after < math.inf


@compiled
def run_printed(
    p: PreparedHall,
    s: State,
    work: Scratch,
    grid: RouteGrid,
    bits: Bits,
    inset: Floats,
    stream: Stream,
    tally: Floats,
    schedule: Floats,
    rule: GuidedSettings,
    stuck: Ints,
    first: int,
    steps: int,
    last: Kept,
    best: Kept,
) -> None:
    """Make ``steps`` iterations, starting from iteration ``first``; arguments as of
    :func:`.guided_metropolis.run`, and ``stuck`` (g,) moves of each unit refused in a row."""
    rate, count = schedule[0], schedule[2]
    keep(s, last)
    tally[4] = tally[0]
    for step in range(first, first + steps):
        size = max(1.0 - step / count, 0.5)
        bare = tally[0] - tally[1]
        limit = bare - math.log(1.0 - uniform(stream)) / rate
        after, allowed = math.inf, False
        for _draw in range(rule.draws):
            after, allowed = draw_once(p, s, work, stream, bare, limit, size, stuck, rule)
            if allowed:
                break
        if after < math.inf:
            tally[0], tally[3] = after + tally[1], tally[3] + 1.0
            look_at_route(p, s, work, grid, bits, inset, stream, tally, rate, last, best)
