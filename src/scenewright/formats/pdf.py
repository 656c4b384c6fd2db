"""Plans to print: one PDF of vectors to scale, by fpdf2 (extra ``pdf``).

A page a sheet: the plan of each level, then elevations of kitchen and shelf walls, the schedule of
furniture and pictures of rooms. Text can be selected and searched; its fonts are embedded.
"""

from __future__ import annotations

import os

from scenewright.core.atomic_file import atomic_write
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.drawing.pdf.document import make_pdf
from scenewright.formats.drawing_set import draw_set


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the set of sheets of a solution; the file appears whole or not at all."""
    pdf = make_pdf(draw_set(solution, plan), solution.brief.name or "Plan")
    with atomic_write(path) as partial:
        partial.write_bytes(bytes(pdf.output()))
