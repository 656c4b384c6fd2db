"""Works and stores: a steampunk engine house, a warehouse."""

from __future__ import annotations

from math import cos, pi, sin

from scenewright.catalog.assets.buildings.building_plans import plan, ring, style, within
from scenewright.catalog.assets.buildings.facades import arch, arches, bays, box, on, row, steps
from scenewright.catalog.assets.buildings.roofs import dome, gable, spire, vault
from scenewright.catalog.assets.materials import (
    BRASS,
    BRICK,
    CONCRETE,
    COPPER,
    CURTAIN_WALL,
    IRON,
    METAL_SHEET,
    PANE,
    SLATE,
    STEEL,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import path
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, extrude, rotate_mesh, translate_mesh
from scenewright.geometry.solids import Interval, Spot, block, disc, lathe, tube

Rectangle = tuple[Interval, Interval]
"""An upright box in plan: from x to x, from y to y."""


def _chimney(w: float, h: float, top: float, at: Spot) -> Mesh:
    """A round brick chimney, thinner above, with a ring at its head; ``top`` in shares of h."""
    shape = [(0.09, 0), (0.085, 0.1), (0.06, 0.88), (0.085, 0.91), (0.075, top)]
    return lathe([(r * w, z * h) for r, z in shape], at, 8)


def _engine_frames(hall: Rectangle, tower: Rectangle, w: float, d: float, h: float) -> list[Mesh]:
    """Iron bands round the tower and the eaves, pilasters of the front, ribs of the glass vault."""
    frames = [box(*tower, (z * h, (z + 0.025) * h), 0.3) for z in (0.3, 0.64)]
    frames += [box(*hall, (0.32 * h, 0.35 * h), 0.25)]
    frames += on(
        "f",
        *hall,
        [
            block((a - 0.3, a + 0.3), (-0.1, 0.35), (0, 0.33 * h))
            for a, _ in bays((-0.62 * w, 0.62 * w), 6.0)
        ],
    )
    frames += [
        vault((x - 0.15, x + 0.15), (-0.72 * d, 0.52 * d), (0.34 * h, 0.53 * h), "x", 8)
        for x in row(-0.86 * w, 0.32 * w, 6)
    ]
    return frames


def _clock(w: float, h: float, at: float, face: float) -> tuple[list[Mesh], Mesh, list[Mesh]]:
    """The clock of the tower at ``x = at`` on the plane ``y = face``: cogs, dial, hands."""
    clock = [
        _cog(0.19 * w, (at, face, 0.5 * h), 0.5, 12),
        _cog(0.1 * w, (0.33 * w, face - 0.1, 0.4 * h), 0.9, 7),
    ]
    hub = rotate_mesh(disc(0.13 * w, (-0.8, 0.8), sides=14), "x", pi / 2)
    dial = translate_mesh(hub, at, face, 0.5 * h)
    hands = [
        block((at - 0.12, at + 0.12), (face + 0.8, face + 0.95), (0.5 * h, 0.5 * h + 0.11 * w)),
        block((at, at + 0.08 * w), (face + 0.8, face + 0.95), (0.5 * h - 0.12, 0.5 * h + 0.12)),
    ]
    return clock, dial, hands


def _pipes(w: float, d: float, h: float) -> list[Mesh]:
    """Pipes from the boilers into the hall, and along the wall beside the tower."""
    pipes = [
        tube(
            [
                (x * w, -0.3 * d, 0.34 * h),
                (x * w, -0.3 * d, z * h),
                (0.2 * w, -0.3 * d, z * h),
                (0.2 * w, -0.3 * d, 0.3 * h),
            ],
            0.025 * w,
            6,
        )
        for x, z in ((0.52, 0.48), (0.82, 0.56))
    ]
    pipes += [
        tube(
            [(0.92 * w, y * d, 0), (0.92 * w, y * d, 0.4 * h), (0.7 * w, y * d, 0.4 * h)],
            0.02 * w,
            5,
        )
        for y in (0.25, 0.45, 0.65)
    ]
    return pipes


def _steampunk_works(size: Size) -> Parts:
    """A brick engine house: a clock of cogs, copper boilers, pipes, chimneys, a glass vault."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    hall = ((-0.9 * w, 0.36 * w), (-0.8 * d, 0.6 * d))
    tower = ((0.36 * w, 0.84 * w), (0.1 * d, 0.8 * d))
    face, at = 0.8 * d, 0.6 * w
    brick = [
        box(*hall, (0, 0.34 * h)),
        box(*tower, (0, 0.66 * h)),
        *(_chimney(w, h, top, (x * w, -0.62 * d)) for x, top in ((0.5, 1.0), (0.78, 0.93))),
    ]
    frames = _engine_frames(hall, tower, w, d, h)
    glass = [vault((-0.86 * w, 0.32 * w), (-0.7 * d, 0.5 * d), (0.34 * h, 0.52 * h), "x", 8)]
    panes = on(
        "f",
        *hall,
        arches(
            [(a + b) / 2 for a, b in bays((-0.62 * w, 0.62 * w), 6.0)],
            (0.05 * h, 0.28 * h),
            3.2,
            (-0.1, 0.1),
        ),
    )
    clock, dial, hands = _clock(w, h, at, face)
    boilers = [
        *(_boiler(0.13 * w, 0.36 * h, (x * w, -0.3 * d)) for x in (0.52, 0.82)),
        dome(0.23 * w, (0.66 * h, 0.82 * h), (at, 0.45 * d), 10, 4),
    ]
    pipes = _pipes(w, d, h)
    lantern = [spire(at, 0.45 * d, (0.8 * h, 0.92 * h), 0.04 * w, 6)]
    door = [arch(at, (0.02 * h, 0.2 * h), 0.2 * w, (face - 0.1, face + 0.15))]
    return parts(
        size,
        {
            BRICK: brick,
            IRON: [*frames, *pipes, *hands, *door, *lantern],
            CURTAIN_WALL: glass,
            PANE: panes,
            BRASS: clock,
            COPPER: boilers,
            METAL_SHEET: [dial],
            CONCRETE: [
                block((-w, w), (-d, 0.9 * d), (0, 0.015 * h)),
                *steps((0.4 * w, 0.8 * w), (face, d), 0.02 * h, 2),
            ],
        },
    )


def _cog(radius: float, at: tuple[float, float, float], half: float, teeth: int) -> Mesh:
    """A toothed wheel that stands upright, its axis along y."""
    count = 4 * teeth
    outline: list[Spot] = []
    for k in range(count):
        angle = 2 * pi * k / count
        reach = radius * (1.0 if k % 4 < 2 else 0.84)
        outline.append((reach * cos(angle), reach * sin(angle)))
    wheel = rotate_mesh(extrude(outline, -half, half), "x", pi / 2)
    return translate_mesh(wheel, *at)


def _boiler(radius: float, high: float, at: Spot) -> Mesh:
    """A standing boiler with a round head."""
    shape = [
        (1.0, 0.0),
        (1.0, 0.3),
        (1.06, 0.31),
        (1.06, 0.35),
        (1.0, 0.36),
        (1.0, 0.8),
        (0.8, 0.93),
        (0.3, 1.0),
    ]
    return lathe([(r * radius, z * high) for r, z in shape], at, 8)


def _warehouse(size: Size) -> Parts:
    """A long shed of two shallow gables with loading gates, a canopy and a small office."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    eave = 0.78 * h
    body = ((-w, w), (-d, 0.8 * d))
    roofs = [gable(x, (-d, 0.8 * d), (eave, h), "y") for x in ((-w, 0.0), (0.0, w))]
    gates = [
        block((x - 2.0, x + 2.0), (0.8 * d, 0.8 * d + 0.12), (1.0, min(5.2, 0.6 * h)))
        for x in row(-0.84 * w, 0.4 * w, max(2, round(w / 5)))
    ]
    dock = [block((-0.98 * w, 0.54 * w), (0.78 * d, 0.95 * d), (0, 1.0))]
    canopy = [block((-0.98 * w, 0.54 * w), (0.78 * d, d), (0.66 * h, 0.7 * h))]
    office = [block((0.6 * w, 0.96 * w), (0.78 * d, 0.98 * d), (0, 0.62 * h))]
    panes = [
        block((0.62 * w, 0.94 * w), (0.97 * d, 0.985 * d), (z * h, (z + 0.12) * h))
        for z in (0.14, 0.42)
    ]
    ribs = [
        p
        for side in "lr"
        for p in on(
            side,
            *body,
            [
                block((y - 0.15, y + 0.15), (-0.1, 0.12), (0, eave))
                for y in row(-0.86 * d, 0.86 * d, 8)
            ],
        )
    ]
    lights = [
        gable(
            (x * w - 0.05 * w, x * w + 0.05 * w),
            (-0.85 * d, 0.65 * d),
            (0.94 * h, 1.03 * h),
            "y",
            0.05 * h,
        )
        for x in (-0.5, 0.5)
    ]
    return parts(
        size,
        {
            METAL_SHEET: [box(*body, (0, eave)), *ribs],
            SLATE: [*roofs],
            STEEL: [*gates, *canopy],
            CONCRETE: [*dock, *office],
            PANE: [*panes, *lights],
        },
    )


ASSETS = (
    style(
        "steampunk_works",
        "Steampunk works",
        _steampunk_works,
        plan(
            within(-0.9, 0.36, -0.8, 0.6),
            within(0.36, 0.84, 0.1, 0.8),
            ring(0.1, 0.5, -0.62),
            ring(0.1, 0.78, -0.62),
            door=(0.6, 1.0),
        ),
        (36, 26, 30),
    ),
    style(
        "warehouse",
        "Warehouse",
        _warehouse,
        plan(path((-0.5, -1), (-0.5, 0.8)), path((0.5, -1), (0.5, 0.8)), path((0, -1), (0, 0.8))),
        (60, 40, 11),
    ),
)
