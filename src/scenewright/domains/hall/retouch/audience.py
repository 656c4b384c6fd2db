"""An audience before its stage: on its axis, within sight of it, looking at it, long rows with
aisles; the stage with its back at a wall where that helps."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import NamedTuple

import numpy as np

from scenewright.core.layout import corners
from scenewright.domains.hall.classes import PEW_PITCH
from scenewright.domains.hall.measures import AISLE
from scenewright.domains.hall.patterns import ACROSS, ALONG, CHAIN, CODE, FAN, GRID, NUMBER
from scenewright.domains.hall.patterns.chain import BLOCK
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.lines import count_objects, find_layers
from scenewright.domains.hall.retouch.stages import AT_WALL, measure_stage, propose_stages
from scenewright.domains.hall.seats.turns import MOST_TURNED, measure_turns
from scenewright.domains.hall.terms.state import Kept

VIEW, BEFORE = 0.6, 0.5
"""Metres a seat may lie beyond the side of its stage for each metre it lies before it, and the
least it has to."""
PER_OFF_AXIS, PER_TURNED, MOST_OF_AUDIENCE, SIDE = 0.3, 6.0, 12.0, 2.0
"""What a metre of the middle of the seats off the axis counts, what seats that look away do, the
most that counts, and what a metre by which the mean seat lies out of sight does."""
PASSED, PER_LONG_ROW = 0.5, 0.25
"""Metres between neighbours through which one leaves a row, and what each seat counts that a row
without has more than between two aisles; metres."""
THIN, STRETCHED, SEAT, LOOSENED = 0.6, 1.3, 1.0, 8.0
"""Gaps between neighbours and between rows, in metres, above which a metre more costs ``LOOSENED``,
for seats up to ``SEAT`` wide: an audience sits together; wider ones are pews, with aisles between
blocks and one pitch."""
PER_TOO_DEEP = 0.5
"""Cost of each metre by which an audience is deeper than wide."""
FAR, GAPS = (1.3, 2.0, 3.0), (1.1, 0.92, 0.57)
"""Metres between stage and first row, and between rows, that are tried."""
AWAY = 30.0
"""The cost of all seats that look past their stage, in metres."""
FARTHEST_ROW, NEAR_EDGE = 4.0, 0.05
"""Metres between stage and first row from which on each is a fault, and how far the first row is
set from the edge of a zone that begins farther off."""
ROWS, FEWEST, CLOSE_SEATS, SEATS_OFF_EDGE = 24, 6, 0.05, 0.02
"""Rows at most, seats of an audience at least, and metres between neighbours in close rows
and from the edge of the zone."""
LOOSE = (0.25,)
"""Metres between chairs of looser rows that are tried besides."""
SHORT, UNEVEN, LONGEST = 6, 3, 4
"""Seats of the longer of uneven rows at least, and how many numbers of such rows are tried: of
those without aisles, and of the longest that find room."""


class Audience(NamedTuple):
    """The unit of the seats, and that of what they look at."""

    seats: int
    stage: int


def find_audiences(problem: HallProblem, kept: Kept) -> list[Audience]:
    """Seats in rows or arcs that alone look at one object."""
    targets, spans = problem.units.targets, problem.units.spans
    return [
        Audience(unit, int(target))
        for unit, target in enumerate(targets)
        if target >= 0
        and (targets == target).sum() == 1
        and spans[target, 1] - spans[target, 0] == 1
        and spans[unit, 1] - spans[unit, 0] >= FEWEST
        and int(kept.rows[unit, 0]) in (CHAIN, GRID, FAN)
    ]


def sit_aside(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """The faults of all audiences of boxes (n, 5), in metres."""
    total = 0.0
    for seats, stage in find_audiences(problem, kept):
        spans = problem.units.spans
        total += measure_audience(
            boxes[slice(*spans[seats])], boxes[spans[stage, 0]], kept.pose[seats, 2]
        )
        if kept.pose[seats, 3] == 0.0:
            total += PER_LONG_ROW * max(_find_longest(problem, kept, seats) - BLOCK, 0)
        total += measure_stage(problem, boxes, stage) + _measure_loose(problem, kept, seats)
    return total


def _measure_loose(problem: HallProblem, kept: Kept, seats: int) -> float:
    """What straight rows of a unit count that lie too far apart, or neighbours in them, or that are
    deeper than wide; metres."""
    wide, deep = problem.units.sizes[problem.units.spans[seats, 0]]
    if int(kept.rows[seats, 0]) not in (CHAIN, GRID):
        return 0.0
    row, used = find_layers(problem, seats)[0], int(kept.rows[seats, 1])
    layers = kept.layers[row : row + used]
    number, along, pews = layers[:, NUMBER], layers[:, ALONG], wide > SEAT
    aisles = float(np.abs(along[number > 1] - AISLE).max(initial=0.0))
    thin = aisles if pews else along[number > 1].max(initial=0.0) - THIN
    close = PEW_PITCH - deep + 2.0 * CLOSE_SEATS if pews else STRETCHED
    stretched = layers[1:, ACROSS].max(initial=0.0) - close
    across = used * deep + layers[1:, ACROSS].sum()
    too_deep = across - (number * (wide + along) - along).max()
    loose = LOOSENED * (max(thin, 0.0) + max(stretched, 0.0))
    return float(loose + PER_TOO_DEEP * max(too_deep, 0.0))


def _find_longest(problem: HallProblem, kept: Kept, seats: int) -> int:
    """Seats of the longest row of a unit in rows that one leaves at its ends only, else 0."""
    row, used = find_layers(problem, seats)[0], int(kept.rows[seats, 1])
    layers = kept.layers[row : row + used]
    close = layers[layers[:, ALONG] < PASSED, NUMBER]
    return int(close.max(initial=0)) if int(kept.rows[seats, 0]) == CHAIN else 0


def _cut_aisles(problem: HallProblem, kept: Kept, seats: int) -> Kept:
    """The layout with aisles through the rows of a unit that are long."""
    long = _find_longest(problem, kept, seats) > BLOCK
    if int(kept.rows[seats, 0]) != CHAIN or long == (kept.pose[seats, 3] > 0.0):
        return kept
    pose = kept.pose.copy()
    pose[seats, 3] = AISLE if long else 0.0
    return kept._replace(pose=pose)


def measure_audience(seats: Floats, stage: Floats, heading: float) -> float:
    """How far seats (n, 5) lie beside and off the axis of a stage (5,) and too far before it, in
    metres."""
    front = np.array([np.cos(stage[2]), np.sin(stage[2])])
    off = seats[:, :2] - stage[:2]
    ahead = off @ front - 0.5 * stage[4]
    far = max(float((ahead - 0.5 * seats[:, 4]).min()) - FARTHEST_ROW, 0.0)
    aside = off @ (front[1], -front[0])
    beyond = np.abs(aside) - 0.5 * stage[3] - VIEW * np.maximum(ahead, 0.0)
    hidden = np.maximum(beyond, 0.0) + np.maximum(BEFORE - ahead, 0.0)
    turned = 1.0 + float(np.cos(heading - stage[2]))
    total = (
        SIDE * float(hidden.mean()) + PER_OFF_AXIS * abs(float(aside.mean())) + PER_TURNED * turned
    )
    away = float((measure_turns(seats, stage) > MOST_TURNED).mean())
    return min(total + far + AWAY * away, MOST_OF_AUDIENCE)


def propose_audiences(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with the seats of one audience on the axis of their stage, where it stands or in the
    middle of a wall."""
    for audience in find_audiences(problem, kept):
        yield from _where_they_sit(problem, kept, audience.seats)
        deep = _measure_fan(problem, kept, boxes, audience.seats)
        for moved, stage in propose_stages(problem, kept, boxes, audience.stage):
            for form in _forms(problem, moved, audience.seats):
                yield from _before(problem, form, audience.seats, stage, deep)


