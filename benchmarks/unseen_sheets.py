"""Contact sheets: pictures of homes from above, six a sheet, for an eye that judges them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.assets import shipped
from scenewright.core.solution import Solution

Pixels = NDArray[np.uint8]
WIDTH, EDGE = 900, 12
COLUMNS, ROWS = 3, 2


def draw_home(solution: Solution) -> Pixels:
    """A home from above, (height, :data:`WIDTH`, 3)."""
    from scenewright.domains import scene_of
    from scenewright.formats.png import picture

    return np.asarray(picture(scene_of(solution), shipped(), WIDTH))[..., :3]


def write_sheets(folder: Path, pictures: list[tuple[str, Any]]) -> None:
    """Write ``sheet-1.png`` … to a folder, and ``sheets.txt``, which names the homes in order."""
    from PIL import Image

    folder.mkdir(parents=True, exist_ok=True)
    each = COLUMNS * ROWS
    for first in range(0, len(pictures), each):
        sheet = lay_out([pixels for _, pixels in pictures[first : first + each]])
        Image.fromarray(sheet).save(folder / f"sheet-{first // each + 1}.png")
    lines = [f"{k // each + 1}.{k % each + 1} {name}" for k, (name, _) in enumerate(pictures)]
    (folder / "sheets.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")


def lay_out(pictures: list[Pixels]) -> Pixels:
    """Pictures in rows of three on white, each in a cell of the size of the largest.

    >>> lay_out([np.zeros((10, 20, 3), np.uint8)] * 4).shape
    (44, 96, 3)
    """
    high = max(p.shape[0] for p in pictures) + EDGE
    wide = max(p.shape[1] for p in pictures) + EDGE
    rows = -(-len(pictures) // COLUMNS)
    sheet = np.full((rows * high, COLUMNS * wide, 3), 255, np.uint8)
    for k, pixels in enumerate(pictures):
        top, left = (k // COLUMNS) * high, (k % COLUMNS) * wide
        sheet[top : top + pixels.shape[0], left : left + pixels.shape[1]] = pixels
    return sheet
