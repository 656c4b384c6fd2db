"""Houses of ProcTHOR as AI2-THOR reads them (schema 1.0.0), written and read as JSON.

Theirs is left-handed with y up: our (x, y, z) is (x, z, y) there, and a front that looks along a
heading h is turned by 90° - h about y. Floors are the inner faces of walls, walls one-sided, seen
from their right. What the schema has no word for (names, sizes, groups) is under ``scenewright``,
which other readers pass over. M. Deitke and others, *ProcTHOR: Large-Scale Embodied AI Using
Procedural Generation* (2022); *AI2-THOR* 5.0, ``ProceduralData``.
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING

from scenewright.core.atomic_file import write_atomically
from scenewright.core.errors import InputError
from scenewright.core.registry import domain_of

if TYPE_CHECKING:
    from scenewright.core.brief import Brief
    from scenewright.core.plan import Plan
    from scenewright.core.solution import Solution


def check(brief: Brief) -> None:
    """Raise :class:`InputError` for scenes without rooms."""
    if not domain_of(brief.domain).rooms:
        raise InputError(f"a {brief.domain} has no rooms", "write a .glb or .usda instead")


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the house of a solution to ``path``; the file appears whole or not at all."""
    from scenewright.catalog.loading import catalog_of
    from scenewright.domains import scene_of
    from scenewright.formats.simulation.procthor.house import house_of

    check(solution.brief)
    house = house_of(scene_of(solution, plan), catalog_of(solution.brief.catalogs))
    write_atomically(path, json.dumps(house, ensure_ascii=False, indent=1) + "\n")


def read(path: Path, keep: bool = False) -> Brief:
    """The brief of a house; ``keep`` leaves its objects where they stand."""
    from scenewright.formats.simulation.procthor.reading import read_house

    return read_house(path, keep)
