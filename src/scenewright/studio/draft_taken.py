"""A plan that was brought, taken over into a drawing: what :mod:`.draft_brief` means by it
is that brief again, except for what is listed as lost.

Its outlines stay what they were in the file, of rooms inner faces of walls or their
middles. Of a row of the brief the drawing changes the keys it knows; all others are kept.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping

import numpy as np

from scenewright.building.plan import plan_rooms
from scenewright.core.brief import Brief, Door, Window
from scenewright.core.errors import InputError
from scenewright.studio.draft_geometry import MOST, SAME, Point, close_edge, rounded
from scenewright.studio.drafting import GROUPS, NOUNS, STOREY, new_draft
from scenewright.studio.shapes import Json
from scenewright.studio.wishing import FORMS

DRAWN = frozenset({"format", "version", "rooms", "levels", "stairs"})
"""Keys of a brief that the drawing has rows of, or itself."""
LOST = {
    "walls": "walls that are drawn for themselves: walls follow the rooms now",
    "source_file": "the file it came from: results cannot be written back into that",
}
"""Keys of a brief that a drawing cannot hold, and how that is told."""
LEAF = {key: Door.model_fields[key].default for key in ("width", "hinge", "swing")}
PANE = {key: Window.model_fields[key].default for key in ("width", "sill")}
OPENINGS = {"door": LEAF, "passage": {"width": LEAF["width"]}, "window": PANE}
"""What openings are that do not say."""


def draft_of(brief: Brief) -> Json:
    """The drawing of a brief of :data:`TAKEN`, ``lost`` with what it cannot hold, by name.
    InputError for another brief, and for a hall of several storeys.

    >>> from scenewright.formats import read
    >>> draft = draft_of(read("sample:home-room"))
    >>> [room["name"] for room in draft["rooms"]], [one["kind"] for one in draft["openings"]]
    (['Room'], ['door', 'window'])
    """
    document: Json = json.loads(brief.model_dump_json(exclude_unset=True))
    take = TAKEN.get(brief.domain)
    if take is None:
        raise InputError(f"a {brief.domain} that was brought cannot be drawn over", "begin a plan")
    draft = new_draft(brief.domain, brief.name) | {"style": brief.style}
    drawn = {*DRAWN, *LOST, FORMS[brief.domain].under, "lanes", "sources"}
    draft["kept"] = {key: row for key, row in document.items() if key not in {*drawn, *draft}}
    draft["lost"] = [text for key, text in LOST.items() if document.get(key)]
    take(draft, document, brief)
    noun = NOUNS[brief.domain]
    for group, name in (("rooms", f"{noun}s"), ("streets", "streets"), ("buildings", "buildings")):
        if len(draft[group]) > MOST:
            raise InputError(f"more than {MOST} {name} cannot be drawn over", "change its file")
    return draft


def _take_rooms(draft: Json, document: Json, brief: Brief) -> None:
    levels = [*_levels(document.get("levels", []))]
    if len(levels) > 1 and not FORMS[brief.domain].storeys:
        fault = f"a {brief.domain} of several storeys cannot be drawn over"
        raise InputError(fault, "bring its file changed")
    draft |= {key: getattr(brief, key) for key in ("wall_thickness", "outer_wall_thickness")}
    draft["levels"], draft["kept"]["outlines"] = levels, brief.outlines
    for room, space in zip(document["rooms"], plan_rooms(brief).spaces, strict=True):
        _take_room(draft, {**room, "id": space.id, "level": room.get("level") or levels[0]["id"]})
    for row in document.get("stairs", []):
        _put(draft, "stairs", {"width": 0.9, "shape": "straight", "turn": "left", **row})


def _take_ground(draft: Json, document: Json, brief: Brief) -> None:
    """Sites, blocks and areas with their streets, each once and ``of`` those whose it is; what else
    is on a site stays where it is."""
    form, whole = FORMS[brief.domain], json.loads(brief.model_dump_json())
    streets: dict[str, Json] = {json.dumps(lane): lane for lane in whole.get("lanes", ())}
    for number, (place, full) in enumerate(
        zip(document[form.under], whole[form.under], strict=True), 1
    ):
        place = {key: row for key, row in place.items() if key != "roads"}
        asked = {key: place.pop(key) for key in (form.rows, *form.keys) if place.get(key)}
        outline = [rounded(point) for point in place["outline"]]
        if _is_clockwise(outline):
            _turn_edges(place, len(outline))
            outline.reverse()
        usual = f"{NOUNS[brief.domain]}-{number}"
        known = {"id": place.get("id") or usual, "outline": outline}
        row = _put(draft, "rooms", {**place, **known})
        row |= {"name": place.get("name") or row["id"], **({"asked": asked} if asked else {})}
        for road in full.get("roads", ()):
            streets.setdefault(json.dumps(road), {**road, "of": []})["of"].append(row["id"])
    for street in streets.values():
        _put(draft, "streets", street)


def _take_growth(draft: Json, document: Json, brief: Brief) -> None:
    """Areas as other ground, with the streets and buildings of the one source."""
    whole = json.loads(brief.model_dump_json())
    (source, *others), rows = whole["sources"], document["sources"][0]
    if others or source.get("path"):
        fault = "an extension of a file, or of several sources, cannot be drawn over"
        raise InputError(fault, "bring one whose buildings are listed in it")
    _take_ground(draft, document, brief)
    draft["kept"]["source"] = {key: rows[key] for key in rows if key not in {"buildings", "roads"}}
    for street in source["roads"]:
        _put(draft, "streets", {**street, "of": []})
    for number, row in enumerate(source["buildings"], 1):
        outline = [rounded(point) for point in row["outline"]]
        outline = outline[::-1] if _is_clockwise(outline) else outline
        known = {"outline": outline, "name": row["name"] or f"Building {number}"}
        known |= {key: row.get(key) or "" for key in ("use", "roof")}
        _put(draft, "buildings", {**row, **known})
    if any(row["name"] for row in source["buildings"]):
        draft["lost"].append("names of the buildings that stand")


TAKEN: Mapping[str, Callable[[Json, Json, Brief], None]] = {
    "home": _take_rooms,
    "hall": _take_rooms,
    "site": _take_ground,
    "village": _take_ground,
    "extend": _take_growth,
}
"""Kinds of scene that are drawn over when they were brought."""


def _levels(rows: list[Json]) -> Iterator[Json]:
    """Storeys, each with the thickness of what lies above it; the first with its elevation."""
    rows = rows or [{"id": "level-1"}]
    for row, above in zip(rows, [*rows[1:], None], strict=True):
        one = {"name": "", "height": STOREY, **row}
        if above is not None:
            far = above.get("elevation", 0.0) - one.get("elevation", 0.0)
            one["slab"] = round(far - one["height"], 4)
        yield one


def _take_room(draft: Json, room: Json) -> None:
    """Put a room with its openings, columns and zones into a drawing."""
    form = FORMS[draft["domain"]]
    outline = [rounded(point) for point in room.pop("outline")]
    name = room.pop("name", "") or room["id"]
    holes, zones = room.pop("holes", []), room.pop("zones", [])
    openings = [(one, _kind(one)) for one in room.pop("doors", [])]
    openings += [(one, "window") for one in room.pop("windows", [])]
    asked = {key: room.pop(key) for key in (form.rows, *form.keys) if room.get(key)}
    turned = _is_clockwise(outline)
    if turned and ("slopes" in room or "main_wall" in room):
        _turn_edges(room, len(outline))
    outline = outline[::-1] if turned else outline
    row = _put(draft, "rooms", {**room, "name": name, "outline": outline})
    row |= {"asked": asked} if asked else {}
    for one, kind in openings:
        at = close_edge(outline, one["at"])
        _put(
            draft,
            "openings",
            {**OPENINGS[kind], **one, "kind": kind, "at": at, "level": row["level"]},
        )
    for hole in holes:
        _take_hole(draft, row, hole)
    for zone in zones:
        _take_zone(draft, row, zone)


def _take_zone(draft: Json, room: Json, zone: Json) -> None:
    """A zone with an outline is drawn; one whose place is proposed stays so."""
    if "outline" in zone:
        outline = [rounded(point) for point in zone["outline"]]
        outline = outline[::-1] if _is_clockwise(outline) else outline
        more = {"name": zone.get("name") or zone["id"], "level": room["level"]}
        new = _put(draft, "zones", {**zone, **more, "outline": outline})
        if new["id"] != zone["id"]:
            draft["lost"].append(f"links of {zone['id']}: two zones have this id")
    else:
        room.setdefault("proposed", []).append(zone)


def _take_hole(draft: Json, room: Json, hole: list[Point]) -> None:
    """A square hole along the axes is a column that can be moved; another one stays in its room."""
    corners = np.array(hole, float)
    low, high = corners.min(axis=0), corners.max(axis=0)
    wide, deep = high - low
    square = len(hole) == 4 and abs(wide - deep) < 1e-3
    if square and bool(np.all(np.minimum(abs(corners - low), abs(high - corners)) < SAME)):
        at, size = rounded((low + high) / 2), round(float(wide), 4)
        _put(draft, "columns", {"at": at, "size": size, "level": room["level"]})
        return
    room.setdefault("holes", []).append(hole)
    told = f"a column of {room['name']} that is no square along the axes: it stays where it is"
    draft["lost"] += [told] if told not in draft["lost"] else []


def _put(draft: Json, group: str, row: Json) -> Json:
    """Add a row with an id that nothing drawn has, and a storey."""
    taken = {one["id"] for key in ("levels", *GROUPS) for one in draft[key]}
    noun = row.get("kind") or group.removesuffix("s")
    wanted = row.get("id") or f"{noun}-1"
    names = (wanted, *(f"{noun}-{n}" for n in range(1, len(taken) + 2)))
    new = {**row, "id": next(name for name in names if name not in taken)}
    new["level"] = row.get("level") or draft["levels"][0]["id"]
    draft[group].append(new)
    return new


def _kind(door: Json) -> str:
    return "passage" if door.get("swing") == "none" else "door"


def _is_clockwise(outline: list[Point]) -> bool:
    x, y = np.transpose(outline)
    return float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) < 0


def _turn_edges(room: Json, sides: int) -> None:
    """Name edges of an outline of so many sides by their numbers once it is turned round."""
    if room.get("main_wall") is not None:
        room["main_wall"] = (sides - 2 - room["main_wall"]) % sides
    for slope in room.get("slopes", []):
        slope["edge"] = (sides - 2 - slope["edge"]) % sides
    if room.get("streets"):
        room["streets"] = [(sides - 2 - side) % sides for side in room["streets"]]
