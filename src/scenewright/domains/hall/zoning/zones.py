"""The functional zones of a hall: from what the brief says to polygons that fit the floor.

Zones never overlap and never leave the floor; what belongs to no zone is circulation. Links tell
between which zones people must be able to walk.
"""

from __future__ import annotations

from typing import NamedTuple

import shapely

from scenewright.building import outlines
from scenewright.building.door_approach import free_width, gates
from scenewright.building.plan import place
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.space import Space
from scenewright.domains.hall.demands.checked import check_demands
from scenewright.domains.hall.demands.shared import share_demands
from scenewright.domains.hall.hall_layout import Zone, ZoneLink
from scenewright.domains.hall.settings import USUAL_ZONING, ZoningSettings
from scenewright.domains.hall.zoning import LEAST_ZONE, ZoneWish, proposals
from scenewright.domains.hall.zoning.borders import (
    Border,
    WallStretch,
    border_lengths,
    floor_of,
    shared_borders,
    wall_stretches,
    zone_of,
)
from scenewright.domains.hall.zoning.passage_widths import check_widths
from scenewright.domains.hall.zoning.zone_wishes import check_names, wishes_of

__all__ = ["Border", "HallPlan", "WallStretch", "borders_of", "wall_stretches", "zones_of"]

OUTSIDE_FLOOR = 0.02
ZONE_OVERLAP = 0.02
NEGLIGIBLE = 0.05
LEAST_WAY = 0.5
"""Metres of a door that holes must leave free."""
ZONE_GRID = 1e-7
"""Overlays of outlines that run along each other need a grid: without, GEOS 3.14 now and then
returns all or nothing."""


class HallPlan(NamedTuple):
    """The zones of a hall and the links between them."""

    zones: tuple[Zone, ...]
    links: tuple[ZoneLink, ...]


def zones_of(
    brief: Brief,
    number: int,
    space: Space,
    seed: int = 0,
    variant: int = 0,
    rule: ZoningSettings = USUAL_ZONING,
) -> HallPlan:
    """The zones and links of room ``number`` of a brief, whose space is ``space``.

    Zones without an outline are proposed (:mod:`scenewright.domains.hall.zoning`, by ``seed``, as
    ``rule`` says); ``variant`` counts through proposals that differ, best first. A hall without
    zones is one, ``hall``. Raises InputError, with the place in the brief, for zones that cannot be
    built and links that cannot be walked.
    """
    check_names(brief, number, space)
    given = given_zones(brief, number, space)
    wishes = wishes_of(brief, number, space, given)
    zones = tuple(given.values())
    if len(zones) < len(wishes):
        try:
            zones = _propose_zones(brief, number, space, wishes, (seed, variant), rule)
        except InputError as error:
            raise error.located(place=place(brief, number)) from None
    borders = shared_borders(zones)
    links = _given_links(brief, number, space, zones, borders)
    return HallPlan(zones, links or default_links(zones, borders, brief.passage_width))


def check_halls(brief: Brief, plan: Plan) -> None:
    """InputError where the zones, links and demands of a brief's halls cannot be meant."""
    brief = share_demands(brief)
    for number, (room, space) in enumerate(zip(brief.rooms, plan.spaces, strict=True)):
        if room.ask:
            raise InputError(
                "asks for groups of furniture, but is a hall",
                "say what it is to hold in demands",
                place=place(brief, number),
            )
        _check_doors(brief, number, space)
        check_demands(brief, number, space)
        check_names(brief, number, space)
        wishes = wishes_of(brief, number, space, given_zones(brief, number, space))
        if room.links or all(wish.zone for wish in wishes):
            zones_of(brief, number, space)
        if len(wishes) > 1:
            check_widths(brief, number, space)


def borders_of(plan: HallPlan, space: Space) -> tuple[Border, ...]:
    """The straight pieces of border between every two zones of a hall: passages lead through
    them and partitions stand on them."""
    del space
    return shared_borders(plan.zones)


def given_zones(brief: Brief, number: int, space: Space) -> dict[str, Zone]:
    """The zones whose outline the brief states, by id, cut to the floor."""
    floor, shell = floor_of(space), shapely.Polygon(space.outline)
    reach = OUTSIDE_FLOOR + (brief.wall_thickness if brief.outlines == "centre" else 0.0)
    found: dict[str, shapely.Polygon] = {}
    zones: dict[str, Zone] = {}
    for index, wish in enumerate(brief.rooms[number].zones):
        if wish.outline is None:
            continue
        where = place(brief, number, f"zones[{index}] '{wish.id}'")
        try:
            shape = outlines.polygon(wish.outline)
            _check_inside(shape, shell, reach)
            part = _one_piece(shape.intersection(floor, grid_size=ZONE_GRID))
            _check_apart(part, found)
            taken = shapely.union_all(list(found.values()), grid_size=ZONE_GRID)
            part = _one_piece(part.difference(taken, grid_size=ZONE_GRID))
            made = zone_of(part, (wish.id, wish.name), space)
            if not shapely.Polygon(made.outline, made.holes).is_valid:  # hairs along a wall
                part = _one_piece(shapely.set_precision(part, 2 * outlines.SAME_POINT))
                made = zone_of(part, (wish.id, wish.name), space)
        except InputError as error:
            raise error.located(place=where) from None
        found[wish.id] = part
        zones[wish.id] = made
    return zones


