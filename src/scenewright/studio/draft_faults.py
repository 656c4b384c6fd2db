"""What is wrong with a drawn plan, all of it at once and each where it lies."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import combinations
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.domains import plan_of
from scenewright.studio.drafting import brief_of, nearest_edge
from scenewright.studio.shapes import Json

ON = 0.02
"""Metres from a wall within which an opening lies on it."""
OVERLAP = 0.01
"""Square metres from which rooms overlap."""
SMALL = 0.5
"""Square metres that a room has at least."""


class DraftFault(NamedTuple):
    """What is wrong, at which places (a point, or a ring) and of which things; one that only
    ``warns`` keeps nothing from being arranged."""

    message: str
    points: list[list[float]]
    ids: tuple[str, ...]
    warns: bool = False


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
    faults = [*find_room_faults(draft), *find_opening_faults(draft)]
    if not draft["rooms"]:
        return ReadDraft(None, None, faults)
    if not any(not fault.warns for fault in faults):
        try:
            brief = brief_of(draft)
            return ReadDraft(brief, plan_of(brief), faults)
        except InputError as error:
            faults.append(_place(draft, error))
    return ReadDraft(None, None, faults)


def find_room_faults(draft: Json) -> Iterator[DraftFault]:
    """Rooms that cross themselves, are too small, overlap, or are not led into."""
    sound = {}
    for room in draft["rooms"]:
        shape = shapely.Polygon(room["outline"])
        if not shape.is_valid:
            message = f"the walls of {room['name']} cross each other"
            yield DraftFault(message, room["outline"], (room["id"],))
        elif shape.area < SMALL:
            message = f"{room['name']} has only {shape.area:.2f} m²"
            yield DraftFault(message, room["outline"], (room["id"],))
        else:
            sound[room["id"]] = (room["name"], shape)
    for (one, (name, a)), (other, (name_b, b)) in combinations(sound.items(), 2):
        common = shapely.intersection(a, b)
        if common.area > OVERLAP:
            message = f"{name} and {name_b} overlap by {common.area:.2f} m²"
            yield DraftFault(message, _ring(common), (one, other))
    doors = [shapely.Point(o["at"]) for o in draft["openings"] if o["kind"] != "window"]
    for number, (name, shape) in sound.items():
        if not any(shape.boundary.distance(door) < ON for door in doors):
            spot = shape.representative_point()
            message = f"no door leads into {name}"
            yield DraftFault(message, [[spot.x, spot.y]], (number,), warns=True)


def find_opening_faults(draft: Json) -> Iterator[DraftFault]:
    """Openings on no wall, wider than it, or over one another; columns in no room."""
    spans = []
    for row in draft["openings"]:
        far, edge, share = nearest_edge(draft, row["at"])
        if edge is None or far > ON:
            message = f"the {row['kind']} stands in no wall"
            yield DraftFault(message, [row["at"]], (row["id"],))
            continue
        outline = draft["rooms"][edge[0]]["outline"]
        a, b = np.array(outline[edge[1]]), np.array(outline[(edge[1] + 1) % len(outline)])
        length = float(np.hypot(*(b - a)))
        reach = min(share, 1 - share) * length
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
    rooms = [shapely.Polygon(room["outline"]) for room in draft["rooms"]]
    for column in draft["columns"]:
        if not any(room.contains(shapely.Point(column["at"])) for room in rooms):
            yield DraftFault("the column stands in no room", [column["at"]], (column["id"],))


def _place(draft: Json, error: InputError) -> DraftFault:
    """A fault of the brief, at the room that it names."""
    found = re.match(r"rooms\[(\d+)\]", error.place or "")
    message = f"{error.fault}; {error.remedy}" if error.remedy else error.fault
    if found and int(found[1]) < len(draft["rooms"]):
        room = draft["rooms"][int(found[1])]
        return DraftFault(f"{room['name']}: {message}", room["outline"], (room["id"],))
    return DraftFault(message, [], ())


def _ring(shape: shapely.Geometry) -> list[list[float]]:
    parts = shapely.get_parts(shape)
    largest = max(parts, key=lambda part: float(part.area))
    ring: list[list[float]] = shapely.get_coordinates(largest).round(3).tolist()
    return ring
