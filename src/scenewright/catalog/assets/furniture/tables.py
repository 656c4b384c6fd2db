"""Tables, desks and consoles."""

from __future__ import annotations

from scenewright.catalog.assets.furniture.corners import Outline, corner_outline, draw_border
from scenewright.catalog.assets.joinery import four_legs, fronts, knobs
from scenewright.catalog.assets.materials import BRASS, MIRROR, OAK, WHITE
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import Lines, path
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import block, disc, rod, slab


def drawers_wide(size: Size) -> float:
    """How wide the drawers of a desk are: a chair 0.62 m wide stands beside those down to the
    floor."""
    small = size.width < 1.1
    return 0.4 * size.width if small else min(0.42, size.width / 2 - 0.37)


def corner_desk_outline(size: Size) -> Outline:
    """The L of a desk round a corner, its wing on the left."""
    return corner_outline(size, min(0.7, 0.5 * size.depth), min(0.6, 0.45 * size.width))


def _vanity(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(h, 0.76)
    x, z = (-w + 0.03, w - 0.03), (top - 0.14, top - 0.022)
    face = d - 0.045
    legs = four_legs(w, d, (0, top - 0.022), 0.02, 0.013, 0.02, 0.02)
    found = {
        WHITE: [block(x, (-d + 0.02, face), z), *fronts(x, z, 2, 1, (face, face + 0.016))],
        OAK: [slab((-w, w), (-d, d), (top - 0.022, top), 0.03), *legs],
        BRASS: knobs(x, z, 2, 1, face + 0.016),
    }
    if h > top + 0.2:
        rim = 0.5 * min(w, 0.35)
        glass = disc(1.0, (0.0, 0.01), sides=28)
        plate = glass.vertices[:, [0, 2, 1]] * (1.4 * rim, 1, (h - top) / 2)
        middle = (0, -d + 0.03, (h + top) / 2)
        found[MIRROR] = [Mesh(plate + middle, glass.faces[:, ::-1])]
        found[OAK].append(rod((0, -d + 0.02, top - 0.02), (0, -d + 0.02, h - 0.05), 0.015))
    return parts(size, found)


def corner_desk_symbol(size: Size) -> Lines:
    """Outline of a desk round a corner and the line of its chest."""
    outline = corner_desk_outline(size)
    (edge, _), d = outline[4], size.depth / 2
    return draw_border(outline), path((-size.width / 2, d - 0.5), (edge, d - 0.5))
