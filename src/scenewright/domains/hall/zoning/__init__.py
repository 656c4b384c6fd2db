"""Zones where a brief gives none: a proposal of how to divide the floor.

Recursive slicing: straight cuts parallel to the hall's main directions, each where the areas
come out exactly; a seeded search over trees of cuts (annealing, Kirkpatrick et al. 1983) for the
one whose zones are compact, lie beside whom they should and at their doors. Any outline, with
columns; zones that have an outline stay and the rest of the floor is shared.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.errors import InputError
from scenewright.core.space import Space
from scenewright.domains.hall.hall_layout import Zone, ZoneLink
from scenewright.domains.hall.settings import USUAL_ZONING, ZoningSettings
from scenewright.domains.hall.zoning.borders import (
    border_lengths,
    floor_of,
    shared_borders,
    zone_of,
)
from scenewright.domains.hall.zoning.cuts import GRID, Frame, frame_of, into, out_of
from scenewright.domains.hall.zoning.search import ZoningGround, rank_divisions

LEAST_ZONE = 1.0
ZONE_MARGIN = 1e-3
PASSAGE = 1.2
DECIMALS = 11


class ZoneWish(NamedTuple):
    """A zone as it is wanted: about ``area`` square metres, ``beside`` other zones (ids), at the
    door ``door`` (id of an opening); ``zone`` where it is given already."""

    id: str
    name: str = ""
    area: float = 1.0
    beside: tuple[str, ...] = ()
    door: str | None = None
    zone: Zone | None = None


def propose(
    space: Space,
    wishes: Sequence[ZoneWish],
    seed: int = 0,
    links: Sequence[ZoneLink] = (),
    passage: float = PASSAGE,
) -> tuple[Zone, ...]:
    """The best of :func:`proposals`.

    >>> square = np.array([[0, 0], [6, 0], [6, 6], [0, 6]], float)
    >>> space = Space("hall", "Hall", ("hall",), "0", square)
    >>> zones = propose(space, [ZoneWish("a", area=2.0), ZoneWish("b", area=1.0)])
    >>> [round(float(shapely.Polygon(zone.outline).area), 6) for zone in zones]
    [24.0, 12.0]
    """
    return proposals(space, wishes, 1, seed, links, passage)[0]


def proposals(
    space: Space,
    wishes: Sequence[ZoneWish],
    count: int,
    seed: int = 0,
    links: Sequence[ZoneLink] = (),
    passage: float = PASSAGE,
    rule: ZoningSettings = USUAL_ZONING,
) -> tuple[tuple[Zone, ...], ...]:
    """At most ``count`` ways to divide the floor into zones, best first; every two put at least
    15 % of the floor into different zones. The areas wished for are shares of the floor.

    ``rule`` steers the search. ``links`` are borders that must be there, ``passage`` their least
    length for zones that only wish to lie beside each other. One that misses a link, or has zones
    nobody can walk to, is only returned where none was found that does not. Always at least one,
    or an InputError.
    """
    if len(wishes) == 1 and wishes[0].zone is None:
        return ((zone_of(floor_of(space), wishes[0][:2], space),),)
    frame = frame_of(space)
    ground = _ground(space, frame, wishes, links, passage)._replace(rule=rule)
    if not ground.parts:
        whole = tuple(wish.zone for wish in wishes if wish.zone is not None)
        return (whole,)
    best: tuple[Zone, ...] = ()
    fewest = len(links) + len(wishes) + 1
    for attempt in range(rule.attempts):
        chosen: list[tuple[Zone, ...]] = []
        for pieces in rank_divisions(ground, np.random.default_rng([seed, attempt]))[
            : rule.tried * count
        ]:
            zones = _zones(space, frame, wishes, pieces)
            if not zones:
                continue
            faults = _faults(zones, links, passage)
            if faults == 0 and all(_differ(zones, other, rule.different) for other in chosen):
                chosen.append(zones)
            if faults < fewest:
                best, fewest = zones, faults
            if len(chosen) == count:
                break
        if chosen:
            return tuple(chosen)
    if best:
        return (best,)
    raise InputError(
        "no way was found to divide the floor into its zones by straight cuts",
        "give the outline of some zones",
    )


def _ground(
    space: Space,
    frame: Frame,
    wishes: Sequence[ZoneWish],
    links: Sequence[ZoneLink],
    passage: float,
) -> ZoningGround:
    """The input of the search, in the hall's frame."""
    order = {wish.id: index for index, wish in enumerate(wishes)}
    fixed = {
        index: _to_hall_frame(frame, shapely.Polygon(wish.zone.outline, wish.zone.holes))
        for index, wish in enumerate(wishes)
        if wish.zone is not None
    }
    free = [index for index in range(len(wishes)) if index not in fixed]
    floor = _to_hall_frame(frame, floor_of(space))
    taken = shapely.union_all(
        [shape.buffer(ZONE_MARGIN, join_style="mitre") for shape in fixed.values()]
    )
    rest = floor.difference(taken, grid_size=GRID) if fixed else floor
    parts = [p for p in shapely.get_parts(rest).tolist() if p.area >= LEAST_ZONE] if free else []
    if free and not parts:
        raise InputError(
            f"the zones with an outline leave no floor for zone '{wishes[free[0]].id}'",
            "make them smaller or leave it out",
        )
    must = {tuple(sorted((order[k.first], order[k.second]))): k.width for k in links}
    beside = [(w.id, name) for w in wishes for name in w.beside if name in order]
    may = {tuple(sorted((order[one], order[two]))) for one, two in beside}
    pairs = [(i, j, width, 4.0) for (i, j), width in must.items()]
    pairs += [(i, j, passage, 1.0) for i, j in may if (i, j) not in must]
    doors, names = _doors(space, frame)
    return ZoningGround(
        parts=tuple(sorted(parts, key=lambda part: -part.area)),
        free=tuple(free),
        fixed=fixed,
        areas=tuple(wish.area for wish in wishes),
        pairs=tuple(sorted(pairs)),
        doors=doors,
        at_door={order[w.id]: names.index(w.door) for w in wishes if w.door in names},
    )


