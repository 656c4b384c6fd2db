"""What of a scene is free to move, how heavy it is and how it rubs.

Mass is density by volume of the closed meshes; what is drawn solid is hollow inside walls as thick
as things of its material have.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from math import inf
from typing import NamedTuple

import numpy as np

from scenewright.catalog.classes import RUN
from scenewright.core.catalog import Catalog, Part
from scenewright.geometry.mesh import Mesh, volume
from scenewright.render.items import RenderItem

LEAST = 0.05
"""Least mass of what moves, in kg."""
HEAVY = 120.0
"""Kilograms from which on a thing stands as if it were fixed."""
ANCHORED = 1.2
"""What is higher than this, in metres, and stands flat to a wall is screwed to it."""
SOFT = frozenset(("leaf", "needles", "crown", "sheer", "curtain", "grass"))
"""Words of what gives way: nothing rests on it and nothing runs into it."""


class Substance(NamedTuple):
    """Density in kg/m³, the coefficient of friction, and how thick walls of it are, in metres."""

    density: float
    friction: float
    walls: float


SUBSTANCES = (
    ("steel chrome metal iron brass bronze", Substance(7800.0, 0.4, 0.0008)),
    ("glass mirror screen window", Substance(2500.0, 0.35, 0.004)),
    ("ceramic clay tiles brick", Substance(2200.0, 0.5, 0.01)),
    ("stone slate concrete rock plaster render", Substance(2300.0, 0.6, 0.03)),
    ("fabric velvet wool linen leather duvet mattress", Substance(45.0, 0.7, inf)),
    ("curtain shade carpet", Substance(200.0, 0.7, 0.002)),
    ("oak walnut pine teak timber rattan bark floor lacquer panel", Substance(600.0, 0.45, 0.016)),
    ("plastic", Substance(1000.0, 0.35, 0.003)),
    ("paper cardboard", Substance(600.0, 0.5, 0.004)),
    ("leaf needles crown", Substance(20.0, 0.6, inf)),
    ("soil", Substance(1300.0, 0.8, inf)),
)
"""Substances by words of a material's name; the first row that has one counts."""
OTHERWISE = Substance(600.0, 0.5, 0.016)


def is_free(item: RenderItem, catalog: Catalog) -> bool:
    """Whether nothing but its weight holds a piece: it stands on a floor or on another thing, is on
    no water, no part of a kitchen, not screwed to a wall and not too heavy to be moved."""
    kind = catalog.kinds.get(str(item.extras.get("category", "")))
    if item.kind != "piece" or kind is None or kind.support in ("wall", "ceiling") or kind.flat:
        return False
    piped = any(service.outlet == "water" for service in kind.services)
    if piped or kind.category in RUN or not item.parts:
        return False
    high = max(float(part.vertices[:, 2].max()) for part in item.parts)
    hard = [part for part in item.parts if not is_soft(part.material.name)]
    screwed = kind.back == "flat" and high > ANCHORED
    return bool(hard) and not screwed and mass_of(hard) <= HEAVY


@lru_cache(maxsize=4096)
def is_soft(name: str) -> bool:
    """Whether what a material of a name is on gives way.

    >>> is_soft("light leaf"), is_soft("oak, boho leaf")
    (True, False)
    """
    return not SOFT.isdisjoint(name.partition(",")[0].split())


@lru_cache(maxsize=4096)
def substance_of(name: str) -> Substance:
    """What a material of a name is made of.

    >>> substance_of("oak, industrial steel").density, substance_of("brushed steel").density
    (600.0, 7800.0)
    """
    plain = name.partition(",")[0]  # a palette's name follows a comma
    for words, substance in SUBSTANCES:
        if any(word in plain for word in words.split()):
            return substance
    return OTHERWISE


def mass_of(parts: Iterable[Part]) -> float:
    """The mass of what is drawn, in kg: of each part the volume, at most its area by the thickness
    of its walls.

    >>> from scenewright.core.catalog import Material
    >>> from scenewright.geometry.prisms import box
    >>> leaf = Part(Material("oak", (0.7, 0.5, 0.3)), *box((0, 0, 0), (0.8, 0.04, 2.0))[:2])
    >>> round(mass_of([leaf]), 1)
    32.9
    """
    return max(sum(_mass(part) for part in parts), LEAST)


def _mass(part: Part) -> float:
    a, b, c = (part.vertices[part.faces[:, k]] for k in range(3))
    area = float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()) / 2
    return weigh(part.material.name, volume(Mesh(part.vertices, part.faces)), area)


def weigh(name: str, volume: float, area: float) -> float:
    """The mass in kg of a closed mesh of a volume in m³ and a surface in m².

    >>> round(weigh("oak", 0.5, 4.0), 1)
    38.4
    """
    density, _, walls = substance_of(name)
    return density * min(abs(volume), area * walls)
