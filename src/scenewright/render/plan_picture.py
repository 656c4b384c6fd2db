"""A scene as a small plan in pixels: rooms, walls, openings and the symbols of the pieces.

For contact sheets, where a dozen plans are compared at a glance; the plan to print is drawn as
SVG. Levels stand side by side, y is up.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from scenewright.core.catalog import Catalog, asset_of
from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import GroundSurface, Piece, Scene
from scenewright.core.space import Level, Opening
from scenewright.render.picture import Pixels

Floats = NDArray[np.float64]
Colour = tuple[int, int, int]
Bounds = tuple[float, float, float, float]

FINER = 3
"""Times as fine as asked for that is drawn, for smooth edges."""
CUT = 1.2
"""Height above the floor at which walls and windows are cut, metres."""
PAGE: Colour = (255, 255, 255)
ROOM: Colour = (247, 244, 238)
GROUND: Colour = (226, 232, 214)
WALL: Colour = (52, 50, 47)
GLASS: Colour = (112, 160, 196)
LINE: Colour = (70, 66, 60)
LOCKED: Colour = (178, 68, 44)
TREE: Colour = (150, 184, 128)
SURFACES: dict[str, Colour] = {
    "asphalt": (190, 190, 188),
    "pavement": (212, 208, 200),
    "kerb": (170, 168, 164),
    "path": (222, 212, 192),
    "walk": (222, 212, 192),
    "marking": (250, 250, 250),
}
USES: tuple[tuple[tuple[str, ...], Colour], ...] = (
    (("sleeping", "single", "bunk", "cot"), (188, 205, 228)),
    (("seating", "reading", "media"), (236, 204, 170)),
    (("dining", "dining_wall", "terrace"), (244, 226, 168)),
    (("kitchen", "counter"), (214, 198, 226)),
    (("bath", "shower", "toilet", "basin", "washer"), (190, 222, 222)),
    (("desk", "vanity"), (206, 224, 186)),
)
"""Tints of furniture groups, so that plans can be told apart at a glance."""
OTHER: tuple[Colour, ...] = (
    (226, 214, 200),
    (198, 212, 226),
    (224, 200, 196),
    (206, 220, 198),
    (222, 208, 228),
    (236, 224, 186),
    (196, 222, 216),
)
"""Tints of other functions, in turn."""
LOWEST, HIGHEST = 9.0, 36.0
"""Heights of buildings, metres, from light to dark."""


class PlanPage(NamedTuple):
    """What is drawn on, pixels a metre, and the pixel of the plan's (0, 0) on each level."""

    pen: ImageDraw.ImageDraw
    scale: float
    origins: dict[str, tuple[float, float]]

    def points(
        self, level: str, points: Iterable[Sequence[float] | Floats]
    ) -> list[tuple[float, float]]:
        """Plan points (k, 2) of a level as pixels."""
        x, y = self.origins[level]
        return [(x + self.scale * p[0], y - self.scale * p[1]) for p in points]


def draw_scene_plan(scene: Scene, catalog: Catalog, side: int) -> Pixels:
    """The plan as pixels ``(height, side, 3)``; the height follows the plan's shape, from half the
    width to the width."""
    height = round(side * _shape(scene))
    image = Image.new("RGB", (FINER * side, FINER * height), PAGE)
    page = _lay_out(scene, ImageDraw.Draw(image), FINER * side, FINER * height)
    outdoors = any("site" in space.functions for space in scene.spaces)
    for space in scene.spaces:
        _fill(page, space.level, space.outline, GROUND if outdoors else ROOM)
        for hole in space.holes:
            _fill(page, space.level, hole, PAGE)
    levels = {space.id: space.level for space in scene.spaces}
    for surface in scene.surfaces:
        _draw_surface(page, surface, levels[surface.space])
    for wall in scene.walls:
        for prism in wall.prisms:
            if prism.base <= CUT < prism.top:
                _fill(page, wall.level, prism.outline, WALL)
    for opening in scene.openings:
        _draw_opening(page, opening)
    tints = _tints(scene.pieces)
    for piece in sorted(scene.pieces, key=lambda p: p.pose.z + p.size.height):
        _draw_piece(page, piece, levels[piece.space], catalog, tints, outdoors)
    return np.asarray(image.resize((side, height), Image.Resampling.BOX), np.uint8)


def _measure_levels(scene: Scene) -> tuple[list[tuple[Level, Bounds]], float, float, float]:
    """Levels with what they cover, the gap between them, and the width and depth of all."""
    bounds = [(level, _bounds(scene, level)) for level in scene.levels]
    kept = [(level, box) for level, box in bounds if box is not None]
    gap = 0.06 * max((box[2] - box[0] for _, box in kept), default=1.0)
    wide = sum(box[2] - box[0] for _, box in kept) + gap * max(len(kept) - 1, 0)
    return kept, gap, max(wide, 1e-6), max((box[3] - box[1] for _, box in kept), default=1.0)


