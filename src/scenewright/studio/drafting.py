"""A plan drawn on the page: rooms by the middle lines of their walls, openings on these, columns,
storeys and stairs; zones of halls; sites or blocks with the streets about them; areas with the
buildings that are continued into them.

A draft is plain JSON and may be faulty (:mod:`.draft_faults` says where); every act makes another
one, and :mod:`.draft_brief` says what it means. What lies at one place is joined: what is moved
takes along every corner that lies there, so rooms stay joined.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from scenewright.core.brief.uses import USES
from scenewright.core.errors import InputError
from scenewright.studio.draft_geometry import (
    MOST,
    REACH,
    SAME,
    Point,
    find_faces,
    is_inner,
    lies_on,
    nearest_edge,
    on_level,
    place_on_wall,
    point_along,
    prolong,
    read_length,
    read_number,
    read_point,
    read_points,
    rounded,
)
from scenewright.studio.shapes import Json
from scenewright.studio.wishing import FORMS

FORMAT = "scenewright/draft"
SIZES = {"door": 0.9, "passage": 1.2, "window": 1.4}
"""Usual widths of openings, metres."""
WIDTHS = {"road": 6.0, "path": 2.5}
"""Usual widths of streets, metres."""
STOREY = 2.6
"""Clear height of a storey, metres."""
HIGH = 7.5
"""Usual height of a building, metres."""
OUTLINED = ("rooms", "zones", "buildings")
GROUPS = (*OUTLINED, "streets", "stairs", "openings", "columns")
NOUNS = {"home": "room", "hall": "hall", "site": "site", "village": "block", "extend": "area"}
"""Kinds of scene that are drawn, and what an outline is in each."""


def new_draft(domain: str = "home", name: str = "New plan") -> Json:
    """An empty draft of one of the kinds of :data:`NOUNS`. InputError for another."""
    _one_of(*NOUNS)({}, {}, domain)
    walls = {"wall_thickness": 0.12, "outer_wall_thickness": 0.3}
    levels = [{"id": "level-1", "name": "", "height": STOREY}]
    head = {"format": FORMAT, "name": name, "domain": domain, "style": "", **walls}
    return {**head, "levels": levels, **{group: [] for group in GROUPS}}


def complete_draft(draft: Json) -> Json:
    """A draft that was kept before there were zones, streets and storeys, with these."""
    whole = {**new_draft(), **draft}
    for group in GROUPS:
        whole[group] = [{"level": "level-1", **row} for row in whole[group]]
    return whole


def keep_asked(draft: Json, asked: Mapping[str, Json]) -> Json:
    """A draft whose rooms, sites or blocks are asked for what is known by their ids; what a hall
    was filled up with where there was room is not asked for."""
    key = FORMS[draft["domain"]].rows

    def kept(room: Json) -> Json:
        known, own = asked.get(room["id"], {}), room.get("asked", {}).get(key, [])
        rows = [row for row in known.get(key, []) if row.get("required", True) or row in own]
        whole = {**known, **({key: rows} if rows else {})}
        return {**room, "asked": whole} if rows or known.keys() - {key} else room

    return {**draft, "rooms": [kept(room) for room in draft["rooms"]]}


def draw_act(draft: Json, asked: Mapping[str, Any]) -> tuple[Json, str]:
    """The draft after an act, and what was done. InputError for what cannot be done.

    >>> square = {"act": "room", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]], "name": "Bedroom"}
    >>> drawn, done = draw_act(new_draft(), square)
    >>> done, drawn["rooms"][0]["id"]
    ('drew Bedroom', 'room-1')
    >>> drawn, _ = draw_act(drawn, {"act": "opening", "kind": "door", "at": [1.0, 0.2]})
    >>> drawn["openings"][0]["at"]
    [1.0, 0.0]
    """
    act = ACTS.get(str(asked.get("act")))
    if act is None:
        raise InputError(f"there is no act {asked.get('act')!r}", f"use {', '.join(ACTS)}")
    copied: Json = json.loads(json.dumps(draft))
    done = act(copied, asked)
    return copied, done


def _room(draft: Json, asked: Mapping[str, Any]) -> str:
    return _put_outline(draft, asked, "rooms", NOUNS[draft["domain"]])


def _zone(draft: Json, asked: Mapping[str, Any]) -> str:
    return _put_outline(draft, asked, "zones", "zone")


def _building(draft: Json, asked: Mapping[str, Any]) -> str:
    done = _put_outline(draft, asked, "buildings", "building")
    draft["buildings"][-1] |= {"height": HIGH, "use": "", "roof": ""}
    return done


def _put_outline(draft: Json, asked: Mapping[str, Any], group: str, noun: str) -> str:
    outline = read_points(asked.get("outline"), 3)
    x, y = np.transpose(outline)
    if float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) < 0:
        outline.reverse()
    row = _put(draft, asked, group, noun, {"outline": outline})
    row["name"] = str(asked.get("name") or _usual_name(row, noun))[:100]
    return f"drew {row['name']}"


def _usual_name(row: Json, noun: str) -> str:
    return f"{noun.capitalize()} {row['id'].split('-')[1]}"


def _street(draft: Json, asked: Mapping[str, Any]) -> str:
    kind, line = str(asked.get("kind") or "road"), read_points(asked.get("line"), 2)
    _one_of(*WIDTHS)(draft, {}, kind)
    row = {"line": line, "kind": kind, "width": WIDTHS[kind], "name": ""}
    _put(draft, asked, "streets", "street", row)
    return "drew a path" if kind == "path" else "drew a street"


def _opening(draft: Json, asked: Mapping[str, Any]) -> str:
    kind = str(asked.get("kind"))
    if kind not in SIZES:
        raise InputError(f"{kind!r} is no opening", f"use {', '.join(SIZES)}")
    at = place_on_wall(draft, read_point(asked.get("at")), _level(draft, asked))
    more: dict[str, Json] = {"door": {"hinge": "left", "swing": "in"}, "window": {"sill": 0.9}}
    row = {"kind": kind, "at": at, "width": SIZES[kind], **more.get(kind, {})}
    _put(draft, asked, "openings", kind, row)
    return f"put in a {kind}"


def _column(draft: Json, asked: Mapping[str, Any]) -> str:
    _put(draft, asked, "columns", "column", {"at": read_point(asked.get("at")), "size": 0.4})
    return "put in a column"


def _stairs(draft: Json, asked: Mapping[str, Any]) -> str:
    at, heading = read_point(asked.get("at")), round(read_number(asked.get("heading", 0)), 4)
    if not math.isfinite(heading):
        raise InputError("the stairs lead nowhere", "give their heading in radians")
    more = {"width": 0.9, "shape": "straight", "turn": "left"}
    _put(draft, asked, "stairs", "stairs", {"at": at, "heading": heading, **more})
    return "put in stairs"


def _storey(draft: Json, asked: Mapping[str, Any]) -> str:
    """One more storey above; with ``copy`` its rooms are those of the storey below."""
    below = draft["levels"][-1]
    if len(draft["levels"]) >= MOST:
        raise InputError(f"at most {MOST} storeys", "leave some out")
    level = {"id": f"level-{_fresh(draft, 'level')}", "name": "", "height": below["height"]}
    draft["levels"].append(level)
    for room in on_level(draft, "rooms", below["id"]) if asked.get("copy") else ():
        _put(draft, {"level": level["id"]}, "rooms", "room", {**room})
    return "drew another storey"


def _put(draft: Json, asked: Mapping[str, Any], group: str, kind: str, row: Json) -> Json:
    """Put a row in a group, with an id and its storey."""
    if len(draft[group]) >= MOST:
        raise InputError(f"at most {MOST} {group}", "leave some out")
    new = {**row, "id": f"{kind}-{_fresh(draft, kind)}", "level": _level(draft, asked)}
    draft[group].append(new)
    return new


def _level(draft: Json, asked: Mapping[str, Any]) -> str:
    """The storey that an act is about: the first, unless it says."""
    level = str(asked.get("level") or draft["levels"][0]["id"])
    if all(one["id"] != level for one in draft["levels"]):
        raise InputError(f"there is no storey {level!r}", "draw it first")
    return level


def _move(draft: Json, asked: Mapping[str, Any]) -> str:
    """Move corners or a wall, with all that lies there on its storey; a wall takes along those in
    one line with it that it is joined to."""
    points, by, level = read_points(asked.get("points")), asked.get("by"), _level(draft, asked)
    dx, dy = read_point(by)
    rows = [("outline", row) for group in OUTLINED for row in on_level(draft, group, level)]
    outlines = [row["outline"] for _, row in rows]
    walls = [points]
    if len(points) == 2:
        walls = find_faces(outlines, points) if is_inner(draft) else [prolong(outlines, points)]
    held = [
        (row, nearest_edge(draft, row["at"], level)) for row in on_level(draft, "openings", level)
    ]
    for key, row in [*rows, *(("line", row) for row in draft["streets"])]:
        row[key] = [
            rounded((x + dx, y + dy)) if any(lies_on([x, y], wall) for wall in walls) else [x, y]
            for x, y in row[key]
        ]
    for row, edge in held:
        if edge.far <= REACH:
            row["at"] = point_along(draft, edge)
    return "moved a wall" if len(points) == 2 else "moved a corner" if len(points) == 1 else "moved"


def _shift(draft: Json, asked: Mapping[str, Any]) -> str:
    """Move one thing alone, whatever it is joined to; with ``copy`` another one like it."""
    row, (dx, dy) = _find(draft, asked), read_point(asked.get("by"))
    groups = [group for group in (*OUTLINED, "streets") if row in draft[group]]
    if not groups:
        raise InputError("this is not moved as a whole", "choose an outline or a street")
    named = row["name"] or row["id"]
    if asked.get("copy"):
        noun = groups[0].removesuffix("s")
        row = _put(draft, {"level": row["level"]}, groups[0], noun, {**row})
        row["name"] = _usual_name(row, noun) if "outline" in row else row["name"]
    key = "line" if "line" in row else "outline"
    row[key] = [rounded((x + dx, y + dy)) for x, y in row[key]]
    return f"{'doubled' if asked.get('copy') else 'moved'} {named}"


def _length(draft: Json, asked: Mapping[str, Any]) -> str:
    """Give a side of an outline a length, or a part of a street: what is at its end moves."""
    row, k = _find(draft, asked), asked.get("edge")
    points: list[Point] = row.get("outline") or row.get("line") or []
    sides = len(points) - ("line" in row)
    if not isinstance(k, int) or not 0 <= k < sides:
        raise InputError("there is no such wall", "choose what is drawn")
    wanted, n = read_length(asked.get("metres")), len(points)
    a, b, c = (np.array(points[(k + step) % n]) for step in range(3))
    by = np.array(rounded((b - a) / max(float(np.hypot(*(b - a))), SAME) * wanted)) - (b - a)
    if "line" in row:
        row["line"] = [*points[: k + 1], *(rounded(by + point) for point in points[k + 1 :])]
        return f"made a street {wanted:g} m long"
    ends = {"points": [b.tolist(), c.tolist()], "by": rounded(by), "level": row["level"]}
    _move(draft, ends)
    return f"made a wall {wanted:g} m long"


def _set(draft: Json, asked: Mapping[str, Any]) -> str:
    key, value = str(asked.get("key")), asked.get("value")
    row, keys = (draft, OWN) if not asked.get("id") else (_find(draft, asked), KEYS_BY_ROW)
    if key not in keys or key not in row:
        raise InputError(f"{key} of {asked.get('id')!r} cannot be set", "choose what is drawn")
    row[key] = keys[key](draft, row, value)
    if key == "name":
        row.pop("function", None)  # of a file that was drawn over: what the new name means holds
    named = f" of {row.get('name') or row['id']}" if row is not draft else ""
    return f"changed {key.replace('_', ' ')}{named}"


def _ask(draft: Json, asked: Mapping[str, Any]) -> str:
    """What a room, hall, site or block is asked for: keys of it in the brief."""
    row, given, form = _find(draft, asked), asked.get("asked"), FORMS[draft["domain"]]
    known = {form.rows, *form.keys} - {""}
    if not isinstance(given, dict) or not given.keys() <= known or row not in draft["rooms"]:
        raise InputError("this cannot be asked for", f"give {', '.join(sorted(known))}")
    row["asked"] = given
    return f"wishes for {row['name']}"


def _remove(draft: Json, asked: Mapping[str, Any]) -> str:
    row = _find(draft, asked)
    if row in draft["levels"]:
        if len(draft["levels"]) < 2:
            raise InputError("a plan has one storey at least", "draw on this one")
        for group in GROUPS:
            draft[group] = [one for one in draft[group] if one["level"] != row["id"]]
    for group in ("levels", *GROUPS):
        draft[group] = [one for one in draft[group] if one is not row]
    for street in draft["streets"]:
        if row["id"] in street.get("of", ()):
            street["of"] = [place for place in street["of"] if place != row["id"]]
            if not street["of"]:
                del street["of"]
    return f"removed {row.get('name') or row['id']}"


def _text(_draft: Json, _row: Json, value: Any) -> str:
    return str(value)[:100]


def _metres(_draft: Json, _row: Json, value: Any) -> float:
    return read_length(value)


def _one_of(*words: str) -> Callable[[Json, Json, Any], Any]:
    def chosen(_draft: Json, _row: Json, value: Any) -> Any:
        if value not in words:
            raise InputError(f"{value!r} cannot be", f"use {', '.join(words)}")
        return value

    return chosen


def _place(draft: Json, row: Json, value: Any) -> Point:
    at = read_point(value)
    return place_on_wall(draft, at, row["level"]) if row in draft["openings"] else at


def _turned(_draft: Json, _row: Json, value: Any) -> float:
    return round(math.remainder(read_number(value), math.tau), 4)


OWN: Mapping[str, Callable[[Json, Json, Any], Any]] = {
    "name": _text,
    "style": _text,
    "wall_thickness": _metres,
    "outer_wall_thickness": _metres,
}
KEYS_BY_ROW: Mapping[str, Callable[[Json, Json, Any], Any]] = {
    "name": _text,
    "height": _metres,
    "width": _metres,
    "size": _metres,
    "sill": _metres,
    "hinge": _one_of("left", "right"),
    "swing": _one_of("in", "out", "slide"),
    "kind": _one_of(*WIDTHS),
    "shape": _one_of("straight", "quarter", "half", "spiral"),
    "turn": _one_of("left", "right"),
    "heading": _turned,
    "use": _one_of("", *USES),
    "roof": _one_of("", "gabled", "hipped", "flat"),
    "at": _place,
}
"""What can be set of the plan and of what is drawn on it, and how a value is read."""
ACTS: Mapping[str, Callable[[Json, Mapping[str, Any]], str]] = {
    "room": _room,
    "zone": _zone,
    "building": _building,
    "street": _street,
    "opening": _opening,
    "column": _column,
    "stairs": _stairs,
    "storey": _storey,
    "move": _move,
    "shift": _shift,
    "length": _length,
    "set": _set,
    "ask": _ask,
    "remove": _remove,
}


def _find(draft: Json, asked: Mapping[str, Any]) -> Json:
    for group in ("levels", *GROUPS):
        for row in draft[group]:
            if row["id"] == asked.get("id"):
                found: Json = row
                return found
    raise InputError(f"there is no {asked.get('id')!r}", "choose what is drawn")


def _fresh(draft: Json, kind: str) -> int:
    """A number that nothing of a kind has."""
    taken = {row["id"] for group in ("levels", *GROUPS) for row in draft[group]}
    return next(n for n in range(1, 3 * MOST + 2) if f"{kind}-{n}" not in taken)
