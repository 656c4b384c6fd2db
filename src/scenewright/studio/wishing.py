"""What a place is asked for: wishes of rooms, demands of halls, buildings of sites, and numbers of
each. The JSON Schema of its form, and the brief with it."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.domains import domain_of
from scenewright.formats import brief_json
from scenewright.studio.shapes import Json

MOST = 50
"""Rows of a place."""


class Form(NamedTuple):
    """What can be asked of the places of a kind of scene: where the brief lists these (``under``),
    the model of one, the key of their ``rows`` and its model, and other ``keys`` of a place; and
    whether places have ``walls`` with doors, and lie on several ``storeys`` as they are drawn; what
    else a drawing ``needs`` to mean anything."""

    under: str
    place: str
    rows: str = ""
    row: str = ""
    keys: tuple[str, ...] = ()
    walls: bool = False
    storeys: bool = False
    needs: str = ""


NUMBERS = ("floor_area_ratio", "coverage", "height_limit", "setback", "road_setback", "spacing")
FORMS: Mapping[str, Form] = {
    "home": Form("rooms", "Room", "wishes", "WishBrief", walls=True, storeys=True),
    "hall": Form("rooms", "Room", "demands", "Demand", ("theme", "people", "fill"), walls=True),
    "site": Form("sites", "Site", "buildings", "Building", (*NUMBERS, "form")),
    "village": Form("blocks", "VillageBlock", keys=("count", "coverage", "square")),
    "extend": Form("areas", "GrowthArea", keys=("count", "coverage", "storeys"), needs="buildings"),
}
"""By domain; what is none of these asks for nothing on the page."""


@cache
def ask_schema(domain: str) -> Json:
    """The JSON Schemas of one row and of the other keys of a place, each whole in itself, and words
    to choose from.

    >>> schema = ask_schema("hall")
    >>> "category" in schema["row"]["properties"], [*schema["keys"]["properties"]]
    (True, ['theme', 'people', 'fill'])
    """
    form = FORMS.get(domain)
    if form is None:
        raise InputError(f"a {domain} asks for nothing here", "write it in the brief")
    defs = brief_json.schema()["$defs"]
    part = domain_of(domain).part_model()
    if part is not None:
        defs = {**defs, **part.model_json_schema().get("$defs", {})}
    place = defs[form.place]["properties"]
    keys = _whole({"type": "object", "properties": {key: place[key] for key in form.keys}}, defs)
    row = _whole(defs[form.row], defs) if form.row else None
    return {"rows": form.rows, "row": row, "keys": keys, "choices": _choices(domain)}


def _choices(domain: str) -> dict[str, list[str]]:
    """Words that a key is filled in with where its schema names none."""
    whole = domain_of(domain)
    styles = whole.verb("styles")() if whole.has("styles") else []
    return {
        "theme": [*whole.table("themes")],
        "patterns": [*whole.table("patterns")],
        "style": [row["name"] for row in styles],
    }


def _whole(schema: Json, defs: Json) -> Json:
    """A schema with the definitions that it refers to, and these to."""
    kept: Json = {}
    while missing := [*{*re.findall(r"#/\$defs/(\w+)", json.dumps([schema, kept]))} - kept.keys()]:
        kept |= {name: defs[name] for name in missing}
    return {**schema, "$defs": kept}


def list_wishes(brief: Brief) -> dict[str, Json]:
    """What each place of a brief is asked for, by its id."""
    form = FORMS.get(brief.domain)
    if form is None:
        return {}
    wanted = {form.rows, *form.keys}
    return {
        place["id"]: {key: place[key] for key in place if key in wanted}
        for place in json.loads(brief.model_dump_json(exclude_defaults=True)).get(form.under, ())
        if place.get("id")
    }


def with_wishes(brief: Brief, place: str, asked: Any) -> Brief:
    """The brief in which a place is asked for this and nothing else, by key or as the list of its
    rows. InputError for what cannot be."""
    form = FORMS.get(brief.domain)
    document = json.loads(brief.model_dump_json(exclude_unset=True))
    found = [one for one in document.get(form.under, ()) if one.get("id") == place] if form else []
    if form is None or not found:
        raise InputError(f"there is no '{place}' to wish for", "choose one of the plan")
    known = {form.rows, *form.keys} - {""}
    asked = {form.rows: asked} if isinstance(asked, list) and form.rows else asked
    if not isinstance(asked, dict) or not asked.keys() <= known:
        raise InputError("wishes: are none of this plan", f"give {', '.join(sorted(known))}")
    rows = asked.get(form.rows, [])
    if not isinstance(rows, list) or len(rows) > MOST:
        raise InputError(f"{form.rows}: are no list", f"give at most {MOST}")
    kept = {key: value for key, value in found[0].items() if key not in known}
    found[0].clear()
    found[0].update(kept | asked)
    return brief_json.loads(json.dumps(document))
