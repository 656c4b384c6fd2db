"""Cars as exhibits: bodies swept along their length, glass and lamps cut from the same surface.

Their long side lies along that of their box.
"""

from __future__ import annotations

from functools import partial
from math import pi
from typing import NamedTuple

import numpy as np

from scenewright.catalog.assets import materials as m
from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.lengthwise import draw_lengthwise, lengthwise
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.symbols import Lines, close_line, path
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Floats, Mesh, loft, rotate_mesh
from scenewright.geometry.shells import shell
from scenewright.geometry.solids import block, cushion, rod

Curve = tuple[tuple[float, float], ...]


class Body(NamedTuple):
    """A make: its shoulder and its roof from tail to nose (shares of half the length and of the
    height), how high it clears the ground, and where its side windows are parted."""

    name: str
    deck: Curve
    roof: Curve
    under: float
    pillars: tuple[float, ...]


_LONG: Curve = ((-1.0, 0.5), (-0.96, 0.62), (-0.4, 0.635), (0.4, 0.63), (0.93, 0.52), (1.0, 0.42))
BODIES = (
    Body("hatchback", _LONG, ((-0.97, 0.62), (-0.74, 0.955), (-0.15, 1.0), (0.06, 0.975),
                              (0.45, 0.63)), 0.13, (-0.66, -0.28, 0.06, 0.3)),
    Body("saloon", ((-1.0, 0.54), (-0.96, 0.66), (-0.7, 0.67), *_LONG[2:]),
         ((-0.74, 0.67), (-0.42, 0.96), (-0.12, 1.0), (0.06, 0.97), (0.42, 0.63)),
         0.12, (-0.52, -0.2, 0.08, 0.28)),
    Body("estate", _LONG, ((-0.985, 0.64), (-0.88, 0.94), (-0.2, 1.0), (0.08, 0.975), (0.45, 0.63)),
         0.13, (-0.84, -0.5, -0.14, 0.12, 0.31)),
    Body("off-roader", ((-1.0, 0.5), (-0.97, 0.64), (0.4, 0.66), (0.94, 0.6), (1.0, 0.46)),
         ((-0.97, 0.64), (-0.88, 0.95), (-0.2, 1.0), (0.14, 0.985), (0.42, 0.66)),
         0.19, (-0.82, -0.5, -0.12, 0.14, 0.3)),
    Body("coupé", ((-1.0, 0.56), (-0.95, 0.66), (-0.4, 0.65), *_LONG[3:]),
         ((-0.9, 0.66), (-0.4, 0.95), (-0.1, 1.0), (0.04, 0.97), (0.4, 0.63)),
         0.11, (-0.5, -0.06, 0.26)),
)  # fmt: skip
_PLAN: Curve = ((-1.0, 0.86), (-0.94, 0.95), (-0.6, 1.0), (0.5, 0.99), (0.85, 0.94), (0.96, 0.86),
                (1.0, 0.74))  # fmt: skip
"""Half the width from tail to nose."""
AXLES, WHEEL, ARCH = (-0.6, 0.6), 0.215, 1.2
"""Where the axles are, the radius of wheels as a share of the height, and that of arches."""
_HALF = 11
"""Points of a section from the middle of the floor to the middle of the roof."""


def _at(curve: Curve, x: float) -> float:
    places, values = np.array(curve).T
    return float(np.interp(x, places, values))


