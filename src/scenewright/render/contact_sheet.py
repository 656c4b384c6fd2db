"""A contact sheet: a dozen small pictures, numbered, with a line below each."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from scenewright.core.atomic_file import atomic_write
from scenewright.core.errors import InputError
from scenewright.render.picture import Pixels

GAP, EDGE, HEAD, FOOT = 14, 22, 58, 30
INK, FAINT, MARK = (40, 38, 34), (120, 116, 108), (178, 68, 44)
PAPER, FRAME = (250, 248, 244), (206, 202, 194)


class SheetEntry(NamedTuple):
    """One picture (h, w, 3) on a sheet, the ``label`` it is called by, a line of ``text`` below it,
    and whether it is ``marked`` as the champion."""

    picture: Pixels
    label: str
    text: str
    marked: bool = False


def draw_sheet(entries: Sequence[SheetEntry], title: str, text: str) -> Pixels:
    """The sheet as pixels, as many columns as rows or a few more; ``text`` stands below the
    ``title``.

    >>> picture = np.zeros((40, 60, 3), np.uint8)
    >>> draw_sheet([SheetEntry(picture, "1", "")] * 12, "twelve", "").shape[2]
    3
    """
    columns = min(math.ceil(math.sqrt(len(entries) * 4 / 3)), len(entries)) or 1
    rows = math.ceil(len(entries) / columns)
    wide = max((entry.picture.shape[1] for entry in entries), default=200)
    high = max((entry.picture.shape[0] for entry in entries), default=0)
    size = (2 * EDGE + columns * (wide + GAP) - GAP, HEAD + rows * (high + FOOT + GAP) + EDGE)
    page = Image.new("RGB", size, PAPER)
    pen = ImageDraw.Draw(page)
    pen.text((EDGE, 12), title, INK, _font(20))
    pen.text((EDGE, 37), text, FAINT, _font(13))
    for k, entry in enumerate(entries):
        left = EDGE + k % columns * (wide + GAP)
        top = HEAD + k // columns * (high + FOOT + GAP)
        _draw_entry(page, pen, entry, left, top, wide, high)
    return np.asarray(page, np.uint8)


def write_sheet(pixels: Pixels, path: Path) -> None:
    """Write a sheet as PNG; the file appears whole or not at all, missing folders are made."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with atomic_write(path) as partial:
            Image.fromarray(pixels).save(partial, format="png", compress_level=3)
    except OSError as error:
        raise InputError(
            f"cannot be written: {error.strerror or error}", "choose another place", file=str(path)
        ) from None


def _draw_entry(
    page: Image.Image,
    pen: ImageDraw.ImageDraw,
    entry: SheetEntry,
    left: int,
    top: int,
    wide: int,
    high: int,
) -> None:
    tall, broad = entry.picture.shape[:2]
    page.paste(
        Image.fromarray(entry.picture), (left + (wide - broad) // 2, top + (high - tall) // 2)
    )
    colour, width = (MARK, 3) if entry.marked else (FRAME, 1)
    pen.rectangle((left - 1, top - 1, left + wide, top + high), outline=colour, width=width)
    pen.text((left + 2, top + high + 3), entry.label, MARK if entry.marked else INK, _font(20))
    indent = 12 + round(_font(20).getlength(entry.label))
    pen.text((left + indent, top + high + 9), entry.text, FAINT, _font(12))


def _font(size: int) -> Any:
    return ImageFont.load_default(size)
