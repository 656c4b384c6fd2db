"""What is wrong with a drawn plan, all of it at once and each where it lies."""

from __future__ import annotations

import math
import re
from collections.abc import Generator, Iterator
from itertools import combinations
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.domains import plan_valid
from scenewright.studio.draft_brief import ABOUT, brief_of
from scenewright.studio.draft_geometry import THICK, edges_of, is_inner, nearest_edge, on_level
from scenewright.studio.shapes import Json
from scenewright.studio.wishing import FORMS

ON = 0.02
"""Metres from a wall within which an opening lies on it."""
OVERLAP = 0.01
"""Square metres from which rooms overlap."""
SMALL = 0.5
"""Square metres that a room has at least."""
FLIGHT = 4.0
"""Metres that stairs reach, about."""


class DraftFault(NamedTuple):
    """What is wrong, at which places (a point, or a ring) and of which things; one that only
    ``warns`` keeps nothing from being arranged."""

    message: str
    points: list[list[float]]
    ids: tuple[str, ...]
    warns: bool = False
    level: str = ""


class ReadDraft(NamedTuple):
    """The brief and plan of a draft, if it means any, and its faults."""

    brief: Brief | None
    plan: Plan | None
    faults: list[DraftFault]


def read_draft(draft: Json) -> ReadDraft:
    """What a draft means, with every fault.

    >>> from scenewright.studio.drafting import draw_act, new_draft
    >>> square = [[0, 0], [4, 0], [4, 3], [0, 3]]
    >>> draft, _ = draw_act(new_draft(), {"act": "room", "outline": square, "name": "Bedroom"})
    >>> [fault.message for fault in read_draft(draft).faults]
    ['no door leads into Bedroom']
    """
    faults = [
        one._replace(level=level["id"])
        for level in draft["levels"]
        for one in _find_on_level(draft, level["id"])
    ]
    faults += find_street_faults(draft)
    faults += [DraftFault(f"not held: {text}", [], (), True) for text in draft.get("lost", ())]
    needs = FORMS[draft["domain"]].needs
    if needs and not draft[needs]:
        faults.append(DraftFault(f"no {needs} are drawn yet", [], ()))
    if not draft["rooms"]:
        return ReadDraft(None, None, faults)
    if not any(not fault.warns for fault in faults):
        try:
            brief = brief_of(draft)
            return ReadDraft(brief, plan_valid(brief), faults)
        except InputError as error:
            faults.append(_place(draft, error))
    return ReadDraft(None, None, faults)


def _find_on_level(draft: Json, level: str) -> Iterator[DraftFault]:
    rooms, zones = on_level(draft, "rooms", level), on_level(draft, "zones", level)
    sound = yield from find_outline_faults(rooms)
    if FORMS[draft["domain"]].walls:
        yield from find_closed_rooms(draft, level, sound)
    yield from find_outline_faults(on_level(draft, "buildings", level))
    inner = yield from find_outline_faults(zones)
    floor = shapely.union_all([shape for _, shape in sound.values()])
    for number, (name, shape) in inner.items():
        if shape.difference(floor).area > OVERLAP:
            yield DraftFault(f"{name} reaches out of the hall", _ring(shape), (number,))
    yield from find_opening_faults(draft, level)
    for group, noun in (("columns", "column"), ("stairs", "foot of the stairs")):
        for row in on_level(draft, group, level):
            if not floor.covers(shapely.Point(row["at"])):
                yield DraftFault(f"the {noun} stands in no room", [row["at"]], (row["id"],))
    if level == draft["levels"][-1]["id"]:
        for row in on_level(draft, "stairs", level):
            yield DraftFault("the stairs lead to no storey", [row["at"]], (row["id"],))


Sound = dict[str, tuple[str, shapely.Polygon]]
"""Outlines that are outlines, by id, with their names."""


def find_outline_faults(rows: list[Json]) -> Generator[DraftFault, None, Sound]:
    """Outlines that cross themselves, are too small or overlap; the sound ones are returned."""
    sound: Sound = {}
    for row in rows:
        shape = shapely.Polygon(row["outline"])
        if not shape.is_valid:
            message = f"the sides of {row['name']} cross each other"
            yield DraftFault(message, row["outline"], (row["id"],))
        elif shape.area < SMALL:
            message = f"{row['name']} has only {shape.area:.2f} m²"
            yield DraftFault(message, row["outline"], (row["id"],))
        else:
            sound[row["id"]] = (row["name"], shape)
    for (one, (name, a)), (other, (name_b, b)) in combinations(sound.items(), 2):
        common = shapely.intersection(a, b)
        if common.area > OVERLAP:
            message = f"{name} and {name_b} overlap by {common.area:.2f} m²"
            yield DraftFault(message, _ring(common), (one, other))
    return sound


