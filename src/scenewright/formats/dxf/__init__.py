"""Plans for CAD: DXF (AutoCAD 2010) in metres, by ezdxf (extra ``dxf``).

Every level is a plan in the model at true size, on layers named after the US National CAD Standard,
and a layout to scale. Objects are blocks, one a model and size, with the attributes ID, KIND, NAME,
SIZE and PRICE; dimensions, arcs of doors and hatches are entities of their own. ``.mm.dxf`` writes
millimetres, ``.3d.dxf`` meshes.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from scenewright.core.extras import require

if TYPE_CHECKING:
    from scenewright.core.plan import Plan
    from scenewright.core.solution import Solution

require("ezdxf")


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the plan of a solution in metres; the file appears whole or not at all."""
    write_unit(solution, path, plan, "m")


def write_unit(
    solution: Solution, path: str | os.PathLike[str], plan: Plan | None, unit: str
) -> None:
    """Write the plan of a solution in a unit, ``m`` or ``mm``."""
    from scenewright.core.atomic_file import atomic_write
    from scenewright.domains import draw_levels
    from scenewright.drawing.dxf.document import UNITS, make_document

    document = make_document(draw_levels(solution, plan), UNITS[unit])
    with atomic_write(path) as partial:
        document.saveas(partial)
