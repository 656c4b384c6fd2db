"""How many of a demand a hall takes, where the brief leaves that to the floor.

A demand with ``fill`` adds objects until all in its zones, with the free floor around each, take
that share of the zones. In practice a third to a little over half: of a shop's floor fixtures with
their aisles of 1.2 m take half (:mod:`scenewright.domains.hall.demands.programme`, after Neufert
2012); shelves 0.6 m deep at 1.5 to 1.7 m from middle to middle, as libraries have them, 35 to 40
per cent without their aisles (Neufert 2012). Exhibits want 0.75 m around each, so that a wheelchair
passes between two, which lets them stand on 15 to 20 per cent at most.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from scenewright.core.brief import Brief, Room
from scenewright.core.brief.zones import Demand
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.domains.hall.build_problem import HallContext, wall_lengths, zone_areas
from scenewright.domains.hall.demands.checked import floor_needed, ids_of, sizes_of
from scenewright.domains.hall.demands.holdings import fill_defaults
from scenewright.domains.hall.demands.open_numbers import open_numbers, zones_of
from scenewright.domains.hall.seats.audience import may_share_zone
from scenewright.domains.hall.seats.chairs import out_of_table, seats_around

LONGEST, MOST_NOTES = 400, 100
"""Letters of a note of a brief, and notes, at most."""
FAIR, ROW, FULL_FLOOR = 0.5, 3, 0.8
"""Part of what a demand would fill if alone that others leave it, objects of a row, and share of
the floor that all may take for that."""
MOST_NAMED, FILL_LITTLE = 3, 0.05
"""Of how many others a note says what they take, and from which share of the floor on."""
WALL_TO_TABLES = 0.45
"""Metres kept free between walls and tables with their chairs."""
FILL_WALL_SHARE = 0.8
"""Share of the walls of a zone that things may fill; the rest is corners."""


def fill_halls(
    brief: Brief, halls: Sequence[HallContext], catalog: Catalog, printed: bool = False
) -> Brief:
    """A brief whose demands with ``fill``, and those of usual goods without a number, say how many
    there may be at ``most``; the brief itself where there are none."""
    opened = [
        room if printed else open_numbers(brief, room, hall)
        for room, hall in zip(brief.rooms, halls, strict=True)
    ]
    rooms = [_fill(room, hall, catalog) for room, hall in zip(opened, halls, strict=True)]
    same = all(new is old for new, old in zip(rooms, brief.rooms, strict=True))
    return brief if same else brief.model_copy(update={"rooms": rooms})


def _fill(room: Room, hall: HallContext, catalog: Catalog) -> Room:
    if all(share_of(demand) is None for demand in room.demands):
        return room
    demands = [
        demand if share_of(demand) is None else _grow(demand, room.demands, hall, catalog)
        for demand in room.demands
    ]
    return room.model_copy(update={"demands": demands})


def share_of(demand: Demand) -> float | None:
    """The share of its zones that a demand is to fill, if it says so."""
    return None if demand.fill == "none" else demand.fill


def _grow(demand: Demand, every: Sequence[Demand], hall: HallContext, catalog: Catalog) -> Demand:
    """A demand with the number its zones take; those that fill the same zones share alike. Where
    other things take all that, a row of it and half of its share have room beside them, as long as
    the zones are not full."""
    areas, mine = zone_areas(hall), zones_of(demand, hall)
    used = sum(floor_needed(other) * _overlap(other, mine, areas, hall) for other in every)
    others = [d for d in every if share_of(d) is not None and (zones_of(d, hall) * mine).any()]
    floor, fill = float((areas * mine).sum()), share_of(demand) or 0.0
    least = len(sizes_of(demand))
    each = max(floor_needed(demand) / least, 1e-9)
    fair = max(FAIR * fill * floor / len(others), ROW * each) - least * each
    more = max(
        (fill * floor - used) / len(others), min(fair, (FULL_FLOOR * floor - used) / len(others))
    )
    count = least + max(int(more / each), 0)
    if fill_defaults(demand, "").at_wall:
        width = float(np.mean([size[0] for size in sizes_of(demand)]))
        count = min(count, int(FILL_WALL_SHARE * float((wall_lengths(hall) * mine).sum()) / width))
    chairs = _stand_out(demand, every, catalog)
    count = min(count, _count_tables(demand, hall, chairs, used)) if chairs else count
    return demand.model_copy(update={"count": least, "length": None, "most": max(count, least)})


def _stand_out(demand: Demand, every: Sequence[Demand], catalog: Catalog) -> float:
    """How far the chairs that come with tables to sit at all round stand out, in metres; 0 for
    other demands."""
    asked = {other.category for other in every if may_share_zone(demand, other)}
    tall = max(size[2] for size in sizes_of(demand))
    around = seats_around(demand.category, catalog)
    return out_of_table(demand.category, asked, catalog, tall) if around else 0.0


def _count_tables(demand: Demand, hall: HallContext, chairs: float, used: float) -> int:
    """How many tables with chairs stand in rows and columns in the zones of a demand, as far apart
    as its passages are wide, where other things use ``used`` square metres of the shorter side."""
    zones = zones_of(demand, hall) > 0.0
    wide = float(np.max([size[:2] for size in sizes_of(demand)])) + 2.0 * chairs + hall.passage
    found, taken = 0, (used - floor_needed(demand)) / max(int(zones.sum()), 1)
    for zone in (one for one, held in zip(hall.plan.zones, zones, strict=True) if held):
        short, long = sorted(np.ptp(zone.outline, axis=0))
        sides = np.array([short, long - taken / short]) + hall.passage - 2.0 * WALL_TO_TABLES
        found += int(np.prod(np.maximum(sides // wide, 0.0)))
    return found


def _overlap(demand: Demand, mine: np.ndarray, areas: np.ndarray, hall: HallContext) -> float:
    """The share of a demand that stands in some zones, by floor."""
    where = zones_of(demand, hall) * areas
    return float((where * mine).sum() / max(float(where.sum()), 1e-9))


def settle_counts(
    brief: Brief, halls: Sequence[HallContext], pieces: Mapping[int, Sequence[Piece]]
) -> Brief:
    """The brief with the numbers that stand, by the pieces of each hall, in the place of ``fill``
    and ``most``; its notes say what came of each ``fill``."""
    rooms = [_settle(room, pieces.get(k, ())) for k, room in enumerate(brief.rooms)]
    if all(new is old for new, old in zip(rooms, brief.rooms, strict=True)):
        return brief
    every = zip(brief.rooms, rooms, halls, strict=True)
    said = [line for old, new, hall in every for line in _describe_fill(old, new, hall)]
    notes = [*brief.notes, *(line[:LONGEST] for line in said)][:MOST_NOTES]
    return brief.model_copy(update={"rooms": rooms, "notes": notes})


def _describe_fill(asked: Room, settled: Room, hall: HallContext) -> list[str]:
    """Of each demand with ``fill`` how many stand, and how full its zones are with all there."""
    areas, found = zone_areas(hall), []
    names = ids_of(asked.demands)
    for name, old, new in zip(names, asked.demands, settled.demands, strict=True):
        if share_of(old) is None:
            continue
        mine = zones_of(old, hall)
        floor = max(float((areas * mine).sum()), 1e-9)
        shares = [floor_needed(d) * _overlap(d, mine, areas, hall) for d in settled.demands]
        rows = zip(names, shares, strict=True)
        taken = {other: share / floor for other, share in rows if other != name}
        full = sum(shares) / floor
        most = f" of {old.most} that it allows" if (old.most or 0) > (new.count or 0) else ""
        found.append(
            f"{name}: fill {old.fill:g} asked, {new.count}{most} stand; all there takes {full:.2f} "
            f"of {', '.join(hall.names[k] for k in np.flatnonzero(mine)[:5])} with its free floor"
            f"{_name_others(taken)}"
        )
    return found


def _name_others(taken: Mapping[str, float]) -> str:
    """What the others of a zone take of its floor, the most first.

    >>> _name_others({"racks": 0.3, "tables": 0.12, "bin": 0.01})
    ': racks 0.30, tables 0.12'
    """
    most = sorted(taken.items(), key=lambda one: -one[1])[:MOST_NAMED]
    named = ", ".join(f"{name} {share:.2f}" for name, share in most if share >= FILL_LITTLE)
    return f": {named}" if named else ""


def _settle(room: Room, pieces: Sequence[Piece]) -> Room:
    if all(demand.most is None for demand in room.demands):
        return room
    demands = []
    for demand, name in zip(room.demands, ids_of(room.demands), strict=True):
        held = sum(p.function == name and p.category == demand.category for p in pieces)
        stated = {"count": max(held, demand.count or 1), "most": None, "fill": None}
        demands.append(demand if demand.most is None else demand.model_copy(update=stated))
    return room.model_copy(update={"demands": demands})