def _measure_fan(problem: HallProblem, kept: Kept, boxes: Floats, seats: int) -> float:
    """How deep the arcs of a unit lie among boxes (n, 5), from the seats in front to those in the
    back, in metres."""
    mine, heading = boxes[slice(*problem.units.spans[seats])], kept.pose[seats, 2]
    along = corners(mine) @ np.array([np.cos(heading), np.sin(heading)])
    return float(np.ptp(along))


def _where_they_sit(problem: HallProblem, kept: Kept, seats: int) -> Iterator[Kept]:
    """Layouts with aisles through long rows, which move to a side for them by half of their width
    or not at all."""
    cut = _cut_aisles(problem, kept, seats)
    heading = float(kept.pose[seats, 2])
    right = 0.5 * cut.pose[seats, 3] * np.array([np.sin(heading), -np.cos(heading)])
    for side in (0.0, -1.0, 1.0) if cut is not kept else ():
        pose = cut.pose.copy()
        pose[seats, :2] += side * right
        yield cut._replace(pose=pose)


def _forms(problem: HallProblem, kept: Kept, seats: int) -> Iterator[Kept]:
    """Layouts with the seats in the form they have, and in more and fewer rows; long ones with
    aisles."""
    yield _cut_aisles(problem, kept, seats)
    (row, room), number = find_layers(problem, seats), int(count_objects(problem)[seats])
    if not problem.units.choices[seats, CHAIN] or int(kept.rows[seats, 0]) == FAN:
        return
    along = float(kept.layers[row, ALONG])
    across = float(kept.layers[row + 1, ACROSS]) if kept.rows[seats, 1] > 1 else GAPS[0]
    first = problem.units.spans[seats, 0]
    apart = float(problem.units.clear[first, ::2].sum()) + AT_WALL
    least = problem.route if problem.units.access[first].any() else 0.0
    pews = problem.units.sizes[first, 0] > SEAT
    tried = (apart,) if pews else (*GAPS, apart, across)
    gaps = sorted({round(gap, 1): gap for gap in tried if gap >= least}.values())
    loose = (gap for gap in LOOSE if gap < along - CLOSE_SEATS)
    besides = [AISLE] if pews else sorted({along, min(along, CLOSE_SEATS), *loose})
    uses = sorted({*_rows(number, room), *_long_rows(problem, seats, number, room)})
    for used, gap, beside in product(uses, gaps, besides):
        layers, rows = kept.layers.copy(), kept.rows.copy()
        for k in range(used):
            each = number // used + (1 if k >= used - number % used else 0)
            layers[row + k, [NUMBER, ALONG, ACROSS, CODE]] = each, beside, gap, CHAIN
        rows[seats] = CHAIN, used
        yield _cut_aisles(problem, kept._replace(layers=layers, rows=rows), seats)


