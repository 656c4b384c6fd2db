"""Real flats: the plans of Raster-to-Vector (Liu, Wu, Kohli, Furukawa 2017) as briefs.

The data are polygonised middle lines of walls, so rooms touch; openings are segments whose kind
is only guessed. This adapter cleans them and decides what is a door, a window or a passage; it
places nothing.
"""

from __future__ import annotations

import json
import re
from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from benchmarks.real_data import data_set
from scenewright.building import plan
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError

Floats = NDArray[np.float64]
Shape = Any

PLANS = "floorplans_r2v/plans.json"
WALL = 0.1
LEAST_AREA = 0.3
LEAST_WIDTH = 0.3
LEAST_DOOR = 0.3
WIDE = 1.2
LEAF = 1.0  # no single leaf is wider than this, metres: such doors slide
CRAMPED = 3.0  # wet rooms below this many square metres have doors that open out

FUNCTIONS = {
    "bedroom": "bedroom",
    "living_room": "living",
    "kitchen": "kitchen",
    "bathroom": "bathroom",
    "restroom": "toilet",
    "washing_room": "washroom",
    "balcony": "balcony",
    "entrance": "hall",
    "corridor": "hall",
    "closet": "storage",
    "PS": "other",
}
_SLIDING = {"balcony", "storage", "other"}
_OPEN = {"living", "dining", "kitchen", "hall"}


class Plan(NamedTuple):
    """One flat: its id, its brief (None if it cannot be used), and what was dropped or changed."""

    id: str
    brief: Brief | None
    words: tuple[str, ...]


class Face(NamedTuple):
    """One room: functions, its shape on the middle lines of the walls, the inner floor, and the
    directed edges (e, 4) of the latter."""

    functions: tuple[str, ...]
    shape: Shape
    floor: Shape
    edges: Floats


class Seat(NamedTuple):
    """Where an opening sits in one room: face index, start and end on the inner wall face."""

    face: int
    start: Floats
    end: Floats

    @property
    def width(self) -> float:
        return float(np.hypot(*(self.end - self.start)))


def raw_plans() -> list[dict[str, Any]]:
    """The plans as they are in the file, in the order listed."""
    raw: list[dict[str, Any]] = json.loads(data_set(PLANS).read_text(encoding="utf-8"))
    return raw


def adapt(raw: dict[str, Any]) -> Plan:
    """One plan as a brief that builds, dropping openings that cannot be built."""
    words: list[str] = []
    faces = _faces(raw["rooms"], words)
    if not faces:
        return Plan(raw["id"], None, (*words, "no room is left"))
    rooms = [_room(face, number) for number, face in enumerate(faces)]
    _open(rooms, faces, raw["openings"], words)
    brief = _built(
        {"name": raw["id"], "outlines": "centre", "wall_thickness": WALL, "rooms": rooms}, words
    )
    return Plan(raw["id"], brief, tuple(words))


def _room(face: Face, number: int) -> dict[str, Any]:
    """A room of the brief, its openings still to come."""
    rings = [face.shape.exterior, *face.shape.interiors]
    outline, *holes = [[(round(x, 4), round(y, 4)) for x, y in ring.coords[:-1]] for ring in rings]
    return {
        "id": f"{number}-{face.functions[0]}",
        "name": " + ".join(face.functions),
        "function": list(face.functions),
        "outline": outline,
        "holes": holes,
        "doors": [],
        "windows": [],
    }


def _faces(rooms: list[dict[str, Any]], words: list[str]) -> list[Face]:
    """The rooms worth keeping: no slivers, no overlaps, no double or straight points.

    Where rooms overlap the smaller keeps its floor; one within another becomes a hole.
    """
    faces: list[Face] = []
    taken: Shape = shapely.Polygon()
    for room in sorted(rooms, key=lambda r: float(r["area"])):
        raw = shapely.Polygon(room["polygon"]).buffer(0)
        shape = _largest(_largest(raw.difference(taken)).simplify(0.015))
        floor = _walled(shape)
        slim = floor.buffer(-(LEAST_WIDTH - WALL) / 2).is_empty
        if shape.area < LEAST_AREA or floor.area < 0.12 or slim:
            told = "+".join(room["labels"]) or "unlabelled"
            words.append(f"dropped a sliver: {told}, {shape.area:.2f} m²")
            continue
        outer = _largest(floor.buffer(WALL / 2, join_style="mitre", mitre_limit=5.0))
        outer = _largest(outer.intersection(shape)).simplify(0.005)
        taken = taken.union(outer)
        functions = tuple(dict.fromkeys(FUNCTIONS[label] for label in room["labels"] or ["PS"]))
        if len(functions) > 1:
            functions = tuple(f for f in functions if f != "other")
        faces.append(Face(functions, outer, _walled(outer), _edges(_walled(outer))))
    return faces[::-1]