def _section(body: Body, x: float, size: Size) -> Floats:
    """Half a section ``(11, 3)``: floor, wheel house, sill, side, shoulder, window, roof."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    wide, deck = _at(_PLAN, x) * d, _at(body.deck, x) * h
    inside = body.roof[0][0] <= x <= body.roof[-1][0]
    crown = max(_at(body.roof, x) * h - deck if inside else 0.0, 0.02 * h)
    low = (body.under + 0.08 * max(abs(x) - 0.85, 0.0) / 0.15) * h
    arch = low + 0.015
    for axle in AXLES:
        out = (ARCH * WHEEL * h) ** 2 - ((x - axle) * w) ** 2
        arch = max(arch, WHEEL * h + np.sqrt(out)) if out > 0 else arch
    lean = 0.24 * min(crown / (0.3 * h), 1.0)
    rows = (
        (0.0, low), (0.6, low), (0.6, arch), (0.965, arch), (1.0, arch + 0.5 * (deck - arch)),
        (0.985, arch + 0.86 * (deck - arch)), (0.93, deck), (0.9, deck + 0.12 * crown),
        (0.9 - lean, deck + 0.84 * crown), (0.78 - lean, deck + 0.95 * crown), (0.0, deck + crown),
    )  # fmt: skip
    return np.array([(x * w, wide * y, z) for y, z in rows])


def _stations(body: Body) -> list[float]:
    arches = [a + 0.155 * np.cos(t) for a in AXLES for t in np.linspace(0, pi, 11)]
    rows = [*np.linspace(-1, 1, 19), *arches, *(x for x, _ in body.roof + body.deck), 0.985, -0.985]
    found = [-1.0]
    for x in sorted(rows):
        if x - found[-1] > 0.012:
            found.append(float(x))
    return [*found[:-1], 1.0]


def _surface(body: Body, xs: Floats, rows: Floats, size: Size, side: int) -> Floats:
    """Points ``(n, k, 3)`` of a side of the body at stations and between rows of its sections."""
    halves = np.array([_section(body, float(x), size) for x in xs])
    low = np.minimum(rows.astype(np.int64), _HALF - 2)
    share = (rows - low)[None, :, None]
    grid = halves[:, low] * (1 - share) + halves[:, low + 1] * share
    return np.asarray(grid * (1, side, 1))


def _patch(
    body: Body, x: tuple[float, float], rows: tuple[float, float], size: Size, side: int
) -> Mesh:
    """A pane or lamp: a piece of the surface of a body, standing out of it by 4 mm."""
    xs = np.linspace(*x, 4)
    return shell(_surface(body, xs, np.linspace(*rows, 3), size, side), 0.004, 0.012)


def _screen(body: Body, x: tuple[float, float], size: Size) -> Mesh:
    """A windscreen or rear window: the roof's slope from side to side."""
    xs, rows = np.linspace(*x, 4), np.array([8.15, 9.0, 9.6, 10.0])
    right = _surface(body, xs, rows, size, 1)
    left = _surface(body, xs, rows[::-1][1:], size, -1)
    return shell(np.concatenate([right, left], 1), 0.004, 0.012)


def _car(size: Size, body: Body, paint: Material) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    halves = np.array([_section(body, x, size) for x in _stations(body)])
    rings = np.concatenate([halves[:, ::-1], (halves * (1, -1, 1))[:, 1:-1]], 1)
    hull = loft([ring[::-1] for ring in rings])
    sides = (-1, 1)
    tail, nose = body.roof[:2], body.roof[-2:]
    glass = [
        *(_patch(body, (a + 0.015, b - 0.015), (7.1, 7.9), size, s)
          for a, b in zip(body.pillars, body.pillars[1:], strict=False) for s in sides),
        _screen(body, (tail[0][0] + 0.03, tail[1][0] - 0.02), size),
        _screen(body, (nose[0][0] + 0.02, nose[1][0] - 0.03), size),
    ]  # fmt: skip
    seams = [
        _patch(body, (x - 0.0035, x + 0.0035), (3.3, 6.9), size, s)
        for x in body.pillars[1:] for s in sides
    ]  # fmt: skip
    sills = [_patch(body, (-0.42, 0.42), (3.05, 3.4), size, s) for s in sides]
    front = _section(body, 1.0, size)
    low, high = float(front[1, 2]), float(front[6, 2])
    wide = float(front[6, 1])

    def across(share: float, a: float, b: float, x: float, out: float) -> Mesh:
        z = (low + a * (high - low), low + b * (high - low))
        return block((min(x, x + out), max(x, x + out)), (-share * wide, share * wide), z)

    found: Stuff = {
        m.CERAMIC_GLASS: glass,
        m.BLACK: [*seams, *sills, across(0.62, 0.52, 0.86, w, 0.012),
                  across(0.8, 0.05, 0.3, w, 0.014), across(0.85, 0.04, 0.26, -w, -0.012)],
        m.PAPER: [across(0.28, 0.3, 0.46, w, 0.016), across(0.28, 0.55, 0.72, -w, -0.012)],
        m.CHROME: [across(0.64, 0.84, 0.88, w, 0.014),
                   *(block(((x + 0.04) * w - 0.06, (x + 0.04) * w + 0.06),
                           (s * 0.985 * d - 0.012, s * 0.985 * d + 0.012), (0.56 * h, 0.58 * h))
                     for x in body.pillars[1:-1] for s in sides)],
        m.GLOW: [_patch(body, (0.9, 0.985), (5.1, 6.3), size, s) for s in sides],
        m.VERMILION: [_patch(body, (-0.99, -0.93), (4.7, 6.3), size, s) for s in sides],
    }  # fmt: skip
    found.setdefault(paint, []).append(hull)
    x = (body.pillars[-1] + 0.02) * w
    found[paint] += [
        cushion((x - 0.06, x + 0.06), _span(s, 0.9 * d, d), (0.635 * h, 0.7 * h), 0.03, 2)
        for s in sides
    ]
    for axle in AXLES:
        for s in sides:
            for material, meshes in _wheel(axle * w, s, 0.95 * d, WHEEL * h).items():
                found.setdefault(material, []).extend(meshes)
    return parts(size, found)


