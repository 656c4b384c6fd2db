"""Baked textures as files: JPEG of colour, and of normals where relief pays."""

from __future__ import annotations

import io
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from scenewright.render.colour import coded_of
from scenewright.render.textures.table import TEXTURES, bake

QUALITY = 76
SHARE = 0.998
"""Brighter shares of a texture are cut off, so that the rest has more steps."""
STEPS = 1 << 14
"""Steps of light between black and white in the table of sRGB: darkest ones a fifth of a byte."""
Pixels = NDArray[np.uint8]


class TexturePicture(NamedTuple):
    """A JPEG file whose colours, as linear light times ``factor`` (3,), are the multipliers of
    the texture."""

    content: bytes
    factor: tuple[float, float, float]


@lru_cache(64)
def color_picture(name: str) -> TexturePicture:
    """The colours of a texture by its name.

    >>> picture = color_picture("mosaic")
    >>> picture.content[:3].hex(), all(1.0 < value < 2.0 for value in picture.factor)
    ('ffd8ff', True)
    """
    tone = bake(name).tone
    red, green, blue = np.quantile(tone.reshape(-1, 3), SHARE, axis=0).tolist()
    share = np.asarray(tone / np.array([red, green, blue]), np.float32)
    return TexturePicture(to_jpeg(code_pixels(share)), (red, green, blue))


@lru_cache(64)
def normal_picture(name: str) -> bytes:
    """Normals of a texture's heights in the frame right, up, out, each coordinate from -1 to 1 as
    0 to 255."""
    row, height = TEXTURES[name], bake(name).height.astype(np.float64)
    down, across = (metres / pixels for metres, pixels in zip(row.metres, row.pixels, strict=True))
    slope_x = (np.roll(height, -1, 1) - np.roll(height, 1, 1)) / (2 * across) * row.relief
    slope_y = (np.roll(height, 1, 0) - np.roll(height, -1, 0)) / (2 * down) * row.relief
    normal = np.stack([-slope_x, -slope_y, np.ones_like(height)], -1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    return to_jpeg(as_pixels(normal / 2 + 0.5), whole=True)


def code_pixels(light: NDArray[np.float32]) -> Pixels:
    """Linear light as bytes of sRGB, by a table: light beyond 1 is white.

    >>> code_pixels(np.array([0.0, 0.214, 1.0, 2.0], np.float32)).tolist()
    [0, 127, 255, 255]
    """
    return _codes()[np.minimum(light * (STEPS - 1), STEPS - 1).astype(np.uint16)]


@lru_cache(1)
def _codes() -> Pixels:
    return as_pixels(coded_of(np.linspace(0.0, 1.0, STEPS)))


def as_pixels(shares: NDArray[np.float64]) -> Pixels:
    """Shares in [0, 1] as bytes."""
    return np.round(shares * 255).astype(np.uint8)


def to_webp(content: bytes) -> bytes:
    """A picture file as WebP: without loss, if it is a PNG."""
    out, picture = io.BytesIO(), Image.open(io.BytesIO(content))
    picture.save(out, "WEBP", quality=QUALITY, lossless=picture.format == "PNG")
    return out.getvalue()


def to_jpeg(pixels: Pixels, whole: bool = False) -> bytes:
    """A JPEG file of pixels ``(h, w, 3)``; hues at half the size unless ``whole``."""
    out, hues = io.BytesIO(), "4:4:4" if whole else "4:2:0"
    Image.fromarray(pixels).save(out, "JPEG", quality=QUALITY, optimize=True, subsampling=hues)
    return out.getvalue()
