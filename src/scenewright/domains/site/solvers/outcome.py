"""What a solver of sites answers with."""

from __future__ import annotations

from typing import NamedTuple

from scenewright.domains.site.problem import Flags, Floats


class SiteFound(NamedTuple):
    """Boxes (n, 5), which buildings found a place (n,), scores by name, how many layouts were
    looked at and in how many generations (1 where there are none), and the planar form each
    building stands in (empty: not known)."""

    boxes: Floats
    present: Flags
    score: dict[str, float]
    evaluations: int
    generations: int = 1
    forms: tuple[str, ...] = ()
