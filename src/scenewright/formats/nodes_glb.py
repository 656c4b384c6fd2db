"""The same scene as ``.glb`` where everything draws itself: no instances, no merged walls.

For readers that know no EXT_mesh_gpu_instancing, and for those that take a scene apart.
"""

from __future__ import annotations

import os

from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.formats.glb import write_scene


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the scene of a solution to ``path``; the file appears whole or not at all."""
    write_scene(solution, path, plan, batched=False)
