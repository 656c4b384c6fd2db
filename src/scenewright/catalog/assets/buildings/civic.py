"""Public buildings: gallery, museum, gymnasium, Rococo palace."""

from __future__ import annotations

from scenewright.catalog.assets.buildings.facades import (
    box,
    columns,
    pediment,
    piers,
    rail,
    row,
    steps,
    windows,
)
from scenewright.catalog.assets.buildings.roofs import dome, gable
from scenewright.catalog.assets.materials import LIMESTONE, PANE, STONE, TIMBER, VERDIGRIS
from scenewright.catalog.assets.model import Parts, parts
from scenewright.core.scene import Size
from scenewright.geometry.solids import block, disc


def _museum(size: Size) -> Parts:
    """A temple front at the head of a flight of steps, wings with pilasters, a low dome."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    base, eave = 0.12 * h, 0.56 * h
    wings = ((-w, w), (-0.9 * d, 0.4 * d))
    centre = ((-0.36 * w, 0.36 * w), (-d, 0.62 * d))
    front = 0.8 * d
    spots = [(x, front - 0.4) for x in row(-0.33 * w, 0.33 * w, 8)]
    spots += [(s * 0.33 * w, front - 0.14 * d) for s in (-1, 1)]
    capitals = [
        block((x - 0.75, x + 0.75), (y - 0.75, y + 0.75), (eave - 0.05 * h, eave)) for x, y in spots
    ]
    bases = [
        block((x - 0.75, x + 0.75), (y - 0.75, y + 0.75), (base, base + 0.03 * h)) for x, y in spots
    ]
    wing_w = 0.62 * w
    sides = [((-w, -w + wing_w), wings[1]), ((w - wing_w, w), wings[1])]
    pilasters = [p for x, y in sides for p in piers(x, y, (base, 0.5 * h), 6.0, 0.9, 0.25, "f")]
    panes = [
        p for x, y in sides for p in windows(x, y, [(base, 0.5 * h)], 6.0, 0.4, 0.6, "fb", 0.2)
    ]
    panes += [
        p
        for s, (x, y) in zip("lr", sides, strict=True)
        for p in windows(x, y, [(base, 0.5 * h)], 6.0, 0.4, 0.6, s, 0.2)
    ]
    trim = [
        box(*wings, (0.5 * h, 0.54 * h), 0.35),
        box(*wings, (0, base), 0.2),
        block((-0.38 * w, 0.38 * w), (-d, front + 0.3), (eave, 0.63 * h)),
        *rail(wings[0], wings[1], (0.54 * h, 0.58 * h), 0.4),
    ]
    roof = [
        gable((-0.39 * w, 0.39 * w), (-d, front), (0.63 * h, 0.8 * h), "y"),
        dome(0.24 * w, (0.8 * h, 0.98 * h), (0, -0.3 * d), 18, 4),
        disc(0.03 * w, (0.96 * h, h), (0, -0.3 * d), 8),
    ]
    drum = disc(0.25 * w, (0.6 * h, 0.82 * h), (0, -0.3 * d), 18)
    gable_face = pediment((-0.39 * w, 0.39 * w), (front - 0.5, front + 0.35), (0.63 * h, 0.805 * h))
    flight = steps((-0.42 * w, 0.42 * w), (0.6 * d, d), base, 8)
    doors = [
        block((x - 0.04 * w, x + 0.04 * w), (0.6 * d, 0.63 * d), (base, 0.4 * h))
        for x in (-0.16 * w, 0.0, 0.16 * w)
    ]
    return parts(
        size,
        {
            LIMESTONE: [box(*wings, (0, 0.5 * h)), box(*centre, (0, eave)), drum, gable_face],
            STONE: [
                *columns(spots, (base, eave), 0.52),
                *capitals,
                *bases,
                *trim,
                *pilasters,
                *flight,
            ],
            VERDIGRIS: roof,
            PANE: panes,
            TIMBER: doors,
        },
    )
