"""Colours of faces from textures and vertices: a few plain materials instead of a picture.

Assets have plain materials. A texture is looked up at a few places of each face, and faces of
like colour become one material: exact for the colour atlases of low-poly models, a fair
likeness for photographs.
"""

from __future__ import annotations

import io
import warnings
from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.models.model import part_of
from scenewright.core.catalog import Material, Part
from scenewright.core.errors import InputError

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Pixels = NDArray[np.uint8]

MOST_BYTES = 64 * 2**20
MOST_PIXELS = 2**26
SIDE = 2048
"""Pixels to which larger textures are reduced."""
MOST_COLOURS = 16
KINDS = ("PNG", "JPEG", "BMP", "GIF", "TGA")
PLACES = np.array([[4, 1, 1], [1, 4, 1], [1, 1, 4], [2, 2, 2]]) / 6.0
"""Where a face is looked up, in shares of its corners."""


@lru_cache(2)
def picture(content: bytes) -> Pixels | None:
    """The pixels ``(h, w, 3)`` of a texture, reduced to :data:`SIDE`; None if it is unreadable.

    Models of one folder often share one, so the last two are kept. One that would be too large
    in memory raises :class:`InputError` before it is unpacked.
    """
    from PIL import Image

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            image = Image.open(io.BytesIO(content), formats=KINDS)
            if image.width * image.height > MOST_PIXELS:
                raise InputError(
                    f"a texture has {image.width} x {image.height} pixels", "make it smaller"
                )
            image.draft("RGB", (SIDE, SIDE))
            image.thumbnail((SIDE, SIDE))
            return np.asarray(image.convert("RGB"), np.uint8)
    except Image.DecompressionBombError:
        raise InputError("a texture has too many pixels", "make it smaller") from None
    except (OSError, ValueError, SyntaxError, EOFError, KeyError, IndexError) as error:
        if isinstance(error, InputError):
            raise
        return None


def looked_up(pixels: Pixels, places: Floats) -> Floats:
    """Mean sRGB colour ``(m, 3)`` of faces whose corners are at ``places`` (m, 3, 2).

    Places are in shares of the picture from its upper left corner; beyond it, it is repeated.
    """
    height, width = pixels.shape[:2]
    spots = np.einsum("pk,mkc->mpc", PLACES, np.nan_to_num(places, posinf=0.0, neginf=0.0))
    share = spots - np.floor(spots)
    column = np.minimum((share[..., 0] * width).astype(np.int64), width - 1)
    row = np.minimum((share[..., 1] * height).astype(np.int64), height - 1)
    return np.asarray(pixels[row, column].mean(1) / 255.0)


def by_colour(material: Material, vertices: Floats, faces: Ints, colours: Floats) -> list[Part]:
    """The faces as parts of few colours, each the material with another colour.

    ``vertices`` (n, 3) in metres, ``faces`` (m, 3), ``colours`` (m, 3) in [0, 1], one a face.
    """
    palette, which = few(colours)
    return [
        part_of(_tint_material(material, colour, k), vertices, faces[which == k])
        for k, colour in enumerate(palette)
    ]


def few(colours: Floats) -> tuple[Floats, Ints]:
    """At most :data:`MOST_COLOURS` colours ``(k, 3)`` and which of them ``(m,)`` is nearest.

    >>> palette, which = few(np.array([[1.0, 0, 0], [0, 0, 1], [1, 0.01, 0]]))
    >>> palette.round(1).tolist(), which.tolist()
    ([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]], [1, 0, 1])
    """
    whole = np.round(np.clip(colours, 0.0, 1.0) * 255).astype(np.uint8)
    rough = np.unique(whole // 12, axis=0, return_inverse=True)[1].reshape(-1)
    if rough.max() >= MOST_COLOURS:
        rough = _median_cut(whole)
    _, which = np.unique(rough, return_inverse=True)
    counts = np.bincount(which)
    sums = [np.bincount(which, whole[:, k]) for k in range(3)]
    return np.stack(sums, 1) / counts[:, None] / 255.0, which.astype(np.int64)


def _median_cut(whole: Pixels) -> Ints:
    """P. Heckbert's median cut (1982), as Pillow has it."""
    from PIL import Image

    row = Image.fromarray(whole[None])
    return np.asarray(row.quantize(MOST_COLOURS, method=Image.Quantize.MEDIANCUT), np.int64)[0]


def _tint_material(material: Material, colour: Floats, number: int) -> Material:
    red, green, blue = (round(float(c), 4) for c in colour)
    return Material(
        f"{material.name} {number + 1}",
        (red, green, blue),
        material.roughness,
        material.metallic,
        material.opacity,
    )


def srgb(linear: Sequence[float]) -> tuple[float, float, float]:
    """The sRGB colour of linear light (IEC 61966-2-1).

    >>> srgb([0.0, 0.2140, 1.0])
    (0.0, 0.5, 1.0)
    """
    light = np.clip(np.asarray(linear[:3], np.float64), 0.0, 1.0)
    coded = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    red, green, blue = np.round(coded, 3).tolist()
    return red, green, blue
