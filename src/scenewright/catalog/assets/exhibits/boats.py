"""Boats as exhibits, on two trestles.

Their long side lies along that of their box; where there is height for it they carry a sail.
"""

from __future__ import annotations

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.lengthwise import draw_lengthwise, lengthwise
from scenewright.catalog.assets.materials import ACCENT, LINEN, OAK_DARK, TEAK, TIMBER, WHITE
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.symbols import Lines, close_line, path
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Floats, Mesh, loft
from scenewright.geometry.solids import block, profile, rod, sheet, tube

_RIM = ((-1.0, 0.62), (-0.7, 0.84), (-0.3, 0.98), (0.1, 1.0), (0.5, 0.84), (0.8, 0.5), (1.0, 0.04))
"""Half the breadth of a boat from its stern to its stem, in shares."""
SAILED = 0.4
"""Boats at least this high, as a share of their length, carry a mast."""


def _waterline(long: float, broad: float, low: float, rise: float) -> Floats:
    """A section at one height, its stem and stern drawn up by shares of ``rise``."""
    right = np.array([(x * long, -y * broad) for x, y in _RIM])
    whole = np.concatenate([right, right[::-1] * (1, -1)])
    height = low + rise * np.maximum(whole[:, 0] / long, -0.4 * whole[:, 0] / long) ** 2
    return np.column_stack([whole, height])


def _hull(w: float, d: float, low: float, high: float) -> tuple[Mesh, Mesh]:
    """The bottom, and the open upper strakes."""
    deep, rise = high - low, 0.16 * (high - low)
    top, chine = high - rise, low + 0.45 * deep
    bottom = loft(
        [
            _waterline(0.72 * w, 0.1 * d, low, 0.2 * rise),
            _waterline(0.86 * w, 0.6 * d, low + 0.2 * deep, 0.5 * rise),
            _waterline(0.94 * w, 0.86 * d, chine, 0.8 * rise),
        ]
    )
    strakes = loft(
        [
            _waterline(0.94 * w, 0.86 * d, chine, 0.8 * rise),
            _waterline(w, d, top, rise),
            _waterline(0.97 * w, 0.92 * d, top, rise),
            _waterline(0.88 * w, 0.74 * d, chine + 0.1 * deep, 0.5 * rise),
        ]
    )
    return bottom, strakes


def _boat(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    sailed = h >= SAILED * size.width
    high = 0.34 * h if sailed else h
    low = 0.22 * high
    bottom, strakes = _hull(w, d, low, high)
    seats = [
        block(((x - 0.05) * w, (x + 0.05) * w), (-y * d, y * d), (0.74 * high, 0.78 * high))
        for x, y in ((-0.6, 0.78), (-0.05, 0.9), (0.45, 0.74))
    ]
    gunwale = _waterline(0.985 * w, 0.96 * d, 0.865 * high, 0.13 * high)[: len(_RIM)]
    rails = [tube(gunwale * (1, s, 1), 0.02 + 0.008 * d, 5) for s in (1, -1)]
    trestles = [
        profile([(-0.5 * d, 0), (0.5 * d, 0), (0.35 * d, 0.42 * high), (-0.35 * d, 0.42 * high)], x)
        for x in ((-0.56 * w, -0.48 * w), (0.42 * w, 0.5 * w))
    ]
    found: Stuff = {
        ACCENT: [bottom],
        WHITE: [strakes],
        TEAK: [*seats, *rails],
        TIMBER: trestles,
        OAK_DARK: [],
    }
    if sailed:
        found[OAK_DARK] = [
            rod((0.1 * w, 0, 0.4 * high), (0.1 * w, 0, h), 0.05, 0.03, 8),
            rod((0.1 * w, 0, 1.25 * high), (-0.86 * w, 0, 1.2 * high), 0.035, sides=6),
        ]
        main = [(-0.84 * w, 1.25 * high), (0.07 * w, 1.3 * high), (0.07 * w, 0.97 * h)]
        found[LINEN] = [sheet(main, (-0.008, 0.008))]
    else:
        found[OAK_DARK] = [
            rod((-0.75 * w, s * 0.3 * d, 0.8 * high), (0.55 * w, s * 0.3 * d, 0.82 * high), 0.025)
            for s in (-1, 1)
        ]
    return parts(size, found)


def _boat_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    rim = _waterline(w, d, 0.0, 0.0)[:, :2]
    inner = rim * (0.93, 0.84)
    seats = [
        path((x * w, -y * d), (x * w, y * d)) for x, y in ((-0.6, 0.76), (-0.05, 0.83), (0.45, 0.7))
    ]
    return close_line(rim), close_line(inner), *seats


_CALLED = (
    "boat ship canoe kayak dinghy dinghies yacht gondola raft catamaran "
    "boot boote schiff schiffe kanu bateau bateaux navire barque barca barco bote velero 船 舟"
)

ASSETS = (
    Drawing(
        "exhibit_island",
        lengthwise(_boat),
        draw_lengthwise(_boat_symbol),
        id="exhibit_island_boat",
        name="Boat",
        sizes=(Size(1.5, 0.8, 0.5), Size(4.5, 1.9, 1.4), Size(9.0, 4.0, 4.0)),
        called=tuple(_CALLED.split()),
    ),
)