def find_closed_rooms(draft: Json, level: str, sound: Sound) -> Iterator[DraftFault]:
    """Rooms that no door or stairs lead into."""
    openings = on_level(draft, "openings", level)
    doors = [shapely.Point(one["at"]) for one in openings if one["kind"] != "window"]
    stairs = [_flight(one) for one in draft["stairs"]]
    reach = THICK if is_inner(draft) else ON
    for number, (name, shape) in sound.items():
        led = any(shape.boundary.distance(door) < reach for door in doors)
        if not led and not any(shape.intersects(flight) for flight in stairs):
            spot = shape.representative_point()
            message = f"no door leads into {name}"
            yield DraftFault(message, [[spot.x, spot.y]], (number,), warns=True)


def find_opening_faults(draft: Json, level: str) -> Iterator[DraftFault]:
    """Openings on no wall, wider than it, or over one another."""
    spans = []
    for row in on_level(draft, "openings", level):
        edge = nearest_edge(draft, row["at"], level)
        if edge.far > ON:
            message = f"the {row['kind']} stands in no wall"
            yield DraftFault(message, [row["at"]], (row["id"],))
            continue
        a, b = [*edges_of(draft["rooms"][edge.room]["outline"])][edge.corner]
        length = float(np.hypot(*(b - a)))
        reach = min(edge.share, 1 - edge.share) * length
        if row["width"] / 2 > reach + ON:
            message = f"the {row['kind']} is {row['width']:g} m wide: its wall ends before"
            yield DraftFault(message, [row["at"]], (row["id"],))
        half = (b - a) / length * row["width"] / 2
        line = shapely.LineString([np.array(row["at"]) - half, np.array(row["at"]) + half])
        spans.append((row, line))
    for (one, a), (other, b) in combinations(spans, 2):
        if shapely.intersection(a.buffer(ON), b).length > ON:
            message = f"the {one['kind']} and the {other['kind']} lie over one another"
            yield DraftFault(message, [one["at"], other["at"]], (one["id"], other["id"]))


def find_street_faults(draft: Json) -> Iterator[DraftFault]:
    """Streets that lead past everything that is drawn."""
    rows = [*draft["rooms"], *draft["buildings"]]
    borders = [shapely.LinearRing(row["outline"]) for row in rows]
    places = shapely.MultiLineString(borders)
    for row in draft["streets"]:
        line = shapely.LineString(row["line"])
        if draft["rooms"] and not row.get("of") and line.distance(places) >= ABOUT:
            middle = line.interpolate(0.5, normalized=True)
            message = f"a street is {line.distance(places):.0f} m away from all that is drawn"
            yield DraftFault(message, [[middle.x, middle.y]], (row["id"],), warns=True)


def _place(draft: Json, error: InputError) -> DraftFault:
    """A fault of the brief, at the outline or street that it names."""
    message = f"{error.fault}; {error.remedy}" if error.remedy else error.fault
    named = {FORMS[draft["domain"]].under: "rooms", "lanes": "streets", "buildings": "buildings"}
    for name, number in re.findall(r"(\w+)\[(\d+)\]", error.place or ""):
        group = named.get(name)
        if group and int(number) < len(draft[group]):
            row = draft[group][int(number)]
            what = f"{row['name']}: {message}" if row["name"] else message
            points = row["outline"] if "outline" in row else [row["line"][0]]
            return DraftFault(what, points, (row["id"],), level=row["level"])
    return DraftFault(message, [], ())


def _flight(row: Json) -> shapely.LineString:
    (x, y), heading = row["at"], row["heading"]
    head = (x + FLIGHT * math.cos(heading), y + FLIGHT * math.sin(heading))
    return shapely.LineString([(x, y), head])


def _ring(shape: shapely.Geometry) -> list[list[float]]:
    parts = shapely.get_parts(shape)
    largest = max(parts, key=lambda part: float(part.area))
    ring: list[list[float]] = shapely.get_coordinates(largest).round(3).tolist()
    return ring
