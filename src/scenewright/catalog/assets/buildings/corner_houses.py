"""Houses round a corner, over an L."""

from __future__ import annotations

from scenewright.catalog.assets.buildings.building_plans import style
from scenewright.catalog.assets.buildings.facades import box, windows
from scenewright.catalog.assets.buildings.roofs import gable
from scenewright.catalog.assets.furniture.corners import Outline, corner_outline, cover, draw_border
from scenewright.catalog.assets.materials import BRICK, PANE, RENDER, STONE, TILES, TIMBER
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import Lines, path
from scenewright.core.scene import Size
from scenewright.geometry.solids import block


def _corner_house_outline(size: Size) -> Outline:
    return corner_outline(size, 0.48 * size.depth, 0.44 * size.width)


def _corner_house(size: Size) -> Parts:
    """Two gabled wings of two storeys that hold a terrace between them, the door in the nook."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    (_, front), (edge, _) = _corner_house_outline(size)[2:5:2]
    eave, out = 0.62 * h, 0.35
    main = ((-w + out, w - out), (-d + out, front - out))
    wing = ((-w + out, edge - out), (-d + out, d - out))
    levels = [(0.05 * h, 0.32 * h), (0.34 * h, 0.6 * h)]
    panes = [
        *windows(*main, levels, 2.8, 0.42, 0.52, "br"),
        *windows((edge, w - out), main[1], levels[1:], 2.4, 0.46, 0.52, "f"),
        *windows(*wing, levels, 2.6, 0.46, 0.52, "fl"),
        *windows(wing[0], (front, d - out), levels, 2.6, 0.46, 0.52, "r"),
    ]
    y = main[1][1]
    glazing = block((0.45 * (edge + w), w - out - 0.6), (y - 0.04, y + 0.04), (0.02 * h, 0.29 * h))
    door = block((edge + 0.3, edge + 1.3), (y - 0.05, y + 0.06), (0.02 * h, 0.29 * h))
    return parts(
        size,
        {
            RENDER: [box(*main, (0, eave)), box(*wing, (0, eave))],
            TILES: [
                gable((-w, w), (-d, front), (eave, 0.94 * h), "x"),
                gable((-w, edge), (-d, d), (eave, 0.92 * h), "y"),
            ],
            PANE: [*panes, glazing],
            TIMBER: [door],
            BRICK: [block((0.5 * w, 0.5 * w + 0.8), (-d + 0.9, -d + 1.6), (eave, h))],
            STONE: [box(*main, (0, 0.02 * h), 0.1), box(*wing, (0, 0.02 * h), 0.1)],
        },
    )


def _corner_house_symbol(size: Size) -> Lines:
    """The outline with both ridges, and the door in the nook."""
    w, d = size.width / 2, size.depth / 2
    outline = _corner_house_outline(size)
    (_, front), (edge, _) = outline[2], outline[4]
    back, left = (front - d) / 2, (edge - w) / 2
    wide = min(0.6, 0.12 * size.width)
    x = edge + 0.8 + wide
    door = path((x - wide, front), (x, front - 1.4 * wide), (x + wide, front))
    ridges = path((w, back), (left, back)), path((left, back), (left, d))
    return draw_border(outline), *ridges, door


ASSETS = (
    style(
        "corner_house",
        "L-shaped house",
        _corner_house,
        _corner_house_symbol,
        (15, 13, 8.5),
        cover(_corner_house_outline),
    ),
)