def _walled(shape: Shape) -> Shape:
    """The floor between the walls."""
    return _largest(shape.buffer(-WALL / 2, join_style="mitre", mitre_limit=5.0))


def _largest(shape: Shape) -> Shape:
    """The largest part, without pinholes."""
    parts = [part for part in shapely.get_parts(shape) if part.geom_type == "Polygon"]
    best: Shape = max(parts, key=lambda part: part.area, default=shapely.Polygon())
    holes = [hole for hole in best.interiors if shapely.Polygon(hole).area > 0.05]
    return shapely.Polygon(best.exterior, holes) if not best.is_empty else best


def _edges(floor: Shape) -> Floats:
    turned = shapely.geometry.polygon.orient(floor)
    rings = [np.array(ring.coords) for ring in (turned.exterior, *turned.interiors)]
    return np.concatenate([np.hstack([ring[:-1], ring[1:]]) for ring in rings])


def _open(
    rooms: list[dict[str, Any]], faces: list[Face], openings: list[dict[str, Any]], words: list[str]
) -> None:
    """Give every opening to a room as a door or a window."""
    fronts = _front_doors(faces, openings)
    for number, opening in enumerate(openings):
        seats = _seats(faces, np.array(opening["a"]), np.array(opening["b"]))
        told = f"an opening {opening['width']:.2f} m wide at {opening['a']}"
        if not seats:
            words.append(f"dropped {told}: it lies on no wall")
        elif len(seats) == 2 and min(seat.width for seat in seats) < LEAST_DOOR:
            words.append(f"dropped {told}: too narrow for a door")
        elif len(seats) == 2:
            host, door = _door(faces, seats)
            rooms[host]["doors"].append(door)
        elif number in fronts and seats[0].width >= 0.5:
            rooms[seats[0].face]["doors"].append(_front(faces, seats[0]))
        elif "balcony" not in faces[seats[0].face].functions:
            rooms[seats[0].face]["windows"].append(_window(faces, seats[0]))
        else:
            words.append(f"dropped {told}: a balcony has no windows")


def _front_doors(faces: list[Face], openings: list[dict[str, Any]]) -> set[int]:
    """The opening of each entrance hall that is most like a front door (0.85 m)."""
    best: dict[int, tuple[float, int]] = {}
    for number, opening in enumerate(openings):
        if opening["kind"] != "entrance_or_window":
            continue
        seats = _seats(faces, np.array(opening["a"]), np.array(opening["b"]))
        if len(seats) == 1:
            unlike = abs(seats[0].width - 0.85)
            best[seats[0].face] = min(best.get(seats[0].face, (9.0, -1)), (unlike, number))
    return {number for _, number in best.values()}


def _seats(faces: list[Face], a: Floats, b: Floats) -> list[Seat]:
    """The wall faces on both sides of a segment: at most one on each, the longest in common."""
    along = (b - a) / max(float(np.hypot(*(b - a))), 1e-9)
    out = np.array([along[1], -along[0]])
    best: dict[bool, tuple[float, Seat, tuple[float, float]]] = {}
    for number, face in enumerate(faces):
        start, end = face.edges[:, :2], face.edges[:, 2:]
        s, t = (start - a) @ along, (end - a) @ along
        off = np.abs(np.stack([(start - a) @ out, (end - a) @ out])).max(0)
        low = np.maximum(np.minimum(s, t), 0.0)
        high = np.minimum(np.maximum(s, t), float((b - a) @ along))
        for k in np.flatnonzero((off < 0.2) & (high - low > 0.2)):
            side = bool(t[k] > s[k])
            score = float(high[k] - low[k] - 2 * off[k])
            if side not in best or score > best[side][0]:
                seat = _on(face.edges[k], number, a + along * low[k], a + along * high[k])
                best[side] = (score, seat, (float(low[k]), float(high[k])))
    if len(best) == 2:
        return _common([entry[1] for entry in best.values()])
    return [entry[1] for entry in best.values()]


def _on(edge: Floats, face: int, first: Floats, last: Floats) -> Seat:
    """A stretch projected on an edge, in the edge's direction, a centimetre off its ends."""
    along = edge[2:] - edge[:2]
    length = float(np.hypot(*along))
    along = along / length
    ends = sorted(float((point - edge[:2]) @ along) for point in (first, last))
    low, high = max(ends[0], 0.01), min(ends[1], length - 0.01)
    return Seat(face, edge[:2] + along * low, edge[:2] + along * high)


