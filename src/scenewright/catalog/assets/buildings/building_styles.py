"""The table of building styles, and how light and how symmetric a front is.

Zhang and Yang (2023) let people choose among 19 styles of building and code facades by tone and
symmetry. The rows marked so are their 19 (their "place style" is read as palace style); the
others are plain buildings that any town has more of. Tone and symmetry are measured on the model,
so models from files have them too.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.assets import shipped
from scenewright.core.catalog import Part
from scenewright.geometry import rays

Floats = NDArray[np.float64]
Use = Literal["housing", "civic", "sacred", "commercial", "works", "garden"]

CELLS = 160
"""Rays across the wider side of a front."""
LEAN = 0.5
"""Faces whose normal rises more than this (its z part) are roofs, not facade."""


class Style(NamedTuple):
    """A style of building: ``id`` of its asset, ``storey`` height in metres, usual ``floors``
    (0: none to speak of), what it is used for, and whether it is one of the paper's 19."""

    id: str
    name: str
    storey: float
    floors: int
    use: Use
    named: bool = True


class Facade(NamedTuple):
    """``tone``: mean lightness of the front's upright faces, 0 black to 1 white (CIE L*/100);
    ``symmetry``: share of the front, 0 to 1, that is the same mirrored in its middle axis."""

    tone: float
    symmetry: float


_ROWS = (
    Style("palace", "Palace style", 6.0, 2, "civic"),
    Style("classical_residence", "Classical residence", 3.6, 2, "housing"),
    Style("pagoda", "Pagoda style", 5.8, 7, "sacred"),
    Style("gothic_church", "Gothic style", 20.0, 1, "sacred"),
    Style("byzantine_church", "Byzantine style", 12.0, 1, "sacred"),
    Style("rococo_palace", "Rococo style", 5.0, 2, "civic"),
    Style("baroque_church", "Baroque style", 14.0, 1, "sacred"),
    Style("commercial_block", "Commercial buildings", 4.2, 7, "commercial"),
    Style("steampunk_works", "Steampunk style", 6.0, 2, "works"),
    Style("modern_residential", "Modern residential buildings", 3.0, 11, "housing"),
    Style("pavilion", "Pavilion", 4.0, 0, "garden"),
    Style("gallery", "Gallery", 5.0, 2, "civic"),
    Style("gymnasium", "Gymnasium", 12.0, 1, "civic"),
    Style("museum", "Museum", 7.0, 2, "civic"),
    Style("villa", "Villa", 2.9, 2, "housing"),
    Style("mosque", "Islamic style", 10.0, 1, "sacred"),
    Style("japanese_house", "Japanese style", 3.4, 1, "housing"),
    Style("buddhist_temple", "Buddhist temple", 8.0, 1, "sacred"),
    Style("modernist_house", "Modernism style", 3.2, 2, "housing"),
    Style("point_tower", "Point tower", 3.1, 27, "housing", named=False),
    Style("corner_house", "L-shaped house", 2.9, 2, "housing", named=False),
    Style("office_tower", "Office tower", 4.0, 23, "commercial", named=False),
    Style("row_houses", "Row houses", 3.0, 3, "housing", named=False),
    Style("warehouse", "Warehouse", 8.0, 1, "works", named=False),
)

STYLES: dict[str, Style] = {row.id: row for row in _ROWS}


def floors_of(style: Style, height: float) -> int:
    """Storeys of a building of a style at some height: its usual floors, grown in proportion.

    >>> floors_of(STYLES["modern_residential"], 18.0)
    6
    """
    usual = shipped().assets[style.id].usual.height
    return max(1, round(style.floors * height / usual)) if style.floors else 0


def facade_of_style(identity: str) -> Facade:
    """Tone and symmetry of a shipped style at its usual size."""
    asset = shipped().assets[identity]
    return facade(asset.mesh(asset.usual))


def facade(parts: Sequence[Part]) -> Facade:
    """Tone and symmetry of a model seen square on from the front, by a grid of parallel rays.

    A place is symmetric if its mirror image is as light (to 0.04) and as far back (to a fiftieth
    of the width); places where one of the two is open sky count against it. A model whose front
    shows no upright face gets tone 0.5.
    """
    lightness, depth, upright, seen = _elevation(parts)
    tone = float(lightness[upright].mean()) if upright.any() else 0.5
    near = 0.02 * _width(parts)
    same = seen & seen[:, ::-1]
    same &= np.abs(lightness - lightness[:, ::-1]) <= 0.04
    same &= np.abs(depth - depth[:, ::-1]) <= near
    either = seen | seen[:, ::-1]
    return Facade(tone, float(same.sum() / either.sum()) if either.any() else 1.0)


def lightness(color: Sequence[float]) -> float:
    """CIE 1976 lightness L*/100 of an sRGB colour, from its luminance (IEC 61966-2-1).

    >>> round(lightness((1, 1, 1)), 3), round(lightness((0.5, 0.5, 0.5)), 2)
    (1.0, 0.53)
    """
    coded = np.asarray(color, np.float64)
    linear = np.where(coded <= 0.04045, coded / 12.92, ((coded + 0.055) / 1.055) ** 2.4)
    luminance = float(linear @ (0.2126, 0.7152, 0.0722))
    cube = luminance ** (1 / 3) if luminance > (6 / 29) ** 3 else luminance * 841 / 108 + 4 / 29
    return 1.16 * cube - 0.16


def _elevation(
    parts: Sequence[Part],
) -> tuple[Floats, Floats, NDArray[np.bool_], NDArray[np.bool_]]:
    """Lightness, depth, whether it is a facade and whether there is anything, ``(rows, columns)``
    symmetric about the middle of the bounding box."""
    points = np.concatenate([part.vertices for part in parts])
    starts = np.cumsum([0, *(len(part.vertices) for part in parts)])
    faces = np.concatenate([p.faces + s for p, s in zip(parts, starts, strict=False)])
    shade = np.repeat([lightness(p.material.color) for p in parts], [len(p.faces) for p in parts])
    low, high = points.min(0), points.max(0)
    step = max(float(high[0] - low[0]), float(high[2] - low[2]), 1e-6) / CELLS
    x, z = (_cells(low[k], high[k], step) for k in (0, 2))
    across, up = np.meshgrid(x, z)
    eyes = np.stack([across, np.full_like(across, high[1] + 1.0), up], -1).reshape(-1, 3)
    ways = np.tile([0.0, -1.0, 0.0], (len(eyes), 1))
    distance, face, normal = rays.hits(rays.build(points, faces), eyes, ways)
    seen = (face >= 0).reshape(across.shape)
    upright = seen & (normal[:, 2] < LEAN).reshape(across.shape)
    depth = np.where(face >= 0, distance, 0.0).reshape(across.shape)
    return (
        shade[np.maximum(face, 0)].reshape(across.shape),
        depth.astype(np.float64),
        upright,
        seen,
    )


def _cells(low: float, high: float, step: float) -> Floats:
    """Middles of equal cells about as wide as ``step``."""
    count = max(1, round((high - low) / step))
    return low + (np.arange(count) + 0.5) * (high - low) / count


def _width(parts: Sequence[Part]) -> float:
    return float(np.ptp(np.concatenate([part.vertices[:, 0] for part in parts])))