def _to_hall_frame(frame: Frame, shape: shapely.Polygon) -> shapely.Polygon:
    """A polygon in the hall's frame, without the last bits of noise."""
    turned = shapely.transform(shape, lambda points: np.round(into(frame, points), DECIMALS))
    sound: shapely.Polygon = turned if turned.is_valid else turned.buffer(0)
    return sound


def _doors(space: Space, frame: Frame) -> tuple[np.ndarray, list[str]]:
    """The two ends of every door just inside the hall (d, 2, 2), and the doors' ids."""
    doors = [opening for opening in space.openings if opening.kind != "window"]
    floor, rows = floor_of(space), []
    for door in doors:
        middle, along = np.array([door.x, door.y]), np.array([door.ux, door.uy])
        out = np.array([along[1], -along[0]]) * (door.thickness / 2 + 0.1)
        inner = min(
            middle - out, middle + out, key=lambda at: shapely.distance(floor, shapely.Point(at))
        )
        rows.append([inner - along * door.width / 2, inner + along * door.width / 2])
    ends = np.array(rows).reshape(-1, 2)
    return np.round(into(frame, ends), DECIMALS).reshape(-1, 2, 2), [door.id for door in doors]


def _zones(
    space: Space, frame: Frame, wishes: Sequence[ZoneWish], pieces: dict[int, shapely.Polygon]
) -> tuple[Zone, ...]:
    """The pieces of a division as zones in the plan, in the order of the wishes; none where one
    has hairs that a clean outline cannot follow."""
    zones = []
    for index, wish in enumerate(wishes):
        if wish.zone is not None:
            zones.append(wish.zone)
            continue
        if index not in pieces:
            return ()
        back = shapely.transform(pieces[index], lambda points: out_of(frame, points))
        zone = zone_of(back, (wish.id, wish.name), space)
        drawn = shapely.Polygon(zone.outline, zone.holes)
        if not drawn.is_valid or abs(drawn.area - back.area) > 1e-3 * back.area:
            return ()
        zones.append(zone)
    return tuple(zones)


def _faults(zones: tuple[Zone, ...], links: Sequence[ZoneLink], passage: float) -> int:
    """How many links have no border to pass, and how many zones cannot be walked to."""
    order = {zone.id: index for index, zone in enumerate(zones)}
    lengths = border_lengths(shared_borders(zones))
    root = list(range(len(zones)))
    for (first, second), length in lengths.items():
        if length >= passage:
            root = [root[first] if one == root[second] else one for one in root]
    met = [
        lengths.get((min(pair), max(pair)), 0.0) >= link.width
        for link in links
        for pair in [(order[link.first], order[link.second])]
    ]
    return met.count(False) + len(set(root)) - 1


def _differ(zones: tuple[Zone, ...], others: tuple[Zone, ...], share: float) -> bool:
    one, two = (
        np.array([shapely.Polygon(zone.outline, zone.holes) for zone in both])
        for both in (zones, others)
    )
    same = shapely.area(shapely.intersection(one, two, grid_size=GRID)).sum()
    return bool(same < (1.0 - share) * shapely.area(one).sum())
