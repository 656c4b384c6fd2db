"""A sheet of portraits: each model plain and by saliency, side by side, its name below."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from scenewright.core.atomic_file import atomic_write
from scenewright.core.errors import InputError
from scenewright.render.colour import linear_of
from scenewright.render.picture import PAGE, Pixels, develop_image
from scenewright.render.portrait import HOTTEST, RAMP, Portrait
from scenewright.text import quantity

MOST = 48
"""Portraits on a sheet."""
SIDES = ((2, 420), (6, 320), (15, 230), (28, 190), (MOST, 160))
"""Up to how many portraits, and the side of their pictures in pixels."""
SHAPE = 1.5
"""Width by height a sheet should have."""
GAP, EDGE, HEAD, FOOT = 18, 28, 74, 50
INK, FAINT = (52, 50, 46), (128, 124, 116)
PAPER = tuple(develop_image(linear_of(np.array(PAGE.color)).astype(np.float32)).tolist())
"""The page as it comes out in pictures."""
TITLES = {
    "picture": "saliency in the picture",
    "saliency": "visible saliency",
    "entropy": "viewpoint entropy",
}


def side_of(count: int) -> int:
    """Pixels across one picture where ``count`` portraits share a sheet.

    >>> side_of(1), side_of(48)
    (420, 160)
    """
    return next((side for most, side in SIDES if count <= most), SIDES[-1][1])


def columns_of(count: int) -> int:
    """Columns that bring a sheet nearest to :data:`SHAPE`.

    >>> [columns_of(count) for count in (1, 5, 15, 48)]
    [1, 2, 4, 7]
    """
    side = side_of(count)
    wide, high = 2 * side + GAP, side + FOOT

    def misfit(columns: int) -> float:
        rows = math.ceil(count / columns)
        return abs(math.log(columns * wide / (rows * high) / SHAPE)) + 0.02 * (columns * rows)

    return min(range(1, count + 1), key=misfit)


def sheet(portraits: Sequence[Portrait], measure: str, of: int) -> Pixels:
    """The sheet as pixels; ``of`` is how many models there are, drawn or not."""
    side, columns = portraits[0].plain.shape[0], columns_of(len(portraits))
    rows = math.ceil(len(portraits) / columns)
    wide, high = 2 * side + GAP, side + FOOT
    page = Image.new("RGB", (2 * EDGE + columns * wide - GAP, HEAD + rows * high + EDGE), PAPER)
    pen = ImageDraw.Draw(page)
    _head(pen, page.width, f"Best views by {TITLES[measure]}", len(portraits), of)
    for k, portrait in enumerate(portraits):
        left, top = EDGE + k % columns * wide, HEAD + k // columns * high
        page.paste(Image.fromarray(portrait.plain), (left, top))
        page.paste(Image.fromarray(portrait.salient), (left + side, top))
        name = _cut(portrait.name, 2 * side - GAP, 15)
        pen.text((left + 4, top + side + 3), name, INK, _font(15))
        text = f"visual quality {portrait.quality:.3f}"
        pen.text((left + 4, top + side + 22), text, FAINT, _font(13))
    return np.asarray(page, np.uint8)


def write(pixels: Pixels, path: Path) -> None:
    """Write a sheet as PNG; the file appears whole or not at all, missing folders are made."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(path) as partial:
            Image.fromarray(pixels).save(partial, format="png", compress_level=4)
    except OSError as error:
        raise InputError(
            f"cannot be written: {error.strerror or error}", "choose another place", file=str(path)
        ) from None


def _head(pen: ImageDraw.ImageDraw, width: int, title: str, count: int, of: int) -> None:
    """The title, how many are drawn, and what the colours mean."""
    text = f"{count} of {of} models" if of > count else quantity(count, "model")
    pen.text((EDGE, 18), title, INK, _font(21))
    pen.text((EDGE, 46), text, FAINT, _font(13))
    long, left = 150, width - EDGE - 150
    for x in range(long):
        share = x / (long - 1) * (len(RAMP) - 1)
        colour = [np.interp(share, np.arange(len(RAMP)), RAMP[:, k]) for k in range(3)]
        pen.line((left + x, 24, left + x, 35), tuple(round(255 * float(c)) for c in colour))
    pen.text((left, 40), "saliency 0", FAINT, _font(13))
    pen.text((left + long, 40), f"{HOTTEST:g}", FAINT, _font(13), anchor="ra")


def _font(size: int) -> Any:
    return ImageFont.load_default(size)


def _cut(text: str, width: int, size: int) -> str:
    """The text, shortened with dots if it is wider than ``width`` pixels."""
    font = _font(size)
    if font.getlength(text) <= width:
        return text
    kept = next(k for k in range(len(text), -1, -1) if font.getlength(text[:k] + "…") <= width)
    return text[:kept].rstrip() + "…"
