"""Rasters of heights: ESRI ASCII grids and GeoTIFF, as a grid of heights.

Cells are squares and their heights those of their middles. Of a GeoTIFF the tags ModelPixelScale
(33550), ModelTiepoint (33922) and GDAL's no-data value (42113) are read (OGC 19-008r4).
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scenewright.core.errors import InputError
from scenewright.core.heights import HeightGrid

Floats = NDArray[np.float64]
MOST_CELLS = 50_000_000
SCALE, TIE, EMPTY, SORT = 33550, 33922, 42113, 34737
LIMIT = 1e5
"""Metres beyond which a height is none."""


def read_raster(file: Path) -> HeightGrid:
    """The heights of a raster in the coordinates of its map; NaN where it has none."""
    with file.open("rb") as opened:
        head = opened.read(4)
    if head[:2] in (b"II", b"MM"):
        return _read_tiff(file)
    return _read_ascii(file)


def _grid(left: float, low: float, step: float, rows: Floats) -> HeightGrid:
    """A grid of rows from north to south, the middle of the lower left cell at (left, low)."""
    if min(rows.shape) < 2 or not step > 0:
        raise InputError("has no two rows and columns of heights", "give a larger part of the map")
    values = np.where(np.abs(rows) < LIMIT, rows, np.nan)[::-1]
    return HeightGrid((left, low), step, np.ascontiguousarray(values))


def _read_ascii(file: Path) -> HeightGrid:
    """An ESRI ASCII grid: a head of keys and numbers, rows from north to south."""
    try:
        words = file.read_text(encoding="ascii").split()
        head: dict[str, float] = {}
        while words[2 * len(head)][0].isalpha():
            k = 2 * len(head)
            head[words[k].lower()] = float(words[k + 1])
        columns, rows, step = int(head["ncols"]), int(head["nrows"]), head["cellsize"]
        values = np.array(words[2 * len(head) :], float)
        rows_of = values.reshape(rows, columns)
    except (ValueError, KeyError, IndexError):
        raise InputError(
            f"'{file.name}' is neither an ESRI ASCII grid nor a GeoTIFF",
            "export it as one: gdal_translate -of AAIGrid",
        ) from None
    rows_of = np.where(rows_of == head.get("nodata_value", -9999.0), np.nan, rows_of)
    corner = [head.get(f"{x}llcenter", head.get(f"{x}llcorner", 0.0) + step / 2) for x in "xy"]
    return _grid(corner[0], corner[1], step, rows_of)


def _read_tiff(file: Path) -> HeightGrid:
    from PIL import Image

    Image.MAX_IMAGE_PIXELS = None if Image.MAX_IMAGE_PIXELS is None else MOST_CELLS
    try:
        with Image.open(file) as image:
            if image.width * image.height > MOST_CELLS:
                raise InputError("has more than 50 million cells", "cut it to the site")
            tags: Any = getattr(image, "tag_v2", {})
            scale, tie, empty = (tags.get(number) for number in (SCALE, TIE, EMPTY))
            rows = np.array(image, float)
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(
            f"'{file.name}' is a TIFF that cannot be read", "export it as an ESRI ASCII grid"
        ) from None
    if rows.ndim != 2 or scale is None or tie is None:
        raise InputError(
            f"'{file.name}' is no GeoTIFF of heights north up",
            "export one band with its place, or an ESRI ASCII grid",
        )
    step = float(scale[0])
    if abs(step - float(scale[1])) > 1e-6 * step:
        raise InputError("its cells are no squares", "resample it to square cells")
    if empty is not None:
        rows = np.where(rows == float(str(empty).strip("\0 ")), np.nan, rows)
    half = 0.0 if "PixelIsPoint" in str(tags.get(SORT, "")) else step / 2
    left = float(tie[3]) - float(tie[0]) * step + half
    top = float(tie[4]) + float(tie[1]) * step - half
    return _grid(left, top - step * (len(rows) - 1), step, rows)
