"""The kitchens of Raster-to-Vector plans that only their cooking counter names.

Of 1,005 plans 193 have no room labelled "kitchen" but an icon of a cooking counter, mostly in a
living room that is cooked in as well.
"""

from __future__ import annotations

from typing import Any

import shapely

COUNTER = "cooking_counter"


def name_kitchens(raw: dict[str, Any]) -> dict[str, Any]:
    """The plan with "kitchen" among the labels of each room that holds the middle of a cooking
    counter (or is nearest to it); a plan that names a kitchen already is returned as it is."""
    rooms = raw["rooms"]
    if any("kitchen" in room["labels"] for room in rooms):
        return raw
    cooks = {_nearest_room(icon["box"], rooms) for icon in raw["icons"] if icon["kind"] == COUNTER}
    named = [
        room | {"labels": [*room["labels"], "kitchen"]} if number in cooks else room
        for number, room in enumerate(rooms)
    ]
    return raw | {"rooms": named}


def _nearest_room(box: list[float], rooms: list[dict[str, Any]]) -> int:
    middle = shapely.Point((box[0] + box[2]) / 2, (box[1] + box[3]) / 2)
    far = [shapely.Polygon(room["polygon"]).distance(middle) for room in rooms]
    return far.index(min(far))
