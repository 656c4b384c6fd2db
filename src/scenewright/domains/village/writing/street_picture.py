"""A picture of a village as one sees it standing in its lane, at eye height."""

from __future__ import annotations

import os

from scenewright.catalog.loading import catalog_of
from scenewright.core.atomic_file import atomic_write
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains import plan_of, scene_of
from scenewright.domains.village.lanes import opened
from scenewright.render.street import render_street


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the street picture of a solution to ``path``; it appears whole or not at all."""
    from PIL import Image

    catalog, made = catalog_of(solution.brief.catalogs), plan or plan_of(solution.brief)
    grounds = [block.ground for block in opened(made, solution).detail.blocks]
    pixels = render_street(scene_of(solution, made), grounds, catalog)
    with atomic_write(path) as partial:
        Image.fromarray(pixels).save(partial, format="png", compress_level=6)
