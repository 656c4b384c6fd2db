"""Layouts shown while they are searched: boxes of the best so far, a few times a second."""

from __future__ import annotations

import time
from collections.abc import Callable
from threading import Lock

from scenewright.core.layout import BestLayout
from scenewright.studio.shapes import Json

PAUSE = 0.2
"""Seconds between two pictures of one space; what is found between them is not told."""


def stream_layouts(tell: Callable[[Json], None]) -> Callable[[BestLayout], None]:
    """A listener for :func:`scenewright.domains.solve` that tells boxes (name, x, y, heading,
    width, depth) of a space, the latest only; it may be called from several threads.

    >>> told = []
    >>> hear = stream_layouts(told.append)
    >>> for _ in range(100): hear(BestLayout("living", 0.1, 9.0, lambda: ()))
    >>> told
    [{'space': 'living', 'boxes': []}]
    """
    last: dict[str, float] = {}
    busy = Lock()

    def hear(layout: BestLayout) -> None:
        now = time.monotonic()
        with busy:
            if now - last.get(layout.space, -PAUSE) < PAUSE:
                return
            last[layout.space] = now
        rows = layout.rows()
        boxes = [[row.name, *(round(float(side), 3) for side in row.box)] for row in rows]
        tell({"space": layout.space, "boxes": boxes})

    return hear
