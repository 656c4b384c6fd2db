"""What a model is, where nobody says: a building by its file or its size."""

from __future__ import annotations

from pathlib import PurePath

from scenewright.models.model import Model

BUILDING = "building"
LARGE = 3.5
"""Least side of a building in metres: furniture is hardly that large in two directions."""
CITY = (".json", ".cityjson")


def category_of(model: Model) -> str:
    """The category of a model: ``building`` if it is of a city model or at least
    :data:`LARGE` in two directions, else the file's own word.

    >>> from scenewright.scene import Size
    >>> category_of(Model("tower", "Tower", (), Size(8, 9, 30), "", "", "tower.obj"))
    'building'
    """
    wide = sum(side >= LARGE for side in model.size) >= 2
    city = PurePath(model.source).suffix.lower() in CITY
    return BUILDING if wide or city else model.category