def _common(seats: list[Seat]) -> list[Seat]:
    """Two seats cut to the stretch they share."""
    first, second = seats
    along = (first.end - first.start) / max(first.width, 1e-9)
    spans = [sorted(float((p - first.start) @ along) for p in (s.start, s.end)) for s in seats]
    low, high = max(s[0] for s in spans), min(s[1] for s in spans)
    if high - low < 0.2:
        return [max(seats, key=lambda seat: seat.width)]
    cut = [first.start + along * low, first.start + along * high]
    side = (second.end - second.start) / max(second.width, 1e-9)
    other = [second.start + side * float((p - second.start) @ side) for p in cut[::-1]]
    return [Seat(first.face, cut[0], cut[1]), Seat(second.face, other[0], other[1])]


def _at(seat: Seat) -> list[float]:
    return [round(float(v), 4) for v in (seat.start + seat.end) / 2]


def _door(faces: list[Face], seats: list[Seat]) -> tuple[int, dict[str, Any]]:
    """A door between two rooms, listed in the one it opens into.

    Doors of cupboards and balconies slide, as do wide ones to bedrooms; wide ones between living
    spaces and halls are open. A leaf opens into the larger room that is no hall, towards the
    nearer corner, if it can turn there; else the other way about; else it slides.
    """
    functions = [set(faces[seat.face].functions) for seat in seats]
    host = max(seats, key=lambda seat: _welcome(faces[seat.face]))
    door: dict[str, Any] = {"at": _at(host), "width": round(host.width, 4)}
    if any(f <= _SLIDING for f in functions):
        return host.face, door | {"swing": "slide"}
    if host.width >= WIDE:
        swing = "none" if all(f & _OPEN for f in functions) else "slide"
        return host.face, door | {"swing": swing}
    turning = seats if host.width <= LEAF else []
    for seat in sorted(turning, key=lambda seat: -_welcome(faces[seat.face])):
        for hinge in _hinges(faces[seat.face], seat):
            if _turns(faces[seat.face].floor, seat, hinge):
                leaf = {"at": _at(seat), "width": round(seat.width, 4)}
                return seat.face, leaf | {"swing": "in", "hinge": hinge}
    return host.face, door | {"swing": "slide"}


def _welcome(face: Face) -> float:
    """How gladly a room takes a door leaf: its size, halls late, small wet rooms last."""
    functions = set(face.functions)
    cramped = functions <= {"toilet", "bathroom", "washroom"} and face.floor.area < CRAMPED
    return float(face.floor.area) - 100.0 * (functions <= {"hall"}) - 200.0 * cramped


def _hinges(face: Face, seat: Seat) -> tuple[str, str]:
    """Hinge sides, the one nearer to a corner first (left, facing the wall from inside, is the
    end of the edge)."""
    corners = face.edges[:, :2]
    apart = [float(np.hypot(*(corners - end).T).min()) for end in (seat.start, seat.end)]
    return ("left", "right") if apart[1] <= apart[0] else ("right", "left")


def _turns(floor: Shape, seat: Seat, hinge: str) -> bool:
    """Whether a leaf can swing through a quarter turn inside a room."""
    pivot, tip = (seat.end, seat.start) if hinge == "left" else (seat.start, seat.end)
    along = (seat.end - seat.start) / seat.width
    inward, closed = np.array([-along[1], along[0]]), (tip - pivot) / seat.width
    turn = np.linspace(0, np.pi / 2, 9)[:, None]
    arc = pivot + seat.width * (np.cos(turn) * closed + np.sin(turn) * inward)
    sector = shapely.Polygon([pivot, *arc])
    return bool(sector.difference(floor).area < 0.01)


def _front(faces: list[Face], seat: Seat) -> dict[str, Any]:
    """The front door opens out, as it does in these flats."""
    hinge = _hinges(faces[seat.face], seat)[0]
    return {"at": _at(seat), "width": round(seat.width, 4), "swing": "out", "hinge": hinge}


def _window(faces: list[Face], seat: Seat) -> dict[str, Any]:
    wet = set(faces[seat.face].functions) <= {"bathroom", "toilet", "washroom"}
    sill, height = (1.3, 0.6) if wet else (0.9, 1.2)
    return {"at": _at(seat), "width": round(seat.width, 4), "sill": sill, "height": height}


def _built(raw: dict[str, Any], words: list[str]) -> Brief | None:
    """The brief once it builds: openings that cannot be built are dropped, each with a word."""
    for _ in range(40):
        brief = Brief.model_validate(raw)
        try:
            plan.spaces(brief)
        except InputError as error:
            named = re.match(r"rooms\[(\d+)\].*?(doors|windows)\[(\d+)\]", error.place)
            words.append(f"dropped: {error}")
            if named is None:
                return None
            raw["rooms"][int(named[1])][named[2]].pop(int(named[3]))
            continue
        return brief
    return None