def _shape(scene: Scene) -> float:
    _, _, wide, high = _measure_levels(scene)
    return float(np.clip(high / wide, 0.5, 1.0))


def _lay_out(scene: Scene, pen: ImageDraw.ImageDraw, width: int, height: int) -> PlanPage:
    """Levels side by side in the middle of the page."""
    kept, gap, wide, high = _measure_levels(scene)
    scale = 0.95 * min(width / wide, height / max(high, 1e-6))
    left, origins = (width - scale * wide) / 2, {}
    for level, box in kept:
        base = (height + scale * (box[3] - box[1])) / 2
        origins[level.id] = (left - scale * box[0], base + scale * box[1])
        left += scale * (box[2] - box[0] + gap)
    return PlanPage(pen, scale, origins)


def _bounds(scene: Scene, level: Level) -> Bounds | None:
    """West, south, east and north of what a level's spaces and walls cover."""
    outlines = [space.outline for space in scene.spaces if space.level == level.id]
    for wall in scene.walls:
        if outlines and wall.level == level.id:
            outlines += [prism.outline for prism in wall.prisms]
    if not outlines:
        return None
    points = np.vstack(outlines)
    (west, south), (east, north) = points.min(0).tolist(), points.max(0).tolist()
    return west, south, east, north


def _fill(
    page: PlanPage, level: str, outline: Iterable[Sequence[float] | Floats], colour: Colour
) -> None:
    page.pen.polygon(page.points(level, outline), fill=colour)


def _draw_surface(page: PlanPage, surface: GroundSurface, level: str) -> None:
    """The surfaces on the ground; holes are ground again."""
    colour = SURFACES.get(surface.kind, SURFACES["pavement"])
    for outline, holes in surface.areas:
        _fill(page, level, outline, colour)
        for hole in holes:
            _fill(page, level, hole, GROUND)


def _draw_opening(page: PlanPage, opening: Opening) -> None:
    """Doors and passages clear the wall, windows are glass."""
    along = np.array([opening.ux, opening.uy]) * opening.width / 2
    across = np.array([-opening.uy, opening.ux]) * opening.thickness / 2
    at = np.array([opening.x, opening.y])
    corners = [at - along - across, at + along - across, at + along + across, at - along + across]
    if opening.level in page.origins and opening.roof is None:
        glass = opening.kind == "window"
        _fill(page, opening.level, corners, GLASS if glass else ROOM)


def _draw_piece(
    page: PlanPage,
    piece: Piece,
    level: str,
    catalog: Catalog,
    tints: dict[str, Colour],
    outdoors: bool,
) -> None:
    """Its footprint, tinted by use or by height, and its symbol."""
    if piece.function == "light" or level not in page.origins:
        return
    edge = LOCKED if piece.fixed and piece.function != "landmark" else LINE
    shape = page.points(level, outline_of(piece))
    if piece.category == "tree":
        page.pen.polygon(shape, fill=None)
        x, y = page.points(level, [piece.pose[:2]])[0]
        r = page.scale * min(piece.size.width, piece.size.depth) / 2
        page.pen.ellipse((x - r, y - r, x + r, y + r), fill=TREE)
        return
    colour = _shade(piece) if piece.category == "building" else tints[piece.function]
    page.pen.polygon(shape, fill=colour, outline=edge, width=FINER if piece.fixed else 2)
    if not outdoors:
        _draw_symbol(page, piece, level, catalog, edge)


def _draw_symbol(
    page: PlanPage, piece: Piece, level: str, catalog: Catalog, colour: Colour
) -> None:
    """The lines a plan shows a piece by."""
    x, y, _, heading = piece.pose
    cos, sin = float(np.cos(heading)), float(np.sin(heading))
    asset = asset_of(piece, catalog)
    for line in asset.symbol(piece.size) if asset else ():
        placed = [(x + px * sin + py * cos, y - px * cos + py * sin) for px, py in line]
        page.pen.line(page.points(level, placed), fill=colour, width=2)


def _shade(piece: Piece) -> Colour:
    """The colour of a building: darker the taller; landmarks are red-brown."""
    if piece.function == "landmark":
        return (172, 122, 98)
    share = (piece.size.height - LOWEST) / (HIGHEST - LOWEST)
    level = round(224 - 110 * float(np.clip(share, 0.0, 1.0)))
    return (level, level - 4, level - 10)


def _tints(pieces: Sequence[Piece]) -> dict[str, Colour]:
    """A colour for every function there is."""
    found: dict[str, Colour] = {}
    rest = 0
    for name in sorted({piece.function for piece in pieces}):
        known = next((colour for names, colour in USES if name in names), None)
        found[name] = known or OTHER[rest % len(OTHER)]
        rest += known is None
    return found
