"""A picture of open ground as one sees it standing in its street, at eye height: of a site, of a
village in its lane, of an extension across the seam of old and new."""

from __future__ import annotations

import os

from scenewright.catalog.loading import catalog_of
from scenewright.core.atomic_file import atomic_write
from scenewright.core.plan import Plan
from scenewright.core.registry import domain_of
from scenewright.core.solution import Solution
from scenewright.domains import plan_of, scene_of
from scenewright.render.picture import Pixels
from scenewright.render.street import WIDTH, render_street


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the street picture of a solution to ``path``; it appears whole or not at all."""
    from PIL import Image

    with atomic_write(path) as partial:
        Image.fromarray(picture(solution, plan=plan)).save(partial, format="png", compress_level=6)


def picture(solution: Solution, width: int = WIDTH, plan: Plan | None = None) -> Pixels:
    """The street from its best spot as pixels ``(height, width, 3)``."""
    catalog, made = catalog_of(solution.brief.catalogs), plan or plan_of(solution.brief)
    grounds = domain_of(solution.brief.domain).verb("grounds")(solution, made)
    return render_street(scene_of(solution, made), grounds, catalog, width)
