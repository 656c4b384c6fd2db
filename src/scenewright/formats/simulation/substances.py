"""What the materials of models weigh, how thick they are worked and how they rub.

A drawn cupboard is a solid block, a real one is of boards: a solid weighs the lesser of its volume
and its surface times the thickness its substance is worked in. Densities and sliding friction are
round values of engineers' tables (Engineering ToolBox; Dubbel, *Taschenbuch für den Maschinenbau*).
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from scenewright.core.catalog import Material


class Substance(NamedTuple):
    """Density in kg/m³, thickness of boards, sheets or walls in metres, coefficient of sliding
    friction; what is ``soft`` gives way: nothing rests on it."""

    density: float
    thick: float
    friction: float
    soft: bool = False


WOOD = Substance(650.0, 0.018, 0.5)
SUBSTANCES: tuple[tuple[str, Substance], ...] = (
    ("leaf sheer curtain foliage hedge grass", Substance(300.0, 0.001, 0.6, soft=True)),
    ("fabric linen duvet mattress wool velvet leather cushion", Substance(60.0, 1.0, 0.7)),
    ("steel chrome brass metal iron bronze copper gilt", Substance(7800.0, 0.0012, 0.4)),
    ("glass mirror screen window", Substance(2500.0, 0.004, 0.4)),
    ("ceramic clay porcelain tiles", Substance(2300.0, 0.008, 0.5)),
    ("stone slate concrete rock brick limestone sandstone", Substance(2500.0, 0.03, 0.6)),
    ("plastic rubber glowing shade ember", Substance(1000.0, 0.003, 0.6)),
    ("paper cardboard", Substance(700.0, 0.01, 0.5)),
    ("rattan bone", Substance(400.0, 0.01, 0.5)),
    ("soil bark", Substance(1200.0, 1.0, 0.7)),
)
"""Words in the names of materials, and what they are of; all else is wood or board."""


@cache
def substance_of(material: Material) -> Substance:
    """What a material is, by the words of its name.

    >>> substance_of(Material("brushed steel", (0.7, 0.7, 0.7))).density
    7800.0
    """
    said = material.name.replace(",", " ").split()
    return next((row for words, row in SUBSTANCES if set(words.split()) & set(said)), WOOD)


def weigh(material: Material, volume: float, area: float) -> float:
    """The mass in kg of a closed solid of a volume in m³ and a surface in m².

    >>> round(weigh(Material("oak", (0.8, 0.7, 0.5)), 0.5, 4.0), 3)
    46.8
    """
    one = substance_of(material)
    return one.density * min(abs(volume), area * one.thick)
