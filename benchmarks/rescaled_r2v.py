"""Flats of Raster-to-Vector enlarged until their hinged doors are as wide as doors are.

The metres of these plans are an estimate: the median of all inner openings is taken for 0.78 m.
Where sliding doors and wide passages set that median, hinged doors come out at 0.35 to 0.6 m and
bathtubs at 0.75 m. Here a plan is enlarged until its median hinged leaf measures :data:`LEAF`
metres, the least that is usual for doors of rooms. It is never made smaller.
"""

from __future__ import annotations

from statistics import median
from typing import Any

from benchmarks.plans_r2v import adapt

LEAF = 0.75
"""The median width of hinged leaves, in metres."""
MOST = 2.2
"""No plan is enlarged more than this."""
ROUNDS, NEAR = 8, 0.01
"""Which doors hang on hinges depends on their widths (:func:`benchmarks.plans_r2v.adapt`), so the
factor is looked for in at most so many rounds, until it changes by no more than this share."""


def rescale(raw: dict[str, Any]) -> dict[str, Any]:
    """A plan enlarged by :func:`find_factor`."""
    return enlarge(raw, find_factor(raw))


def find_factor(raw: dict[str, Any]) -> float:
    """The factor, 1 to :data:`MOST`, with which the median hinged leaf of a plan's brief measures
    :data:`LEAF`; the last one tried where a plan has no brief or no hinged door."""
    factor = 1.0
    for _ in range(ROUNDS):
        widths = list_leaves(enlarge(raw, factor))
        if not widths:
            break
        last, factor = factor, min(max(factor * LEAF / median(widths), 1.0), MOST)
        if abs(factor / last - 1.0) <= NEAR:
            break
    return round(factor, 3)


def list_leaves(raw: dict[str, Any]) -> list[float]:
    """The widths of the doors of a plan's brief that hang on hinges, in metres."""
    brief = adapt(raw).brief
    rooms = brief.rooms if brief is not None else []
    return [door.width for room in rooms for door in room.doors if door.swing in ("in", "out")]


def enlarge(raw: dict[str, Any], factor: float) -> dict[str, Any]:
    """A plan with every length times ``factor``, areas times its square.

    >>> room = {"labels": ["closet"], "polygon": [[0, 0], [2.0, 0], [2.0, 1.5]], "area": 1.5}
    >>> plan = {"id": "a", "px_per_m": 50.0, "area_m2": 1.5, "rooms": [room]}
    >>> enlarge(plan | {"openings": [], "icons": []}, 2.0)["rooms"][0]
    {'labels': ['closet'], 'polygon': [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0]], 'area': 6.0}
    """
    if factor == 1.0:
        return raw
    return raw | {
        "px_per_m": raw["px_per_m"] / factor,
        "area_m2": raw["area_m2"] * factor**2,
        "rooms": [
            room
            | {
                "polygon": [_times(at, factor) for at in room["polygon"]],
                "area": room["area"] * factor**2,
            }
            for room in raw["rooms"]
        ],
        "openings": [
            opening
            | {key: _times(opening[key], factor) for key in ("a", "b")}
            | {"width": opening["width"] * factor}
            for opening in raw["openings"]
        ],
        "icons": [icon | {"box": _times(icon["box"], factor)} for icon in raw["icons"]],
    }


def _times(numbers: list[float], factor: float) -> list[float]:
    return [number * factor for number in numbers]