def _rows(number: int, room: int) -> list[int]:
    """Numbers of rows for ``number`` seats: those that divide it, and a few of rows
    neither short nor long, the last of them a seat longer."""
    most = range(2, min(ROWS, room, number // 2) + 1)
    uneven = [n for n in most if number % n and SHORT <= -(-number // n) <= BLOCK]
    fewest = sorted(uneven, key=lambda rows: -number % rows)[:UNEVEN]
    return sorted([*(rows for rows in most if number % rows == 0), *fewest])


def _long_rows(problem: HallProblem, seats: int, number: int, room: int) -> list[int]:
    """The fewest rows for ``number`` seats with aisles, along the longer side of the zone:
    nearly all as long as its floor allows."""
    wide = float(problem.units.sizes[slice(*problem.units.spans[seats]), 0].max())
    low, high = problem.ground.zone_bounds[int(problem.units.zones[seats])].reshape(2, 2)
    found = []
    for used in range(2, min(ROWS, room, number // 2) + 1):
        each = -(-number // used)
        long = each * wide + (-(-each // BLOCK) - 1) * AISLE
        if each > BLOCK and long <= float((high - low).max()):
            found.append(used)
    return found[:LONGEST]


def _before(
    problem: HallProblem, kept: Kept, seats: int, stage: Floats, fan: float
) -> Iterator[Kept]:
    """Layouts with the seats on the axis of a stage (5,), at some distances from it; arcs lie so
    deep as the ``fan``."""
    row, used = find_layers(problem, seats)[0], int(kept.rows[seats, 1])
    deep = float(problem.units.sizes[slice(*problem.units.spans[seats]), 1].max())
    gaps = float(kept.layers[row + 1 : row + used, ACROSS].sum())
    whole = used * deep + gaps
    if int(kept.rows[seats, 0]) == FAN:
        whole = fan
    front = np.array([np.cos(stage[2]), np.sin(stage[2])])
    aside = _shift_aside(problem, kept, seats, stage)
    for far in (*FAR, *_find_edge(problem, seats, stage)):
        moved = kept._replace(pose=kept.pose.copy())
        moved.pose[seats, :2] = stage[:2] + (0.5 * (stage[4] + whole) + far) * front + aside
        moved.pose[seats, 2] = stage[2] + np.pi
        yield moved


def _find_edge(problem: HallProblem, seats: int, stage: Floats) -> tuple[float, ...]:
    """Metres between a stage (5,) and the zone of its seats, where that begins away from it."""
    low, high = problem.ground.zone_bounds[int(problem.units.zones[seats])].reshape(2, 2)
    front = np.array([np.cos(stage[2]), np.sin(stage[2])])
    ends = np.array([[x, y] for x in (low[0], high[0]) for y in (low[1], high[1])])
    near = float(((ends - stage[:2]) @ front).min()) - 0.5 * float(stage[4]) + NEAR_EDGE
    return (near,) if near > FAR[0] else ()


def _shift_aside(problem: HallProblem, kept: Kept, seats: int, stage: Floats) -> Floats:
    """How far rows move off the axis of a stage (5,) to stay within their zone (2,)."""
    row, used = find_layers(problem, seats)[0], int(kept.rows[seats, 1])
    wide = float(problem.units.sizes[slice(*problem.units.spans[seats]), 0].max())
    layers = kept.layers[row : row + used]
    long = layers[:, NUMBER] * (wide + layers[:, ALONG]) - layers[:, ALONG]
    if int(kept.rows[seats, 0]) == CHAIN and kept.pose[seats, 3]:
        long = long + (np.ceil(layers[:, NUMBER] / BLOCK) - 1.0) * kept.pose[seats, 3]
    half = 0.5 * float(long.max())
    way = np.array([-np.sin(stage[2]), np.cos(stage[2])])
    if int(kept.rows[seats, 0]) == FAN or np.abs(way).min() > 1e-6:
        return np.zeros(2)
    low, high = problem.ground.zone_bounds[int(problem.units.zones[seats])].reshape(2, 2)
    ends = sorted(((low - stage[:2]) @ way, (high - stage[:2]) @ way))
    least, most = ends[0] + half + SEATS_OFF_EDGE, ends[1] - half - SEATS_OFF_EDGE
    return way * (0.5 * (least + most) if least > most else float(np.clip(0.0, least, most)))
