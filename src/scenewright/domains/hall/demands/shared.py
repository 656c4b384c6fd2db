"""Rooms with ``like`` hold what another room does; :mod:`..alike` lays them out."""

from __future__ import annotations

from scenewright.building.plan import place, room_ids
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError


def find_models(brief: Brief) -> dict[int, int]:
    """Which room each room with ``like`` is like, by number; InputError where it cannot be."""
    ids = room_ids(brief)
    found = {}
    for number, room in enumerate(brief.rooms):
        if room.like is None:
            continue
        where = place(brief, number, "like")
        if room.like not in ids or room.like == ids[number]:
            others = ", ".join(name for k, name in enumerate(ids) if k != number)
            fault = f"'{room.like}' is not the id of another room"
            raise InputError(fault, f"use one of: {others}", place=where)
        model = ids.index(room.like)
        if brief.rooms[model].like is not None:
            fault = f"'{room.like}' is itself like another room"
            raise InputError(fault, f"say like '{brief.rooms[model].like}'", place=where)
        found[number] = model
    return found


def share_demands(brief: Brief) -> Brief:
    """A brief whose rooms with ``like`` that ask for nothing ask for what the other does, in zones
    they do not draw."""
    models = find_models(brief)
    if not models:
        return brief
    rooms = list(brief.rooms)
    for number, model in models.items():
        other = brief.rooms[model]
        if rooms[number].demands:
            continue
        zones = [zone.model_copy(update={"outline": None, "door": None}) for zone in other.zones]
        same = {"demands": other.demands, "theme": other.theme, "fill": other.fill}
        rooms[number] = rooms[number].model_copy(
            update=same | {"zones": rooms[number].zones or zones}
        )
    return brief.model_copy(update={"rooms": rooms})
