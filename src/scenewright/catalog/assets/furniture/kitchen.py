"""Kitchen units: plinth, fronts, handles and worktop included."""

from __future__ import annotations

from math import pi

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.furniture.corners import Outline, corner_outline, cover
from scenewright.catalog.assets.joinery import GAP, door_pulls, drawer_pulls, front, fronts, spread
from scenewright.catalog.assets.materials import (
    BLACK,
    CERAMIC_GLASS,
    CREAM,
    OAK,
    RUBBER,
    SAGE,
    STEEL,
    STONE,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.symbols import Lines, close_line, draw_crossed_box, path, rectangle
from scenewright.core.footprint import Footprint
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, extrude, loft, rotate_mesh
from scenewright.geometry.solids import Interval, block, rectangle_ring, slab

PLINTH, TOP, FACE = 0.1, 0.038, 0.03


HANDLE = 0.018


def unit(size: Size, top: bool = True) -> tuple[Stuff, Interval, Interval, float]:
    """Plinth, carcass and worktop; the interval in x and z for fronts, and where they stand."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    face, high = d - FACE - HANDLE, h - TOP
    found: Stuff = {
        RUBBER: [block((-w + 0.001, w - 0.001), (-d + 0.02, face - 0.04), (0, PLINTH))],
        WHITE: [block((-w, w), (-d, face), (PLINTH, high))],
        SAGE: [],
        BLACK: [],
        STONE: [block((-w, w), (-d, d), (high, h))] if top else [],
    }
    return found, (-w, w), (PLINTH, high), face


def doors(found: Stuff, x: Interval, z: Interval, face: float, columns: int) -> None:
    """Add a row of doors with their handles."""
    found[SAGE] += fronts(x, z, columns, 1, (face, face + 0.018), "door")
    found[BLACK] += drawer_pulls(x, z, columns, 1, face + 0.018, HANDLE, 0.4)


def drawers(found: Stuff, x: Interval, z: Interval, face: float, heights: list[float]) -> None:
    """Add drawers from below up, each a share of the height, with their handles."""
    low = z[0]
    for share in heights:
        high = low + share * (z[1] - z[0])
        found[SAGE] += fronts(x, (low, high), 1, 1, (face, face + 0.018))
        found[BLACK] += drawer_pulls(x, (low, high), 1, 1, face + 0.018, HANDLE, 0.4)
        low = high


def _base_cabinet(size: Size) -> Parts:
    found, x, z, face = unit(size)
    doors(found, x, z, face, 2 if size.width > 0.65 else 1)
    return parts(size, found)


def _drawer_cabinet(size: Size) -> Parts:
    found, x, z, face = unit(size)
    drawers(found, x, z, face, [0.4, 0.36, 0.24])
    return parts(size, found)


def _filler_panel(size: Size) -> Parts:
    """A plain panel in line with the fronts, worktop over it, nothing to open."""
    found, x, z, face = unit(size)
    found[SAGE].append(block(x, (face, face + 0.018), z))
    return parts(size, found)


def _tall_cabinet(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    face, columns = d - FACE - HANDLE, 2 if size.width > 0.65 else 1
    split = min(0.9, 0.42 * h)
    pulls = [
        m
        for z, at in (((PLINTH, split), 0.8), ((split, h), 0.15))
        for m in door_pulls((-w, w), z, columns, face + 0.018, HANDLE, at, 0.22)
    ]
    return parts(
        size,
        {
            RUBBER: [block((-w + 0.001, w - 0.001), (-d + 0.02, face - 0.04), (0, PLINTH))],
            WHITE: [block((-w, w), (-d, face), (PLINTH, h))],
            SAGE: [
                m
                for z in ((PLINTH, split), (split, h))
                for m in fronts((-w, w), z, columns, 1, (face, face + 0.018), "door")
            ],
            BLACK: pulls,
        },
    )


def _wall_cabinet(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    columns = 2 if size.width > 0.65 else 1
    face = d - 0.02
    return parts(
        size,
        {
            WHITE: [block((-w, w), (-d, face), (0, h))],
            CREAM: fronts((-w, w), (0, h), columns, 1, (face, d), "door"),
        },
    )


def _hood(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    if h < 0.3:
        lamp = slab((-w + 0.08, w - 0.08), (-0.3 * d, 0.3 * d), (0, 0.01), 0.01)
        return parts(size, {STEEL: [block((-w, w), (-d, d), (0.008, h))], CERAMIC_GLASS: [lamp]})
    rim, top = 0.06, 0.06 + min(0.2, 0.35 * h)
    duct = min(0.14, 0.6 * w)
    canopy = _canopy(w, d, (rim, top), duct)
    return parts(
        size,
        {
            STEEL: [
                block((-w, w), (-d, d), (0.006, rim)),
                canopy,
                block((-duct, duct), (-d, -d + 2 * duct), (top, h)),
            ],
            CERAMIC_GLASS: [
                block((-w + 0.04, w - 0.04), (d - 0.02, d - 0.001), (0.0, 0.02)),
                block((-w + 0.03, w - 0.03), (-d + 0.03, d - 0.03), (0, 0.01)),
            ],
        },
    )


def _canopy(w: float, d: float, z: Interval, duct: float) -> Mesh:
    return loft(
        [
            rectangle_ring((-w, w), (-d, d), z[0]),
            rectangle_ring((-duct - 0.01, duct + 0.01), (-d, -d + 2 * duct + 0.01), z[1]),
        ]
    )


def _island(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    over = min(0.28, 0.3 * size.depth)
    high, front, back = h - 0.04, d - over, -d + 0.04
    x = (-w + 0.03, w - 0.03)
    columns = max(2, round(size.width / 0.6))
    panel = [
        block((a + 0.006, b - 0.006), (front, front + 0.012), (PLINTH + 0.01, high - 0.01))
        for a, b in spread(*x, max(6, round(size.width / 0.12)))
    ]
    cells = (x, (PLINTH, high), columns, 2)
    fitted = fronts(*cells, (-back, 0.018 - back)), drawer_pulls(*cells, 0.018 - back, 0.018, 0.4)
    doors, pulls = ([rotate_mesh(mesh, "z", pi) for mesh in meshes] for meshes in fitted)
    return parts(
        size,
        {
            STONE: [slab((-w, w), (-d, d), (high, h), 0.012)],
            RUBBER: [block((x[0] + 0.04, x[1] - 0.04), (back + 0.05, front - 0.05), (0, PLINTH))],
            WHITE: [block(x, (back, front), (PLINTH, high))],
            SAGE: doors,
            BLACK: pulls,
            OAK: panel,
        },
    )


def _corner_cabinet(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    high, leg = h - TOP, min(0.6, 0.7 * size.width)

    def outline(inset: float, leg: float) -> list[tuple[float, float]]:
        return [
            (-w, -d),
            (w, -d),
            (w, -d + leg - inset),
            (-w + leg - inset, -d + leg - inset),
            (-w + leg - inset, d),
            (-w, d),
        ]

    y, x = -d + leg - FACE - HANDLE, -w + leg - FACE - HANDLE
    up = (PLINTH + GAP, high - GAP)
    face = front((x + 0.02 + GAP, w - GAP), up, (y, y + 0.018), "door", right=True)
    side = block((x, x + 0.018), (y + 0.02 + GAP, d - GAP), up)
    return parts(
        size,
        {
            STONE: [extrude(outline(0, leg), high, h)],
            WHITE: [extrude(outline(FACE + HANDLE, leg), PLINTH, high)],
            RUBBER: [extrude(outline(0.1, leg), 0, PLINTH)],
            SAGE: [face, side],
            BLACK: drawer_pulls((x + 0.02, w), (PLINTH, high), 1, 1, y + 0.018, HANDLE, 0.4),
        },
    )


def unit_symbol(size: Size) -> Lines:
    """The worktop with the line of the fronts below it."""
    w, d = size.width / 2, size.depth / 2
    return rectangle(size), path((-w, d - 0.04), (w, d - 0.04))


def _drawer_symbol(size: Size) -> Lines:
    return (*unit_symbol(size), path((-0.08, size.depth / 2 - 0.02), (0.08, size.depth / 2 - 0.02)))


def _island_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    over = min(0.28, 0.3 * size.depth)
    return rectangle(size, 0, 0.02), path((-w, d - over), (w, d - over))


def _corner_outline(size: Size) -> Outline:
    leg = min(0.6, 0.7 * size.width)
    return corner_outline(size, leg, leg)


def _corner_footprint(size: Size) -> Footprint:
    return () if size.depth <= 0.6 else cover(_corner_outline)(size)


def _corner_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    leg = min(0.6, 0.7 * size.width)
    outline = close_line(_corner_outline(size))
    return outline, path((-w, -d), (-w + leg, -d + leg))


ASSETS = (
    Drawing("base_cabinet", _base_cabinet, unit_symbol),
    Drawing("drawer_cabinet", _drawer_cabinet, _drawer_symbol),
    Drawing("filler_panel", _filler_panel),
    Drawing("tall_cabinet", _tall_cabinet, draw_crossed_box),
    Drawing("wall_cabinet", _wall_cabinet, draw_crossed_box),
    Drawing("hood", _hood, draw_crossed_box),
    Drawing("kitchen_island", _island, _island_symbol),
    Drawing("corner_cabinet", _corner_cabinet, _corner_symbol, footprint=_corner_footprint),
)
