"""Surfaces drawn from formulas: wood and boards, cloth, stone, masonry, ground.

Each function draws one repeat, ``shape`` (h, w) pixels for ``metres`` (down, across), as a
:class:`Surface`. Colours are multipliers of the linear colour of a material, so that one texture
serves every tint of it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.render.textures.noise import (
    Floats,
    Ints,
    Shape,
    cell_noise,
    grid_of,
    spectral_noise,
)

Rng = np.random.Generator
Metres = tuple[float, float]
JOINT = np.array([0.74, 0.72, 0.68])
"""Mortar beside bricks, as linear colour."""


class Surface(NamedTuple):
    """``tone`` (h, w, 3) by which a colour is multiplied, and ``height`` (h, w) in metres."""

    tone: Floats
    height: Floats


class Laid(NamedTuple):
    """Rectangles laid in rows: the number of the row and of the piece at each pixel, where it is
    along it and across it in metres from its middle, and how far the nearest joint is."""

    row: Ints
    piece: Ints
    along: Floats
    across: Floats
    edge: Floats


def _grey(tone: Floats, warm: float = 0.0) -> Floats:
    """Three channels of one tone; where it is dark the more saturated, the more ``warm``."""
    tone = np.maximum(tone, 0.02).astype(np.float32)
    return np.stack([tone ** (1 - warm), tone, tone ** (1 + 1.5 * warm)], -1)


def _flat(shape: Shape) -> Floats:
    return np.zeros(shape)


def lay_rows(
    shape: Shape, metres: Metres, wide: float, long: float, shift: float | Floats = 0.5
) -> Laid:
    """Rows ``wide`` metres across, of pieces ``long``; each row is shifted by a share of a piece,
    one after the other or by ``shift`` (rows,). The picture must hold whole rows and pieces.

    >>> laid = lay_rows((8, 16), (0.2, 0.4), 0.1, 0.2)
    >>> int(laid.row.max()), int(laid.piece.max()), round(float(laid.edge.max()), 4)
    (1, 1, 0.0375)
    """
    y, x = grid_of(shape)
    rows, pieces = round(metres[0] / wide), round(metres[1] / long)
    row = np.minimum((y * rows).astype(np.int64), rows - 1)
    shifts = np.arange(rows) * shift if isinstance(shift, float) else shift
    place = x * pieces + shifts[row]
    piece = np.floor(place).astype(np.int64) % pieces
    across = (y * rows - row - 0.5) * wide
    along = (place - np.floor(place) - 0.5) * long
    edge = np.minimum(wide / 2 - np.abs(across), long / 2 - np.abs(along))
    return Laid(row, piece, along, across, edge)


def _each(rng: Rng, laid: Laid) -> Floats:
    """One random number in [-1, 1] for every piece, at its pixels."""
    numbers = rng.uniform(-1, 1, (int(laid.row.max()) + 1, int(laid.piece.max()) + 1))
    return np.asarray(numbers[laid.row, laid.piece])


def _rise(edge: Floats, wide: float) -> Floats:
    """0 in a joint, 1 from ``wide`` metres off it."""
    found: Floats = np.clip(edge / wide, 0.0, 1.0)
    return found


def _grain(rng: Rng, shape: Shape, metres: Metres, rings: float, pores: float) -> Floats:
    """Grain along x: rings that are cut at a slant, and pores as streaks; about -1 to 1."""
    y, _ = grid_of(shape)
    bend = spectral_noise(rng, shape, (0.12 / metres[0], 1.6 / metres[1]), 2.6)
    phase = 2 * np.pi * (round(rings * metres[0]) * y + 0.9 * bend)
    ring = np.abs(np.sin(phase / 2)) ** 0.6 * 2 - 1
    streak = spectral_noise(rng, shape, (0.004 / metres[0], 0.35 / metres[1]), 1.4)
    cloud = spectral_noise(rng, shape, (0.15 / metres[0], 0.9 / metres[1]), 2.0)
    return 0.45 * ring + pores * 0.5 * streak + 0.35 * cloud


def wood(
    rng: Rng,
    shape: Shape,
    metres: Metres,
    rings: float = 26.0,
    contrast: float = 0.13,
    pores: float = 1.0,
    knots: int = 0,
) -> Surface:
    """Sawn wood, its grain along x: ``rings`` a metre, ``pores`` of open species."""
    grain = _grain(rng, shape, metres, rings, pores)
    tone = 1.0 + contrast * grain
    y, x = grid_of(shape)
    for _ in range(knots):
        cy, cx, size = rng.random(), rng.random(), rng.uniform(0.008, 0.016)
        dy = (np.remainder(y - cy + 0.5, 1) - 0.5) * metres[0]
        dx = (np.remainder(x - cx + 0.5, 1) - 0.5) * metres[1]
        away = np.hypot(dy, dx / 1.7) / size
        tone *= 1.0 - 0.45 * np.exp(-(away**2)) - 0.1 * np.exp(-((away - 1.7) ** 2) * 4)
    return Surface(_grey(tone, 0.25), _flat(shape))


def boards(
    rng: Rng,
    shape: Shape,
    metres: Metres,
    wide: float = 0.16,
    long: float = 1.2,
    joint: float = 0.002,
    contrast: float = 0.11,
    vary: float = 0.10,
    deep: float = 0.55,
) -> Surface:
    """A floor of boards: each cut from another place, a little lighter or darker, with joints."""
    rows = round(metres[0] / wide)
    laid = lay_rows(shape, metres, wide, long, rng.permutation(rows) / rows)
    grain = _grain(rng, shape, metres, 30.0, 1.0)
    numbers = rng.integers(0, shape[1], (rows, int(laid.piece.max()) + 1))
    y, _ = grid_of(shape)
    columns = (np.arange(shape[1])[None] + numbers[laid.row, laid.piece]) % shape[1]
    cut = grain[(y * shape[0]).astype(np.int64), columns]
    rise = _rise(laid.edge, joint)
    tone = (1.0 + contrast * cut + vary * _each(rng, laid)) * (1 - deep * (1 - rise))
    return Surface(_grey(tone, 0.22), 0.001 * _rise(laid.edge, 2.5 * joint))


def herringbone(
    rng: Rng, shape: Shape, metres: Metres, wide: float = 0.08, times: int = 6
) -> Surface:
    """Oak blocks in herringbone, ``times`` as long as ``wide``; the picture is two blocks high
    and wide. Block of a cell (i, j) of the grid of width ``wide``: lying for
    ``(i + j) mod 2 n < n``, else standing."""
    y, x = grid_of(shape)
    fy, fx = y * metres[0] / wide, x * metres[1] / wide
    i, j = np.floor(fy).astype(np.int64), np.floor(fx).astype(np.int64)
    place = (j - i) % (2 * times)
    lying = place < times
    along = np.where(lying, place + fx - j, 2 * times - 1 - place + fy - i)
    across = np.where(lying, fy - i, fx - j)
    edge = np.minimum(np.minimum(across, 1 - across), np.minimum(along, times - along)) * wide
    lines = round(metres[0] / wide)
    first = np.where(lying, (j - place) % lines, (i - (2 * times - 1 - place)) % lines)
    name = np.where(lying, i * lines + first, lines * lines + j * lines + first)
    offsets = rng.random((2 * lines * lines, 3))[name]
    grain = _grain(rng, (256, 512), (0.4, 0.8), 40.0, 1.0)
    row = ((offsets[..., 0] + across * wide / 0.4) * 256).astype(np.int64) % 256
    column = ((offsets[..., 1] + along * wide / 0.8) * 512).astype(np.int64) % 512
    rise = _rise(edge, 0.0015)
    tone = (1 + 0.11 * grain[row, column] + 0.09 * (2 * offsets[..., 2] - 1)) * (0.5 + 0.5 * rise)
    return Surface(_grey(tone, 0.22), 0.001 * _rise(edge, 0.004))


def tiles(
    rng: Rng,
    shape: Shape,
    metres: Metres,
    wide: float = 0.3,
    long: float = 0.3,
    joint: float = 0.004,
    contrast: float = 0.02,
    vary: float = 0.025,
    shift: float = 0.0,
    deep: float = 0.32,
) -> Surface:
    """Tiles, slabs or setts in rows, with joints that lie lower."""
    laid = lay_rows(shape, metres, wide, long, shift)
    cloud = spectral_noise(rng, shape, (wide / metres[0], long / metres[1]), 1.8)
    rise = _rise(laid.edge - joint / 4, joint / 2)
    tone = (1 + contrast * cloud + vary * _each(rng, laid)) * (1 - deep * (1 - rise))
    return Surface(_grey(tone, 0.1), 0.0015 * _rise(laid.edge, joint))


def bricks(
    rng: Rng,
    shape: Shape,
    metres: Metres,
    wide: float = 0.0833,
    long: float = 0.25,
    vary: float = 0.16,
    joint: float = 0.012,
    mortar: float = 1.0,
) -> Surface:
    """Bricks in running bond (240 x 71 mm and joints of 10 to 12 mm, DIN 4172), or blocks of
    stone; mortar of its own colour by ``mortar`` beside a brick of linear (0.30, 0.11, 0.06)."""
    laid = lay_rows(shape, metres, wide, long)
    rough = spectral_noise(rng, shape, (0.02 / metres[0], 0.02 / metres[1]), 1.2)
    rise = _rise(laid.edge - joint / 2, 0.003)[..., None]
    tone = _grey(np.clip(1 + vary * _each(rng, laid) + 0.06 * rough, 0.4, 1.7), 0.2)
    between = 1 + mortar * (JOINT * 0.62 / np.array([0.30, 0.11, 0.06]) - 1)
    found = tone * rise + between * (1 + 0.05 * rough[..., None]) * (1 - rise)
    return Surface(found, 0.006 * _rise(laid.edge - joint / 3, 0.005) + 0.0002 * rough)


def roof_tiles(
    rng: Rng, shape: Shape, metres: Metres, wide: float = 0.24, tall: float = 0.32
) -> Surface:
    """Pantiles in courses: a wave across, each course lying on the one below."""
    laid = lay_rows(shape, metres, tall, wide, 0.0)
    wave = np.cos(2 * np.pi * laid.along / wide)
    down = laid.across / tall + 0.5
    rough = spectral_noise(rng, shape, (0.05 / metres[0], 0.05 / metres[1]), 1.5)
    lip = np.clip((down - 0.88) / 0.1, 0.0, 1.0)
    tone = 1 + 0.12 * wave + 0.1 * _each(rng, laid) + 0.05 * rough - 0.5 * lip**2
    return Surface(_grey(tone, 0.15), 0.02 * wave + 0.02 * down * (1 - lip))


def weave(
    rng: Rng, shape: Shape, metres: Metres, thread: float = 0.003, vary: float = 0.12
) -> Surface:
    """Plain weave: threads over and under each other, each of its own shade, a little uneven."""
    y, x = grid_of(shape)
    down, across = (round(side / thread) for side in metres)
    i, j = (y * down).astype(np.int64), (x * across).astype(np.int64)
    over = (i + j) % 2 == 0
    fy, fx = y * down - i - 0.5, x * across - j - 0.5
    bulge = np.where(
        over,
        np.cos(np.pi * fy) * (0.6 + 0.4 * np.cos(np.pi * fx)),
        np.cos(np.pi * fx) * (0.6 + 0.4 * np.cos(np.pi * fy)),
    )
    shade = np.where(over, rng.normal(size=down)[i], rng.normal(size=across)[j])
    slub = spectral_noise(rng, shape, (0.01 / metres[0], 0.06 / metres[1]), 1.3)
    tone = 0.72 + 0.36 * bulge + vary * (0.5 * shade + 0.4 * slub)
    return Surface(_grey(np.clip(tone, 0.3, 1.6), 0.12), 0.0006 * bulge)


def leather(rng: Rng, shape: Shape, metres: Metres) -> Surface:
    """Grained hide: small cells with creases between them, darker where they meet."""
    count = tuple(round(side / 0.005) for side in metres)
    cells = cell_noise(rng, shape, (count[0], count[1]))
    crease = np.clip((cells.next - cells.near) / 0.35, 0, 1)
    cloud = spectral_noise(rng, shape, (0.3, 0.3), 2.4)
    return Surface(_grey(0.82 + 0.2 * crease + 0.06 * cloud, 0.2), 0.0005 * crease**0.7)


def carpet(rng: Rng, shape: Shape, metres: Metres, tuft: float = 0.006) -> Surface:
    """Cut pile: tufts side by side, each of its own shade."""
    count = tuple(round(side / tuft) for side in metres)
    cells = cell_noise(rng, shape, (count[0], count[1]))
    shade = rng.normal(size=count[0] * count[1])[cells.cell]
    cloud = spectral_noise(rng, shape, (0.25, 0.25), 2.0)
    dome = np.clip(1 - cells.near**2, 0, 1)
    return Surface(_grey(0.68 + 0.4 * dome + 0.08 * shade + 0.03 * cloud, 0.1), 0.003 * dome)


def terrazzo(rng: Rng, shape: Shape, metres: Metres, chip: float = 0.02) -> Surface:
    """Chips of marble of several colours and sizes in a light ground, polished flat."""
    count = tuple(round(side / chip) for side in metres)
    cells = cell_noise(rng, shape, (count[0], count[1]))
    palette = np.array([[0.55, 0.5, 0.46], [1.25, 1.22, 1.15], [0.85, 0.62, 0.5], [0.7, 0.72, 0.7]])
    pick = rng.integers(0, len(palette), count[0] * count[1])[cells.cell]
    size = rng.uniform(0.18, 0.42, count[0] * count[1])[cells.cell]
    inside = np.clip((size - cells.near) * 14, 0, 1)[..., None]
    ground = _grey(1 + 0.03 * spectral_noise(rng, shape, (0.02, 0.02), 1.0))
    return Surface(ground * (1 - inside) + palette[pick] * inside, _flat(shape))


def stone(rng: Rng, shape: Shape, metres: Metres, veins: float = 0.12) -> Surface:
    """Polished stone: clouds, and veins where a bent field passes through zero."""
    field = spectral_noise(rng, shape, (0.5, 0.5), 2.6)
    cloud = spectral_noise(rng, shape, (0.3, 0.3), 1.7)
    vein = np.exp(-np.abs(field) * 26) * np.clip(0.5 + cloud, 0, 1)
    speck = spectral_noise(rng, shape, (0.01 / metres[0], 0.01 / metres[1]), 1.0)
    return Surface(_grey(1 + 0.035 * cloud + 0.012 * speck - veins * vein, 0.12), _flat(shape))


def rough(
    rng: Rng,
    shape: Shape,
    metres: Metres,
    contrast: float = 0.03,
    grain: float = 0.02,
    spot: float = 0.01,
    relief: float = 0.0004,
) -> Surface:
    """Concrete, screed, plaster: clouds of ``contrast`` and a ``grain`` of spots, in metres."""
    cloud = spectral_noise(rng, shape, (0.4, 0.4), 2.2)
    fine = spectral_noise(rng, shape, (spot / metres[0], spot / metres[1]), 1.2)
    return Surface(_grey(1 + contrast * cloud + grain * fine, 0.05), relief * fine)


def grit(
    rng: Rng, shape: Shape, metres: Metres, size: float = 0.012, vary: float = 0.25
) -> Surface:
    """Stones pressed together: asphalt, gravel, felt with chippings."""
    count = tuple(round(side / size) for side in metres)
    cells = cell_noise(rng, shape, (count[0], count[1]))
    shade = rng.uniform(-1, 1, count[0] * count[1])[cells.cell]
    cloud = spectral_noise(rng, shape, (0.3, 0.3), 2.0)
    dome = np.clip((cells.next - cells.near) / 0.5, 0, 1)
    tone = 0.82 + 0.24 * dome + vary * 0.6 * shade + 0.06 * cloud
    return Surface(_grey(tone, 0.05), 0.35 * size * dome)


def grass(rng: Rng, shape: Shape, metres: Metres) -> Surface:
    """Lawn: blades in all directions, patches of another green; strokes are noise drawn out along
    seven directions of the torus."""
    y, x = (np.arange(n)[:, None] if k == 0 else np.arange(n)[None] for k, n in enumerate(shape))
    blades = np.zeros(shape)
    for turn in (-3, -2, -1, 0, 1, 2, 3):
        one = spectral_noise(rng, shape, (0.03 / metres[0], 0.003 / metres[1]), 2.0)
        blades += one[y, (x + turn * y) % shape[1]] / np.sqrt(7)
    patch = spectral_noise(rng, shape, (0.5, 0.5), 2.0)
    green = _grey(np.clip(1.0 + 0.26 * blades + 0.05 * patch, 0.3, 1.9))
    dry = (0.03 * patch)[..., None] * np.array([1.2, 0.2, -0.4])
    return Surface(green * (1 + dry), 0.01 * blades)


def leaves(rng: Rng, shape: Shape, metres: Metres) -> Surface:
    """A crown or hedge: leaves in clumps over the dark between them."""
    cells = cell_noise(rng, shape, (round(metres[0] / 0.06), round(metres[1] / 0.06)))
    shade = rng.uniform(-1, 1, int(cells.cell.max()) + 1)[cells.cell]
    clump = spectral_noise(rng, shape, (0.3, 0.3), 1.6)
    dome = np.clip(cells.next - cells.near, 0, 1)
    tone = np.clip(0.72 + 0.5 * dome + 0.16 * shade + 0.16 * clump, 0.2, 1.9)
    return Surface(_grey(tone, -0.1), 0.03 * dome)
