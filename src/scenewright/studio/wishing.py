"""Wishes and demands of a room: the JSON Schema of their form, and the brief with them."""

from __future__ import annotations

import json
from functools import cache
from typing import Any

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.formats import brief_json
from scenewright.studio.shapes import Json

MOST = 50
"""Wishes of a room."""


@cache
def wish_schema() -> Json:
    """The JSON Schema of one wish, whole in itself.

    >>> "forbid" in wish_schema()["properties"]
    True
    """
    whole = brief_json.schema()
    schema: Json = whole["$defs"]["WishBrief"]
    return schema | {"$defs": whole["$defs"]}


def list_wishes(brief: Brief) -> dict[str, list[Json]]:
    """The wishes of each room that can have some, by its id."""
    return {
        str(room.id): [json.loads(wish.model_dump_json(exclude_defaults=True)) for wish in wishes]
        for room in getattr(brief, "rooms", ())
        if (wishes := getattr(room, "wishes", None)) is not None
    }


def with_wishes(brief: Brief, room: str, wishes: Any) -> Brief:
    """The brief in which a room has these wishes and no others. InputError for what cannot be."""
    if not isinstance(wishes, list) or len(wishes) > MOST:
        raise InputError("wishes: are no list", f"give at most {MOST}")
    document = json.loads(brief.model_dump_json(exclude_unset=True))
    found = [one for one in document.get("rooms", ()) if one.get("id") == room]
    if not found or room not in list_wishes(brief):
        raise InputError(f"there is no room '{room}' to wish for", "choose one of the plan")
    found[0]["wishes"] = wishes
    return brief_json.loads(json.dumps(document))
