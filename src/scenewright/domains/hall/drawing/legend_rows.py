"""The rows of a hall's legend: zones, groups, routes and the key of the signs used."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from shapely import Geometry, Polygon

from scenewright.catalog.kinds import name_of
from scenewright.core.scene import Piece, Scene
from scenewright.core.space import Space
from scenewright.domains.hall.drawing.narrow import Narrow, length, narrow_places
from scenewright.domains.hall.drawing.plan import Halls
from scenewright.domains.hall.drawing.zones import shape_of
from scenewright.domains.hall.hall_layout import PlacedGroup, Zone
from scenewright.drawing.labels import polygon_of
from scenewright.drawing.legend import LegendRow
from scenewright.drawing.wordings import area_words
from scenewright.text import plural, quantity

MANY = 60
"""Rows of a section; the rest is counted in one."""


def legend_rows(
    halls: Halls, scene: Scene, solids: Mapping[str, Geometry]
) -> tuple[LegendRow, ...]:
    """Zones, groups, routes and the key of the signs used; ``solids`` of each space."""
    spaces = {space.id: space for space in scene.spaces}
    several = len({zone.space for zone in halls.graph.zones}) > 1
    rows = [LegendRow("heading", "Zones")] if halls.graph.zones else []
    rows += _limit_rows((_zone_row(z, halls, spaces, several) for z in halls.graph.zones), "zones")
    rows += _circulation(halls, spaces)
    pieces = {piece.id: piece for piece in scene.pieces}
    groups = sorted(halls.graph.groups, key=lambda g: halls.numbers[g.id])
    rows += [LegendRow("heading", "Groups")] if groups else []
    rows += _limit_rows(
        (_group_row(g, halls, pieces, spaces if several else {}) for g in groups), "groups"
    )
    places = [
        narrow_places(tour, halls.passage, solids.get(tour.space, Polygon()))
        for tour in halls.tours
    ]
    routes = _route_rows(halls, places, spaces if several else {})
    return (*rows, *routes, *_key_rows(halls, scene, any(places)))


def _limit_rows(rows: Iterable[LegendRow], what: str) -> list[LegendRow]:
    listed = list(rows)
    more = len(listed) - MANY
    return [*listed[:MANY], LegendRow("note", f"and {more} more {what}")] if more > 0 else listed


def _zone_row(zone: Zone, halls: Halls, spaces: dict[str, Space], several: bool) -> LegendRow:
    name, hall = zone.name or zone.id, spaces.get(zone.space)
    if several and hall is not None and hall.name != name:
        name = f"{hall.name} · {name}"
    return LegendRow(
        "swatch", name, area_words(shape_of(zone).area), halls.colours[zone.space, zone.id]
    )


def _circulation(halls: Halls, spaces: dict[str, Space]) -> list[LegendRow]:
    """The floor of zoned halls that is in no zone."""
    zoned = {zone.space for zone in halls.graph.zones}
    floor = sum(polygon_of(spaces[name]).area for name in zoned if name in spaces)
    rest = floor - sum(shape_of(zone).area for zone in halls.graph.zones)
    return [LegendRow("swatch", "Circulation", area_words(rest), "#f6f4ef")] if rest > 0.5 else []


def _group_row(
    placed: PlacedGroup, halls: Halls, pieces: dict[str, Piece], spaces: dict[str, Space]
) -> LegendRow:
    first = next((pieces[name] for name in placed.objects if name in pieces), None)
    kind = name_of(first.category if first is not None else placed.demand)
    count, name = len(placed.objects), halls.names.get(placed.id, "")
    what = f"{count} {plural(kind)}" if count > 1 else kind
    if name and name.casefold() not in (kind, plural(kind)):
        what = f"{name}: {what}" if count > 1 else name
    if placed.space in spaces:
        what = f"{spaces[placed.space].name} · {what}"
    stopped = any(stop.group == placed.id for tour in halls.tours for stop in tour.stops)
    return LegendRow(
        "stop" if stopped else "number",
        what[:1].upper() + what[1:],
        placed.pattern,
        str(halls.numbers[placed.id]),
    )


def _route_rows(
    halls: Halls, places: Sequence[Sequence[Narrow]], spaces: dict[str, Space]
) -> list[LegendRow]:
    rows = [LegendRow("heading", "Route")] if halls.tours else []
    for tour, narrow in list(zip(halls.tours, places, strict=True))[:MANY]:
        lead = f"{spaces[tour.space].name}: " if tour.space in spaces else ""
        count = len(tour.stops)
        stops = f", {quantity(count, 'stop')}" if count else ""
        wanted = f"{halls.passage:.2f} m"
        width = f"{narrow[0].width:.2f} m (required {wanted})" if narrow else f"{wanted} or more"
        rows.append(LegendRow("route", f"{lead}{length(tour):.0f} m{stops}"))
        rows.append(LegendRow("plain", "Narrowest gap", width))
    return rows


def _key_rows(halls: Halls, scene: Scene, narrow: bool) -> list[LegendRow]:
    """The signs that occur on the sheet, each once."""
    doors = [o for o in scene.openings if o.kind != "window" and len(o.spaces) == 1]
    uses = {door.use for door in doors}
    offered = (
        ("entrance", "Entrance", bool(uses & {"entrance", "both"})),
        ("exit", "Exit", bool(uses & {"exit", "both"})),
        ("ends", "Start and end of the route", bool(halls.tours)),
        ("passage", "Passage to keep, least width", bool(halls.graph.links)),
        ("tight", f"Narrower than {halls.passage:.2f} m", narrow),
        ("border", "Border of zones", len(halls.graph.zones) > 0),
        ("wall", "Partition", any(p.category == "partition" for p in scene.pieces)),
    )
    shown = [LegendRow(sign, words) for sign, words, used in offered if used]
    return [LegendRow("heading", "Key"), *shown] if shown else []
