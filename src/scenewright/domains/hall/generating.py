"""Halls made by a seed: an outline with its doors, and what a shop of its kind holds."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building.outline_forms import (
    OutlineName,
    area_of,
    check_outline,
    draw_outline,
    skew_corners,
)
from scenewright.core.asked import read_asked
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.domains.hall.demands.programme import PROGRAMMES, shop_programme

Floats = NDArray[np.float64]
USUAL_FLOOR, LEAST_FLOOR, MOST_FLOOR = 180.0, 40.0, 3000.0
"""Square metres of a hall where none are asked for, and their bounds."""
FIRE_DOOR = 200.0
"""Square metres from which a hall has a second door, at the back."""


class HallRequest(NamedTuple):
    """What a hall is asked for: its ``use``, a programme of :data:`PROGRAMMES` (empty: drawn),
    square metres of floor (0: as usual), the form of its ``outline`` (None: drawn)."""

    use: str = ""
    area: float = 0.0
    outline: OutlineName | None = None


def generate_hall(asked: Mapping[str, Any], seed: int = 0) -> Brief:
    """A hall with a front towards the south, the same for the same seed.

    >>> brief = generate_hall({"use": "books", "area": 150.0}, seed=3)
    >>> len(brief.rooms[0].doors), brief.rooms[0].demands[0].category
    (1, 'checkout')
    """
    request = read_asked(HallRequest, asked, "hall")
    check_outline(request.outline, seed)
    rng = np.random.default_rng(seed)
    use = request.use or str(rng.choice(sorted(PROGRAMMES)))
    area = request.area or USUAL_FLOOR * float(rng.uniform(0.6, 2.0))
    if use not in PROGRAMMES:
        fault = f"there is no programme for the use '{use}'"
        raise InputError(fault, f"choose {', '.join(PROGRAMMES)}")
    if not isfinite(area) or not LEAST_FLOOR <= area <= MOST_FLOOR:
        remedy = f"give {LEAST_FLOOR:.0f} to {MOST_FLOOR:.0f} m²"
        raise InputError(f"{area:g} m² are asked for", remedy)
    corners = _outline(request.outline or draw_outline(rng), area, rng)
    around = float(np.linalg.norm(corners - np.roll(corners, -1, axis=0), axis=1).sum())
    room = {
        "name": use.capitalize(),
        "outline": np.round(corners, 3).tolist(),
        "height": 3.6,
        "doors": _doors(corners, area),
        "demands": [d.model_dump() for d in shop_programme(use, area, around)],
    }
    document = {"domain": "hall", "name": f"{use.capitalize()} {seed}", "rooms": [room]}
    return Brief.model_validate(document)


def _outline(name: OutlineName, area: float, rng: np.random.Generator) -> Floats:
    """The corners (n, 2) of a hall, counter-clockwise, its front the edge from the first."""
    gap = rng.uniform(0.15, 0.3) if name == "l" else 0.0
    width = np.sqrt(area / (1 - gap) * rng.uniform(0.7, 1.5))
    depth = area / (1 - gap) / width
    corners = np.array([[0, 0], [width, 0], [width, depth], [0, depth]])
    if name == "skew":
        return skew_corners(corners, rng)
    if not gap:
        return corners
    x = width * (1 - np.sqrt(gap))
    y = depth * (1 - np.sqrt(gap))
    found = np.array([[0, 0], [width, 0], [width, y], [x, y], [x, depth], [0, depth]])
    return found * np.sqrt(area / area_of(found))


def _doors(corners: Floats, area: float) -> list[dict[str, Any]]:
    """The entrance in the middle of the front, and in large halls a door at the back."""
    middles = (corners + np.roll(corners, -1, axis=0)) / 2
    front = {"id": "entrance", "at": middles[0].round(3).tolist(), "width": 2.0, "swing": "slide"}
    back = {"id": "back-door", "at": middles[-2].round(3).tolist(), "width": 1.2, "swing": "out"}
    return [front | {"height": 2.4}, *[back | {"height": 2.1}] * (area >= FIRE_DOOR)]
