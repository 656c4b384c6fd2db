"""``Home.xml`` as records in our conventions: metres, y to the north, angles counter-clockwise.

The file has centimetres, y down the page and angles clockwise on the page (those of door leaves
counter-clockwise). :mod:`scenewright.formats.sh3d.tree` parses it without trusting it.
"""

from __future__ import annotations

import math
from collections import Counter
from typing import NamedTuple
from xml.etree.ElementTree import Element

from scenewright.core.errors import InputError
from scenewright.core.space import Points
from scenewright.formats.sh3d.tree import LINE, NUMBER, PIECES, tree

CENTIMETRE = 0.01
FARTHEST = 1e6
SAME_SIZE = 1e-3
ROUNDED = 1.01
"""By how much the box of a tilted piece may be larger than that of the box it fills upright."""


class HomeLevel(NamedTuple):
    """A storey; ``visible`` false if it is hidden in the program. As in all records, ``number`` is
    that of its element in the file (-1: of none)."""

    id: str
    name: str
    elevation: float
    height: float
    visible: bool
    number: int = -1


class HomeWall(NamedTuple):
    """A wall by its middle line; ``arc`` the angle of the arc from start to end (0: straight).

    ``height`` is that at its start, ``height_at_end`` that at its end where it differs. ``joined``
    are the ids of the walls that meet its start and its end ('' for none).
    """

    id: str
    level: str
    start: tuple[float, float]
    end: tuple[float, float]
    thickness: float
    height: float | None
    arc: float
    joined: tuple[str, str]
    height_at_end: float | None = None
    number: int = -1


class HomeRoom(NamedTuple):
    """A room as drawn: its name and corners."""

    name: str
    level: str
    corners: tuple[tuple[float, float], ...]
    place: str
    number: int = -1


class Sash(NamedTuple):
    """A leaf: hinge in the piece's frame (x right, y to the back), length, and the direction it
    points when closed and open, in radians."""

    x: float
    y: float
    width: float
    closed: float
    open: float


class HomePiece(NamedTuple):
    """A piece of furniture, door or window; ``turn`` rotates its frame (x right, y to the back).

    ``width``, ``depth`` and ``height`` are those of the box around it as it lies or leans,
    ``upright`` those before it was ``tilted``. ``members`` are the pieces of a group.
    """

    kind: str
    catalog: str
    name: str
    level: str
    x: float
    y: float
    z: float
    turn: float
    width: float
    depth: float
    height: float
    movable: bool
    visible: bool
    sashes: tuple[Sash, ...]
    members: tuple[HomePiece, ...]
    place: str
    upright: tuple[float, float, float]
    number: int = -1

    @property
    def tilted(self) -> bool:
        """Whether it lies or leans: its box is another than that of the upright piece."""
        size = self.width, self.depth, self.height
        return any(abs(a - b) > SAME_SIZE for a, b in zip(size, self.upright, strict=True))


class Home(NamedTuple):
    """All that is read of a home; ``others`` counts the elements that are not, by tag."""

    name: str
    wall_height: float
    levels: tuple[HomeLevel, ...]
    walls: tuple[HomeWall, ...]
    rooms: tuple[HomeRoom, ...]
    pieces: tuple[HomePiece, ...]
    others: Counter[str]


def parse(content: bytes) -> Home:
    """The records of a ``Home.xml``; InputError if it is broken or no home."""
    root, others = tree(content)
    if root.tag != "home":
        raise InputError(f"is <{root.tag[:40]}>, not a Sweet Home 3D home", "give a Home.xml")
    return Home(
        name=root.get("name", "").removesuffix(".sh3d") or "home",
        wall_height=_number(root, "wallHeight", 250.0, low=1.0) * CENTIMETRE,
        levels=tuple(_level(e) for e in root.findall("level")),
        walls=tuple(_wall(e) for e in root.findall("wall")),
        rooms=tuple(_room(e) for e in root.findall("room")),
        pieces=tuple(_piece(e) for e in root if e.tag in PIECES),
        others=others,
    )


def _level(e: Element) -> HomeLevel:
    return HomeLevel(
        id=_text(e, "id"),
        name=e.get("name", ""),
        elevation=_number(e, "elevation", 0.0) * CENTIMETRE,
        height=_number(e, "height", 250.0, low=1.0) * CENTIMETRE,
        visible=_flag(e, "visible") and _flag(e, "viewable"),
        number=int(e.get(NUMBER, "-1")),
    )


def _wall(e: Element) -> HomeWall:
    return HomeWall(
        id=e.get("id", ""),
        level=e.get("level", ""),
        start=_point(e, "xStart", "yStart"),
        end=_point(e, "xEnd", "yEnd"),
        thickness=_number(e, "thickness", 7.5, low=0.0, high=500.0) * CENTIMETRE,
        height=_height(e, "height"),
        arc=-_number(e, "arcExtent", 0.0, high=2 * math.pi),
        joined=(e.get("wallAtStart", ""), e.get("wallAtEnd", "")),
        height_at_end=_height(e, "heightAtEnd"),
        number=int(e.get(NUMBER, "-1")),
    )


def _height(e: Element, key: str) -> float | None:
    return None if e.get(key) is None else _number(e, key, low=0.0) * CENTIMETRE


def _room(e: Element) -> HomeRoom:
    corners = tuple(_point(p, "x", "y") for p in e.findall("point"))
    number = int(e.get(NUMBER, "-1"))
    return HomeRoom(e.get("name", "").strip(), e.get("level", ""), corners, _place(e), number)


