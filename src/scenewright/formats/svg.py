"""A plan to print: SVG 1.1 to scale, in millimetres, drawn by the solution's domain.

The file holds no script, no style sheet, no image and no font; names are escaped.
"""

from __future__ import annotations

import os

from scenewright.core.atomic_file import write_atomically
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains import draw_plan
from scenewright.drawing.svg import write_svg


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the plan of a solution to ``path``; the file appears whole or not at all."""
    write_atomically(path, write_svg(draw_plan(solution, plan)))
