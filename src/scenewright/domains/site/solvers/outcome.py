"""The answer of a solver of sites."""

from __future__ import annotations

from typing import NamedTuple

from scenewright.domains.site.problem import Flags, Floats
from scenewright.engine.solve import Found


class SiteLayout(NamedTuple):
    """Boxes (n, 5), which buildings found a place (n,), scores by name (empty: not measured), the
    planar form each building stands in (empty: not known), and in how many generations it was
    found (1 where there are none)."""

    boxes: Floats
    present: Flags
    score: dict[str, float]
    forms: tuple[str, ...] = ()
    generations: int = 1


SiteFound = Found[SiteLayout]
