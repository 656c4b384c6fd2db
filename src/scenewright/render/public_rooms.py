"""What large rooms of the public have beside furniture: signs over exits, numbers over runs of
shelves, a band of colour under the ceiling, tiles of the ceiling."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from zlib import crc32

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.door_uses import LIVED_IN, OPEN_AIR
from scenewright.building.masonry import polygons
from scenewright.building.shell import opening_box
from scenewright.core.catalog import Material, Part
from scenewright.core.layout import corners
from scenewright.core.scene import Piece, Scene
from scenewright.core.space import Opening, Space
from scenewright.geometry.mesh import Mesh, merge
from scenewright.geometry.prisms import box, prism
from scenewright.render.items import BuiltKind, RenderItem, extrude_polygon

LARGE = 60.0
"""From this area on, m², a room that is not lived in is one of the public."""
NOT_PUBLIC = OPEN_AIR | (LIVED_IN - {"study"}) | {"site", "village", "extend"}
SOLEMN = frozenset(("worship", "museum"))
"""Functions of rooms without tiles and bands."""
GREEN = Material("exit sign", (0.0, 0.52, 0.28), 0.5, 0.0, 1.0, 0.6)
WHITE = Material("sign white", (0.96, 0.96, 0.94), 0.6)
BLACK = Material("poster frame", (0.1, 0.1, 0.11), 0.5)
RAIL = Material("ceiling rail", (0.86, 0.86, 0.85), 0.6)
ACCENTS = ("2f5d62", "8c4a3c", "c08a3e", "4a5f7d", "5f6f52", "7b4a5b", "3f6d87", "a06a4a")
"""Colours of bands and signs, one a room."""
EXIT = (0.4, 0.2, 0.03)
"""Width, height and thickness in metres of a sign seen from 20 m (ISO 3864-1: height by 100)."""
TILE, BAR, DEEP = 1.2, 0.024, 0.006
TILED = 4.3
"""Ceilings up to this height, in metres, have tiles."""
BAND, BELOW, PAINT = 0.45, 0.25, 0.006
"""Height of the band, how far below the ceiling it ends, and its thickness, in metres."""
POSTER, LOWEST, APART = (0.9, 1.25, 0.02), 1.25, 3.4
"""Width, height and thickness of a poster, its lower edge, distance of posters, in metres."""
NUMBERED = frozenset(("gondola", "shelving", "book_shelving"))
"""Kinds whose runs have a number."""
PANEL = (0.9, 0.34, 0.03)
OVER = 0.45
"""How far above its run a number hangs, in metres."""
SEGMENTS = ("abcdef", "bc", "abged", "abgcd", "fgbc", "afgcd", "afgedc", "abc", "abcdefg", "abcdfg")
"""The strokes of the digits 0 to 9 as of displays: a upper, b c right, d lower, e f left, g
middle."""
STROKES = {
    "a": (0.0, 0.12, 0.07, 0.015),
    "g": (0.0, 0.0, 0.07, 0.015),
    "d": (0.0, -0.12, 0.07, 0.015),
    "b": (0.055, 0.06, 0.015, 0.075),
    "c": (0.055, -0.06, 0.015, 0.075),
    "e": (-0.055, -0.06, 0.015, 0.075),
    "f": (-0.055, 0.06, 0.015, 0.075),
}
"""Middle and half sizes of a stroke in metres, across and up."""

Floats = NDArray[np.float64]


def is_public(space: Space) -> bool:
    """Whether a room is large and neither lived in nor in the open air."""
    public = NOT_PUBLIC.isdisjoint(space.functions)
    return public and shapely.Polygon(space.outline, space.holes).area > LARGE


def fittings(scene: Scene) -> Iterator[RenderItem]:
    """The fittings of all public rooms."""
    for space in filter(is_public, scene.spaces):
        doors = [o for o in scene.openings if o.kind == "door" and [*o.spaces] == [space.id]]
        yield from _item(space, "signs", "sign", [*_exits(space, doors), *_numbers(space, scene)])
        if SOLEMN.isdisjoint(space.functions) and not space.slopes:
            yield from _item(space, "ceiling rails", "ceiling", _rails(space))
            yield from _item(space, "band", "sign", _band(space, scene))
            yield from _item(space, "posters", "sign", [*_posters(space, scene)])


def _item(space: Space, name: str, kind: BuiltKind, parts: Sequence[Part]) -> Iterator[RenderItem]:
    if parts:
        name = f"{space.id} {name}"
        facts: dict[str, str | float] = {"category": kind, "space": space.id}
        yield RenderItem(
            name, kind, space.level, space.id, name, tuple(parts), (0, 0, 0), 0.0, facts
        )


def _accent(space: Space) -> Material:
    return accent(crc32(space.id.encode()))


def accent(number: int) -> Material:
    """A colour of signs."""
    code = ACCENTS[number % len(ACCENTS)]
    red, green, blue = (int(code[k : k + 2], 16) / 255 for k in (0, 2, 4))
    return Material(f"accent paint {code}", (red, green, blue), 0.7)


def _exits(space: Space, doors: Sequence[Opening]) -> Iterator[Part]:
    """A green sign with an arrow to a white doorway over each way out."""
    wide, tall, thick = EXIT
    floor = shapely.Polygon(space.outline)
    for door in doors:
        if door.use == "entrance" or door.head + 2 * tall > space.height:
            continue
        across = np.array([-door.uy, door.ux])
        if not floor.contains(shapely.Point(np.array([door.x, door.y]) + across)):
            across = -across
        foot = np.array([door.x, door.y]) + across * (door.thickness / 2 + 0.005)
        frame = (foot, across, door.head + 0.1 + tall / 2)
        plate = box((-wide / 2, 0, -tall / 2), (wide / 2, thick, tall / 2))
        yield Part(GREEN, *_put(plate, *frame))
        tip = np.array([[0.02, 0.05], [-0.08, 0.0], [0.02, -0.05]])
        arrow = prism(tip[::-1] if _turned(tip) else tip, 0.0, 0.004)
        head = Mesh(arrow.vertices[:, [0, 2, 1]] + (0, thick, 0), arrow.faces[:, ::-1])
        shaft = box((0.02, thick, -0.018), (0.15, thick + 0.004, 0.018))
        way_out = box((-0.16, thick, -0.08), (-0.1, thick + 0.004, 0.08))
        yield Part(WHITE, *_put(merge([head, shaft, way_out]), *frame))


def _turned(ring: Floats) -> bool:
    return not shapely.is_ccw(shapely.LinearRing(ring))


def _put(mesh: Mesh, foot: Floats, facing: Floats, height: float) -> Mesh:
    """A mesh whose y looks along ``facing`` in plan, with its origin over ``foot``."""
    turn = np.array([[facing[1], -facing[0]], [facing[0], facing[1]]])
    flat = mesh.vertices[:, :2] @ np.array([turn[0], turn[1]]) + foot
    return Mesh(np.column_stack([flat, mesh.vertices[:, 2] + height]), mesh.faces)


def _numbers(space: Space, scene: Scene) -> Iterator[Part]:
    """A panel over each run of shelves with its number on both faces."""
    mine = [p for p in scene.pieces if p.space == space.id and p.category in NUMBERED]
    wide, tall, thick = PANEL
    for number, run in enumerate(_runs(mine), 1):
        ring = shapely.get_coordinates(shapely.oriented_envelope(run))
        sides = np.diff(ring[:3], axis=0)
        lengths = np.hypot(*sides.T)
        along = sides[np.argmax(lengths)] / lengths.max()
        top = max(p.pose.z + p.size.height for p in mine)
        height = min(top + OVER + tall / 2, space.height - 0.3)
        if height - tall / 2 < top + 0.1:
            continue
        foot = np.array(run.centroid.coords[0])
        panel = box((-wide / 2, -thick / 2, -tall / 2), (wide / 2, thick / 2, tall / 2))
        rods = [
            box((x - 0.006, -0.006, tall / 2), (x + 0.006, 0.006, space.height - height))
            for x in (-wide / 3, wide / 3)
        ]
        yield Part(_accent(space), *_put(panel, foot, along, height))
        yield Part(RAIL, *_put(merge(rods), foot, along, height))
        digits = merge([*_digits(str(number), thick / 2)])
        for facing in (along, -along):
            yield Part(WHITE, *_put(digits, foot, facing, height))


def _runs(pieces: Sequence[Piece]) -> list[shapely.Polygon]:
    """The outlines of rows of pieces side by side, from left to right."""
    boxes = [box_of(p).buffer(0.06, join_style="mitre") for p in pieces]
    runs = polygons(shapely.union_all(boxes)) if boxes else []
    return sorted(runs, key=lambda run: (round(run.centroid.x, 2), round(run.centroid.y, 2)))


def box_of(piece: Piece) -> shapely.Polygon:
    """The rectangle a piece stands on."""
    x, y, _, heading = piece.pose
    return shapely.Polygon(corners(np.array([x, y, heading, piece.size.width, piece.size.depth])))


def _digits(words: str, front: float) -> Iterator[Mesh]:
    """Digits beside one another on a panel, seen against their y: x runs to the left."""
    for place, digit in enumerate(words):
        middle = -0.19 * (place - (len(words) - 1) / 2)
        for stroke in SEGMENTS[int(digit)]:
            x, z, half, up = STROKES[stroke]
            low = (middle - x - half, front, z - up)
            yield box(low, (middle - x + half, front + 0.004, z + up))


def _rails(space: Space) -> list[Part]:
    """The rails between the tiles of a ceiling that is not too high."""
    if space.height > TILED:
        return []
    shape = shapely.Polygon(space.outline, space.holes)
    x0, y0, x1, y1 = shape.bounds
    xs, ys = (np.arange(a + TILE / 2, b, TILE) for a, b in ((x0, x1), (y0, y1)))
    bars = [shapely.box(x - BAR / 2, y0, x + BAR / 2, y1) for x in xs]
    bars += [shapely.box(x0, y - BAR / 2, x1, y + BAR / 2) for y in ys]
    low = space.height - DEEP
    pieces = [part for bar in bars for part in polygons(shape.intersection(bar))]
    return [Part(RAIL, *merge([extrude_polygon(p, low, space.height) for p in pieces]))]


def _band(space: Space, scene: Scene) -> list[Part]:
    """A painted band along the walls, open at windows and doors that reach it."""
    high = space.height - BELOW
    low = high - BAND
    tops = [p.pose.z + p.size.height for p in scene.pieces if p.space == space.id]
    if low < max([2.2, *tops]):
        return []
    floor = shapely.Polygon(space.outline, space.holes)
    gaps = [opening_box(o, 0.2) for o in scene.openings if o.head > low]
    rim = floor.difference(floor.buffer(-PAINT, join_style="mitre"))
    left = rim.difference(shapely.union_all(gaps))
    meshes = [extrude_polygon(p, low, high) for p in polygons(left)]
    return [Part(_accent(space), *merge(meshes))] if meshes else []


def _posters(space: Space, scene: Scene) -> Iterator[Part]:
    """Posters of plain shapes on stretches of wall that nothing stands before."""
    tall = [p for p in scene.pieces if p.space == space.id and p.pose.z + p.size.height > LOWEST]
    gaps = [opening_box(one, 0.4).buffer(0.3) for one in scene.openings]
    taken = shapely.union_all([*gaps, *(box_of(p).buffer(0.35) for p in tall)])
    ring = shapely.get_coordinates(shapely.orient_polygons(shapely.Polygon(space.outline)).exterior)
    for number, (foot, inwards) in enumerate(_spots(ring, taken)):
        wide, high, thick = POSTER
        frame = (foot, inwards, LOWEST + high / 2)
        sheet = box((-wide / 2, 0.002, -high / 2), (wide / 2, thick, high / 2))
        rim = box(
            (-wide / 2 - 0.03, 0.001, -high / 2 - 0.03), (wide / 2 + 0.03, 0.015, high / 2 + 0.03)
        )
        yield Part(WHITE, *_put(sheet, *frame))
        yield Part(BLACK, *_put(rim, *frame))
        for color, mesh in _drawn(number, thick):
            yield Part(color, *_put(mesh, *frame))


def _spots(ring: Floats, taken: shapely.Geometry) -> Iterator[tuple[Floats, Floats]]:
    """Places on walls, evenly apart, and the way into the room there."""
    for start, end in pairwise(ring):
        length = float(np.hypot(*(end - start)))
        along = (end - start) / max(length, 1e-9)
        count = int((length - 1.0) / APART)
        for k in range(count):
            foot = start + along * length * (k + 0.5) / count
            near = shapely.LineString([foot - along * POSTER[0] / 2, foot + along * POSTER[0] / 2])
            if not taken.intersects(near):
                yield foot, np.array([-along[1], along[0]])


def _drawn(number: int, front: float) -> Iterator[tuple[Material, Mesh]]:
    """Three fields of colour on a poster, another way each."""
    wide, high = (side - 0.16 for side in POSTER[:2])
    rng = np.random.default_rng(number)
    for k, code in enumerate(rng.permutation(len(ACCENTS))[:3]):
        left, right = sorted(rng.uniform(-wide / 2, wide / 2, 2)) if k else (-wide / 2, wide / 2)
        low, top = sorted(rng.uniform(-high / 2, high / 2, 2)) if k else (-high / 2, 0.0)
        if right - left < 0.2 or top - low < 0.2:
            left, right, top = -wide / 2, wide / 6, min(low + 0.3, high / 2)
        yield accent(int(code)), box((left, front, low), (right, front + 0.001 * (k + 1), top))
