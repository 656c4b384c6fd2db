"""A plan drawn on the page: rooms by the middle lines of their walls, openings on these, columns.

A draft is plain JSON and may be faulty (:mod:`.draft_faults` says where); every act makes another
one. Rooms that share a wall have their corners on the same line: what is moved takes along every
corner that lies there, so the rooms stay joined.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.formats import brief_json
from scenewright.studio.shapes import Json

FORMAT = "scenewright/draft"
SAME = 1e-6
"""Metres within which two corners are one."""
REACH = 0.6
"""Metres from a wall within which an opening is put on it."""
SHORTEST = 0.05
"""Metres that a wall or an opening has at least."""
MOST, FARTHEST = 200, 2000.0
"""Rooms, openings and corners of one at most; metres from the origin."""
SIZES = {"door": 0.9, "passage": 1.2, "window": 1.4}
"""Usual widths of openings, metres."""


def new_draft(name: str = "New plan") -> Json:
    """An empty draft."""
    walls = {"wall_thickness": 0.12, "outer_wall_thickness": 0.3}
    return {"format": FORMAT, "name": name, **walls, "rooms": [], "openings": [], "columns": []}


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
    outline = _points(asked.get("outline"))
    if len(outline) < 3 or len(draft["rooms"]) >= MOST:
        raise InputError(f"a room has 3 to {MOST} corners", "draw it around")
    x, y = np.transpose(outline)
    if float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) < 0:
        outline.reverse()
    number = _fresh(draft, "room")
    name = str(asked.get("name") or f"Room {number}")[:100]
    draft["rooms"].append({"id": f"room-{number}", "name": name, "outline": outline})
    return f"drew {name}"


def _opening(draft: Json, asked: Mapping[str, Any]) -> str:
    kind = str(asked.get("kind"))
    if kind not in SIZES or len(draft["openings"]) >= MOST:
        raise InputError(f"{kind!r} is no opening", f"use {', '.join(SIZES)}")
    at = _on_wall(draft, _point(asked.get("at")))
    number = _fresh(draft, kind)
    row: Json = {"id": f"{kind}-{number}", "kind": kind, "at": at, "width": SIZES[kind]}
    more: dict[str, Json] = {"door": {"hinge": "left", "swing": "in"}, "window": {"sill": 0.9}}
    draft["openings"].append(row | more.get(kind, {}))
    return f"put in a {kind}"


def _column(draft: Json, asked: Mapping[str, Any]) -> str:
    if len(draft["columns"]) >= MOST:
        raise InputError(f"at most {MOST} columns", "leave some out")
    number = _fresh(draft, "column")
    row = {"id": f"column-{number}", "at": _point(asked.get("at")), "size": 0.4}
    draft["columns"].append(row)
    return "put in a column"


def _move(draft: Json, asked: Mapping[str, Any]) -> str:
    """Move corners or a wall, with all that lies there; a wall takes along those in one line
    with it that it is joined to."""
    points, (dx, dy) = _points(asked.get("points")), _point(asked.get("by"))
    points = _prolong(draft, points) if len(points) == 2 else points
    held = [(row, *nearest_edge(draft, row["at"])) for row in draft["openings"]]
    for room in draft["rooms"]:
        room["outline"] = [
            _rounded((x + dx, y + dy)) if _lies_on((x, y), points) else [x, y]
            for x, y in room["outline"]
        ]
    for row, far, edge, share in held:
        if far <= REACH and edge is not None:
            outline, k = draft["rooms"][edge[0]]["outline"], edge[1]
            a, b = np.array(outline[k]), np.array(outline[(k + 1) % len(outline)])
            row["at"] = _rounded(a + share * (b - a))
    return "moved a wall" if len(points) == 2 else "moved a corner" if len(points) == 1 else "moved"


def _length(draft: Json, asked: Mapping[str, Any]) -> str:
    """Give an edge of a room a length: the wall at its end moves along it."""
    room = _find(draft, "rooms", asked)
    k, metres = asked.get("edge"), asked.get("metres")
    outline = room["outline"]
    if not isinstance(k, int) or not 0 <= k < len(outline):
        raise InputError("there is no such wall", "choose what is drawn")
    wanted, n = _length_of(metres), len(outline)
    a, b, c = (np.array(outline[(k + step) % n]) for step in range(3))
    long = float(np.hypot(*(b - a)))
    by = _rounded((b - a) / max(long, SAME) * (wanted - long))
    _move(draft, {"points": [b.tolist(), c.tolist()], "by": by})
    return f"made a wall {wanted:g} m long"


def _set(draft: Json, asked: Mapping[str, Any]) -> str:
    key, value = str(asked.get("key")), asked.get("value")
    if key in ("name", "wall_thickness", "outer_wall_thickness") and not asked.get("id"):
        draft[key] = str(value)[:100] if key == "name" else _length_of(value)
        return f"changed {key.replace('_', ' ')}"
    for group, keys in KEYS.items():
        for row in draft[group]:
            if row["id"] == asked.get("id") and key in keys:
                row[key] = keys[key](draft, value)
                return f"changed {key} of {row.get('name', row['id'])}"
    raise InputError(f"{key} of {asked.get('id')!r} cannot be set", "choose what is drawn")


def _remove(draft: Json, asked: Mapping[str, Any]) -> str:
    for group in KEYS:
        for row in draft[group]:
            if row["id"] == asked.get("id"):
                draft[group].remove(row)
                return f"removed {row.get('name', row['id'])}"
    raise InputError(f"there is no {asked.get('id')!r}", "choose what is drawn")


def _text(_draft: Json, value: Any) -> str:
    return str(value)[:100]


def _metres(_draft: Json, value: Any) -> float:
    return _length_of(value)


def _one_of(*words: str) -> Callable[[Json, Any], Any]:
    def chosen(_draft: Json, value: Any) -> Any:
        if value not in words:
            raise InputError(f"{value!r} cannot be", f"use {', '.join(words)}")
        return value

    return chosen


KEYS: Mapping[str, Mapping[str, Callable[[Json, Any], Any]]] = {
    "rooms": {"name": _text},
    "openings": {
        "width": _metres,
        "hinge": _one_of("left", "right"),
        "swing": _one_of("in", "out", "slide"),
        "sill": _metres,
        "at": lambda draft, value: _on_wall(draft, _point(value)),
    },
    "columns": {"size": _metres, "at": lambda _draft, value: _point(value)},
}
"""What can be set of each kind of thing, and how a value is read."""
ACTS: Mapping[str, Callable[[Json, Mapping[str, Any]], str]] = {
    "room": _room,
    "opening": _opening,
    "column": _column,
    "move": _move,
    "length": _length,
    "set": _set,
    "remove": _remove,
}


def brief_of(draft: Json) -> Brief:
    """The brief of a home that a draft means; InputError where it means none."""
    rooms: list[Json] = [
        {**room, "doors": [], "windows": [], "holes": []} for room in draft["rooms"]
    ]
    for row in draft["openings"]:
        _, edge, _ = nearest_edge(draft, row["at"])
        if edge is not None:
            rooms[edge[0]]["windows" if row["kind"] == "window" else "doors"].append(_asked(row))
    for column in draft["columns"]:
        (x, y), half = column["at"], column["size"] / 2
        ring = [
            [x - half, y - half],
            [x + half, y - half],
            [x + half, y + half],
            [x - half, y + half],
        ]
        for room in rooms:
            if _holds(room["outline"], x, y):
                room["holes"].append(ring)
    keys = ("name", "wall_thickness", "outer_wall_thickness")
    document = {key: draft[key] for key in keys} | {"outlines": "centre", "rooms": rooms}
    return brief_json.loads(json.dumps(document))


def _asked(row: Json) -> Json:
    keys = ("id", "at", "width", "hinge", "swing", "sill")
    kept: Json = {key: row[key] for key in keys if key in row}
    return kept | ({"swing": "none"} if row["kind"] == "passage" else {})


def nearest_edge(draft: Json, at: list[float]) -> tuple[float, tuple[int, int] | None, float]:
    """How far a point is from the nearest wall, whose it is (room, edge), and where along it."""
    best: tuple[float, tuple[int, int] | None, float] = (math.inf, None, 0.0)
    p = np.array(at)
    for number, room in enumerate(draft["rooms"]):
        corners = np.array(room["outline"])
        for k, (a, b) in enumerate(zip(corners, np.roll(corners, -1, axis=0), strict=True)):
            along = b - a
            share = float(np.clip((p - a) @ along / max(float(along @ along), SAME), 0, 1))
            far = float(np.hypot(*(p - a - share * along)))
            if far < best[0] - SAME:
                best = (far, (number, k), share)
    return best


def _on_wall(draft: Json, at: list[float]) -> list[float]:
    far, edge, share = nearest_edge(draft, at)
    if edge is None or far > REACH:
        raise InputError("no wall is there", "choose a place on a wall")
    outline = draft["rooms"][edge[0]]["outline"]
    a, b = np.array(outline[edge[1]]), np.array(outline[(edge[1] + 1) % len(outline)])
    return _rounded(a + share * (b - a))


def _prolong(draft: Json, ends: list[list[float]]) -> list[list[float]]:
    """The ends of a wall with the walls in one line with it that it is joined to.

    >>> outline = [[0, 0], [2, 0], [2, 2], [0, 2]]
    >>> beside = [[2, 0], [5, 0], [5, 2], [2, 2]]
    >>> rooms = {"rooms": [{"outline": outline}, {"outline": beside}]}
    >>> _prolong(rooms, [[0, 0], [2, 0]])
    [[0.0, 0.0], [5.0, 0.0]]
    """
    a, b = np.array(ends, float)
    long = float(np.hypot(*(b - a)))
    along = (b - a) / max(long, SAME)
    spans = []
    for room in draft["rooms"]:
        corners = np.array(room["outline"], float) - a
        off, part = corners @ np.array([-along[1], along[0]]), corners @ along
        on = (abs(off) < SAME) & (abs(np.roll(off, -1)) < SAME)
        spans += np.sort(np.stack([part, np.roll(part, -1)], 1)[on], axis=1).tolist()
    low, high = 0.0, long
    for _ in spans:
        touching = [s for s in spans if s[0] <= high + SAME and s[1] >= low - SAME]
        low = min(low, *(s[0] for s in touching))
        high = max(high, *(s[1] for s in touching))
    return [_rounded(a + low * along), _rounded(a + high * along)]


def _lies_on(at: tuple[float, float], points: list[list[float]]) -> bool:
    """Whether a corner is one of some points, or lies between two of a wall."""
    if any(math.dist(at, point) < SAME for point in points):
        return True
    if len(points) != 2:
        return False
    a, b = points
    return abs(math.dist(a, at) + math.dist(at, b) - math.dist(a, b)) < SAME


def _holds(outline: list[list[float]], x: float, y: float) -> bool:
    inside = False
    for (ax, ay), (bx, by) in zip(outline, [*outline[1:], outline[0]], strict=True):
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
            inside = not inside
    return inside


def _find(draft: Json, group: str, asked: Mapping[str, Any]) -> Json:
    for row in draft[group]:
        if row["id"] == asked.get("id"):
            found: Json = row
            return found
    raise InputError(f"there is no {asked.get('id')!r}", "choose what is drawn")


def _fresh(draft: Json, kind: str) -> int:
    """A number that no thing of a kind has."""
    taken = {row["id"] for group in KEYS for row in draft[group]}
    return next(n for n in range(1, 3 * MOST + 2) if f"{kind}-{n}" not in taken)


def _number(value: Any) -> float:
    """A number of metres; NaN for what is none."""
    plain = isinstance(value, int | float) and not isinstance(value, bool)
    return float(value) if plain and abs(value) <= FARTHEST else math.nan


def _length_of(value: Any) -> float:
    number = _number(value)
    if not number >= SHORTEST:
        raise InputError(f"{value!r} is no length", "type metres, such as 3.6")
    return number


def _point(value: Any) -> list[float]:
    found = [_number(one) for one in value] if isinstance(value, list) else []
    if len(found) != 2 or not all(math.isfinite(number) for number in found):
        raise InputError("is no place on the plan", "give [x, y] in metres")
    return _rounded(found)


def _points(value: Any) -> list[list[float]]:
    if not isinstance(value, list) or not 1 <= len(value) <= MOST:
        raise InputError("is no list of places", "give [[x, y], ...] in metres")
    return [_point(one) for one in value]


def _rounded(point: Any) -> list[float]:
    return [round(float(number), 4) for number in point]
