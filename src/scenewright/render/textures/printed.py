"""What people print and paint: labels of packs, spines of books, posters, paintings, carpets.

Like the other surfaces each is one repeat that multiplies a colour; here hues differ within it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from scenewright.render.textures.generators import Metres, Rng, Surface, lay_rows
from scenewright.render.textures.noise import Floats, Shape, grid_of, spectral_noise

Hue = tuple[float, float, float]
PACKED = np.array(
    [
        (0.72, 0.06, 0.05), (0.02, 0.16, 0.45), (0.85, 0.52, 0.04), (0.05, 0.30, 0.10),
        (0.86, 0.84, 0.78), (0.86, 0.84, 0.78), (0.80, 0.26, 0.03), (0.30, 0.05, 0.22),
        (0.04, 0.38, 0.46), (0.70, 0.60, 0.42),
    ]
)  # fmt: skip
"""Linear colours of packs."""
BOUND = np.array(
    [
        (0.30, 0.05, 0.04), (0.04, 0.10, 0.22), (0.05, 0.16, 0.09), (0.70, 0.63, 0.50),
        (0.42, 0.22, 0.08), (0.75, 0.74, 0.70), (0.06, 0.06, 0.07), (0.55, 0.36, 0.08),
        (0.20, 0.30, 0.36), (0.62, 0.20, 0.10),
    ]
)  # fmt: skip
"""Linear colours of bindings."""


def _within(distance: Floats, soft: float) -> Floats:
    """1 where a distance is positive, 0 where it is negative, with an edge ``soft`` wide."""
    found: Floats = np.clip(distance / soft + 0.5, 0.0, 1.0)[..., None]
    return found


def _over(below: Floats, colour: Floats | Hue, share: Floats) -> Floats:
    found: Floats = below * (1 - share) + np.asarray(colour) * share
    return found


def labels(
    rng: Rng, shape: Shape, metres: Metres, wide: float = 0.16, long: float = 0.12
) -> Surface:
    """Packs side by side: each of a colour of its own with a band, a name, a picture, small
    print; ``wide`` is the height of a pack, ``long`` its width."""
    laid = lay_rows(shape, metres, wide, long, 0.37)
    each = (int(laid.row.max()) + 1, int(laid.piece.max()) + 1)
    here = (laid.row, laid.piece)
    u, v = laid.along / long, -laid.across / wide
    ground, other = (PACKED[rng.integers(0, len(PACKED), each)][here] for _ in range(2))
    found = ground * (1 - 0.25 * _within(0.5 * np.abs(u) - 0.2, 0.05))
    top = rng.uniform(0.02, 0.2, each)[here]
    found = _over(found, other, _within(0.17 - np.abs(v - top - 0.1), 0.03))
    word = np.minimum(0.034 - np.abs(v - top - 0.12), rng.uniform(0.22, 0.4, each)[here] - abs(u))
    letters = np.sin(u * rng.uniform(60, 90, each)[here]) + 0.75
    found = _over(found, (0.9, 0.88, 0.84), _within(np.minimum(word, 0.1 * letters), 0.02))
    size = rng.uniform(0.1, 0.17, each)[here]
    round_it = size - np.hypot(u - rng.uniform(-0.12, 0.12, each)[here], v + 0.2)
    found = _over(found, PACKED[rng.integers(0, len(PACKED), each)][here], _within(round_it, 0.03))
    small = np.minimum(0.01 - np.abs(np.mod(v, 0.05) - 0.025), 0.12 - np.abs(v + 0.42))
    found = _over(found, found * 0.45, _within(np.minimum(small, 0.35 - np.abs(u)), 0.012))
    edge = np.clip(laid.edge / 0.003, 0.0, 1.0)
    return Surface(found * (0.45 + 0.55 * edge)[..., None], 0.0 * laid.edge)


def spines(rng: Rng, shape: Shape, metres: Metres) -> Surface:
    """Books side by side, 1.2 to 4 cm thick: binding, title, bands, a dark line between two."""
    thick = rng.uniform(0.012, 0.04, int(metres[1] / 0.02))
    ends = np.cumsum(thick)
    ends *= metres[1] / ends[-1]
    y, x = grid_of(shape)
    place = x * metres[1]
    book = np.minimum(np.searchsorted(ends, place), len(ends) - 1)
    start = np.concatenate([[0.0], ends[:-1]])[book]
    u, half = (place - start) / (ends[book] - start) - 0.5, (ends[book] - start) / 2
    count = len(ends)
    found = BOUND[rng.integers(0, len(BOUND), count)][book]
    found = found * rng.uniform(0.7, 1.3, count)[book][..., None]
    ink = np.where(found.mean(-1, keepdims=True) > 0.3, 0.04, np.array([0.75, 0.6, 0.3]))
    middle, reach = rng.uniform(0.3, 0.6, count)[book], rng.uniform(0.08, 0.2, count)[book]
    word = np.minimum(reach - np.abs(y - middle), 0.1 * (np.sin(y * 190.0 + book) + 0.7))
    found = _over(found, ink, _within(np.minimum(word, 0.2 - np.abs(u)), 0.02))
    band = np.minimum(0.006 - np.abs(np.abs(y - 0.5) - rng.uniform(0.3, 0.44, count)[book]), 0.2)
    found = _over(found, ink, _within(band, 0.008) * (rng.random(count)[book] > 0.5)[..., None])
    rounded = np.clip((half - np.abs(u) * 2 * half) / 0.003, 0.0, 1.0)
    worn = 1 + 0.05 * spectral_noise(rng, shape, (0.2, 0.02), 1.4)
    return Surface(found * ((0.35 + 0.65 * rounded) * worn)[..., None], 0.001 * rounded)


def _framed(found: Floats, varnish: Hue = (0.05, 0.04, 0.03), margin: float = 0.012) -> Surface:
    """A picture with a margin, so that it ends all round as it begins."""
    y, x = grid_of(found.shape[:2])
    inside = np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y)) - margin
    return Surface(_over(np.broadcast_to(varnish, found.shape), found, _within(inside, 0.006)),
                   0.0 * x)  # fmt: skip


def _brushed(rng: Rng, found: Floats, by: float = 0.09) -> Floats:
    stroke = spectral_noise(rng, found.shape[:2], (0.012, 0.06), 1.6)
    return np.asarray(np.maximum(found * (1 + by * stroke[..., None]), 0.004))


def landscape(rng: Rng, shape: Shape, metres: Metres, warm: float = 0.5) -> Surface:
    """Hills behind one another under a sky that is ``warm`` at the horizon, water before them."""
    del metres
    y, x = grid_of(shape)
    sky, glow = np.array([0.16, 0.26, 0.42]), np.array([0.8, 0.62 - 0.2 * warm, 0.5 - 0.35 * warm])
    low = np.clip(y / 0.55, 0, 1)[..., None] ** 1.5
    cloud = np.clip(spectral_noise(rng, shape, (0.1, 0.4), 2.2), 0, 1.5)[..., None]
    found = sky * (1 - low) + glow * low + 0.16 * cloud * (1 - 0.5 * low)
    for k, far in enumerate((0.9, 0.6, 0.35, 0.15)):
        ridge = 0.42 + 0.09 * k + (0.05 + 0.03 * k) * spectral_noise(rng, (4, shape[1]), (1, 0.4))
        near = np.array([0.05, 0.09 - 0.02 * warm, 0.03]) * (1.4 - 0.2 * k)
        found = _over(found, near * (1 - far) + 0.55 * far * (sky + glow) / 2,
                      _within(y - ridge[0][None], 0.012))  # fmt: skip
    water = _within(y - 0.82 + 0.015 * np.sin(9 * x), 0.02)
    shine = (
        0.5 * (sky + glow) * (0.5 + 0.3 * spectral_noise(rng, shape, (0.012, 0.3), 1.5))[..., None]
    )
    return _framed(_brushed(rng, _over(found, shine, water)))


def fields(rng: Rng, shape: Shape, metres: Metres, count: int = 3) -> Surface:
    """Soft fields of colour above one another, as abstract painters laid them."""
    del metres
    y, x = grid_of(shape)
    ground, *hues = PACKED[rng.permutation(len(PACKED))[: count + 1]]
    found = np.broadcast_to(0.6 * ground + 0.1, (*shape, 3))
    cuts = np.sort(np.append(rng.uniform(0.2, 0.8, count - 1), [0.06, 0.94]))
    soft = 0.012 * spectral_noise(rng, shape, (0.05, 0.05), 1.5)
    for low, high, hue in zip(cuts, cuts[1:], hues, strict=False):
        inside = np.minimum(np.minimum(y - low - 0.02, high - 0.02 - y), 0.42 - np.abs(x - 0.5))
        found = _over(found, hue, _within(inside + soft, 0.035) * 0.92)
    return _framed(_brushed(rng, found, 0.12), (0.7, 0.68, 0.62))


def strokes(rng: Rng, shape: Shape, metres: Metres, count: int = 26) -> Surface:
    """Discs, bars and arcs over one another on a light ground."""
    del metres
    y, x = grid_of(shape)
    found = np.broadcast_to(np.array([0.78, 0.72, 0.6]), (*shape, 3))
    for k in range(count):
        cx, cy, size, turn = (
            *rng.uniform(0.12, 0.88, 2),
            rng.uniform(0.03, 0.17),
            6.3 * rng.random(),
        )
        p = (x - cx) * np.cos(turn) + (y - cy) * np.sin(turn)
        q = (y - cy) * np.cos(turn) - (x - cx) * np.sin(turn)
        away = np.hypot(p, q)
        form = (size - away, np.minimum(0.012 - abs(q), 2 * size - abs(p)),
                0.01 - np.abs(away - size))[k % 3]  # fmt: skip
        found = _over(found, PACKED[rng.integers(len(PACKED))] * (0.4 + 0.6 * (k % 2)),
                      _within(form, 0.006) * 0.9)  # fmt: skip
    return _framed(_brushed(rng, found, 0.05), (0.7, 0.66, 0.56))


Rounds = Sequence[tuple[float, float, float, float, Hue]]
SITTER: Rounds = (
    (0.5, 1.08, 0.42, 0.44, (0.035, 0.03, 0.045)),
    (0.5, 0.83, 0.13, 0.11, (0.62, 0.56, 0.46)),
    (0.5, 0.7, 0.07, 0.12, (0.40, 0.22, 0.13)),
    (0.5, 0.44, 0.165, 0.22, (0.06, 0.03, 0.015)),
    (0.5, 0.5, 0.125, 0.175, (0.52, 0.30, 0.19)),
    (0.46, 0.36, 0.14, 0.09, (0.05, 0.025, 0.012)),
    (0.455, 0.49, 0.02, 0.012, (0.05, 0.03, 0.02)),
    (0.545, 0.49, 0.02, 0.012, (0.05, 0.03, 0.02)),
    (0.5, 0.545, 0.014, 0.035, (0.44, 0.22, 0.13)),
    (0.5, 0.6, 0.035, 0.011, (0.33, 0.08, 0.06)),
)
FRUIT: Rounds = (
    (0.5, 1.05, 0.9, 0.34, (0.22, 0.11, 0.05)),
    (0.3, 0.44, 0.035, 0.2, (0.03, 0.1, 0.05)),
    (0.3, 0.6, 0.095, 0.19, (0.03, 0.12, 0.06)),
    (0.6, 0.74, 0.27, 0.1, (0.55, 0.57, 0.62)),
    (0.47, 0.64, 0.085, 0.085, (0.62, 0.09, 0.03)),
    (0.61, 0.62, 0.095, 0.095, (0.75, 0.30, 0.03)),
    (0.74, 0.65, 0.08, 0.08, (0.45, 0.50, 0.06)),
    (0.55, 0.56, 0.075, 0.075, (0.70, 0.16, 0.03)),
    (0.36, 0.86, 0.075, 0.07, (0.70, 0.52, 0.05)),
    (0.2, 0.84, 0.045, 0.045, (0.20, 0.03, 0.10)),
    (0.26, 0.88, 0.045, 0.045, (0.16, 0.02, 0.10)),
)
"""Ovals over one another that make a person who sits, and fruit on a table: middle, half axes,
linear colour."""


def ovals(rng: Rng, shape: Shape, metres: Metres, rows: Rounds = SITTER) -> Surface:
    """Ovals shaded from the upper left on a dark ground, as in a studio."""
    del metres
    y, x = grid_of(shape)
    light = np.clip(1.1 - 1.3 * np.hypot(x - 0.35, y - 0.4), 0.12, 1)[..., None]
    found = np.array([0.16, 0.11, 0.06]) * light
    for cx, cy, rx, ry, hue in rows:
        p, q = (x - cx) / rx, (y - cy) / ry
        away = np.hypot(p, q)
        depth = np.sqrt(np.clip(1 - away**2, 0, 1))
        lit = np.clip(0.3 + 0.75 * (0.65 * depth - 0.45 * p - 0.45 * q), 0.12, 1.3)
        found = _over(
            found, lit[..., None] * np.array(hue), _within((1 - away) * min(rx, ry), 0.01)
        )
    return _framed(_brushed(rng, found))


def poster(rng: Rng, shape: Shape, metres: Metres) -> Surface:
    """A board of a museum: a headline, a picture and two columns of text on white."""
    y, x = grid_of(shape)
    found = np.broadcast_to(np.array([0.84, 0.83, 0.80]), (*shape, 3))
    half = (shape[0] // 2, shape[1])
    held = np.tile(landscape(rng, half, metres, rng.random()).tone, (2, 1, 1))
    shifted = np.roll(held, int(0.16 * shape[0]), 0)
    found = _over(
        found, shifted, _within(np.minimum(0.2 - abs(y - 0.38), 0.42 - abs(x - 0.5)), 0.004)
    )
    ink = (0.04, 0.05, 0.07)
    head = np.minimum(0.022 - abs(y - 0.09), 0.32 - abs(x - 0.4))
    found = _over(found, ink, _within(np.minimum(head, 0.02 * (np.sin(95 * x) + 0.8)), 0.006))
    line = 0.006 - np.abs(np.mod(y, 0.026) - 0.013)
    column = np.minimum(0.19 - np.abs(np.abs(x - 0.5) - 0.22), 0.15 - np.abs(y - 0.79))
    letters = 0.004 * (np.sin(260 * x + 40 * np.sin(300 * np.floor(y / 0.026))) + 1.1)
    found = _over(
        found, 0.25 + 0 * found, _within(np.minimum(np.minimum(line, column), letters), 0.006)
    )
    return _framed(found, (0.84, 0.83, 0.80))


def tapestry(rng: Rng, shape: Shape, metres: Metres) -> Surface:
    """A knotted carpet: borders within one another, a medallion, small figures between."""
    del metres
    y, x = grid_of(shape)
    hues = np.array(
        [(0.33, 0.04, 0.03), (0.03, 0.06, 0.16), (0.60, 0.45, 0.22), (0.10, 0.14, 0.08)]
    )
    p, q = np.abs(x - 0.5), np.abs(y - 0.5)
    rim = 0.5 - np.maximum(p, q)
    small = np.sin(62 * p) * np.sin(62 * q) + 0.4 * np.sin(124 * (p + q))
    found = np.broadcast_to(hues[0], (*shape, 3))
    found = _over(found, hues[2], _within(small - 0.55, 0.2))
    found = _over(found, hues[1], _within(0.3 - 1.3 * p - q + 0.02 * np.sin(40 * (p - q)), 0.006))
    found = _over(found, hues[2], _within(np.minimum(0.22 - 1.3 * p - q, small - 0.1), 0.02))
    for inner, wide, hue in ((0.1, 0.1, 1), (0.085, 0.012, 2), (0.03, 0.012, 2), (0.015, 0.02, 0)):
        found = _over(found, hues[hue], _within(np.minimum(inner - rim, rim - inner + wide), 0.003))
    found = _over(found, hues[0], _within(np.minimum(0.02 - abs(rim - 0.055), small), 0.02))
    knots = 1 + 0.1 * rng.standard_normal(shape)[..., None]
    return _framed(found * knots, (0.5, 0.42, 0.3), 0.006)
