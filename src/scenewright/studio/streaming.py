"""Layouts shown while they are searched: boxes of the best so far, a few times a second."""

from __future__ import annotations

import time
from collections.abc import Callable
from threading import Lock

from scenewright.core.layout import SETTLED, BestLayout, NamedBox
from scenewright.studio.shapes import Json

PAUSE = 0.2
"""Seconds between two pictures of one space; what is found between them is not told."""


def stream_layouts(tell: Callable[[Json], None]) -> Callable[[BestLayout], None]:
    """A listener for :func:`scenewright.domains.solve` that tells boxes (name, x, y, heading,
    width, depth) of a space, the latest only, and at which ``stage`` they are. A reason is always
    told, and so are what is settled and the first boxes, whatever empty pictures came before. It
    may be called from several threads.

    >>> told = []
    >>> hear = stream_layouts(told.append)
    >>> for _ in range(100): hear(BestLayout("living", 0.1, 9.0, lambda: ()))
    >>> told
    [{'space': 'living', 'stage': 'search', 'boxes': []}]
    >>> hear(BestLayout("living", 1.0, 9.0, lambda: (), "repair", "as wide as its wall allows"))
    >>> told[-1]
    {'space': 'living', 'stage': 'repair', 'reason': 'as wide as its wall allows'}
    """
    last: dict[str, float] = {}
    filled: set[str] = set()
    busy = Lock()

    def hear(layout: BestLayout) -> None:
        now = time.monotonic()
        with busy:
            due = layout.stage == SETTLED or now - last.get(layout.space, -PAUSE) >= PAUSE
            rows = layout.rows() if due or layout.space not in filled else ()
            due |= bool(rows)
            if rows:
                filled.add(layout.space)
            if due:
                last[layout.space] = now
        if due or layout.reason:
            tell(_describe(layout, rows if due else None))

    return hear


def _describe(layout: BestLayout, rows: tuple[NamedBox, ...] | None) -> Json:
    """A layout as an event, with its boxes if there are ``rows``."""
    told: Json = {"space": layout.space, "stage": layout.stage}
    told |= {"reason": layout.reason} if layout.reason else {}
    if rows is not None:
        told["boxes"] = [[row.name, *(round(float(side), 3) for side in row.box)] for row in rows]
    return told