def default_links(
    zones: tuple[Zone, ...], borders: tuple[Border, ...], width: float
) -> tuple[ZoneLink, ...]:
    """Links that make every zone reachable where the brief states none: the spanning tree of
    greatest borders (Kruskal 1956) among the zones that share one at least ``width`` long."""
    lengths = border_lengths(borders)
    root = list(range(len(zones)))
    links = []
    for (first, second), length in sorted(lengths.items(), key=lambda row: (-row[1], row[0])):
        if length >= width and root[first] != root[second]:
            root = [root[first] if one == root[second] else one for one in root]
            links.append((first, second))
    return tuple(
        ZoneLink(zones[i].space, zones[i].id, zones[j].id, width) for i, j in sorted(links)
    )


def _check_doors(brief: Brief, number: int, space: Space) -> None:
    asked = space.holes and (brief.rooms[number].demands or len(brief.rooms) == 1)
    for gate in gates(space) if asked else ():
        opening = gate.opening
        free = opening.width if opening.kind == "window" else free_width(space, gate)
        if free < min(LEAST_WAY, opening.width - 0.01):
            raise InputError(
                f"a hole leaves {free:.2f} m of it free",
                "move the hole or the door",
                place=place(brief, number, f"door '{opening.id}'"),
            )


def _propose_zones(
    brief: Brief,
    number: int,
    space: Space,
    wishes: tuple[ZoneWish, ...],
    which: tuple[int, int],
    rule: ZoningSettings,
) -> tuple[Zone, ...]:
    seed, variant = which
    links = _unbuilt_links(brief, number, space)
    width = brief.passage_width
    found = proposals(space, wishes, variant + 1, seed, links, width, rule)
    return found[variant % len(found)]


def _unbuilt_links(brief: Brief, number: int, space: Space) -> tuple[ZoneLink, ...]:
    return tuple(
        ZoneLink(space.id, *link.between, brief.passage_width if link.width is None else link.width)
        for link in brief.rooms[number].links
    )


def _check_inside(shape: shapely.Polygon, shell: shapely.Polygon, reach: float) -> None:
    points = shapely.points(shapely.get_coordinates(shape.difference(shell, grid_size=ZONE_GRID)))
    away = shapely.distance(points, shell)
    if len(away) and away.max() > reach:
        far = points[int(away.argmax())]
        raise InputError(
            f"reaches {away.max():.2f} m out of the hall at ({far.x:.2f}, {far.y:.2f})",
            "keep its corners inside the hall's outline",
        )


def _one_piece(shape: shapely.Geometry) -> shapely.Polygon:
    """The largest part of a zone, if all others together are negligible."""
    parts = [part for part in shapely.get_parts(shape).tolist() if part.area > 0.0]
    parts = sorted((p for p in parts if p.geom_type == "Polygon"), key=lambda part: -part.area)
    if not parts or parts[0].area < LEAST_ZONE:
        area = parts[0].area if parts else 0.0
        raise InputError(
            f"holds only {area:.2f} m² of floor", f"a zone needs at least {LEAST_ZONE:g} m²"
        )
    if sum(part.area for part in parts[1:]) > max(NEGLIGIBLE, 0.01 * parts[0].area):
        raise InputError(
            f"is cut into {len(parts)} pieces by walls, columns or other zones, the second of "
            f"{parts[1].area:.2f} m²",
            "make each piece a zone of its own",
        )
    largest: shapely.Polygon = parts[0]
    return largest


def _check_apart(shape: shapely.Polygon, found: dict[str, shapely.Polygon]) -> None:
    for name, other in found.items():
        shared = shape.intersection(other, grid_size=ZONE_GRID)
        if shared.area > ZONE_OVERLAP:
            middle = shared.representative_point()
            raise InputError(
                f"overlaps zone '{name}' by {shared.area:.2f} m² "
                f"near ({middle.x:.2f}, {middle.y:.2f})",
                "move their common border",
            )


def _given_links(
    brief: Brief, number: int, space: Space, zones: tuple[Zone, ...], borders: tuple[Border, ...]
) -> tuple[ZoneLink, ...]:
    order = {zone.id: index for index, zone in enumerate(zones)}
    lengths = border_lengths(borders)
    widest: dict[tuple[int, int], float] = {}
    for index, link in enumerate(brief.rooms[number].links):
        width = brief.passage_width if link.width is None else link.width
        first, second = sorted(order[name] for name in link.between)
        length = lengths.get((first, second), 0.0)
        if length < width - OUTSIDE_FLOOR:
            where = place(brief, number, f"links[{index}]")
            raise InputError(_no_passage(link.between, length, width), _WIDEN, place=where)
        widest[first, second] = max(width, widest.get((first, second), 0.0))
    return tuple(
        ZoneLink(space.id, zones[i].id, zones[j].id, width)
        for (i, j), width in sorted(widest.items())
    )


_WIDEN = "give the zones a longer border or the passage a smaller width, or leave out the link"


def _no_passage(between: tuple[str, str], length: float, width: float) -> str:
    first, second = between
    if length == 0.0:
        return f"the zones '{first}' and '{second}' share no border"
    return (
        f"the border of the zones '{first}' and '{second}' is only {length:.2f} m long, "
        f"the passage is to be {width:g} m wide"
    )
