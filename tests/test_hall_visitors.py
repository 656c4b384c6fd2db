"""Terms about visitors against slow plain ones on shapely, and moves against afresh."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import shapely
from benchmarks.hall_measure import posed

from scenewright.core.brief import Brief
from scenewright.core.layout import corners
from scenewright.domains.hall.patterns import WALL
from scenewright.domains.hall.solvers.chains import HallChain, begin_chain
from scenewright.domains.hall.solvers.moves import reseed, scatter
from scenewright.domains.hall.solvers.start import copy_frames
from scenewright.domains.hall.solving import solve
from scenewright.domains.hall.terms.table import EGRESS, EVENNESS, ORDER, QUEUES, SIGHT
from scenewright.domains.hall.terms.trial import begin, judge, settle, undo
from scenewright.domains.hall.terms.visitors import (
    FAR_OFF,
    FIRST,
    LANE,
    OFF_AXIS,
    QUEUE,
    RAYS,
    TILL,
)
from scenewright.domains.hall.terms.whole import measure_all
from scenewright.domains.hall.visit.doors import visitor_exits, ways_in, ways_out
from scenewright.engine.draws import below, streams
from scenewright.formats import read

Told = dict[str, Any]
SAMPLES = ("exhibition", "shop", "auditorium", "irregular")
SCREEN = {"category": "showcase", "size": [2.5, 0.5, 2.2], "count": 6, "clearance": 0.3}
GALLERY: Told = {
    "id": "hall",
    "outline": [[0, 0], [40, 0], [40, 12], [0, 12]],
    "holes": [[[20, 5], [21, 5], [21, 6], [20, 6]]],
    "doors": [{"id": "in", "at": [0, 6], "width": 1.8, "swing": "out"}],
    "demands": [
        {"id": "ship", "category": "exhibit_island", "size": [4, 2, 2]},
        {"id": "screens", **SCREEN},
        {"id": "desk", "category": "info_desk"},
        {"id": "tills", "name": "belts", "category": "checkout", "count": 2, "patterns": ["chain"]},
    ],
}
"""One room with all that the terms ask about, 40 m deep, with a column."""


def gallery() -> Brief:
    return Brief.model_validate(
        {"format": "scenewright/brief", "version": 1, "domain": "hall", "rooms": [GALLERY]}
    )


def chains() -> list[HallChain]:
    briefs = [gallery(), *(read(f"sample:hall-{name}") for name in SAMPLES)]
    found = [posed(brief).fitted for brief in briefs]
    return [begin_chain(one.problem, one.start, streams(3, 1)[0]) for one in found]


def slow(chain: HallChain) -> dict[int, Any]:
    """Every term about visitors of a measured state, from polygons."""
    p, s = chain.p, chain.s
    boxes = np.zeros((len(p.sizes), 5))
    copy_frames(s, boxes)
    shapes = shapely.polygons(corners(boxes))
    walls = shapely.polygons(corners(_boxes(s.walls[s.walls[:, 4] > 0.0])))
    lines = shapely.linestrings(p.edges.reshape(-1, 2, 2))
    units = [list(range(a, b)) for a, b in p.spans]
    middles = [boxes[unit, :2].mean(0) for unit in units]
    found: dict[int, Any] = {SIGHT: 0.0, ORDER: 0.0}
    if p.main >= 0:
        main = p.spans[p.main, 0]
        x, y, heading, width, _ = boxes[main]
        way = np.array([math.sin(heading), -math.cos(heading)])
        ends = [boxes[main, :2] + 0.4 * width * t * way for t in np.linspace(-1, 1, RAYS)]
        rays = [shapely.LineString([p.entrances[0], end]) for end in ends]
        hides = [shapes[i] for i in range(len(boxes)) if p.tall[i] and i != main]
        hides += [*walls, *shapely.polygons(corners(_boxes(p.hiding)))]
        hidden = [
            any(ray.intersects(shape) for shape in hides) or any(ray.crosses(e) for e in lines)
            for ray in rays
        ]
        axis = shapely.LineString([p.entrances[0], p.entrances[0] + 100 * p.inward[0]])
        far = axis.distance(shapely.Point(boxes[main, :2]))
        found[SIGHT] = float(np.mean(hidden)) + OFF_AXIS * min(far, FAR_OFF)
    for u, role in enumerate(p.roles):
        for bit, doors in ((FIRST, p.entrances[:1]), (TILL, p.exits)):
            others = [v for v in range(len(units)) if not p.roles[v] & bit]
            if role & bit:
                far = [np.hypot(*(doors - middle).T).min() for middle in middles]
                found[ORDER] += np.mean([max(far[u] - far[v], 0.0) for v in others])
    found[EGRESS] = [
        len(unit)
        / len(boxes)
        * max(float(np.hypot(*(p.ways_out - middle).T).min()) / 15.0 - 1.0, 0.0)
        for unit, middle in zip(units, middles, strict=True)
    ]
    floor = shapely.polygonize(list(shapely.get_parts(shapely.node(shapely.union_all(lines)))))
    inside = max(floor.geoms, key=lambda part: part.area)
    solid = shapely.polygons(corners(_boxes(p.obstacles)))
    found[QUEUES] = [0.0] * len(units)
    for u in np.flatnonzero(p.roles & TILL):
        shares = []
        for i in units[u]:
            x, y, heading, width, depth = boxes[i]
            off = (depth + QUEUE) / 2
            at = [x + off * math.cos(heading), y + off * math.sin(heading), heading, width, QUEUE]
            astray = 0.0
            if p.roles[u] & LANE:
                ways = p.exits - boxes[i, :2]
                way = ways[np.hypot(*ways.T).argmin()]
                right = np.array([math.sin(heading), -math.cos(heading)])
                toward = float(right @ way / np.hypot(*way))
                astray, off = 1.0 - abs(toward), -math.copysign((width + QUEUE) / 2, toward)
                at = [*(boxes[i, :2] + off * right), heading, QUEUE, depth]
            queue = shapely.polygons(corners(np.array([at])))[0]
            taken = queue.area - queue.intersection(inside).area
            for k, shape in enumerate([*shapes, *walls, *solid]):
                taken += queue.intersection(shape).area if k != i else 0.0
            shares.append(min(taken / queue.area, 1.0) + astray)
        found[QUEUES][u] = float(np.mean(shares))
    found[EVENNESS] = _unevenness(chain)
    return found


def _boxes(frames: Any) -> Any:
    return np.column_stack([frames[:, :2], frames[:, 7], 2 * frames[:, 4], 2 * frames[:, 5]])


def _unevenness(chain: HallChain) -> float:
    p, s = chain.p, chain.s
    zones = range(len(p.zone_areas))
    before = s.stretches[:, 5].copy()
    for host, off in enumerate(s.offsets):
        row = len(before) - 2 * len(p.hosts) + 2 * host
        if abs(off) > p.thickness / 2:
            before[row : row + 2] = p.hosts[host, 4 if off > 0.0 else 5]
    length = [s.stretches[before == z, 4].sum() for z in zones]
    rows = [
        sum(
            p.sizes[a:b, 0].sum()
            for u, (a, b) in enumerate(p.spans)
            if p.zones[u] == z and s.code[u] == WALL
        )
        for z in zones
    ]
    taken = np.zeros(len(zones))
    for u, (a, b) in enumerate(p.spans):
        taken[p.zones[u]] += p.sizes[a:b].prod(1).sum()
    floor = float(np.abs(taken / p.zone_areas - taken.sum() / p.zone_areas.sum()).mean())
    if not sum(length):
        return floor
    whole = sum(rows) / sum(length)
    return floor + float(
        np.mean([abs(r / w - whole) for r, w in zip(rows, length, strict=True) if w > 0.0])
    )


def agree(chain: HallChain) -> None:
    told = slow(chain)
    for term in (SIGHT, ORDER, EVENNESS):
        assert chain.s.costs[term, 0] == pytest.approx(told[term], abs=1e-6), term
    for term in (EGRESS, QUEUES):
        count = len(chain.p.spans)
        assert chain.s.costs[term, :count] == pytest.approx(told[term], abs=1e-6), term


def test_visitors_agree_with_shapely_while_everything_moves() -> None:
    seen = np.zeros(5)
    for chain in chains():
        p, s, work, stream = chain.p, chain.s, chain.work, chain.stream
        energy = measure_all(p, s, work)
        for step in range(150):
            unit = below(stream, len(p.spans))
            begin(p, s, work, unit)
            if step % 4:
                scatter(p, s, unit, stream)
            else:
                codes = p.choices[unit].nonzero()[0]
                reseed(p, s, unit, codes[below(stream, len(codes))], 0.5, 1.0)
            change = judge(p, s, work, unit)
            if math.isfinite(change) and step % 3:
                settle(p, s, work, unit)
                energy += change
            else:
                undo(p, s, work, unit)
            if step % 5 == 0:
                agree(chain)
                terms = (SIGHT, ORDER, EVENNESS, EGRESS, QUEUES)
                seen += [s.costs[term].sum() > 0.0 for term in terms]
        assert energy == pytest.approx(measure_all(p, s, work), rel=1e-9)
    assert (seen > 3).all(), "every term is seen at work"


def test_the_ship_is_seen_and_the_desk_comes_first() -> None:
    """What is left of sight and queues is the metres off the axis and the angle of the lanes alone:
    no line of sight is hidden, and all the floor to queue on is free."""
    fitted = posed(gallery()).fitted
    p = begin_chain(fitted.problem, fitted.start, streams(0, 1)[0]).p
    for seed in range(3):
        with_all = solve(gallery(), steps=6000, seed=seed)
        values = dict.fromkeys(("sight", "order", "queues"), 0.0)
        for term in with_all.terms:
            values[term.term] = values.get(term.term, 0.0) + term.value
        (ship,) = (piece.pose for piece in with_all.pieces if piece.function == "ship")
        axis = np.array([-p.inward[0, 1], p.inward[0, 0]])
        far = abs(float(axis @ (np.array([ship.x, ship.y]) - p.entrances[0])))
        assert values["sight"] == pytest.approx(OFF_AXIS * far, abs=1e-5), "nothing hides it"
        assert far < 1.0
        assert values["order"] < 1.5
        tills = [piece.pose for piece in with_all.pieces if piece.function == "tills"]
        astray = np.mean([1.0 - abs(_toward_exit(p.exits, till)) for till in tills])
        assert values["queues"] == pytest.approx(astray, abs=1e-5), "all the floor before is free"
        assert all(abs(math.sin(till.heading)) > 0.99 for till in tills), "lanes lead straight out"
        middle = np.mean([till[:2] for till in tills], axis=0)
        assert np.hypot(*(middle - p.exits[0])) < 5.0, "and end near the way out"


def _toward_exit(exits: Any, till: Any) -> float:
    """Cosine of the angle between the lane beside a till and the way to the nearest exit."""
    ways = exits - np.array([till.x, till.y])
    way = ways[np.hypot(*ways.T).argmin()]
    return float(
        (math.sin(till.heading) * way[0] - math.cos(till.heading) * way[1]) / math.hypot(*way)
    )


def test_visitors_never_leave_by_an_emergency_exit() -> None:
    doors = [
        {"id": "main", "at": [6, 0], "width": 2.4},
        {"id": "back", "at": [12, 5], "width": 1.0, "use": "exit"},
        {"id": "wide", "at": [0, 5], "width": 2.0, "use": "exit"},
    ]
    room = {"outline": [[0, 0], [12, 0], [12, 9], [0, 9]], "demands": [{"category": "plinth"}]}
    for kept, left in ((doors, ["wide", "main"]), (doors[:2], ["main"]), (doors[1:2], ["back"])):
        brief = {"format": "scenewright/brief", "version": 1, "domain": "hall"}
        made = Brief.model_validate({**brief, "rooms": [{**room, "doors": kept}]})
        space = posed(made).hall.space
        assert [door.id for door in visitor_exits(space)] == left
        assert {door.id for door in ways_out(space)} == {door["id"] for door in kept}
        assert all(door.use != "exit" for door in ways_in(space))
