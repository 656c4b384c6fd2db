"""What completes a furnished room: lamps under the ceiling, curtains at the windows."""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.building.ceiling import below, lowest
from scenewright.building.door_approach import DoorApproach, gates
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Space
from scenewright.domains.home.cases.furnishing import nearest_own
from scenewright.domains.home.furnishing.obstacles import join_standing, standing_of
from scenewright.domains.home.problem import Ground
from scenewright.geometry.fit import faults

DARK = frozenset(("balcony", "other", "storage"))
CURTAINED = frozenset(
    ("living", "dining", "study", "bedroom", "double_bedroom", "single_bedroom", "child_bedroom")
)
TABLES = ("dining_table", "round_table")
LAMP = Size(0.46, 0.46, 0.14)
HEAD_ROOM = 2.0  # what a lamp leaves below it, metres
TABLE_ROOM = 1.4  # what a lamp over a table leaves below it, metres
LEAST_LIT = 0.5  # the least floor that a ceiling lamp is hung over, square metres
PENDANT = Size(0.44, 0.44, 0.9)
CURTAIN_DEPTH = 0.09
COOKING = 0.8  # no curtain nearer than this to kitchen units, metres


def extras(
    space: Space, ground: Ground, pieces: tuple[Piece, ...], catalog: Catalog
) -> tuple[Piece, ...]:
    """Lamps and curtains for a room in which ``pieces`` stand already."""
    return (*_lamps(space, ground, pieces, catalog), *_curtains(space, ground, pieces, catalog))


def _lamps(
    space: Space, ground: Ground, pieces: tuple[Piece, ...], catalog: Catalog
) -> list[Piece]:
    if DARK & set(space.functions) or not space.functions:
        return []
    tables = [p for p in pieces if p.category in TABLES and p.function == "dining"]
    pendant, lamp = (
        _real(category, usual, catalog)
        for category, usual in (("pendant_lamp", PENDANT), ("ceiling_lamp", LAMP))
    )
    hung = [
        _hung("pendant_lamp", space, ground, catalog, *t.pose[:2], t.pose.heading, pendant, i)
        for i, t in enumerate(tables)
    ]
    found = [p for p in hung if p.pose.z > TABLE_ROOM]
    shape = _shape(space)
    high = shape.difference(below(shape, ground.slopes, space.height, HEAD_ROOM + lamp.height))
    x, y = _middle(high) if high.area > LEAST_LIT else (np.nan, np.nan)
    wide = high.buffer(-max(lamp.width, lamp.depth) * 0.72)
    far = wide.contains(shapely.Point(x, y)) and all(
        np.hypot(x - t.pose.x, y - t.pose.y) > 1.2 for t in tables
    )
    tall = any(p.pose.z + p.size.height > space.height - lamp.height for p in pieces)
    if far and not tall and space.height - lamp.height > HEAD_ROOM:
        found.append(_hung("ceiling_lamp", space, ground, catalog, x, y, 0.0, lamp, 0))
    return found


def _real(category: str, usual: Size, catalog: Catalog) -> Size:
    """The size of a user's own lamp nearest to the usual one; the usual one where there is none."""
    own = nearest_own(category, usual, catalog)
    return own.usual if own else usual


def _middle(shape: shapely.Geometry) -> tuple[float, float]:
    """The middle of the largest circle in a floor, where a ceiling lamp belongs."""
    circle = shapely.maximum_inscribed_circle(shape, tolerance=0.05)
    x, y = circle.coords[0]
    centre = shape.centroid
    inside = shape.buffer(-LAMP.width).contains(centre)
    return (centre.x, centre.y) if inside else (x, y)


def _shape(space: Space) -> shapely.Polygon:
    return shapely.Polygon(space.outline, list(space.holes))


def _hung(
    category: str,
    space: Space,
    ground: Ground,
    catalog: Catalog,
    x: float,
    y: float,
    heading: float,
    size: Size,
    index: int,
) -> Piece:
    own = nearest_own(category, size, catalog)
    asset = own if own and own.usual == size else catalog.choose(category, size)
    name = f"{space.id}/{category}" + (f"_{index + 1}" if index else "")
    box = np.array([[x, y, heading, size.width, size.depth]])
    ceiling = float(lowest(box, ground.slopes, space.height)[0])
    pose = Pose(float(x), float(y), ceiling - size.height, float(heading))
    return Piece(name, category, asset.id if asset else "", space.id, pose, size, space.id, "light")


def _curtains(
    space: Space, ground: Ground, pieces: tuple[Piece, ...], catalog: Catalog
) -> list[Piece]:
    if not CURTAINED & set(space.functions):
        return []
    standing = standing_of(pieces, frozenset(c for c, k in catalog.kinds.items() if k.flat))
    found: list[Piece] = []
    for gate in gates(space):
        opening = gate.opening
        outer = opening.kind == "window" and len(opening.spaces) == 1 and opening.roof is None
        if not outer or opening.width < 0.6 or _cooked_at(gate, pieces):
            continue
        for piece in _sizes(space, ground, gate, catalog, len(found)):
            box = np.array([[*piece.pose[:2], piece.pose.heading, *piece.size[:2]]])
            span = np.array([[piece.pose.z, piece.pose.z + piece.size.height]])
            codes, _ = faults(
                box,
                span,
                np.zeros(1, bool),
                ground.edges,
                ground.keep_free,
                ground.windows[:0],
                standing.boxes,
                standing.spans,
                0.002,
            )
            if codes[0] == 0:
                found.append(piece)
                standing = join_standing(standing, standing_of((piece,), frozenset()))
                break
    return found


def _cooked_at(gate: DoorApproach, pieces: tuple[Piece, ...]) -> bool:
    """True if kitchen units stand near a window: no place for a curtain."""
    near = gate.opening.width / 2 + COOKING
    units = (p for p in pieces if p.function in ("kitchen", "kitchenette", "counter"))
    return any(np.hypot(*(gate.face - np.array(p.pose[:2]))) < near for p in units)


def _sizes(
    space: Space, ground: Ground, gate: DoorApproach, catalog: Catalog, index: int
) -> list[Piece]:
    """A curtain to the floor, else one that ends below the sill; wide, else as the window."""
    opening = gate.opening
    heading = float(np.arctan2(gate.inward[1], gate.inward[0]))
    x, y = gate.face + gate.inward * (CURTAIN_DEPTH / 2 + 0.004)
    name = f"{space.id}/curtain" + (f"_{index + 1}" if index else "")
    pieces = []
    for low in (0.02, max(opening.sill - 0.12, 0.02)):
        for wider in (0.5, 0.24, 0.0):
            box = np.array([[x, y, heading, opening.width + wider, CURTAIN_DEPTH]])
            top = min(opening.head + 0.15, lowest(box, ground.slopes, space.height)[0] - 0.02)
            if top < min(opening.head, space.height - 0.02) - 1e-9:
                continue
            size = Size(opening.width + wider, CURTAIN_DEPTH, top - low)
            asset = catalog.choose("curtain", size)
            pose = Pose(float(x), float(y), low, heading)
            pieces.append(
                Piece(
                    name,
                    "curtain",
                    asset.id if asset else "",
                    space.id,
                    pose,
                    size,
                    space.id,
                    "light",
                )
            )
    return pieces