def _piece(e: Element) -> HomePiece:
    upright = _length(e, "width"), _length(e, "depth"), _length(e, "height", 1.0)
    width, depth, height = _box_in_plan(e, *upright)
    mirrored = e.get("modelMirrored") == "true"
    x, y = _point(e, "x", "y")
    return HomePiece(
        kind=e.tag,
        catalog=e.get("catalogId", "").rpartition("#")[2],
        name=e.get("name", ""),
        level=e.get("level", ""),
        x=x,
        y=y,
        z=_number(e, "elevation", 0.0) * CENTIMETRE,
        turn=-_number(e, "angle", 0.0),
        width=width,
        depth=depth,
        height=height,
        movable=_flag(e, "movable"),
        visible=_flag(e, "visible"),
        sashes=tuple(_sash(s, width, depth, mirrored) for s in e.findall("sash")),
        members=tuple(_piece(m) for m in e if m.tag in PIECES),
        place=_place(e),
        upright=upright,
        number=int(e.get(NUMBER, "-1")),
    )


def _length(e: Element, key: str, default: float | None = None) -> float:
    return max(_number(e, key, default, low=0.0), 0.1) * CENTIMETRE


def _box_in_plan(
    e: Element, width: float, depth: float, height: float
) -> tuple[float, float, float]:
    """Width, depth and height of the box around a piece that is tilted: rolled by r about the axis
    from its front to its back, then pitched by p about that along its width. Of a full box it is

        w' = w |cos r| + h |sin r|,  h" = w |sin r| + h |cos r|,
        d' = d |cos p| + h" |sin p|,  h' = d |sin p| + h" |cos p|;

    the file says less where the model does not fill its box.
    """
    roll, pitch = _number(e, "roll", 0.0), _number(e, "pitch", 0.0)
    if not (roll or pitch):
        return width, depth, height
    c, s = abs(math.cos(roll)), abs(math.sin(roll))
    width, height = width * c + height * s, width * s + height * c
    c, s = abs(math.cos(pitch)), abs(math.sin(pitch))
    depth, height = depth * c + height * s, depth * s + height * c
    full = {"widthInPlan": width, "depthInPlan": depth, "heightInPlan": height}
    found = [min(_length(e, key, n / CENTIMETRE), n * ROUNDED) for key, n in full.items()]
    return found[0], found[1], found[2]


def _sash(e: Element, width: float, depth: float, mirrored: bool) -> Sash:
    x = (_number(e, "xAxis", 0.0) - 0.5) * width
    closed, opened = _number(e, "startAngle", 0.0), _number(e, "endAngle", 0.0)
    if mirrored:
        x, closed, opened = -x, math.pi - closed, math.pi - opened
    y = (0.5 - _number(e, "yAxis", 0.5)) * depth
    return Sash(x, y, _number(e, "width", 1.0, low=0.0) * width, closed, opened)


def _point(e: Element, x: str, y: str) -> tuple[float, float]:
    return _number(e, x) * CENTIMETRE, -_number(e, y) * CENTIMETRE


def _number(
    e: Element,
    key: str,
    default: float | None = None,
    low: float = -FARTHEST,
    high: float = FARTHEST,
) -> float:
    text = e.get(key)
    if text is None and default is not None:
        return default
    if text is None:
        raise InputError(f"{key} is missing", "save the home again", place=_place(e))
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not low <= value <= high:
        raise InputError(
            f"{key} is '{text[:30]}'", f"it must be from {low:g} to {high:g}", place=_place(e)
        )
    return value


def _text(e: Element, key: str) -> str:
    text = e.get(key)
    if not text:
        raise InputError(f"{key} is missing", "save the home again", place=_place(e))
    return text


def _flag(e: Element, key: str) -> bool:
    return e.get(key, "true") != "false"


def _place(e: Element) -> str:
    named = e.get("name") or e.get("id") or ""
    return f"Home.xml line {e.get(LINE)}, <{e.tag}>" + f" '{named[:40]}'" * bool(named)


def place_of(feature: HomeLevel | HomeWall | HomeRoom | HomePiece) -> str:
    """The name of a feature in its file, else its id."""
    return (getattr(feature, "name", "") or getattr(feature, "id", ""))[:80]


def outline_of(piece: HomePiece) -> list[tuple[float, float]]:
    """Corners of the footprint of a piece, counter-clockwise."""
    c, s = math.cos(piece.turn), math.sin(piece.turn)
    half = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    local = [(a * piece.width / 2, b * piece.depth / 2) for a, b in half]
    return [(piece.x + c * u - s * v, piece.y + s * u + c * v) for u, v in local]


def middle_line(wall: HomeWall) -> Points:
    """The middle line of a wall as a polyline ``(n, 2)``; an arc has a point every 5 degrees.

    The centre c of the arc turns start into end: ``c = (end - w start) / (1 - w)`` in complex
    numbers with ``w = exp(i arc)``.
    """
    import numpy as np

    start, end = complex(*wall.start), complex(*wall.end)
    turn = complex(math.cos(wall.arc), math.sin(wall.arc))
    if abs(1 - turn) < 1e-6 or start == end:
        return np.array([wall.start, wall.end])
    centre = (end - turn * start) / (1 - turn)
    steps = np.linspace(0.0, wall.arc, max(2, math.ceil(abs(wall.arc) / math.radians(5)) + 1))
    points = centre + (start - centre) * np.exp(1j * steps)
    return np.column_stack([points.real, points.imag])
