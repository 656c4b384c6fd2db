"""What stands in churches, and the bar of a restaurant: demands called altar, pulpit, font, bar."""

from __future__ import annotations

from scenewright.catalog.assets import materials as m
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.solids import block, disc, lathe, rod

TABLE = 0.95
"""Height of an altar."""


def _altar(size: Size, stone: Material) -> Parts:
    """Steps all round; where there is height for it an altar on them with cloth, cross, candles."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    bare = h < TABLE + 0.2
    count = max(1, round((h if bare else 0.3 * (h - TABLE) + 0.1) / 0.15))
    rise = h / count if bare else 0.15
    found: Stuff = {
        stone: [
            block((-w + 0.3 * k, w - 0.3 * k), (-d, d - 0.3 * k), (rise * k, rise * (k + 1)))
            for k in range(count)
        ],
        m.VELVET: [],
    }
    low = rise * count
    half = min(0.35 * w, 1.1)
    run = block((-0.3 * half, 0.3 * half), (-0.5 * d, d - 0.3 * (count - 1)), (low, low + 0.004))
    found[m.VELVET].append(run)
    if bare:
        del found[m.VELVET]
        return parts(size, found)
    deep, top = min(0.35 * d, 0.4), low + min(TABLE, 0.75 * (h - low))
    y = (-0.4 * d - deep, -0.4 * d + deep)
    found[stone] += [
        block((-0.8 * half, 0.8 * half), (y[0] + 0.08, y[1] - 0.08), (low, top - 0.1)),
        block((-half, half), y, (top - 0.1, top)),
    ]
    found[m.LINEN] = [
        block((-0.7 * half, 0.7 * half), (y[0], y[1] + 0.006), (top, top + 0.006)),
        block((-0.7 * half, 0.7 * half), (y[1], y[1] + 0.006), (top - 0.3, top)),
    ]
    tall, at = h - top - 0.006, y[0] + 0.15
    bar = top + 0.006 + 0.66 * tall
    found[m.GILT] = [
        rod((0, at, top + 0.006), (0, at, h), 0.018, sides=8),
        rod((-0.22 * tall - 0.05, at, bar), (0.22 * tall + 0.05, at, bar), 0.018, sides=8),
        *(
            lathe(
                [(0.06, top + 0.006), (0.015, top + 0.05), (0.02, top + 0.3 * tall)],
                (x * half, at),
                10,
            )
            for x in (-0.6, -0.4, 0.4, 0.6)
        ),
    ]
    found[m.PAPER] = [
        disc(0.014, (top + 0.3 * tall, top + 0.6 * tall), (x * half, at), 8)
        for x in (-0.6, -0.4, 0.4, 0.6)
    ]
    return parts(size, found)
