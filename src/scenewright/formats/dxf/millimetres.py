"""Plans for CAD in millimetres: as :mod:`scenewright.formats.dxf`, with ``$INSUNITS`` 4."""

from __future__ import annotations

import os

from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.formats.dxf import write_unit


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the plan of a solution in millimetres; the file appears whole or not at all."""
    write_unit(solution, path, plan, "mm")
