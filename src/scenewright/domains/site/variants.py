"""Ways to solve a site otherwise: another form, axis or side of the ground."""

from __future__ import annotations

import math
from typing import NamedTuple

from scenewright.domains.site.problem import Floats, SiteProblem
from scenewright.domains.site.solvers.chosen import SiteChoice


class Variant(NamedTuple):
    """A planar ``form`` for blocks that have none ("": as asked for); radians by which fronts are
    turned off the preferred heading; the heading of the side that buildings are drawn to (None:
    none); how blocks are to be filled, if that was chosen; or where buildings stand: ``boxes``
    (n, 5), what cannot stand is left out."""

    form: str = ""
    turn: float = 0.0
    side: float | None = None
    choice: SiteChoice | None = None
    boxes: Floats | None = None


def vary(problem: SiteProblem, variant: Variant) -> SiteProblem:
    """A problem as a variant of it is solved."""
    forms = tuple(form or variant.form for form in problem.block_forms)
    drawn = (0.0, 0.0)
    if variant.side is not None:
        drawn = (math.cos(variant.side), math.sin(variant.side))
    return problem._replace(facing=problem.facing + variant.turn, block_forms=forms, drawn_to=drawn)
