"""The scene for engines, as ``.glb``: levels of detail, collision meshes, no instances.

Conventions are told in :mod:`scenewright.formats.gltf.handover`.
"""

from __future__ import annotations

import os

from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.formats.glb import write_scene


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the scene of a solution to ``path``; the file appears whole or not at all."""
    write_scene(solution, path, plan, batched=False, for_engines=True)
