"""What lies and stands between buildings: roads, trees, lamp posts, benches. Light, for there
are many."""

from __future__ import annotations

from math import cos, pi, sin

from scenewright.catalog.assets.buildings.roofs import spire
from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.furniture.greenery import rosette_symbol
from scenewright.catalog.assets.materials import BARK, BLACK, CONCRETE, GLOW, STEEL, TEAK
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import wobble
from scenewright.catalog.assets.symbols import Lines, oval, path, rectangle
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, loft
from scenewright.geometry.solids import block, disc, leg

CROWN = Material("crown", (0.31, 0.45, 0.24), roughness=0.95)
CROWN_LIGHT = Material("light crown", (0.41, 0.54, 0.29), roughness=0.95)
NEEDLES = Material("needles", (0.24, 0.37, 0.24), roughness=0.95)


def _clump(
    rx: float,
    ry: float,
    z: tuple[float, float],
    at: tuple[float, float],
    start: int,
    sides: int = 11,
) -> Mesh:
    """An uneven round mass of leaves, 10 ``sides`` triangles: a point, five rings, a point."""
    middle, half = (z[0] + z[1]) / 2, (z[1] - z[0]) / 2
    rings = [[(at[0], at[1], z[0] + 0.04 * half)] * sides]
    for k, angle in enumerate((-1.05, -0.55, 0.0, 0.55, 1.05)):
        ring = []
        for i in range(sides):
            turn = 2 * pi * (i + 0.5 * (k % 2)) / sides
            wide = cos(angle) * (0.9 + 0.12 * wobble(start + 7 * k + 3 * i))
            ring.append(
                (
                    at[0] + rx * wide * cos(turn),
                    at[1] + ry * wide * sin(turn),
                    middle + half * (sin(angle) + 0.1 * (wobble(start + 5 * k + i) - 0.5)),
                )
            )
        rings.append(ring)
    rings.append([(at[0], at[1], z[1])] * sides)
    return loft(rings)


def _tree(size: Size) -> Parts:
    """A broad crown of five masses on a trunk."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    trunk = leg(0.0, 0.0, (0.0, 0.5 * h), 0.02 * (w + d), 0.032 * (w + d), 8)
    return parts(
        size,
        {
            BARK: [trunk],
            CROWN: [
                _clump(0.8 * w, 0.8 * d, (0.3 * h, 0.84 * h), (0.0, 0.0), 0),
                _clump(0.5 * w, 0.5 * d, (0.27 * h, 0.66 * h), (-0.44 * w, 0.34 * d), 11, 9),
                _clump(0.5 * w, 0.5 * d, (0.3 * h, 0.7 * h), (0.38 * w, -0.44 * d), 23, 9),
            ],
            CROWN_LIGHT: [
                _clump(0.62 * w, 0.62 * d, (0.5 * h, h), (0.1 * w, 0.08 * d), 3),
                _clump(0.46 * w, 0.46 * d, (0.4 * h, 0.8 * h), (0.46 * w, 0.4 * d), 31, 9),
            ],
        },
    )


def _conifer(size: Size) -> Parts:
    """Three cones, one in the other."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    cones = [
        spire(0.0, 0.0, (low * h, high * h), wide, 8, k * pi / 8, 0.02)
        for k, (low, high, wide) in enumerate(
            ((0.12, 0.6, 1.0), (0.36, 0.8, 0.74), (0.58, 1.0, 0.5))
        )
    ]
    shaped = [Mesh(cone.vertices * (w, d, 1.0), cone.faces) for cone in cones]
    trunk = leg(0.0, 0.0, (0.0, 0.3 * h), 0.06 * w, 0.07 * w, 5)
    return parts(size, {BARK: [trunk], NEEDLES: shaped})


def _lamp_post(size: Size) -> Parts:
    """A tapered mast with an arm to the front and a flat head."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    back, thick = -0.8 * d, min(0.08, 0.5 * w)
    mast = leg(0.0, back, (0.0, 0.97 * h), 0.5 * thick, thick, 6)
    foot = disc(min(0.16, w), (0.0, 0.12), (0.0, back), 6)
    arm = block((-0.03, 0.03), (back, 0.7 * d), (0.965 * h, 0.985 * h))
    head = block((-w, w), (0.3 * d, d), (0.97 * h, h))
    light = block((-0.8 * w, 0.8 * w), (0.4 * d, 0.92 * d), (0.96 * h, 0.972 * h))
    return parts(size, {BLACK: [mast, foot, arm, head], GLOW: [light]})


def _site_bench(size: Size) -> Parts:
    """Slats for seat and back on two frames."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    seat = min(0.45, 0.55 * h)
    slats = [
        block((-w, w), (a * d, (a + 0.42) * d), (seat - 0.04, seat)) for a in (-0.5, 0.04, 0.58)
    ]
    back = [block((-w, w), (-d, -d + 0.05), (z * h, (z + 0.16) * h)) for z in (0.66, 0.84)]
    frames = []
    for s in (-1, 1):
        x = (s * 0.8 * w - 0.03, s * 0.8 * w + 0.03)
        frames += [
            block(x, (-d + 0.04, -d + 0.1), (0, 0.98 * h)),
            block(x, (0.8 * d - 0.06, 0.8 * d), (0, seat - 0.03)),
            block(x, (-d + 0.08, 0.8 * d), (seat - 0.09, seat - 0.035)),
        ]
    return parts(size, {TEAK: [*slats, *back], STEEL: frames})


def _lamp_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size), oval(0, -0.8 * d, 0.2 * min(w, d)), path((0, -0.8 * d), (0, d))


def _bench_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size), path((-w, -0.7 * d), (w, -0.7 * d)), path((-w, 0.2 * d), (w, 0.2 * d))


def _road(size: Size) -> Parts:
    """A strip of asphalt along the depth, paving beside it where it is wide enough."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    kerb = 0.76 * w if size.width >= 6.0 else w
    lanes = block((-kerb, kerb), (-d, d), (0.0, 0.7 * h if kerb < w else h))
    if kerb == w:
        return parts(size, {CONCRETE: [lanes]})
    sides = [block((-w, -kerb), (-d, d), (0.0, h)), block((kerb, w), (-d, d), (0.0, h))]
    return parts(size, {ASPHALT: [lanes], CONCRETE: sides})


def _road_symbol(size: Size) -> Lines:
    return (rectangle(size),)


ASPHALT = Material("asphalt", (0.36, 0.37, 0.38), roughness=0.95)
_TALL = (Size(1.5, 1.5, 4.0), Size(5.0, 5.0, 14.0), Size(9.0, 9.0, 30.0))

ASSETS = (
    Drawing("tree", _tree, rosette_symbol),
    Drawing("tree", _conifer, rosette_symbol, id="tree_conifer", name="Conifer", sizes=_TALL),
    Drawing("road", _road, _road_symbol),
    Drawing("lamp_post", _lamp_post, _lamp_symbol),
    Drawing("site_bench", _site_bench, _bench_symbol),
)
