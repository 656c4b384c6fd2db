"""The designer's layout under the printed cost (Liu et al. 2017, 4.6).

The rooms of the six furnished homes in which at least two groups are found; the groups as they
stand are a layout of the paper's problem with the same groups, sizes reaching as far as theirs.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import shapely
from numpy.typing import NDArray

from benchmarks.home_rooms import Case
from scenewright.building.plan import spaces
from scenewright.building.standing import fixed_pieces
from scenewright.catalog.assets import shipped
from scenewright.domains.home.build_problem import build_problem
from scenewright.domains.home.ground import ground_of
from scenewright.domains.home.learned.learning import FurnishedSpace, found_in
from scenewright.domains.home.paper_problem import as_in_paper
from scenewright.domains.home.presets import PAPER
from scenewright.domains.home.problem import Items
from scenewright.domains.home.programme import Wish
from scenewright.formats import read

Floats = NDArray[np.float64]
LEAST = 2


def designed(path: Path) -> Iterator[tuple[Case, Floats]]:
    """The rooms of a furnished home as the paper's problem, and the designer's boxes (n, 5)."""
    full = read(path, keep=True)
    for room, space in zip(full.rooms, spaces(full), strict=True):
        stands = tuple(fixed_pieces(room, space, shipped()))
        found = tuple(found_in(FurnishedSpace(path.stem, space, stands), shipped()))
        if len(found) < LEAST:
            continue
        wishes = tuple(Wish(one.case.function, 0) for one in found)
        area = float(shapely.Polygon(space.outline, list(space.holes)).area)
        ground = ground_of(space, (), area)
        problem = build_problem(ground, wishes, PAPER, True, full.route_width, area)
        problem = as_in_paper(problem, wishes, space)
        boxes = np.array([(*one.box, one.case.width, one.case.depth) for one in found])
        problem = problem._replace(items=widen_sizes(problem.items, boxes[:, 3:]))
        yield Case(f"{path.stem}/{space.id}", problem, problem), boxes


def widen_sizes(items: Items, sizes: Floats) -> Items:
    """Items whose sizes ``(n, 2)`` range to the given ones too."""
    return items._replace(low=np.minimum(items.low, sizes), high=np.maximum(items.high, sizes))
