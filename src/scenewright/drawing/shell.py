"""The shell in plan, cut at 1.2 m: floors, solid walls, windows and doors."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from shapely import Geometry, MultiPolygon, Polygon, union_all

from scenewright.building.door_leaves import leaves_of
from scenewright.core.layout import corners
from scenewright.core.scene import Piece, Prism, Wall
from scenewright.core.space import Opening, Space
from scenewright.drawing.marks import (
    CUT,
    FINE,
    GREY,
    INK,
    LINE,
    POCHE,
    ArcMark,
    FillPattern,
    Mark,
    MeantMark,
    PaperView,
    Style,
    group,
    line,
    shape,
    to_paper,
)
from scenewright.drawing.meanings import OpeningMeaning, RoomMeaning

CUT_HEIGHT = 1.2
"""Height in metres above the floor at which the plan is cut."""

FLOOR, TILES = "#f6f4ef", "url(#tiles)"
LEAF = 0.04
TILED = {"kitchen", "bathroom", "toilet", "washroom", "balcony"}

Corner = NDArray[np.float64]


def floors(view: PaperView, spaces: Sequence[Space]) -> Mark:
    """Room floors, tinted so that white furniture stands out; wet rooms are tiled."""
    marks: list[Mark] = []
    for space in spaces:
        rings = [to_paper(view, ring) for ring in (space.outline, *space.holes)]
        room = RoomMeaning(space.id, space.name, tuple(rings))
        marks.append(MeantMark(shape(rings, fill=FLOOR), room))
        if TILED.issuperset(space.functions) and space.functions:
            marks.append(shape(rings, fill=TILES))
    return group(marks, fill_rule="evenodd")


def tile_pattern(view: PaperView, size: float = 0.3) -> FillPattern:
    """The pattern of square floor tiles, ``size`` metres each."""
    side = size * view.scale
    joint = line([(side, 0), (0, 0), (0, side)], fill="none", stroke="#dedbd3", stroke_width=FINE)
    return FillPattern("tiles", side, side, 0.0, "", (joint,))


def cut_walls(walls: Sequence[Wall]) -> Geometry:
    """The union of everything the cut goes through, and of knee walls, in plan metres."""
    solid = [p for wall in walls for p in wall.prisms if p.base < CUT_HEIGHT]
    cut = [p for p in solid if p.top > CUT_HEIGHT or p.tilt is not None]
    return union_all([_polygon(prism) for prism in cut])


def low_walls(walls: Sequence[Wall]) -> Geometry:
    """Walls below the cut: parapets and the wall under windows."""
    low = [p for wall in walls for p in wall.prisms if p.top <= CUT_HEIGHT and p.tilt is None]
    return union_all([_polygon(prism) for prism in low])


def walls_mark(view: PaperView, walls: Sequence[Wall]) -> Mark:
    """Low walls as outlines, cut walls solid."""
    low = _draw_filled(view, low_walls(walls), fill="#ffffff", stroke=INK, stroke_width=LINE)
    cut = _draw_filled(view, cut_walls(walls), fill=POCHE, stroke=INK, stroke_width=CUT)
    return group([*low, *cut], fill_rule="evenodd", stroke_linejoin="miter")


def partition_walls(pieces: Sequence[Piece]) -> tuple[Wall, ...]:
    """Pieces that are partitions, as walls."""
    found = []
    for piece in pieces:
        if piece.category == "partition":
            x, y, base, heading = piece.pose
            outline = corners(np.array([[x, y, heading, *piece.size[:2]]]))[0]
            prism = Prism(outline, base, base + piece.size.height)
            found.append(Wall(piece.id, "", (prism,)))
    return tuple(found)


def openings_mark(view: PaperView, openings: Sequence[Opening]) -> Mark:
    """Every opening by its symbol."""
    marks = [MeantMark(_opening(view, o), OpeningMeaning(o.kind)) for o in openings]
    return group(marks, stroke=INK, fill="none")


def frame_of(opening: Opening) -> tuple[Corner, Corner, Corner]:
    """Middle of the opening, unit vector along the wall, unit vector to its left."""
    along = np.array([opening.ux, opening.uy])
    return np.array([opening.x, opening.y]), along, np.array([-opening.uy, opening.ux])


def swing_square(opening: Opening) -> Polygon | None:
    """The square the leaf sweeps a quarter of a disc in; ``None`` if it does not turn."""
    if opening.hinge == 0 or opening.swing == 0:
        return None
    middle, along, left = frame_of(opening)
    half, out = along * opening.width / 2, left * opening.swing
    near = middle + out * opening.thickness / 2
    far = near + out * opening.width
    return Polygon([near - half, near + half, far + half, far - half])


def _opening(view: PaperView, opening: Opening) -> Mark:
    if opening.roof is not None:
        return _roof_window(view, opening, *opening.roof)
    if opening.kind == "window":
        return _window(view, opening)
    half, face = opening.width / 2, opening.thickness / 2
    gap = [to_paper(view, _box(opening, -half, half, -face, face))]
    return group([shape(gap, fill=FLOOR, stroke="none"), _way(view, opening)])


def _way(view: PaperView, opening: Opening) -> Mark:
    if opening.kind == "passage":
        return _faces(view, opening, stroke_dasharray="1 0.7", stroke_width=LINE)
    if opening.hinge and opening.swing:
        return _door(view, opening)
    return _sliding_door(view, opening)


def _box(opening: Opening, begin: float, end: float, right: float, left: float) -> Corner:
    """Corners of a box in the opening: along its direction and to the left, in metres."""
    middle, along, side = frame_of(opening)
    places = ((begin, right), (end, right), (end, left), (begin, left))
    return np.array([middle + a * along + b * side for a, b in places])


def _window(view: PaperView, opening: Opening) -> Mark:
    half, face = opening.width / 2, opening.thickness / 2
    if opening.sill >= CUT_HEIGHT:
        return _faces(view, opening, stroke="#ffffff", stroke_dasharray="1 0.7")
    jamb = min(0.05, half / 4)
    frame = min(0.035, face / 2)
    boxes = [
        _box(opening, -half, -half + jamb, -frame, frame),
        _box(opening, half - jamb, half, -frame, frame),
    ]
    glass = [
        _box(opening, -half + jamb, half - jamb, side, side)[:2] for side in (-frame / 2, frame / 2)
    ]
    whole = shape(
        [to_paper(view, _box(opening, -half, half, -face, face))], fill="#ffffff", stroke_width=LINE
    )
    panes = [line(to_paper(view, pane), stroke_width=FINE) for pane in glass]
    ends = [shape([to_paper(view, box)], stroke_width=FINE) for box in boxes]
    return group([whole, *ends, *panes])


def _roof_window(view: PaperView, opening: Opening, near: float, far: float) -> Mark:
    """A window overhead, in a slope: dashed, with its diagonals; the room is on the left."""
    box = to_paper(view, _overhead(opening, near, far))
    frame = shape([box], stroke_width=LINE, stroke_dasharray="1 0.7")
    return group([frame, *(line(box[k::2], stroke_width=FINE, stroke=GREY) for k in (0, 1))])


def _overhead(opening: Opening, near: float, far: float) -> Corner:
    half, face = opening.width / 2, opening.thickness / 2
    return _box(opening, -half, half, face + near, face + far)


def roof_windows(openings: Sequence[Opening]) -> list[Polygon]:
    """The windows in slopes, in plan metres."""
    return [Polygon(_overhead(o, *o.roof)) for o in openings if o.roof is not None]


def _door(view: PaperView, opening: Opening) -> Mark:
    """The faces of the wall and each leaf."""
    leaves = (mark for leaf in leaves_of(opening) for mark in _leaf(view, leaf.opening))
    return group([_faces(view, opening, stroke_width=FINE, stroke=GREY), *leaves])


def _leaf(view: PaperView, opening: Opening) -> list[Mark]:
    """The quarter arc that a leaf sweeps, and the leaf at a right angle to the wall."""
    middle, along, left = frame_of(opening)
    out = left * opening.swing
    hinge = middle + along * opening.hinge * opening.width / 2 + out * opening.thickness / 2
    shut = hinge - along * opening.hinge * opening.width
    open_ = hinge + out * opening.width
    inward = -along * opening.hinge * LEAF
    leaf = shape(
        [to_paper(view, [hinge, hinge + inward, open_ + inward, open_])],
        fill="#ffffff",
        stroke_width=LINE,
    )
    (x0, y0), (x1, y1) = to_paper(view, [open_, shut]).tolist()
    style: Style = {"stroke_width": FINE, "stroke": GREY}
    sweep = opening.hinge * opening.swing < 0
    arc = ArcMark((x0, y0), (x1, y1), opening.width * view.scale, sweep, style)
    return [arc, leaf]


def _sliding_door(view: PaperView, opening: Opening) -> Mark:
    """Two panels passing each other in the thickness of the wall."""
    half = opening.width / 2
    depth = min(LEAF, opening.thickness / 4)
    first = _box(opening, -half, 0.05 * half, 0.0, depth)
    second = _box(opening, -0.05 * half, half, -depth, 0.0)
    panels = [
        shape([to_paper(view, box)], fill="#ffffff", stroke_width=LINE) for box in (first, second)
    ]
    return group([_faces(view, opening, stroke_width=FINE, stroke=GREY), *panels])


def _faces(view: PaperView, opening: Opening, **style: str | float) -> Mark:
    """Lines across the opening in the two faces of the wall."""
    half, face = opening.width / 2, opening.thickness / 2
    box = _box(opening, -half, half, -face, face)
    pen: dict[str, str | float] = {"stroke_width": FINE}
    return group([line(to_paper(view, side), **(pen | style)) for side in (box[:2], box[2:])])


def _polygon(prism: Prism) -> Polygon:
    return Polygon(prism.outline, prism.holes)


def _draw_filled(view: PaperView, region: Geometry, **style: str | float) -> list[Mark]:
    parts = region.geoms if isinstance(region, MultiPolygon) else [region]
    return [
        shape(
            [
                to_paper(view, np.asarray(ring.coords)[:-1])
                for ring in (part.exterior, *part.interiors)
            ],
            **style,
        )
        for part in parts
        if isinstance(part, Polygon) and not part.is_empty
    ]