def _span(side: int, near: float, far: float) -> tuple[float, float]:
    return (near, far) if side > 0 else (-far, -near)


def _wheel(x: float, side: int, y: float, radius: float) -> Stuff:
    """A tyre, a dark dish in its rim and five spokes over it."""

    def turned(share: float, near: float, far: float, sides: int = 24) -> Mesh:
        ends = ((x, side * (y + near), radius), (x, side * (y + far), radius))
        return rod(*ends, share * radius, sides=sides)

    spoke = block((x - 0.08 * radius, x + 0.08 * radius), _span(side, y + 0.001, y + 0.008),
                  (1.05 * radius, 1.66 * radius))  # fmt: skip
    spokes = [rotate_mesh(spoke, "y", 2 * pi * k / 5, (x, 0.0, radius)) for k in range(5)]
    return {
        m.RUBBER: [turned(1.0, -0.2, 0.0)],
        m.STEEL: [turned(0.72, -0.1, 0.003), *spokes, turned(0.18, 0.0, 0.012, 10)],
        m.BLACK: [turned(0.64, -0.1, 0.005)],
    }


def _car_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    rim = [(x * w, -y * d) for x, y in _PLAN] + [(x * w, y * d) for x, y in _PLAN[::-1]]
    front, back = (0.06, 0.45), (-0.74, -0.95)
    panes = [
        close_line(
            np.array([(a * w, -0.68 * d), (b * w, -0.8 * d), (b * w, 0.8 * d), (a * w, 0.68 * d)])
        )
        for a, b in (front, back)
    ]
    sides = [path((-0.74 * w, s * 0.68 * d), (0.06 * w, s * 0.68 * d)) for s in (-1, 1)]
    return close_line(np.array(rim)), *panes, *sides


_CAR = (Size(2.2, 1.1, 0.8), Size(4.5, 1.9, 1.5), Size(8.0, 3.0, 3.0))
_CARS = "car automobile vehicle cabriolet oldtimer auto voiture coche pkw 汽车 車 自動車"

ASSETS = tuple(
    Drawing(
        "exhibit_island",
        lengthwise(partial(_car, body=BODIES[k % len(BODIES)], paint=paint)),
        draw_lengthwise(_car_symbol),
        id=f"exhibit_island_car_{k + 1}",
        name=f"Car, {BODIES[k % len(BODIES)].name}, {paint.name.partition(' ')[0]}",
        sizes=_CAR,
        called=tuple(_CARS.split()),
    )
    for k, paint in enumerate(m.LACQUERS)
)
