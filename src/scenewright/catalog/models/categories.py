"""What is a building, where nobody says."""

from __future__ import annotations

from scenewright.core.scene import Size

BUILDING = "building"
LARGE = 3.5
"""Least side of a building in metres: furniture is hardly that large in two directions."""
CITY = (".json", ".cityjson", ".jsonl")
"""Suffixes of files that hold nothing but buildings."""


def building(size: Size, unit: float = 1.0) -> bool:
    """Whether a size is at least :data:`LARGE` in two directions, with lengths of ``unit`` metres.

    >>> building(Size(8, 9, 3)), building(Size(9, 0.2, 2.5))
    (True, False)
    """
    return sum(side * unit >= LARGE for side in size) >= 2
